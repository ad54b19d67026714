//! Curves over a cycle: the values that they mark are the true ones, the lines are where they should be, and nothing covers a label.

use kinegon::Solution;
use kinegon::cycle::{Curve, Curves, Drive, Path};
use kinegon::drawing::{Drawing, Mark, Pen, Point, Rect, Shape, curves};
use kinegon::scene::Scene;
use std::f64::consts::PI;
use support::files;
use support::stages::solved;
use support::survey::ALIKE;

/// Most bytes of a figure's SVG file.
const MOST_BYTES: usize = 60_000;

/// What the curves of a scene look like over a range; without one once around or from limit to limit.
fn sampled<T>(scene: &str, range: Option<[f64; 2]>, want: &str, look: impl FnOnce(&Scene, &Curves) -> T) -> T {
    let Solution { scene, mechanism, pose, .. } = solved(scene).unwrap_or_else(|error| panic!("{error}"));
    let drive = Drive::new(&mechanism, None).expect("it has a drive");
    let mut path = Path::new(&mechanism, &pose, drive).expect("it can be moved");
    let range = path.cover(range.map(|r| r[0]), range.map(|r| r[1]));
    let range = range.expect("it can be reached");
    let names: Vec<String> = want.split_whitespace().map(str::to_owned).collect();
    let curves = Curves::new(&path, range, Some(&names)).unwrap_or_else(|e| panic!("{want}: {e}"));
    look(&scene, &curves)
}

fn drawn(scene: &str, range: Option<[f64; 2]>, want: &str) -> Drawing {
    sampled(scene, range, want, |scene, sampled| {
        curves(scene, sampled, None).unwrap_or_else(|error| panic!("{want}: {error}"))
    })
}

fn file(name: &str) -> String {
    let path = files::path(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn figure_2() -> String {
    file("examples/figure-2.json")
}

/// The scene on a sheet that holds more panels.
fn upright(scene: &str) -> String {
    let mut scene: serde_json::Value = serde_json::from_str(scene).expect("a scene is JSON");
    scene["figure"]["page"] = "a4-portrait".into();
    scene.to_string()
}

/// An in-line slider-crank: crank 50 mm, rod 150 mm, 100 rad/s.
const SLIDER_CRANK: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    "ground": { "A": [0, 0], "E": [300, 0] },
    "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 40, "omega": 100 } },
               "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["C"] } },
    "sliders": [{ "link": "3", "at": "C", "on": "ground", "along": "AE" }], "near": { "C": [190, 0] } }"#;

/// A four-bar linkage: ground 100 mm, crank, coupler, rocker; the joint C near a place.
fn four_bar([crank, coupler, rocker]: [f64; 3], angle: f64, near: [f64; 2]) -> String {
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [100, 0] }},
        "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {crank} }}, "drive": {{ "angle": {angle}, "omega": 10 }} }},
                   "2": {{ "points": ["B", "C"], "lengths": {{ "BC": {coupler} }} }},
                   "3": {{ "points": ["D", "C"], "lengths": {{ "DC": {rocker} }} }} }}, "near": {{ "C": {near:?} }} }}"#
    )
}

fn curve<'a>(curves: &'a Curves, name: &str) -> &'a Curve {
    let has = |c: &&Curve| c.asked.iter().any(|a| a.name() == name);
    let found = curves.curves.iter().find(has);
    found.unwrap_or_else(|| panic!("no curve of {name}"))
}

/// The greatest or the least value of a curve, and everywhere it is reached.
fn extreme(curves: &Curves, name: &str, greatest: bool) -> (f64, Vec<f64>) {
    let extremes = &curve(curves, name).extremes;
    let same = extremes.iter().filter(|e| e.greatest == greatest);
    let value = same.clone().next().map(|e| e.value);
    (value.unwrap_or_else(|| panic!("{name} has no such extreme")), same.map(|e| e.at).collect())
}

fn close(got: f64, truth: f64, relative: f64, what: &str) {
    let off = (got - truth).abs() / truth.abs().max(1e-300);
    assert!(off <= relative, "{what}: {got} instead of {truth}");
}

