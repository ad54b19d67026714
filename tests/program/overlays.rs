//! A student's drawing over the right figure: nothing covers a name, crosses and lines are where the student has them, and the words tell what went wrong.

use kinegon::Solution;
use kinegon::check::{self, Checked, Measured, Mistake, PointsOf, Student};
use kinegon::drawing::{Drawing, Emphasis, Mark, Overlay, OwnKind, Pen, Point, Shape, Vec2, overlay};
use kinegon::scene::PageSize;
use kinegon::{Order, Sheet};
use support::faults::{faults, id};
use support::files;
use support::program::{kinegon, scratch, stderr};
use support::stages::{answer_key, solved};

fn solution(scene: &str) -> Solution {
    solved(&files::read(scene)).expect("a good scene")
}

/// The sheets of a student's values, and what they are drawn from.
struct Drawings {
    sheets: Vec<Drawing>,
    own: Overlay,
    checked: Checked,
}

/// The sheets at the scene's scales, else at the student's.
fn drawn(mut solution: Solution, measured: &Measured, depth: usize) -> Drawings {
    let (own, checked) = {
        let right = answer_key(&solution, depth);
        let checked = check::check(measured, &right).expect("values that are understood");
        let own = check::redrawn(measured, &right, &checked);
        (own.expect("scales are there"), checked)
    };
    let figure = &mut solution.scene.figure;
    figure.mu = figure.mu.or(measured.mu);
    let sheets = overlay(&solution, &own);
    Drawings { sheets, own, checked }
}

/// The values of somebody who makes one mistake in one of its ways and is exact elsewhere but for what a ruler shows.
fn with_mistake(solution: &Solution, mistake: Mistake, way: usize) -> Measured {
    let right = answer_key(solution, 1);
    let student = Student::new(&right).expect("all sheets");
    let ways = student.ways(mistake);
    student.draw(&[&ways[way]], [0.05, 0.05], &mut || 0.3, &[])
}

fn paper() -> Measured {
    let text = files::read("examples/paper-as-student.json");
    Measured::read_json(&text).expect("a good form")
}

/// Figure 2 at scales at which everything has room beside the words.
fn figure_2() -> Solution {
    let mut solution = solution("examples/figure-2.json");
    for (sheet, mu) in [(Sheet::Scheme, 5.0), (Sheet::Velocity, 2.0), (Sheet::Acceleration, 2.5)] {
        solution.scene.figure.mu[sheet] = Some(mu);
    }
    solution
}

const FOUR_BAR: &str = "templates/four-bar.json";

/// Places of the plan points of a four-bar on a sheet that is turned by 12°, its point c in the velocity plan moved by `moved` mm.
fn points(solution: &Solution, moved: [f64; 2]) -> Measured {
    let (sin, cos) = libm::sincos(12.0_f64.to_radians());
    let scales = answer_key(solution, 1).scales;
    let points = solution.construction.plans().map(|plan| {
        let mu = scales[plan.sheet()].expect("a panel");
        let names = [plan.order.pole(), "b", "c"];
        let places = names.map(|name| {
            let v = plan.points[name].vector / mu;
            let mut at = [v.x, v.y];
            if name == "c" && plan.order == Order::Velocity {
                at = [at[0] + moved[0], at[1] + moved[1]];
            }
            let [x, y] = at;
            let turned = [30.0 + cos * x - sin * y, 50.0 + sin * x + cos * y];
            (name.to_owned(), turned)
        });
        let mut points = PointsOf::new(plan.order);
        places.into_iter().for_each(|(name, at)| points.put(name, at, None));
        points
    });
    Measured { mu: scales, points: points.collect(), ..Measured::default() }
}

