//! Sheets for a lecture hall and scales of a cycle: letters are large, nothing touches them, all sheets of a scene have one set of scales,
//! no pole is cut off, and a panel whose content is cut says so.

use kinegon::Sheet;
use kinegon::construction::Aim;
use kinegon::cycle::Animation;
use kinegon::drawing::{Drawing, Mark, Pen, Shape};
use kinegon::scene::{Figure, Page, ScalesFor, StyleName};
use kinegon::{Scene, Solution};
use std::collections::BTreeSet;
use support::faults::{faults, id, panels};
use support::files;
use support::stages::staged;
use support::survey::{HALL, HALL_SHEETS, SCALES_OF_A_CYCLE};

fn solved_as(text: &str, asked: impl Fn(&mut Figure)) -> Solution {
    let mut scene = Scene::read(text).expect("a good scene");
    asked(&mut scene.figure);
    kinegon::solve(&scene).expect("it moves")
}

fn page(name: &str) -> Page {
    Page::from_name(name).expect("it is a page")
}

/// Letters on the baseline in em, nested ones included, over the height of the sheet, in per cent: the smallest.
fn smallest(drawing: &Drawing) -> [f64; 2] {
    let runs = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.runs().map(|run| (run.size, text.size)).collect::<Vec<_>>()),
        _ => None,
    });
    let all: Vec<(f64, f64)> = runs.flatten().collect();
    let least = |sizes: &mut dyn Iterator<Item = f64>| 100.0 * sizes.fold(f64::INFINITY, f64::min) / drawing.height;
    [least(&mut all.iter().map(|(_, size)| *size)), least(&mut all.iter().map(|(run, _)| *run))]
}

#[test]
fn letters_in_a_hall_are_large_and_free() {
    let mut wrong = Vec::new();
    let surfaces = ["16x9", "a4"].into_iter().flat_map(|sheet| {
        let all = [None, Some(Sheet::Velocity), Some(Sheet::Acceleration), Some(Sheet::Scheme)];
        all.map(|focus| (sheet, focus))
    });
    let templates = files::templates();
    let all = templates.iter().flat_map(|scene| surfaces.clone().map(move |surface| (scene, surface)));
    for ((name, text), (sheet, focus)) in all.step_by(HALL_SHEETS.now()) {
        let solution = solved_as(text, |figure| {
            (figure.style, figure.page, figure.focus) = (StyleName::Lecture, page(sheet), focus);
        });
        let drawing = solution.figure();
        let [letters, scripts] = smallest(&drawing);
        if letters < 3.5 || scripts < 1.75 {
            wrong.push(format!("{name} on {sheet}: letters of {letters:.2} %, scripts of {scripts:.2} %"));
        }
        // That names have no room is said where it is in nobody's way, if there is such a place.
        let what: Vec<String> = faults(&drawing).into_iter().filter(|what| !what.contains("-unlabelled")).collect();
        wrong.extend(what.iter().map(|what| format!("{name} on {sheet}, focus {focus:?}: {what}")));
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

/// The texts of the scales, by panel.
fn scales(drawing: &Drawing) -> Vec<String> {
    let texts = drawing.marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Text(text) => Some(text.text.content()),
        _ => None,
    });
    texts.filter(|text| text.starts_with('=') && text.ends_with("/mm")).collect()
}