#[test]
fn a_long_title_stays_on_the_sheet() {
    let scene =
        SLIDER_CRANK.replace(r#""kinegon": 1,"#, &format!(r#""kinegon": 1, "title": "{}","#, "crank ".repeat(40)));
    let drawing = drawn(&scene, None, "omega(2)");
    let title = drawing.marks.iter().find(|mark| mark.pen == Pen::Heading).expect("it has a title");
    let sheet = Rect::new(0.0, 0.0, drawing.width, drawing.height);
    assert_eq!(title.shape.bounds().union(sheet), sheet);
}

/// Greatest and least values of a four-bar (ground 100, crank 30, coupler 90, rocker 70, 10 rad/s) with their places, and the slider-crank's
/// fastest slide: derivatives of the closed forms, with 50 digits (mpmath).
const CLOSED_FORMS: [(&str, bool, f64, f64); 12] = [
    ("angle(3)", true, 143.817_712_778_847_4, 223.531_152_167_372_45),
    ("angle(3)", false, 92.046_713_097_672_58, 35.659_087_696_138_76),
    ("omega(3)", true, 4.287_197_646_390_529_5, 114.282_929_876_706_94),
    ("omega(3)", false, -5.325_975_469_600_563, 336.653_835_592_159_34),
    ("alpha(3)", true, 74.470_334_173_125_17, 22.524_855_465_232_516),
    ("alpha(3)", false, -32.075_536_263_191_644, 295.947_656_820_284_24),
    ("y(C)", true, 69.955_342_898_166_11, 35.659_087_696_138_76),
    ("y(C)", false, 41.324_931_941_867_73, 223.531_152_167_372_45),
    ("v(C)", true, 372.818_282_872_039_4, 336.653_835_592_159_34),
    ("a(C)", true, 5_216.605_148_334_348, 22.320_661_493_066_897),
    ("a(C)", false, 1_286.604_456_145_154_5, 114.282_929_876_706_94),
    ("v_r(3/ground)", false, -5_273.197_732_698_685, 73.175_296_636_241_16),
];

#[test]
fn extremes_have_proved_bounds_that_hold_the_closed_forms() {
    for (name, greatest, value, at) in CLOSED_FORMS {
        let scene = if name.starts_with("v_r") {
            SLIDER_CRANK.to_owned()
        } else {
            four_bar([30.0, 90.0, 70.0], 60.0, [60.0, 60.0])
        };
        sampled(&scene, Some([1.0, 359.0]), name, |scene, curves| {
            let found = curves.certain_extremes(scene, curve(curves, name));
            let found = found[usize::from(greatest)].unwrap_or_else(|| panic!("{name} has no such extreme"));
            assert!(found.is_proved, "{name}: {found:?}");
            // The truth is rounded to f64 here.
            assert!((found.value - value).abs() <= found.error + f64::EPSILON * value.abs(), "{name}: {found:?}");
            assert!((found.at - at).abs() <= found.within + f64::EPSILON * at, "{name}: {found:?}, at {at}");
            assert!(found.error <= 1e-10 * value.abs() && found.within <= 2e-10, "{name}: {found:?}");
        });
    }
}

#[test]
fn what_is_no_extreme_for_certain_is_not_proved() {
    // The rocker is stretched at limits, where it turns infinitely fast: its angle there has no proof, but a bound that holds.
    let scene = four_bar([80.0, 50.0, 60.0], 60.0, [60.0, 50.0]);
    let limit = libm::acos((80.0 * 80.0 + 100.0 * 100.0 - 110.0 * 110.0) / (2.0 * 80.0 * 100.0));
    let straight = libm::atan2(80.0 * libm::sin(limit), 80.0 * libm::cos(limit) - 100.0).to_degrees();
    sampled(&scene, None, "angle(3)", |scene, curves| {
        let found =
            curves.certain_extremes(scene, curve(curves, "angle(3)")).map(|found| found.expect("it is bounded"));
        println!("{found:?}, limit {} {straight}", limit.to_degrees());
        let at_limits = found.iter().filter(|f| (f.at.abs() - limit.to_degrees()).abs() < 1e-6);
        for found in at_limits {
            assert!(!found.is_proved, "{found:?}");
            let off = (libm::remainder(found.value - straight, 360.0))
                .abs()
                .min(libm::remainder(found.value + straight, 360.0).abs());
            assert!(off <= found.error.max(1e-12), "{found:?}: off by {off}");
            assert!(found.error < 1e-5, "{found:?}");
        }
    });
    // A speed is zero at a dead centre, where its curve has a corner.
    sampled(SLIDER_CRANK, Some([10.0, 350.0]), "v(C)", |scene, curves| {
        let [least, _] = curves.certain_extremes(scene, curve(curves, "v(C)"));
        let least = least.expect("it is bounded");
        assert!(least.error < 1e-6 && least.value == 0.0, "{least:?}");
    });
    // A constant is held against its value where it is.
    sampled(SLIDER_CRANK, Some([10.0, 350.0]), "omega(1)", |scene, curves| {
        let found = curves.certain_extremes(scene, curve(curves, "omega(1)"));
        assert_eq!(found[0], found[1]);
        assert_eq!(found[0].map(|f| (f.value, f.error)), Some((100.0, 0.0)));
    });
}

#[test]
fn extremes_of_a_slider_crank_are_the_closed_forms() {
    let (r, l, omega) = (50.0, 150.0, 100.0);
    let want = "x(C) omega(2) a_r(3/ground) v(C) v_r(3/ground)";
    sampled(SLIDER_CRANK, Some([0.0, 360.0]), want, |_, curves| {
        // x = r cos θ + √(l² − r² sin² θ).
        let (most, at) = extreme(curves, "x(C)", true);
        close(most, r + l, 1e-12, "outer dead centre");
        assert_eq!(at.len(), 2, "at 0° and at 360°: {at:?}");
        let (least, at) = extreme(curves, "x(C)", false);
        close(least, l - r, 1e-12, "inner dead centre");
        close(at[0], 180.0, 1e-6, "its place");
        // ω_2 = −ω r cos θ / √(l² − r² sin² θ).
        let (most, at) = extreme(curves, "omega(2)", true);
        close(most, omega * r / l, 1e-12, "coupler");
        close(at[0], 180.0, 1e-6, "its place");
        // At θ = 0: a = −r ω² (1 + r/l).
        let (least, _) = extreme(curves, "a_r(3/ground)", false);
        close(least, -r * omega * omega * (1.0 + r / l), 1e-12, "piston");
        // The greatest speed, where d²x/dθ² = 0: the root of a cubic in sin² θ.
        let speed = |degrees: f64| {
            let (sine, cosine) = libm::sincos(degrees * PI / 180.0);
            r * omega * sine * (1.0 + r * cosine / (l * l - r * r * sine * sine).sqrt())
        };
        let (most, at) = extreme(curves, "v(C)", true);
        assert_eq!(at.len(), 2, "{at:?}");
        close(most, 5_273.197_732_698_685, 1e-12, "greatest speed");
        close(speed(at[0]), most, 1e-12, "at its own place");
        assert!(speed(at[0] - 0.1) < most && speed(at[0] + 0.1) < most);
        let (least, at) = extreme(curves, "v(C)", false);
        assert_eq!((least, at.len()), (0.0, 3));
        // What has only a zero there is no joint that turns back.
        assert!(curve(curves, "v(C)").dead.is_empty());
        let dead = &curve(curves, "v_r(3/ground)").dead;
        assert_eq!(dead.len(), 3);
        for (at, truth) in dead.iter().zip([0.0, 180.0, 360.0]) {
            assert!((at - truth).abs() < 1e-9, "{dead:?}");
        }
    });
}

#[test]
fn a_curve_reaches_its_value_in_the_limit_position() {
    // Stretched, coupler and rocker are one line of 120 mm from D to B.
    let scene = four_bar([60.0, 50.0, 70.0], 50.0, [80.0, 67.0]);
    sampled(&scene, None, "angle(3) omega(3) omega(1)", |_, curves| {
        let limit = libm::acos((60.0_f64 * 60.0 + 1e4 - 120.0 * 120.0) / 12e3);
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let at = sign * limit.to_degrees();
            close(curves.range[side], at, 1e-12, "limit");
            let (sine, cosine) = libm::sincos(sign * limit);
            let truth = libm::atan2(60.0 * sine, 60.0 * cosine - 100.0).to_degrees();
            let pieces = &curve(curves, "angle(3)").pieces;
            assert_eq!(pieces.len(), 1);
            let end = if side == 0 { pieces[0].first() } else { pieces[0].last() };
            let end = end.expect("it has samples");
            assert_eq!(end[0], curves.range[side]);
            let turns = (end[1] - truth) / 360.0;
            assert!((turns - turns.round()).abs() < 1e-9, "{} {truth}", end[1]);
        }
        // Its angular velocity grows beyond all bounds in both.
        let omega = curve(curves, "omega(3)");
        assert!(omega.extremes.len() <= 1, "{:?}", omega.extremes);
        assert!(omega.window[1] - omega.window[0] < 200.0, "{:?}", omega.window);
        let even = curve(curves, "omega(1)").constant;
        close(even.expect("it is constant"), 10.0, 1e-9, "crank");
    });
}