#[test]
fn no_name_lies_on_another() {
    let mut all = vec![
        ("the paper".to_owned(), drawn(solution("examples/figure-2.json"), &paper(), 5)),
        ("the paper with room".to_owned(), drawn(figure_2(), &paper(), 5)),
    ];
    for (scene, mistake, way) in [
        ("four-bar", Mistake::TurnedRay, 0),
        ("four-bar", Mistake::TurnedRay, 2),
        ("four-bar", Mistake::OtherMode, 0),
        ("slider-crank", Mistake::TurnedVector, 0),
        ("third-class", Mistake::RayFromWrongPoint, 0),
        ("third-class", Mistake::WrongLines, 0),
        ("third-class", Mistake::OtherMode, 0),
        ("fourth-class", Mistake::WrongSegment, 0),
    ] {
        let own = solution(&format!("templates/{scene}.json"));
        let measured = with_mistake(&own, mistake, way);
        let name = format!("{scene}, {} {way}", mistake.id());
        all.push((name, drawn(own, &measured, 1)));
    }
    for (name, moved) in [("points", [0.0, 0.0]), ("a wrong point", [9.0, -14.0])] {
        let measured = points(&solution(FOUR_BAR), moved);
        all.push((name.to_owned(), drawn(solution(FOUR_BAR), &measured, 1)));
    }
    let mut large = solution(FOUR_BAR);
    large.scene.figure.page.size = PageSize::A3;
    let measured = with_mistake(&large, Mistake::TurnedRay, 1);
    all.push(("large".to_owned(), drawn(large, &measured, 1)));
    for (name, Drawings { sheets, .. }) in all {
        for (number, sheet) in sheets.iter().enumerate() {
            let faults = faults(sheet);
            // Of a crowd a name may touch the factor of its enlargement; at the paper's own scales two heads at s3 reach the panel's heading.
            assert!(faults.len() <= if name == "the paper" { 2 } else { 1 }, "{name}, sheet {number}: {faults:?}");
        }
    }
}

/// The crossing of two lines, each through a place along a direction.
fn crossing([p, d]: [[f64; 2]; 2], [q, e]: [[f64; 2]; 2]) -> [f64; 2] {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let t = cross([q[0] - p[0], q[1] - p[1]], e) / cross(d, e);
    [p[0] + t * d[0], p[1] + t * d[1]]
}

#[test]
fn a_turned_ray_ends_where_geometry_says() {
    let solution = solution(FOUR_BAR);
    let place = |name: &str| {
        let point = solution.mechanism.point(name).expect("it is there");
        let place = solution.pose.point(point);
        [place.x, place.y]
    };
    let [a, b, c, d] = ["A", "B", "C", "D"].map(place);
    // Velocity of B: ω × AB. The ray from b ran along BC in place of normal to it; the one from the pole is normal to DC.
    let v_b = [-10.0 * (b[1] - a[1]), 10.0 * (b[0] - a[0])];
    let along = [c[0] - b[0], c[1] - b[1]];
    let normal = [-(c[1] - d[1]), c[0] - d[0]];
    let want = crossing([v_b, along], [[0.0, 0.0], normal]);

    let measured = with_mistake(&solution, Mistake::TurnedRay, 0);
    let Drawings { sheets, own, .. } = drawn(solution, &measured, 1);
    let mut found = own.points.iter();
    let found = found.find(|p| p.panel == Sheet::Velocity && p.name == "c");
    let at = found.expect("c is elsewhere").at;
    let apart = libm::hypot(at.x - want[0], at.y - want[1]);
    assert!(apart < 1e-6, "{at:?} for {want:?}");
    // The line from b to it is drawn to scale and whole: the scale of the sheet is finer than the scene's, so that it has room.
    let marks = &sheets[0].marks;
    let own_lines = marks.iter().filter_map(|mark| match mark.shape {
        Shape::Line(p, q) | Shape::Arrow { from: p, to: q, .. } if mark.pen == Pen::Student => {
            id(mark).starts_with("velocity-").then_some((p, q))
        }
        _ => None,
    });
    let [pole, b] = ["p", "b"].map(|name| circle(&sheets[0], &format!("velocity-point-{name}")));
    let per_unit = (b - pole).hypot() / libm::hypot(v_b[0], v_b[1]);
    let end = pole + Vec2::new(want[0], -want[1]) * per_unit;
    let is_at = |p: &Point, q: &Point| (*p - *q).hypot() < 1e-6;
    let mut from_b = own_lines.filter(|(p, q)| is_at(p, &b) && is_at(q, &end) || is_at(p, &end) && is_at(q, &b));
    let (p, q) = from_b.next().expect("the ray from b");
    let slope = (q - p).cross(Vec2::new(along[0], -along[1])).abs();
    assert!(slope < 1e-6 * (q - p).hypot() * libm::hypot(along[0], along[1]));
    // The right ray is in the accent colour, and the step beside it.
    let ray = mark(&sheets[0], "velocity-ray-b-c");
    assert_eq!(ray.emphasis, Emphasis::New);
    let other = mark(&sheets[0], "velocity-ray-d-c");
    assert_eq!(other.emphasis, Emphasis::Earlier);
    assert_eq!(text(&sheets[0], "velocity-label-step-3"), "Step 3");
}

