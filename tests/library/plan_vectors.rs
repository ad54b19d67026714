//! Vectors of plans as they are drawn: a head at the end of each, with values and without, from the step on in which it is known; arcs
//! of rates with their names; captions that say what they do.

use kinegon::construction::{Action, Ray, RayOf};
use kinegon::drawing::{Drawing, FigureSheets, Mark, Pen, Point, Shape, Steps, Vec2};
use kinegon::geometry::Vector;
use kinegon::scene::{LanguageName, Page, StyleName, ValuesShown};
use kinegon::{Order, Scene, Solution};
use support::faults::id;
use support::files;
use support::stages::solved;

fn scenes() -> Vec<(String, Solution)> {
    let all = ["templates", "examples", "tests/lecture"].into_iter().flat_map(files::scenes);
    let solved = all.filter_map(|(name, text)| Some((name, solved(&text).ok()?)));
    solved.collect()
}

/// The same with or without values.
fn with_values(solution: &Solution, values: ValuesShown) -> Solution {
    let mut own = solution.clone();
    own.scene.figure.values = Some(values);
    own
}

/// Names that are spelt otherwise in ids.
fn is_spelt(name: &str) -> bool {
    name.is_ascii() && !name.contains(|c: char| "'()/".contains(c))
}

/// The velocity or acceleration of a ray's point relative to its start, turned into the sheet.
fn carried(solution: &Solution, ray: &Ray) -> Vector {
    let plan = solution.construction.plan(ray.order).expect("a plan");
    let run = plan.points[&ray.to].vector - plan.points[&ray.through].vector;
    Vector::new(run.x, -run.y)
}

/// The arrow between two points of a plan, whichever way it points.
fn arrow<'a>(drawing: &'a Drawing, order: Order, [a, b]: [&str; 2]) -> Option<(&'a Mark, Vec2)> {
    let plan = order.sheet().as_str();
    let ids = [format!("{plan}-vector-{a}-{b}"), format!("{plan}-vector-{b}-{a}")];
    drawing.marks.iter().filter(|mark| ids.iter().any(|own| own == id(mark))).find_map(|mark| match mark.shape {
        Shape::Arrow { from, to, .. } => Some((mark, to - from)),
        _ => None,
    })
}

/// A dyad's ray carries the motion of its inner joint relative to the outer one: where nothing slides from the start of the ray
/// to the joint's image, along a guide one way or the other.
#[test]
fn what_a_ray_carries_has_a_head() {
    let mut seen = 0;
    for (name, solution) in scenes() {
        let solution = with_values(&solution, ValuesShown::Hidden);
        let drawing = solution.stepwise_figure();
        for step in solution.construction.numbered_steps() {
            let (Action::Cross { point, .. }, Some(plan)) = (step.action, step.plan) else { continue };
            for ray in solution.construction.rays(plan.order).filter(|ray| ray.to == *point) {
                let RayOf::Leg(special, side) = ray.of else { continue };
                let special = solution.construction.special(special);
                let is_from_pole = plan.points[&ray.through].vector.norm() == 0.0;
                if special.is_assur || is_from_pole || !(is_spelt(point) && is_spelt(&ray.through)) {
                    continue;
                }
                let wanted = carried(&solution, ray);
                if wanted.norm() < 1e-9 * plan.points.values().map(|p| p.vector.norm()).fold(0.0, f64::max) {
                    continue;
                }
                let slides = special.cuts[side].slide().is_some();
                let pen = if plan.order == Order::Velocity { Pen::Image } else { Pen::Tangential };
                let is_it = |mark: &&Mark| match mark.shape {
                    Shape::Arrow { from, to, .. } if usize::from(mark.since) == step.number => {
                        let along = to - from;
                        let cosine = (along.x * wanted.x + along.y * wanted.y) / (along.hypot() * wanted.norm());
                        cosine > 0.9999 && mark.pen == pen || slides && cosine.abs() > 0.9999 && mark.pen != pen
                    }
                    _ => false,
                };
                let found = drawing.marks.iter().find(is_it);
                assert!(found.is_some(), "{name}: no vector {} {point} from step {}", ray.through, step.number);
                seen += 1;
            }
        }
    }
    assert!(seen > 120, "{seen}");
}

/// The panel of steps is a little lower than that of the figure: the end of a part of an ordinary acceleration stays at its place.
#[test]
fn a_coriolis_acceleration_stays_at_its_place_in_all_steps() {
    let solution = solved(&files::read("tests/lecture/shaper2.json")).expect("it moves");
    let drawing = solution.stepwise_figure();
    let at = |name: &str| -> Point {
        let mark = drawing.marks.iter().find(|mark| id(mark) == format!("acceleration-point-{name}"));
        mark.unwrap_or_else(|| panic!("no point {name}")).shape.bounds().center()
    };
    let (mark, along) = arrow(&drawing, Order::Acceleration, ["k_a3", "a"]).expect("a vector");
    assert_eq!(mark.pen, Pen::Coriolis);
    assert!((along - (at("a") - at("k_a3"))).hypot() < 1e-6, "{mark:?}");
}