#[test]
fn curves_go_smoothly_through_change_points() {
    // Crossed, the linkage rolls one ellipse on another: from −(d + r)/(d − r) to its inverse, both in change points.
    let crossed = four_bar([40.0, 100.0, 40.0], 60.0, [80.0, -35.0]);
    let range = Some([0.0, 360.0]);
    sampled(&crossed, range, "omega(3) alpha(3) angle(3)", |_, curves| {
        let (least, at) = extreme(curves, "omega(3)", false);
        close(least, -10.0 * 140.0 / 60.0, 1e-6, "the quickest");
        assert!(at[0].abs() < 0.01, "{at:?}");
        let (most, at) = extreme(curves, "omega(3)", true);
        close(most, -10.0 * 60.0 / 140.0, 1e-6, "the slowest");
        close(at[0], 180.0, 1e-3, "its place");
        for curve in &curves.curves {
            assert_eq!(curve.pieces.len(), 1);
        }
        let (least, _) = extreme(curves, "angle(3)", false);
        close(least, -360.0, 1e-9, "a turn back");
    });
    // The parallelogram moves evenly, whatever rounding says near its change points.
    let parallel = four_bar([40.0, 100.0, 40.0], 60.0, [120.0, 35.0]);
    sampled(&parallel, range, "omega(3) alpha(3) omega(2)", |_, curves| {
        let omega = curve(curves, "omega(3)").constant;
        close(omega.expect("it is constant"), 10.0, 1e-9, "rocker");
        assert_eq!(curve(curves, "alpha(3)").constant, Some(0.0));
        assert_eq!(curve(curves, "omega(2)").constant, Some(0.0));
    });
}

