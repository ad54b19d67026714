//! Ways of vectors' tips over a cycle: they are the closed forms, both directions are to one scale, and nothing covers a name.

use kinegon::Solution;
use kinegon::cycle::{Drive, Hodograph, Hodographs, Path};
use kinegon::drawing::{Drawing, Pen, Point, Shape, hodographs};
use kinegon::scene::Scene;
use std::f64::consts::PI;
use support::faults::{faults, id};
use support::files;
use support::stages::solved;
use support::survey::ALIKE;

/// An in-line slider-crank: crank 50 mm, rod 150 mm, 100 rad/s.
const SLIDER_CRANK: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" },
    "ground": { "A": [0, 0], "E": [300, 0] },
    "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 50 }, "drive": { "angle": 40, "omega": 100 } },
               "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["C"] } },
    "sliders": [{ "link": "3", "at": "C", "on": "ground", "along": "AE" }], "near": { "C": [190, 0] } }"#;

fn sampled<T>(text: &str, want: &str, look: impl FnOnce(&Scene, Result<Hodographs, String>) -> T) -> T {
    let Solution { scene, mechanism, pose, .. } = solved(text).unwrap_or_else(|error| panic!("{error}"));
    let drive = Drive::new(&mechanism, None).expect("it has a drive");
    let mut path = Path::new(&mechanism, &pose, drive).expect("it can be moved");
    let range = path.cover(None, None).expect("it can be reached");
    let names: Vec<String> = want.split_whitespace().map(str::to_owned).collect();
    let sampled = Hodographs::new(&path, range, &names);
    look(&scene, sampled.map_err(|error| error.to_string()))
}

fn drawn(text: &str, want: &str) -> Drawing {
    sampled(text, want, |scene, all| {
        let all = all.unwrap_or_else(|error| panic!("{want}: {error}"));
        hodographs(scene, &all, None).unwrap_or_else(|error| panic!("{want}: {error}"))
    })
}

fn near(got: f64, truth: f64, size: f64, what: &str) {
    assert!((got - truth).abs() <= 1e-9 * size, "{what}: {got} instead of {truth}");
}

/// How far the chords of a way lie inside the way, at most, where that is a circle about the pole.
fn sag(one: &Hodograph) -> f64 {
    let pieces = one.pieces.iter().flat_map(|piece| piece.windows(2));
    let middles = pieces.map(|pair| (0.5 * (pair[0].1 + pair[1].1)).norm());
    middles.fold(f64::INFINITY, f64::min)
}

#[test]
fn the_way_of_a_crank_pin_is_a_circle() {
    sampled(SLIDER_CRANK, "v(B) a(B)", |_, all| {
        let all = all.expect("vectors");
        // v = ω r across the crank, a = ω² r towards its pivot.
        for (one, size, ahead) in [(0, 5e3, 90.0), (1, 5e5, 180.0)] {
            let one = &all.curves[one];
            let place = |degrees: f64| {
                let (sine, cosine) = libm::sincos((degrees + ahead) * PI / 180.0);
                (size * cosine, size * sine)
            };
            let check = |value: f64, x: f64, y: f64| {
                let (a, b) = place(value);
                near(x, a, size, "x");
                near(y, b, size, "y");
            };
            let mut count = 0;
            for (value, tip) in one.pieces.iter().flatten() {
                check(*value, tip.x, tip.y);
                count += 1;
            }
            assert!(count > 50);
            assert!(sag(one) > 0.9995 * size);
            let ends = (one.pieces[0][0].1, one.pieces[0][one.pieces[0].len() - 1].1);
            near((ends.0 - ends.1).norm(), 0.0, size, "it closes");
            assert_eq!(one.marks.len(), 12);
            for (k, (value, tip)) in one.marks.iter().enumerate() {
                near((value - 30.0 * k as f64).rem_euclid(360.0) % 30.0, 0.0, 1.0, "a round angle");
                check(*value, tip.x, tip.y);
            }
            let own = one.own.expect("the scene's position is in a whole turn");
            check(40.0, own.x, own.y);
            for (corner, sign) in one.window.iter().zip([-1.0, 1.0]) {
                near(corner.x, sign * size, size, "window");
                near(corner.y, sign * size, size, "window");
            }
        }
    });
}

#[test]
fn the_way_of_a_slider_is_a_straight_line_with_known_ends() {
    sampled(SLIDER_CRANK, "v(C) a(C)", |_, all| {
        let all = all.expect("vectors");
        let (r, l, omega) = (50.0, 150.0, 100.0);
        // The greatest speed: the root of a cubic in sin² θ. Accelerations at the dead centres; the outer one's is the greatest.
        let speed = 5_273.197_732_698_685;
        let outer = -r * omega * omega * (1.0 + r / l);
        let [v, a] = [&all.curves[0], &all.curves[1]];
        near(v.window[0].x, -speed, speed, "greatest speed back");
        near(v.window[1].x, speed, speed, "and forth");
        near(a.window[0].x, outer, outer.abs(), "greatest acceleration");
        for (one, size) in [(v, speed), (a, outer.abs())] {
            near(one.window[0].y, 0.0, size, "straight");
            near(one.window[1].y, 0.0, size, "straight");
            for (value, tip) in one.pieces.iter().flatten() {
                near(tip.y, 0.0, size, "along the guide");
                if one.asked.name() == "v(C)" {
                    let (sine, cosine) = libm::sincos(value * PI / 180.0);
                    let root = (l * l - r * r * sine * sine).sqrt();
                    near(tip.x, -omega * r * sine * (1.0 + r * cosine / root), size, "speed");
                }
            }
        }
    });
}