/// Of the sheet's arcs none is without its name, and that of an angular acceleration has a second line.
#[test]
fn arcs_of_rates_are_named_and_differ() {
    let (mut arcs, mut second) = (0, 0);
    for (name, solution) in scenes() {
        for (style, page) in [(StyleName::Paper, "a4"), (StyleName::Lecture, "16x9")] {
            let mut own = with_values(&solution, ValuesShown::Shown(None));
            (own.scene.figure.style, own.scene.figure.page) = (style, Page::from_name(page).expect("a page"));
            let drawing = own.figure();
            let texts = drawing.marks.iter().filter(|mark| id(mark).starts_with("scheme-"));
            let texts: Vec<String> = texts
                .filter_map(|mark| match &mark.shape {
                    Shape::Text(text) => Some(text.text.content().replace(' ', "")),
                    _ => None,
                })
                .collect();
            for mark in drawing.marks.iter().filter(|mark| matches!(mark.shape, Shape::ArcArrow { .. })) {
                let Some(rest) = id(mark).strip_prefix("scheme-") else { continue };
                let (symbol, link) = match rest.split_once('-') {
                    Some(("omega", link)) => ("ω", link),
                    Some(("alpha", link)) => ("α", link),
                    _ => panic!("{name}: {rest}"),
                };
                let symbol = format!("{symbol}{link}");
                let is_named = texts.iter().any(|text| text.split('=').any(|one| one == symbol));
                assert!(is_named, "{name} on {page}: no {symbol} in {texts:?}");
                let has_second = drawing.marks.iter().any(|other| id(other) == format!("{}-second", id(mark)));
                assert_eq!(has_second, symbol.starts_with('α'), "{name}: {symbol}");
                arcs += 1;
                second += usize::from(has_second);
            }
        }
    }
    assert!(arcs > 150 && second > 50, "{arcs} {second}");
}

/// The scissor's bars turn; the platform on them does not.
#[test]
fn rates_that_are_not_zero_are_shown_first() {
    let solution = solved(&files::read("tests/lecture/scissor.json")).expect("it moves");
    let drawing = with_values(&solution, ValuesShown::Shown(None)).figure();
    let shown = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) if id(mark).starts_with("scheme-") => Some(text.text.content().replace(' ', "")),
        _ => None,
    });
    let shown: Vec<String> = shown.collect();
    for wanted in ["ω1=0.0833rad/s", "ω2=−0.0833rad/s"] {
        assert!(shown.iter().any(|text| text == wanted), "{wanted}: {shown:?}");
    }
}

#[test]
fn captions_of_passages_name_what_they_do() {
    let mut wrong = Vec::new();
    for (name, solution) in scenes() {
        for language in LanguageName::ALL {
            let mut own = solution.clone();
            own.scene.figure.language = language;
            let steps = FigureSheets::new(&own).steps(Steps::Coarse).steps;
            let is_whole = |caption: &String| {
                let gaps = [": .", ": ,", ", ,", ", .", "  ", " .", "de a a "];
                !caption.trim().is_empty() && gaps.iter().all(|gap| !caption.contains(gap))
            };
            wrong.extend(
                steps.into_iter().filter(|caption| !is_whole(caption)).map(|caption| format!("{name}: {caption}")),
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The cross of an Oldham coupling slides in two discs: without an angle between its guides nothing holds it.
#[test]
fn parallel_guides_are_told() {
    let oldham = |turned: &str| {
        format!(
            r#"{{ "kinegon": 1, "units": {{ "length": "mm", "time": "s" }}, "ground": {{ "A": [0, 0], "B": [30, 0] }},
            "links": {{ "1": {{ "points": ["A"], "drive": {{ "angle": 40, "omega": 10 }} }}, "2": {{ "points": ["M"] }},
                        "3": {{ "points": ["B"] }} }},
            "sliders": [ {{ "link": "2", "at": "M", "on": "1", "along": 0 }},
                         {{ "link": "2", "at": "M", "on": "3", "along": 0 {turned} }} ],
            "near": {{ "M": [18, 15] }} }}"#
        )
    };
    let scene = |turned: &str| Scene::read(&oldham(turned)).expect("a good scene");
    let error = kinegon::solve(&scene("")).expect_err("it cannot be assembled").to_string();
    assert!(error.contains("the two guides that meet at link 2 are parallel") && error.contains("`turned`"), "{error}");
    let solution = kinegon::solve(&scene(r#", "turned": 90"#)).expect("it moves");
    // Both discs turn alike.
    let omega = |link: &str| solution.motion.body(solution.mechanism.link(link).expect("a link")).omega;
    assert!((omega("3") - 10.0).abs() < 1e-9, "{}", omega("3"));
}