#[test]
fn angles_go_on_over_several_turns() {
    let whitworth = file("templates/whitworth.json");
    sampled(&whitworth, Some([-100.0, 980.0]), "angle(3)", |_, curves| {
        let pieces = &curve(curves, "angle(3)").pieces;
        assert_eq!(pieces.len(), 1);
        let rise = pieces[0][pieces[0].len() - 1][1] - pieces[0][0][1];
        close(rise, 1080.0, 1e-9, "three turns");
        let steps = pieces[0].windows(2).map(|w| w[1][1] - w[0][1]);
        assert!(steps.fold(0.0_f64, |a, b| a.max(b.abs())) < 30.0);
    });
}

#[test]
fn a_pole_within_the_range_is_cut_off() {
    // Near 130° the special point of link 3 passes through infinity.
    sampled(&figure_2(), None, "L(B,S3) x(S3)", |_, curves| {
        let length = curve(curves, "L(B,S3)");
        assert!(length.extremes.iter().all(|e| !e.greatest));
        assert!(length.window[1] < 5000.0, "{:?}", length.window);
        assert!(curve(curves, "x(S3)").extremes.is_empty());
    });
}

#[test]
fn equal_curves_are_drawn_once() {
    let lever = file("templates/slotted-lever.json");
    let drawing = drawn(&lever, None, "omega(2) omega(3) v_r(2/3)");
    let lines = |mark: &&Mark| mark.id.as_deref().is_some_and(|id| id.starts_with("omega-curve"));
    assert_eq!(drawing.marks.iter().filter(lines).count(), 1);
    let names = texts(&drawing).map(|(_, text)| text);
    assert_eq!(names.filter(|text| text.replace(' ', "") == "ω2=ω3").count(), 1);
}

