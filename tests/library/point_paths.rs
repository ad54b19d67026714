//! Paths of points over a cycle: they are the closed forms, cusps are sharp, double points cross, what is drawn is within 0.05 mm of them, and nothing is cut.

use kinegon::Solution;
use kinegon::cycle::{Animation, Drive, Path, PointPath, PointPaths, Traces};
use kinegon::drawing::{Drawing, Mark, Pen, Point, Shape, paths};
use kinegon::geometry;
use kinegon::scene::Scene;
use std::f64::consts::PI;
use support::faults::{MOST_BYTES, faults, id};
use support::files;
use support::stages::{solved, staged};
use support::survey::KINDS;

/// Lengths of a four-bar with a coupler point: ground A D, crank A B, coupler B C, rocker D C.
const GROUND: f64 = 160.0;
const CRANK: f64 = 60.0;
const COUPLER: f64 = 140.0;
const ROCKER: f64 = 110.0;

type Place = [f64; 2];

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1]]
}

fn distance(a: Place, b: Place) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

fn place(p: &geometry::Point) -> Place {
    [p.x, p.y]
}

/// Where two circles meet, on the left of the way from the first centre to the second.
fn meet(a: Place, r: f64, b: Place, s: f64) -> Place {
    let d = distance(a, b);
    let along = (d * d + r * r - s * s) / (2.0 * d);
    let height = (r * r - along * along).sqrt();
    let [ux, uy] = minus(b, a).map(|x| x / d);
    [a[0] + along * ux - height * uy, a[1] + along * uy + height * ux]
}

fn on_circle(centre: Place, radius: f64, degrees: f64) -> Place {
    let (sine, cosine) = libm::sincos(degrees * PI / 180.0);
    [centre[0] + radius * cosine, centre[1] + radius * sine]
}

/// B, C and the point with these coordinates along and across B C.
fn coupler_point(degrees: f64, own: Place) -> [Place; 3] {
    let b = on_circle([0.0, 0.0], CRANK, degrees);
    let c = meet(b, COUPLER, [GROUND, 0.0], ROCKER);
    let [ux, uy] = minus(c, b).map(|x| x / COUPLER);
    [b, c, [b[0] + own[0] * ux - own[1] * uy, b[1] + own[0] * uy + own[1] * ux]]
}

fn four_bar(angle: f64, own: Place, figure: &str) -> String {
    let [_, c, _] = coupler_point(angle, own);
    format!(
        r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "D": [{GROUND}, 0] }},
        "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": {CRANK} }}, "drive": {{ "angle": {angle}, "omega": 10 }} }},
          "2": {{ "points": ["B", "C", "P"], "shape": {{ "B": [0, 0], "C": [{COUPLER}, 0], "P": {own:?} }} }},
          "3": {{ "points": ["D", "C"], "lengths": {{ "CD": {ROCKER} }} }} }},
        "near": {{ "C": {c:?} }}, "figure": {figure} }}"#
    )
}

/// A scene with a figure that asks for this besides.
fn with_figure(text: &str, more: &str) -> String {
    let mut scene: serde_json::Value = serde_json::from_str(text).expect("JSON");
    let more: serde_json::Value = serde_json::from_str(more).expect("JSON");
    for (key, value) in more.as_object().expect("an object") {
        scene["figure"][key] = value.clone();
    }
    scene.to_string()
}