fn mark<'a>(drawing: &'a Drawing, name: &str) -> &'a Mark {
    let mut marks = drawing.marks.iter();
    let found = marks.find(|mark| id(mark) == name);
    found.unwrap_or_else(|| panic!("there is no {name}"))
}

fn circle(drawing: &Drawing, name: &str) -> Point {
    mark(drawing, name).shape.bounds().center()
}

fn text(drawing: &Drawing, name: &str) -> String {
    match &mark(drawing, name).shape {
        Shape::Text(text) => text.text.content(),
        other => panic!("{name} is {other:?}"),
    }
}

#[test]
fn points_from_paper_lie_over_the_right_ones() {
    let right = |solution: &Solution, kind: Sheet, name: &str| {
        solution.construction.plan_on(kind).expect("a plan").points[name].vector
    };
    let base = solution(FOUR_BAR);
    let exact = drawn(solution(FOUR_BAR), &points(&base, [0.0, 0.0]), 1);
    assert_eq!(exact.own.points.len(), 6);
    for point in &exact.own.points {
        let kind = match point.panel {
            Sheet::Velocity => Sheet::Velocity,
            _ => Sheet::Acceleration,
        };
        let apart = (point.at.coords - right(&base, kind, &point.name)).norm();
        assert!(apart < 1e-9 * point.at.coords.norm().max(1.0), "{point:?}");
        assert!(!point.is_named, "{point:?}");
    }
    assert!(exact.own.lines.is_empty() && exact.own.steps.is_empty());
    let said = exact.own.words.join(" ");
    assert!(said.contains("Nothing is off: "), "{said}");
    // 12° are more than anybody sees by eye.
    assert!(said.contains("turned by −12°"), "{said}");

    let moved = [9.0, -14.0];
    let measured = points(&base, moved);
    let mu = measured.mu[Sheet::Velocity].expect("a scale");
    let wrong = drawn(solution(FOUR_BAR), &measured, 1);
    for point in wrong.own.points.iter().filter(|p| p.panel == Sheet::Velocity) {
        let apart = (point.at.coords - right(&base, Sheet::Velocity, &point.name)) / mu;
        let is_c = point.name == "c";
        assert_eq!(point.is_named, is_c, "{point:?}");
        let want = if is_c { moved } else { [0.0, 0.0] };
        // The one wrong point turns the sheet by less than a drawn line is wide.
        let off = libm::hypot(apart.x - want[0], apart.y - want[1]);
        assert!(off < 0.3, "{point:?}: {apart:?}");
    }
}