fn texts(drawing: &Drawing) -> impl Iterator<Item = (&Mark, String)> {
    drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some((mark, text.text.content())),
        _ => None,
    })
}

fn frames(drawing: &Drawing) -> Vec<Rect> {
    let frames = drawing.marks.iter().filter(|mark| mark.pen == Pen::Frame);
    frames.map(|mark| mark.shape.bounds()).collect()
}

/// A panel's scale, read from its grid and the numbers beside it as a reader does: at a value, a place.
fn scale(drawing: &Drawing, panel: Rect, upright: bool) -> impl Fn(f64) -> f64 {
    let lines = drawing.marks.iter().filter_map(|mark| match mark.shape {
        Shape::Line(a, b) if mark.pen == Pen::Grid && panel.inflate(0.1, 0.1).contains(a) => {
            let level = a.y == b.y;
            (level == upright).then_some(if level { a.y } else { a.x })
        }
        _ => None,
    });
    let number = |place: f64| -> Option<f64> {
        let numbers = texts(drawing).filter_map(|(mark, text)| {
            let centre = mark.shape.bounds().center();
            let beside = if upright {
                centre.x < panel.x0 && (centre.y - place).abs() < 1.0
            } else {
                centre.y > panel.y1 && (centre.x - place).abs() < 1.0
            };
            beside.then(|| text.replace('−', "-").replace('\u{a0}', "").parse().ok()).flatten()
        });
        numbers.last()
    };
    let pairs: Vec<[f64; 2]> = lines.filter_map(|at| Some([number(at)?, at])).collect();
    let (Some([a, p]), Some([b, q])) = (pairs.first().copied(), pairs.last().copied()) else {
        panic!("no numbers at the grid")
    };
    assert!(a != b, "{pairs:?}");
    move |value| p + (value - a) / (b - a) * (q - p)
}

/// Distance of a point from a chain of straight lines.
fn distance(p: Point, chain: &[Point]) -> f64 {
    let to_line = |w: &[Point]| {
        let along = w[1] - w[0];
        let share = ((p - w[0]).dot(along) / along.hypot2()).clamp(0.0, 1.0);
        (p - (w[0] + along * share)).hypot()
    };
    chain.windows(2).map(to_line).fold(f64::INFINITY, f64::min)
}

#[test]
fn lines_and_dots_on_paper_are_where_the_grid_says() {
    let drawing = drawn(SLIDER_CRANK, Some([0.0, 360.0]), "x(C) v(C)");
    let panels = frames(&drawing);
    let bottom = Rect { y0: panels[0].y0, ..panels[1] };
    let across = scale(&drawing, bottom, false);
    let (r, l) = (50.0, 150.0);
    let place = |degrees: f64| {
        let (sine, cosine) = libm::sincos(degrees * PI / 180.0);
        r * cosine + (l * l - r * r * sine * sine).sqrt()
    };
    let speed = |degrees: f64| {
        let (sine, cosine) = libm::sincos(degrees * PI / 180.0);
        let root = (l * l - r * r * sine * sine).sqrt();
        (100.0 * r * sine * (1.0 + r * cosine / root)).abs()
    };
    let truths: [(&str, &dyn Fn(f64) -> f64); 2] = [("position", &place), ("velocity", &speed)];
    for ((name, truth), panel) in truths.into_iter().zip(panels) {
        let up = scale(&drawing, panel, true);
        let mut chain: Vec<Point> = Vec::new();
        let mut dots = Vec::new();
        for mark in &drawing.marks {
            let own = mark.id.as_deref().is_some_and(|id| id.starts_with(&format!("{name}-curve")));
            match &mark.shape {
                Shape::Polyline(points) if own => chain.extend(points),
                Shape::Circle { center, .. } if matches!(mark.pen, Pen::Curve) => {
                    dots.extend(panel.inflate(0.1, 0.1).contains(*center).then_some(*center));
                }
                _ => {}
            }
        }
        for k in 0..=3600 {
            let degrees = f64::from(k) / 10.0;
            let on = Point::new(across(degrees), up(truth(degrees)));
            let off = distance(on, &chain);
            assert!(off < 0.02, "{name} at {degrees}°: {off} mm");
        }
        assert_eq!(dots.len(), if name == "position" { 3 } else { 5 });
        for dot in dots {
            let degrees = (dot.x - across(0.0)) / (across(360.0) - across(0.0)) * 360.0;
            assert!((dot.y - up(truth(degrees))).abs() < 1e-6, "{name}: {dot:?}");
        }
    }
}