/// Figure, steps and coarse steps have the same scales where that makes none of them much smaller. A work sheet has those
/// of the hand, 1, 2, 2.5, 5; what is projected says how long a value is, not how many millimetres.
#[test]
fn sheets_of_a_scene_have_the_same_scales_where_that_is_cheap() {
    let number = |text: &String| -> f64 {
        text.split_whitespace().nth(1).and_then(|number| number.parse().ok()).expect("a number")
    };
    let mut shared = 0;
    for (name, text) in files::templates() {
        let solution = solved_as(&text, |_| ());
        let all = [solution.figure(), solution.stepwise_figure(), solution.coarse_figure()].map(|sheet| scales(&sheet));
        assert!(all.iter().all(|scales| scales.len() == solution.scene.figure.panels.len()), "{name}: {all:?}");
        let is_same = all.iter().all(|scales| *scales == all[0]);
        let ratio = |panel: usize| {
            let own = all.each_ref().map(|scales| number(&scales[panel]));
            own.into_iter().fold(0.0, f64::max) / own.into_iter().fold(f64::INFINITY, f64::min)
        };
        assert!(is_same || (0..all[0].len()).any(|panel| ratio(panel) > 1.2), "{name}: {all:?}");
        shared += usize::from(is_same);
        let worksheet = solved_as(&text, |figure| figure.worksheet = true);
        let hand = worksheet.scales().given().map(|(_, mu)| mu).collect::<Vec<_>>();
        assert_eq!(scales(&worksheet.figure()).iter().map(number).collect::<Vec<_>>(), hand, "{name}");
        assert_eq!(solution.scales(), worksheet.scales(), "{name}");
        let wide = solved_as(&text, |figure| figure.page = page("16x9"));
        assert!(scales(&wide.figure()).is_empty(), "{name}");
        assert_eq!(wide.scales(), solution.scales(), "{name}");
    }
    assert!(shared > 3, "{shared}");
}

/// What is wrong with the plans of a drawing: a pole that is cut off, content that is cut without a word, a word
/// without a cut.
fn cut_wrongly(drawing: &Drawing) -> Vec<String> {
    let mut wrong = Vec::new();
    for ((_, frame), marks) in drawing
        .panels
        .iter()
        .map(|(name, _)| name)
        .zip(panels(drawing))
        .map(|(name, (frame, marks))| ((name, frame), marks))
    {
        let plan = ["velocity", "acceleration"]
            .into_iter()
            .find(|plan| marks.iter().any(|mark| id(mark).starts_with(&format!("{plan}-"))));
        let Some(plan) = plan else { continue };
        let pole = if plan == "velocity" { "velocity-point-p" } else { "acceleration-point-pi" };
        let find = |name: &str| marks.iter().find(|mark| id(mark) == name);
        match find(pole) {
            Some(mark) if frame.inset(-1.0).contains(mark.shape.bounds().center()) => {}
            _ => wrong.push(format!("{plan}: the pole is cut off")),
        }
        // A vector that is cut has lost its head; a point at its end is gone.
        let is_cut = marks.iter().any(|mark| {
            let is_vector = matches!(mark.pen, Pen::Velocity | Pen::Acceleration | Pen::Normal | Pen::Vector);
            is_vector && matches!(mark.shape, Shape::Line(..)) && id(mark).starts_with(&format!("{plan}-vector-"))
        });
        let says = find(&format!("{plan}-cut")).is_some();
        if is_cut && !says {
            wrong.push(format!("{plan}: cut without a word"));
        }
        // Words stand within their panel.
        if find(&format!("{plan}-cut")).is_some_and(|mark| frame.union(mark.shape.bounds()) != frame) {
            wrong.push(format!("{plan}: the words leave the panel"));
        }
    }
    wrong
}