#[test]
fn on_paper_both_directions_have_one_scale() {
    for page in ["a4", "a4-portrait", "a3"] {
        let text = SLIDER_CRANK.replacen('{', &format!("{{ \"figure\": {{ \"page\": \"{page}\" }},"), 1);
        let drawing = drawn(&text, "v(B) v(C)");
        let find = |wanted: &str| {
            let found = drawing.marks.iter().find(|mark| id(mark) == wanted);
            &found.unwrap_or_else(|| panic!("no {wanted}")).shape
        };
        let Shape::Circle { center: pole, .. } = *find("hodograph-a-pole") else { panic!("the pole is a circle") };
        let Shape::Arrow { from, to, .. } = *find("hodograph-a-own") else { panic!("the vector is an arrow") };
        assert!((from - pole).hypot() < 1e-9);
        let radius = (to - from).hypot();
        // Counted to a scale that a ruler reads.
        let mu = 5000.0 / radius;
        let decade = libm::pow(10.0, libm::floor(libm::log10(mu) + 1e-9));
        let series = [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0];
        assert!(series.iter().any(|s| (mu / decade - s).abs() < 1e-9), "{mu}");
        // At 40° the velocity of the pin points to 130°; the sheet's y runs down.
        let (sine, cosine) = libm::sincos(130.0 * PI / 180.0);
        let tip = Point::new(pole.x + radius * cosine, pole.y - radius * sine);
        assert!((to - tip).hypot() < 1e-6);
        let Shape::Polyline(way) = find("hodograph-a-way-0") else { panic!("the way is a line") };
        for point in way {
            assert!(((*point - pole).hypot() - radius).abs() < 0.02);
        }
        for k in 0..12 {
            let Shape::Circle { center, .. } = *find(&format!("hodograph-a-tip-{}", 30 * k)) else {
                panic!("a mark is a dot")
            };
            assert!(((center - pole).hypot() - radius).abs() < 1e-6);
        }
    }
}

#[test]
fn limits_are_marked_where_the_way_runs_off() {
    let drawing = drawn(&files::read("examples/figure-2.json"), "v(D) a(E)");
    for name in ["a", "b"] {
        for (end, value) in [("low", "−137.58°"), ("high", "137.58°")] {
            let wanted = format!("hodograph-{name}-label-limit-{end}");
            let found = drawing.marks.iter().find(|mark| id(mark) == wanted);
            match found.map(|mark| &mark.shape) {
                Some(Shape::Text(text)) => {
                    assert_eq!(text.text.content().replace(' ', ""), format!("limit{value}"));
                }
                _ => panic!("no {wanted}"),
            }
        }
    }
    let strokes = drawing.marks.iter().filter(|mark| mark.pen == Pen::Zero);
    assert_eq!(strokes.count(), 4);
    // A drive that turns all the way round has none.
    let drawing = drawn(&files::read("templates/four-bar.json"), "v(C)");
    assert!(drawing.marks.iter().all(|mark| mark.pen != Pen::Zero));
}

#[test]
fn only_vectors_have_hodographs() {
    for (want, words) in [
        ("omega(2)", "`omega(2)` is no vector"),
        ("v(C).x", "`v(C).x` is no vector"),
        ("v(Q)", "no point `Q`"),
        ("v", "is no quantity"),
    ] {
        sampled(SLIDER_CRANK, want, |_, all| {
            let error = all.err().unwrap_or_else(|| panic!("{want} is taken"));
            assert!(error.contains(words), "{error}");
        });
    }
    let many = "v(A) v(B) v(C) a(A) a(B) a(C) v(B/C)";
    sampled(SLIDER_CRANK, many, |scene, all| {
        let error = hodographs(scene, &all.expect("vectors"), None).expect_err("too many");
        assert!(error.to_string().contains("room for 6"), "{error}");
    });
}

#[test]
fn nothing_covers_a_name() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for (name, text) in files::scenes("templates").into_iter().step_by(ALIKE.now()) {
        let scene: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        if scene.get("points").is_some() {
            continue;
        }
        let links = scene["links"].as_object().expect("links").iter();
        let points = links.flat_map(|(_, link)| match link["points"].as_array() {
            Some(points) => points.iter().filter_map(|p| p.as_str()).map(str::to_owned).collect(),
            None => Vec::new(),
        });
        let mut points: Vec<String> = points.collect();
        points.sort();
        points.dedup();
        points.retain(|point| scene["ground"].get(point).is_none());
        for (k, pair) in points.chunks(2).enumerate() {
            let mut scene = scene.clone();
            scene["figure"]["page"] = ["a4", "a4-portrait", "letter"][k % 3].into();
            let want: Vec<String> = pair.iter().map(|p| format!("v({p}) a({p})")).collect();
            let drawing = drawn(&scene.to_string(), &want.join(" "));
            let found = faults(&drawing);
            wrong.extend(found.iter().map(|fault| format!("{name} {pair:?}: {fault}")));
            count += 1;
        }
    }
    assert!(count * ALIKE.now() > 20, "{count}");
    // A number may lie on a curve that goes all round it.
    assert!(wrong.len() <= count / 10, "{} faults in {count}\n{}", wrong.len(), wrong.join("\n"));
}