/// What is wrong with a figure, in words.
fn faults(drawing: &Drawing, curves: &[Curve]) -> Vec<String> {
    let mut faults = Vec::new();
    let (frames, file) = (frames(drawing), drawing.svg());
    let sheet = Rect::new(0.0, 0.0, drawing.width, drawing.height);
    let within = |inner: Rect, outer: Rect| {
        let outer = outer.inflate(1e-9, 1e-9);
        outer.union(inner) == outer
    };
    let touch = |a: Rect, b: Rect| a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
    let texts: Vec<(&Mark, String)> = texts(drawing).collect();
    for (index, (mark, text)) in texts.iter().enumerate() {
        let ink = mark.shape.bounds();
        if !within(ink, sheet) {
            faults.push(format!("{text} leaves the sheet"));
        }
        let inside = frames.iter().any(|frame| within(ink, *frame));
        if matches!(mark.pen, Pen::Curve) && !inside {
            faults.push(format!("{text} leaves its panel"));
        }
        for (other, words) in &texts[..index] {
            if touch(ink, other.shape.bounds()) {
                faults.push(format!("{text} touches {words}"));
            }
        }
        for other in &drawing.marks {
            if matches!(other.shape, Shape::Circle { .. }) && touch(ink, other.shape.bounds()) {
                faults.push(format!("{text} lies on a dot"));
            }
        }
    }
    for mark in &drawing.marks {
        let area = mark.shape.bounds();
        let line = matches!(mark.shape, Shape::Polyline(_) | Shape::Line(..));
        if !mark.shape.is_drawable() || line && !frames.iter().any(|frame| within(area, *frame)) {
            faults.push(format!("{mark:?} leaves its panel"));
        }
    }
    let is_name = |id: &str| id.contains("-label-");
    let names = texts.iter().filter(|(m, _)| m.id.as_deref().is_some_and(is_name));
    if names.count() != curves.len() {
        faults.push(format!("not every one of {} curves has a name", curves.len()));
    }
    let is_value = |id: &str| id.contains("-greatest-") || id.contains("-least-");
    let values = texts.iter().filter(|(m, _)| m.id.as_deref().is_some_and(is_value));
    let reached = |c: &Curve| {
        let both = [false, true].into_iter();
        both.filter(|g| c.extremes.iter().any(|e| e.greatest == *g)).count()
    };
    if values.count() != curves.iter().map(reached).sum::<usize>() {
        faults.push("not every extreme has its value".to_owned());
    }
    if file.len() > MOST_BYTES || file.contains("NaN") {
        faults.push(format!("{} bytes", file.len()));
    }
    faults
}

/// Quantities to try on a scene: rates of the links, of the points, places, everything of the sliders.
fn wishes(scene: &str) -> Vec<String> {
    let mechanism = solved(scene).expect("a good scene").mechanism;
    let links: Vec<&str> = mechanism.links().map(|(_, body)| body.name.as_str()).collect();
    let points: Vec<&str> = mechanism.points.iter().map(String::as_str).collect();
    let sliders = (0..mechanism.sliders.len()).map(kinegon::mechanism::SliderId);
    let sliders: Vec<String> = sliders.map(|s| mechanism.slider_name(s)).collect();
    let each = |heads: &[&str], names: &[&str]| {
        let all = heads.iter().flat_map(|head| names.iter().map(move |n| format!("{head}({n})")));
        all.collect::<Vec<_>>().join(" ")
    };
    let sliders: Vec<&str> = sliders.iter().map(String::as_str).collect();
    let few = &points[..points.len().min(10)];
    let mut wishes = vec![
        each(&["omega", "alpha"], &links),
        each(&["v", "a"], few),
        each(&["angle"], &links) + " " + &each(&["x"], &few[..few.len().min(4)]),
    ];
    if !sliders.is_empty() {
        wishes.push(each(&["position", "v_r", "a_r", "a_c"], &sliders));
    }
    wishes
}