#[test]
fn a_measured_component_is_drawn_and_slips_of_writing_are_not() {
    let solution = figure_2();
    let special = solution.construction.special_point("S3").expect("S3");
    let s3 = special.place.finite().expect("it is near");
    let b = solution.pose.point(solution.mechanism.point("B").expect("B"));
    let Drawings { sheets, own, checked } = drawn(solution, &paper(), 5);
    assert_eq!(checked.diagnosis.best.findings.len(), 4);
    let drawn: Vec<_> = own.lines.iter().filter(|l| l.kind != OwnKind::Helper).collect();
    let [line] = drawn.as_slice() else {
        panic!("{drawn:?}");
    };
    let [from, to] = line.ends;
    assert!((from - b).norm() < 1e-9 && to.y == from.y);
    assert!((to.x - s3.x).abs() < 1e-9);
    assert_eq!(line.label.as_deref(), Some("248.1 mm"));
    assert_eq!(line.panel, Sheet::Scheme);
    assert!(own.points.is_empty());
    // On paper: its length to scale, its right counterpart under it, the words of all four steps.
    let Shape::Line(p, q) = mark(&sheets[0], "scheme-student-line-1").shape else {
        panic!("a line");
    };
    assert!(((q - p).hypot() - (s3.x - b.x).abs() / 5.0).abs() < 1e-9);
    for (panel, step) in [("scheme", 2), ("velocity", 8), ("acceleration", 41)] {
        let name = format!("{panel}-label-step-{step}");
        assert_eq!(text(&sheets[0], &name), format!("Step {step}"));
    }
    let hints = sheets[0].marks.iter().filter(|m| m.pen == Pen::Hint);
    let ends = hints.filter_map(|m| match m.shape {
        Shape::Line(a, b) => Some((b - a).hypot()),
        _ => None,
    });
    let right = (s3 - b).norm() / 5.0;
    assert!(ends.into_iter().any(|size| (size - right).abs() < 1e-9));
    let said = own.words.join(" ");
    for part in ["Step 2: for B S3", "Step 8", "137.7597 for 137.7579", "Step 41", "−25.6695"] {
        assert!(said.contains(part), "no {part} in {said}");
    }
    // The table has all values, those that are off in the accent colour.
    let off = own.values.iter().filter(|v| v.is_off).count();
    assert_eq!((own.values.len(), off), (29, 3));
    let table = &sheets[1];
    assert_eq!(text(table, "value-1-own"), "248.0601");
    assert_eq!(text(table, "value-1-verdict"), "OFF");
    assert_eq!(mark(table, "value-1-verdict").emphasis, Emphasis::New);
}

#[test]
fn the_program_writes_sheets_and_keeps_its_inputs() {
    let folder = scratch("overlays");
    let form = folder.join("mine.json");
    let text = r#"{ "kinegon_measured": 1, "mu_v": 5, "values": { "vplan(b,c)": 381.7 } }"#;
    std::fs::write(&form, text).expect("it can be written");
    let scene = files::path(FOUR_BAR);
    let run = |more: &[&str]| {
        let mut command = kinegon();
        command.arg("check").arg(&scene).arg(&form).args(more);
        command.output().expect("it runs")
    };
    let to = folder.join("drawn");
    let to = to.to_str().expect("a plain path");
    let output = run(&["--draw", to, "--format", "svg,tikz", "--language", "es"]);
    assert!(stderr(&output).is_empty(), "{}", stderr(&output));
    assert!(!output.stdout.is_empty());
    let written = |name: &str| std::fs::read_to_string(format!("{to}/{name}")).expect(name);
    assert!(written("mine-check.svg").contains("Plano de velocidades"));
    assert!(written("mine-check.tex").contains("tikzpicture"));
    for (more, says) in [
        (&["--draw", "-"][..], "the report is on stdout"),
        (&["--draw", to, "--format", "html"], "no page to step through"),
        (&["--draw", form.to_str().expect("a plain path")], "no format for files"),
    ] {
        let output = run(more);
        assert_eq!(output.status.code(), Some(2), "{more:?}");
        assert!(stderr(&output).contains(says), "{}", stderr(&output));
    }
    assert_eq!(std::fs::read_to_string(&form).expect("it is there"), text);
}