#[test]
fn no_plan_of_a_cycle_is_cut_without_a_word() {
    let (mut wrong, mut said, mut sheets) = (Vec::new(), 0, 0);
    let scenes = files::templates().into_iter().chain(
        ["shaper", "jansen", "whit"].map(|name| (name.to_owned(), files::read(&format!("tests/lecture/{name}.json")))),
    );
    for (name, text) in scenes {
        let solution = solved_as(&text, |_| ());
        let animation = Animation::new(&solution, None, HALL.now()).expect("it moves");
        let page = staged(&animation.positions, animation.own);
        let scales = solution.scales();
        for (value, (frame, position)) in animation.values.iter().zip(page.iter().zip(&animation.positions)) {
            let finished = frame.after_step(frame.steps.len() + 1);
            // The same position drawn alone at half the scale.
            let mut large = position.clone();
            large.scene.figure.mu[Sheet::Velocity] = scales[Sheet::Velocity].map(|mu| 0.5 * mu);
            large.scene.figure.mu[Sheet::Acceleration] = scales[Sheet::Acceleration].map(|mu| 0.5 * mu);
            for (what, drawing) in [("page", finished), ("draw", position.figure()), ("large", large.figure())] {
                sheets += 1;
                said += drawing.marks.iter().filter(|mark| id(mark).ends_with("-cut")).count();
                let own = cut_wrongly(&drawing);
                wrong.extend(own.iter().map(|own| format!("{name} at {value:.0}, {what}: {own}")));
                if what == "draw" && drawing.marks.iter().any(|mark| id(mark).ends_with("-cut")) {
                    wrong.push(format!("{name} at {value:.0}: cut at the scales of its own"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
    assert!(sheets > 40 * HALL.now() && said > 2 * HALL.now(), "{sheets} sheets, {said} of them cut");
}

#[test]
fn scales_of_a_cycle_hold_all_its_plans() {
    for name in ["four-bar", "whitworth", "slotted-lever"] {
        let text = files::read(&format!("templates/{name}.json"));
        let solution = solved_as(&text, |figure| figure.scales = ScalesFor::Cycle);
        let animation = Animation::new(&solution, None, SCALES_OF_A_CYCLE.now()).expect("it moves");
        for drawing in staged(&animation.positions, animation.own) {
            assert!(!drawing.marks.iter().any(|mark| id(mark).ends_with("-cut")), "{name}");
        }
        assert_eq!(
            scales(&solution.stepwise_figure()),
            scales(&staged(&animation.positions, animation.own)[0]),
            "{name}"
        );
    }
}

#[test]
fn a_panel_in_focus_takes_most_of_the_sheet() {
    for (name, text) in files::templates() {
        for focus in [Sheet::Velocity, Sheet::Acceleration] {
            let drawing = solved_as(&text, |figure| {
                (figure.page, figure.style, figure.focus) = (page("16x9"), StyleName::Lecture, Some(focus));
            })
            .figure();
            let [scheme, plan] = [0, 1].map(|panel| drawing.panels[panel].1);
            // A plan that fills the height cannot be larger.
            let is_its = |mark: &&Mark| id(mark).starts_with(&format!("{}-", focus.as_str()));
            let ink = drawing.marks.iter().filter(is_its).map(|mark| mark.shape.bounds()).reduce(|a, b| a.union(b));
            let filled = ink.map_or(0.0, |ink| ink.height()) / plan.height();
            let share = plan.area() / scheme.area();
            assert!(share > 1.2 || filled > 0.8, "{name}, {focus:?}: {filled} of {plan}, {share} of {scheme}");
        }
    }
}

#[test]
fn coarse_steps_are_few_and_whole() {
    for (name, most) in [("templates/four-bar", 12), ("examples/figure-2", 20), ("tests/lecture/jansen", 40)] {
        let solution = solved_as(&files::read(&format!("{name}.json")), |_| ());
        let passages = solution.construction.passages();
        assert!(passages.len() <= most, "{name}: {} sheets", passages.len());
        // Every step is in one passage, in order.
        let mut next = 1;
        for passage in &passages {
            assert_eq!(passage.steps[0], next, "{name}");
            next = passage.steps[1] + 1;
        }
        assert_eq!(next, solution.construction.numbered_steps().count() + 1, "{name}");
        let drawing = solution.coarse_figure();
        assert_eq!(drawing.steps.len(), passages.len());
        assert!(drawing.steps.iter().all(|caption| caption.ends_with('.')), "{:?}", drawing.steps);
        // The last sheet has all that the last fine one has, hints and words apart; a passage may draw it in another order.
        let shown = |drawing: Drawing| {
            let all = drawing.after_step(drawing.steps.len());
            let marks = all.marks.into_iter().filter(|mark| {
                !mark.passing && ["-point-", "-vector-", "-link-"].iter().any(|kind| id(mark).contains(kind))
            });
            marks.filter_map(|mark| mark.id).collect::<BTreeSet<_>>()
        };
        let fine = solution.stepwise_figure();
        if scales(&drawing) == scales(&fine) {
            assert_eq!(shown(drawing), shown(fine), "{name}");
        }
    }
    let four_bar = solved_as(&files::read("templates/four-bar.json"), |_| ());
    let aims: Vec<Aim> = four_bar.construction.passages().iter().map(|passage| passage.aim).collect();
    assert_eq!(aims, [Aim::Start, Aim::Crossing, Aim::Rates, Aim::Start, Aim::Crossing, Aim::Rates]);
}