#[test]
fn nothing_covers_a_label_and_nothing_leaves_its_panel() {
    let folder = files::path("templates");
    let files = std::fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<String> = files
        .map(|entry| entry.expect("listed").file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".json") && !name.ends_with(".schema.json"))
        .map(|name| format!("templates/{name}"))
        .collect();
    names.push("examples/figure-2.json".into());
    names.sort();
    let (mut tried, mut wrong) = (0, Vec::new());
    for name in names.into_iter().step_by(ALIKE.now()) {
        let text = upright(&file(&name));
        // A drawn configuration has no cycle.
        if !text.contains("\"drive\"") {
            continue;
        }
        for want in wishes(&text) {
            // A cylinder has no full turn.
            let range = name.contains("boom").then_some([300.0, 500.0]);
            let found = sampled(&text, range, &want, |scene, sampled| {
                let drawing = curves(scene, sampled, None).unwrap_or_else(|e| panic!("{name}: {e}"));
                faults(&drawing, &sampled.curves)
            });
            tried += 1;
            wrong.extend(found.into_iter().map(|fault| format!("{name} [{want}]: {fault}")));
        }
    }
    assert!(tried * ALIKE.now() >= 40, "only {tried} figures");
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_papers_mechanism_is_drawn_from_limit_to_limit() {
    let want = "omega(4) alpha(4) v_r(3/2)";
    let drawing = sampled(&figure_2(), None, want, |scene, sampled| {
        let drawing = curves(scene, sampled, None).expect("it fits");
        assert_eq!(faults(&drawing, &sampled.curves), Vec::<String>::new());
        drawing
    });
    let shown = texts(&drawing).map(|(_, text)| text.replace(' ', ""));
    let shown: Vec<String> = shown.collect();
    for words in ["limit−137.58°", "limit137.58°", "scene70°"] {
        assert!(shown.iter().any(|text| text == words), "no {words}: {shown:?}");
    }
    let count = |pen: Pen| drawing.marks.iter().filter(|m| m.pen == pen).count();
    assert_eq!((count(Pen::Limit), count(Pen::Stand)), (6, 3));
    // Curves that grow without bound run out through the border.
    let frames = frames(&drawing);
    for (panel, ends) in frames.iter().zip([[true, false], [true, true], [false, true]]) {
        let lines = drawing.marks.iter().filter_map(|mark| match &mark.shape {
            Shape::Polyline(points) if matches!(mark.pen, Pen::Curve) => Some(points),
            _ => None,
        });
        let own: Vec<&Vec<Point>> = lines.filter(|points| panel.inflate(0.1, 0.1).contains(points[0])).collect();
        assert_eq!(own.len(), 1);
        let edge = |up: bool| if up { panel.y0 } else { panel.y1 };
        let (first, last) = (own[0][0], own[0][own[0].len() - 1]);
        assert!((first.y - edge(ends[0])).abs() < 1e-9, "{first:?}");
        assert!((last.y - edge(ends[1])).abs() < 1e-9, "{last:?}");
    }
}

#[test]
fn the_same_curves_give_the_same_bytes() {
    let want = "omega(4) alpha(4) v_r(3/2) angle(5)";
    let once = drawn(&figure_2(), None, want).svg();
    assert_eq!(once, drawn(&figure_2(), None, want).svg());
}

/// A rocker a little longer than its crank, 20 parts in a million, turns nearly as the crank does, but not quite: its speed is no constant, whether
/// time is counted in seconds or in minutes.
#[test]
fn small_changes_of_speed_are_seen_in_both_units_of_time() {
    for time in ["s", "min"] {
        let scene = serde_json::json!({ "kinegon": 1, "units": { "length": "mm", "time": time },
            "ground": { "A": [0, 0], "D": [100, 0] },
            "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 40 }, "drive": { "angle": 90, "rpm": 60 } },
                       "2": { "points": ["B", "C"], "lengths": { "BC": 100 } },
                       "3": { "points": ["C", "D"], "lengths": { "CD": 40.0008 } } },
            "near": { "C": [100, 40] } });
        sampled(&scene.to_string(), Some([60.0, 120.0]), "rpm(3)", |_, curves| {
            assert_eq!(curves.curves[0].constant, None, "{time}");
        });
    }
}