fn solution(text: &str) -> Solution {
    solved(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn traces(text: &str) -> Traces {
    Traces::new(&solution(text), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The path of the only point that a scene traces.
fn path_of(text: &str) -> PointPath {
    let mut traces = traces(text);
    assert_eq!(traces.paths.len(), 1);
    traces.paths.remove(0)
}

fn lecture(name: &str, more: &str) -> String {
    with_figure(&files::read(&format!("tests/lecture/{name}.json")), more)
}

/// The lines of a path on the sheet, and how a place of the scheme comes there: from the places of two points.
fn drawn_path(drawing: &Drawing, name: &str) -> Vec<Vec<Point>> {
    let of = |mark: &&Mark| id(mark).starts_with(&format!("scheme-{name}"));
    let lines = drawing.marks.iter().filter(of).map(|mark| match &mark.shape {
        Shape::Polyline(points) => points.clone(),
        other => panic!("{} is no line: {other:?}", id(mark)),
    });
    lines.collect()
}

fn on_sheet(drawing: &Drawing, [a, b]: [(&str, Place); 2]) -> impl Fn(Place) -> Point {
    let find = |name: &str| match drawing.marks.iter().find(|mark| id(mark) == format!("scheme-point-{name}")) {
        Some(Mark { shape: Shape::Circle { center, .. }, .. }) => *center,
        other => panic!("no point {name}: {other:?}"),
    };
    let (from, to) = (find(a.0), find(b.0));
    let scale = (to - from).hypot() / distance(a.1, b.1);
    move |p: Place| Point::new(from.x + scale * (p[0] - a.1[0]), from.y - scale * (p[1] - a.1[1]))
}

/// The distance of a point from a chain of lines.
fn off(chain: &[Point], p: Point) -> f64 {
    let to = |ends: &[Point]| {
        let (a, along) = (ends[0], ends[1] - ends[0]);
        let share = if along.hypot2() > 0.0 { ((p - a).dot(along) / along.hypot2()).clamp(0.0, 1.0) } else { 0.0 };
        (p - (a + along * share)).hypot()
    };
    chain.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_path_of_a_coupler_point_is_its_closed_form() {
    for own in [[70.0, 60.0], [-30.0, 80.0], [140.0, -50.0], [180.0, 0.0]] {
        let text = four_bar(40.0, own, r#"{ "trace": ["P"], "ghosts": 12 }"#);
        let path = path_of(&text);
        let [piece] = path.pieces.as_slice() else { panic!("{} pieces", path.pieces.len()) };
        for (value, p) in piece {
            let [_, _, truth] = coupler_point(*value, own);
            assert!(distance(place(p), truth) < 1e-10 * GROUND, "{value}: {p:?} instead of {truth:?}");
        }
        assert!((piece[piece.len() - 1].0 - piece[0].0 - 360.0).abs() < 1e-9);
        assert!(distance(place(&piece[0].1), place(&piece[piece.len() - 1].1)) < 1e-9);
        assert!(path.beyond.is_empty());
        // Ticks every 30° from the scene's own position, across the path.
        assert_eq!(path.ticks.len(), 12);
        for (k, tick) in path.ticks.iter().enumerate() {
            let value = 40.0 + 30.0 * k as f64;
            let [_, _, truth] = coupler_point(value, own);
            assert!(distance(place(&tick.place), truth) < 1e-9, "{k}");
            let [before, after] = [-1e-4, 1e-4].map(|by| coupler_point(value + by, own)[2]);
            let way = minus(after, before);
            let along = tick.along.expect("it moves");
            assert!((along.x * way[1] - along.y * way[0]).abs() < 1e-5 * libm::hypot(way[0], way[1]), "{k}");
        }
        // On paper no part of the curve is farther than 0.05 mm from the line.
        let drawing = solution(&text).figure();
        let lines = drawn_path(&drawing, "path-P");
        let [line] = lines.as_slice() else { panic!("{} lines", lines.len()) };
        let at = on_sheet(&drawing, [("A", [0.0, 0.0]), ("D", [GROUND, 0.0])]);
        for k in 0..20_000 {
            let truth = at(coupler_point(0.018 * f64::from(k), own)[2]);
            assert!(off(line, truth) < 0.05, "{truth:?} is {} mm away", off(line, truth));
        }
        assert!(line.len() < 600, "{} points", line.len());
    }
}

/// A point of the coupler in the instant centre of the coupler stands still and has a cusp there.
#[test]
fn a_point_in_the_instant_centre_has_a_sharp_cusp() {
    let at = 70.0;
    let [b, c, _] = coupler_point(at, [0.0, 0.0]);
    // The lines A B and D C meet there.
    let [dx, dy] = minus(c, [GROUND, 0.0]);
    let share = GROUND * dy / (b[0] * dy - b[1] * dx);
    let centre = b.map(|x| x * share);
    let [ux, uy] = minus(c, b).map(|x| x / COUPLER);
    let [x, y] = minus(centre, b);
    let own = [x * ux + y * uy, y * ux - x * uy];
    // The second scene has a tick exactly in the cusp.
    for start in [33.0, 10.0] {
        let text = four_bar(start, own, r#"{ "trace": ["P"] }"#);
        let drawing = solution(&text).figure();
        let to_sheet = on_sheet(&drawing, [("A", [0.0, 0.0]), ("D", [GROUND, 0.0])]);
        let cusp = to_sheet(centre);
        let line = drawn_path(&drawing, "path-P").swap_remove(0);
        let (index, nearest) = line
            .iter()
            .enumerate()
            .map(|(index, p)| (index, (*p - cusp).hypot()))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .expect("a line has points");
        assert!(nearest < 0.02, "the cusp is cut off by {nearest} mm");
        // A millimetre before and after, the line is on one side of the cusp, in a narrow wedge.
        let away = |step: i64| {
            let mut k = index as i64;
            while (line[k as usize] - cusp).hypot() < 1.0 {
                k = (k + step).rem_euclid(line.len() as i64 - 1);
            }
            (line[k as usize] - cusp).normalize()
        };
        let (before, after) = (away(-1), away(1));
        assert!(before.dot(after) > 0.95, "{before:?} and {after:?}");
        if start == 10.0 {
            let tick = path_of(&text).ticks[2];
            assert!(distance(place(&tick.place), centre) < 1e-9);
            let way = minus(coupler_point(at + 1e-3, own)[2], centre);
            let along = tick.along.expect("it has a tangent");
            let size = libm::hypot(way[0], way[1]);
            assert!((along.x * way[1] - along.y * way[0]).abs() < 1e-3 * size, "{along:?} along {way:?}");
        }
    }
}

/// Points of the rod of a trammel: ellipses, and on the circle over the rod straight lines through the crossing (Cardano).
#[test]
fn points_of_a_trammel_draw_ellipses_and_lines() {
    let scene = |a: f64, b: f64, near: Place| {
        let text = files::read("tests/lecture/trammel.json");
        let text = text.replace(r#""BP": 150, "AP": 150"#, &format!(r#""BP": {b}, "AP": {a}"#));
        let text = text.replace("[100, 110]", &format!("{near:?}"));
        with_figure(&text, r#"{ "trace": ["P"], "beyond_limits": true }"#)
    };
    // On the rod at 100 from A and 200 from B: half axes 200 and 100.
    let path = path_of(&scene(100.0, 200.0, [133.0, 74.0]));
    for (_, p) in path.pieces.iter().chain(&path.beyond).flatten() {
        let sum = (p.x / 200.0) * (p.x / 200.0) + (p.y / 100.0) * (p.y / 100.0);
        assert!((sum - 1.0).abs() < 1e-7, "{p:?}: {sum}");
    }
    let heights = |pieces: &[Vec<(f64, geometry::Point)>]| {
        let all = pieces.iter().flatten().map(|(_, p)| p.y);
        [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
    };
    // The upper half can be reached by the drive, the lower is beyond its limits.
    for (got, truth) in [(heights(&path.pieces), [0.0, 100.0]), (heights(&path.beyond), [-100.0, 0.0])] {
        assert!((got[0] - truth[0]).abs() < 0.01 && (got[1] - truth[1]).abs() < 0.01, "{got:?}");
    }
    // 180² + 240² = 300²: a straight line of twice the rod's length, which the point goes up and down.
    let path = path_of(&scene(180.0, 240.0, [250.0, 160.0]));
    let first = path.pieces[0][0].1;
    let (dx, dy) = (first.x / first.coords.norm(), first.y / first.coords.norm());
    let all = path.pieces.iter().chain(&path.beyond).flatten();
    let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
    for (_, p) in all {
        assert!((p.x * dy - p.y * dx).abs() < 1e-6, "{p:?} is off the line");
        let along = p.x * dx + p.y * dy;
        ends = [ends[0].min(along), ends[1].max(along)];
    }
    assert!((ends[0] + 300.0).abs() < 1e-2 && (ends[1] - 300.0).abs() < 1e-2, "{ends:?}");
}

/// Watt's curve about the middle of the ground: r² = b² − (a sin θ ± √(c² − a² cos² θ))², with half the ground a, the
/// levers b, half the coupler c.
#[test]
fn watt_s_figure_of_eight_crosses_itself() {
    let text = lecture("watt", r#"{ "trace": ["M"], "beyond_limits": true }"#);
    let path = path_of(&text);
    let (middle, [ux, uy]) = ([100.0, 40.0], [200.0, 80.0].map(|x| x / libm::hypot(200.0, 80.0)));
    let (a, b, c) = (0.5 * libm::hypot(200.0, 80.0), 100.0, 40.0);
    for (_, p) in path.pieces.iter().chain(&path.beyond).flatten() {
        let [x, y] = minus(place(p), middle);
        let (along, across) = (x * ux + y * uy, y * ux - x * uy);
        let r = libm::hypot(x, y);
        // Times r², without the angle: (a·across ± √(c² r² − a² along²))² = (b² − r²) r².
        let root = (c * c * r * r - a * a * along * along).max(0.0).sqrt();
        let left = [1.0, -1.0].map(|sign| (a * across + sign * root) * (a * across + sign * root));
        let right = (b * b - r * r) * r * r;
        let least = left.map(|left| (left - right).abs()).into_iter().fold(f64::INFINITY, f64::min);
        assert!(least < 1e-5 * b * b * b * b, "{p:?}: {least}");
    }
    // Both halves together are closed, and each goes once through the middle, one across the other.
    let ([own], [other]) = (path.pieces.as_slice(), path.beyond.as_slice()) else { panic!("two halves") };
    let ends = |piece: &[(f64, geometry::Point)]| [place(&piece[0].1), place(&piece[piece.len() - 1].1)];
    for (one, two) in ends(own).into_iter().zip(ends(other)) {
        assert!(distance(one, two) < 1e-3, "{one:?} and {two:?}");
    }
    let directions = [own, other].map(|half| {
        let near = half.windows(2).filter(|pair| {
            let sides = [pair[0].1, pair[1].1].map(|p| (p.x - middle[0]) * uy - (p.y - middle[1]) * ux);
            let close = distance(place(&pair[0].1), middle) < 5.0;
            close && sides[0].signum() != sides[1].signum() || distance(place(&pair[0].1), middle) < 0.02
        });
        let pair = near.clone().next().expect("it goes through the middle");
        let p = place(&pair[0].1);
        assert!(distance(p, middle) < 1.0, "{p:?}");
        let way = minus(place(&pair[1].1), p);
        way.map(|x| x / libm::hypot(way[0], way[1]))
    });
    let sine = directions[0][0] * directions[1][1] - directions[0][1] * directions[1][0];
    assert!(sine.abs() > 0.3, "{directions:?}");
    // On paper both are whole within the panel.
    let drawing = solution(&text).figure();
    assert_eq!((drawn_path(&drawing, "path-M").len(), drawn_path(&drawing, "beyond-M").len()), (1, 1));
}

/// Jansen's foot by circles alone.
fn foot(degrees: f64) -> Place {
    let z = [-38.0, -7.8];
    let a = on_circle([0.0, 0.0], 15.0, degrees);
    // Left of the way from the first centre to the second, as the leg stands.
    let b = meet(z, 41.5, a, 50.0);
    let d = meet(a, 61.9, z, 39.3);
    let c = meet(z, 40.1, b, 55.8);
    let e = meet(d, 36.7, c, 39.4);
    meet(d, 49.0, e, 65.7)
}

#[test]
fn jansen_s_foot_is_where_circles_meet() {
    let text = lecture("jansen", r#"{ "trace": ["F"], "ghosts": 12 }"#);
    let all = traces(&text);
    let path = &all.paths[0];
    for (value, p) in path.pieces.iter().flatten() {
        assert!(distance(place(p), foot(*value)) < 1e-9, "{value}: {p:?} instead of {:?}", foot(*value));
    }
    assert_eq!((path.pieces.len(), path.ticks.len(), path.beyond.len()), (1, 12, 0));
    // Ghosts are at the ticks.
    assert_eq!(all.ghosts.len(), 11);
    for (ghost, tick) in all.ghosts.iter().zip(&path.ticks[1..]) {
        assert!((ghost.point(path.point) - tick.place).norm() < 1e-9);
    }
    let times = all.times.expect("ticks are at equal times");
    assert!((times.step - 30.0).abs() < 1e-12);
    // 30° at 6 rad/s.
    assert!((times.time.expect("it turns") - PI / 36.0).abs() < 1e-12);
}

/// With the second drive at half the speed of the first, a five-bar is where it began after two turns of the first.
#[test]
fn a_cycle_lasts_as_many_turns_as_the_mechanism_needs() {
    let scene = |second: f64| {
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "E": [100, 0] }},
            "links": {{ "1": {{ "points": ["A", "B"], "lengths": {{ "AB": 30 }}, "drive": {{ "angle": 20, "omega": 4 }} }},
              "2": {{ "points": ["B", "C"], "lengths": {{ "BC": 110 }} }}, "3": {{ "points": ["C", "D"], "lengths": {{ "CD": 120 }} }},
              "4": {{ "points": ["E", "D"], "lengths": {{ "ED": 25 }}, "drive": {{ "angle": 80, "omega": {second} }} }} }},
            "near": {{ "C": [60, 100] }}, "figure": {{ "trace": ["C"], "ghosts": 8 }} }}"#
        )
    };
    for (second, turns) in [(4.0, 1.0), (-2.0, 2.0), (3.0, 4.0)] {
        let all = traces(&scene(second));
        let [piece] = all.paths[0].pieces.as_slice() else { panic!("one piece") };
        let (first, last) = (piece[0], piece[piece.len() - 1]);
        assert!((last.0 - first.0 - 360.0 * turns).abs() < 1e-9, "{second}: {}", last.0 - first.0);
        assert!((last.1 - first.1).norm() < 1e-9);
        assert_eq!((all.paths[0].ticks.len(), all.ghosts.len()), (12 * turns as usize, 7));
        for (value, p) in piece {
            let b = on_circle([0.0, 0.0], 30.0, *value);
            let d = on_circle([100.0, 0.0], 25.0, 80.0 + (value - 20.0) * second / 4.0);
            assert!(distance(place(p), meet(b, 110.0, d, 120.0)) < 1e-9);
        }
    }
    // Without a common period one turn is shown, which does not close.
    let all = traces(&scene(4.0 / 2.0_f64.sqrt()));
    let piece = &all.paths[0].pieces[0];
    assert!((piece[piece.len() - 1].0 - piece[0].0 - 360.0).abs() < 1e-9);
}

#[test]
fn nothing_is_computed_or_drawn_unless_it_is_asked_for() {
    let text = files::read("tests/lecture/jansen.json");
    let none = traces(&text);
    assert!(none.paths.is_empty() && none.ghosts.is_empty() && none.times.is_none());
    let has = |drawing: &Drawing, pen| drawing.marks.iter().any(|mark| mark.pen == pen);
    let plain = solution(&text).figure();
    assert!(!has(&plain, Pen::Trace) && !has(&plain, Pen::Ghost));
    let ghosts = solution(&with_figure(&text, r#"{ "ghosts": 6 }"#)).figure();
    assert!(!has(&ghosts, Pen::Trace) && has(&ghosts, Pen::Ghost));
}

#[test]
fn ghosts_lie_lowest_then_paths_then_the_mechanism() {
    let drawing = solution(&lecture("jansen", r#"{ "trace": ["F"], "ghosts": 6 }"#)).figure();
    let places =
        |pen| drawing.marks.iter().enumerate().filter(move |(_, mark)| mark.pen == pen).map(|(index, _)| index);
    let last = |pen| places(pen).max().expect("it is there");
    let first = |pen| places(pen).min().expect("it is there");
    assert!(last(Pen::Ghost) < first(Pen::Trace));
    assert!(last(Pen::Trace) < first(Pen::Link));
}

#[test]
fn a_path_belongs_to_all_steps_and_to_all_frames() {
    let own = solution(&lecture("jansen", r#"{ "trace": ["F"], "ghosts": 4 }"#));
    let first = own.stepwise_figure().after_step(1);
    assert_eq!(drawn_path(&first, "path-F").len(), 1);
    let animation = Animation::new(&own, None, 8).expect("it moves");
    let drawings = staged(&animation.positions, animation.own);
    assert!(drawings.len() >= 8);
    let traced = |drawing: &Drawing| -> Vec<Mark> {
        let of = |pen| matches!(pen, Pen::Trace | Pen::Ghost);
        drawing.marks.iter().filter(|mark| of(mark.pen)).cloned().collect()
    };
    let lines = traced(&drawings[0]);
    assert!(lines.len() > 12);
    assert!(drawings.iter().all(|drawing| traced(drawing) == lines));
    // The foot is on the path in every frame.
    let line = drawn_path(&drawings[0], "path-F").swap_remove(0);
    for drawing in &drawings {
        let foot = drawing.marks.iter().find(|mark| id(mark) == "scheme-point-F").expect("the foot");
        let Shape::Circle { center, .. } = foot.shape else { panic!("a dot") };
        assert!(off(&line, center) < 0.05);
    }
}

/// All points that move, of every starting scene, in turn with ghosts and in other styles.
#[test]
fn nothing_is_cut_and_nothing_covers_a_name() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (index, (name, text)) in
        files::scenes("templates").into_iter().chain(files::scenes("tests/lecture")).enumerate().step_by(KINDS.now())
    {
        let scene: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        if scene.get("points").is_some() || scene.get("links").is_none() {
            continue;
        }
        let Ok(read) = Scene::read(&text) else { continue };
        let mut points: Vec<&String> = read.links.values().flat_map(|link| &link.points).collect();
        points.sort();
        points.dedup();
        points.retain(|point| !read.ground.contains(point));
        let style = ["paper", "lecture", "board", "print"][index % 4];
        let figure = serde_json::json!({ "trace": points, "style": style, "ghosts": 2 + index % 9, "beyond_limits": index % 2 == 0 });
        let Ok(solution) = solved(&with_figure(&text, &figure.to_string())) else { continue };
        let all = Traces::new(&solution, None).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(all.paths.len(), points.len());
        let before = solved(&text).expect("a scene").figure();
        let known = faults(&before);
        let drawing = solution.figure();
        let found = faults(&drawing).into_iter().filter(|fault| !known.contains(fault));
        wrong.extend(found.map(|fault| format!("{name}: {fault}")));
        // Clipped lines would be in pieces that end on the border.
        let [(_, frame), ..] = drawing.panels.as_slice() else { panic!("{name}: no panel") };
        let inside = frame.inflate(-3.0, -3.0);
        let is_traced = |mark: &&Mark| matches!(mark.pen, Pen::Trace | Pen::Beyond | Pen::Ghost);
        for mark in drawing.marks.iter().filter(is_traced) {
            if inside.union(mark.shape.bounds()) != inside {
                wrong.push(format!("{name}: {} is at the border", id(mark)));
            }
        }
        let lines = drawing.marks.iter().filter(|mark| matches!(mark.shape, Shape::Polyline(_)) && is_traced(mark));
        let pieces = all.paths.iter().map(|path| path.pieces.len() + path.beyond.len());
        assert_eq!(lines.count(), pieces.sum::<usize>(), "{name}");
        assert!(drawing.svg().len() < 4 * MOST_BYTES, "{name}: {}", drawing.svg().len());
        count += 1;
    }
    assert!(count > 20 / KINDS.now(), "{count}");
    // Of a crowd in the large letters of a lecture not all names have a free place on A4.
    assert!(wrong.len() <= count, "{} faults in {count}\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_chart_of_a_path_has_one_scale_and_true_numbers() {
    let own = [70.0, 60.0];
    let text = four_bar(40.0, own, "{}");
    let Solution { scene, mechanism, pose, .. } = solution(&text);
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a drive")).expect("it moves");
    path.cover(None, None).expect("it turns");
    path.follow_to(0.0);
    let names = ["P".to_owned(), "C".to_owned()];
    let all = PointPaths::new(&path, [0.0, 360.0], &names).expect("points");
    let drawing = paths(&scene, &all, None).expect("it fits");
    assert_eq!(faults(&drawing), Vec::<String>::new());
    let centre = |wanted: &str| match drawing.marks.iter().find(|mark| id(mark) == wanted).map(|mark| &mark.shape) {
        Some(Shape::Circle { center, .. }) => *center,
        other => panic!("{wanted}: {other:?}"),
    };
    // The dots at round angles, from two of which the scale follows.
    let dot = |k: i32| centre(&format!("path-a-tip-{}", 30 * k));
    let truth = |k: i32| coupler_point(30.0 * f64::from(k), own)[2];
    let scale = (dot(6).x - dot(0).x) / (truth(6)[0] - truth(0)[0]);
    let at = |p: Place| Point::new(dot(0).x + scale * (p[0] - truth(0)[0]), dot(0).y - scale * (p[1] - truth(0)[1]));
    for k in 0..12 {
        assert!((dot(k) - at(truth(k))).hypot() < 1e-6, "{k}");
    }
    assert!((centre("path-a-own") - at(coupler_point(40.0, own)[2])).hypot() < 1e-6);
    // A point of the ground, a special point and nothing at all have no path.
    for name in ["A", "S2", "Q"] {
        let error = PointPaths::new(&path, [0.0, 360.0], &[name.to_owned()]).err();
        let error = error.unwrap_or_else(|| panic!("{name} is taken")).to_string();
        assert!(error.contains("no point of a link that moves"), "{error}");
    }
}
