//! After each step of the construction the names on the sheet are those that the steps so far have made, no other ones: held against the
//! steps themselves, in both plans and on the scheme.

use kinegon::construction::{Action, Construction, Plan, PointRole};
use kinegon::drawing::{Drawing, Pen, Rect, Shape};
use kinegon::text::Untrusted;
use kinegon::{Scene, Solution};
use support::faults::id;
use support::files;
use support::stages::solved;

/// The scenes: their names and texts.
fn scenes() -> Vec<(String, String)> {
    let examples = [1, 2].map(|number| {
        let name = format!("figure-{number}");
        let text = files::read(&format!("examples/{name}.json"));
        (name, text)
    });
    let folders = ["templates", "tests/lecture"];
    folders.into_iter().flat_map(files::scenes).chain(examples).collect()
}

/// Letters and digits of names, sorted: signs between names and the heights of letters do not count.
fn letters<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let all = names.into_iter().flat_map(str::chars);
    let mut letters: Vec<char> = all.filter(|letter| letter.is_alphanumeric()).collect();
    letters.sort_unstable();
    letters.into_iter().collect()
}

/// The texts of labels in a panel of a sheet.
fn labels(drawing: &Drawing, panel: &(String, Rect)) -> Vec<String> {
    let in_panel = drawing.marks.iter().filter(|mark| mark.pen == Pen::Label);
    let texts = in_panel.filter_map(|mark| match &mark.shape {
        Shape::Text(text) if panel.1.contains(text.ink_box().center()) => Some(text.text.content()),
        _ => None,
    });
    // Neither the factor of an enlarged detail nor the distance of a far point is a name.
    let name = |text: String| match text.strip_prefix("to").and_then(|far| far.split_once(": ")) {
        Some((name, _)) => name.to_owned(),
        None => text,
    };
    texts.filter(|text| !text.contains(" : ")).map(name).collect()
}

/// The names of plan points that an action puts on the sheet.
fn made(action: &Action, pole: &str) -> Vec<String> {
    match action {
        Action::Pole { images, .. } => [vec![pole.to_owned()], images.clone()].concat(),
        Action::LayOff(arrow) => vec![arrow.from.clone(), arrow.to.clone()],
        Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
            vec![point.clone()]
        }
        _ => Vec::new(),
    }
}

/// Whether a point of a plan has no name of its own: one of the ground under a slider, which is the pole, or the end of
/// a normal part of length zero.
fn is_unnamed(construction: &Construction, plan: &Plan, name: &str) -> bool {
    let own = &plan.points[name];
    let is_pole = name.ends_with("_ground") && own.vector.norm() == 0.0;
    let start =
        construction.arrows(plan.order).find(|laid| laid.to == name).and_then(|laid| plan.points.get(&laid.from));
    let vanishes = start.is_some_and(|start| start.vector == own.vector);
    is_pole || (own.role == PointRole::Normal && vanishes)
}

/// What differs on the sheet after a step.
fn wrong_names(solution: &Solution, all: &Drawing, step: usize) -> Vec<String> {
    let (drawing, construction) = (all.after_step(step), &solution.construction);
    let renamed =
        |name: &str| solution.scene.figure.labels.get(name).map_or_else(|| name.to_owned(), Untrusted::for_terminal);
    let mut wrong = Vec::new();
    for (plan, panel) in construction.plans().zip(&drawing.panels[1..]) {
        let steps = construction.numbered_steps().filter(|one| one.sheet == plan.sheet());
        let so_far = steps.filter(|one| one.number <= step).flat_map(|one| made(one.action, plan.order.pole()));
        let mut names: Vec<String> =
            so_far.filter(|name| !is_unnamed(construction, plan, name)).map(|name| renamed(&name)).collect();
        names.sort();
        names.dedup();
        let (wanted, shown) = (letters(names.iter().map(String::as_str)), labels(&drawing, panel));
        let found = letters(shown.iter().map(String::as_str));
        if wanted != found {
            wrong.push(format!("step {step}, {}: {shown:?} in place of {names:?}", panel.0));
        }
    }
    let special = construction.special.iter().filter(|special| special.is_assur);
    for special in special {
        let number = construction.numbered_steps().find(|one| match &one.action {
            Action::SpecialPoint { point, .. } => *point == special.name,
            _ => false,
        });
        let number = number.map_or(0, |one| one.number);
        let name = format!("scheme-label-{}", special.name);
        let is_shown = drawing.marks.iter().any(|mark| id(mark) == name);
        if is_shown != (number <= step) {
            wrong.push(format!("step {step}, scheme: {name} is made in step {number}"));
        }
    }
    wrong
}

#[test]
fn names_come_with_the_steps_that_make_them() {
    let mut wrong = Vec::new();
    let mut sheets = 0;
    for (name, text) in scenes() {
        // Scenes of what cannot be: they have messages in place of figures.
        let Ok(mut scene) = Scene::read(&text) else { continue };
        scene.figure.page = kinegon::scene::Page::from_name("a3").expect("it is a page");
        let Ok(solution) = kinegon::solve(&scene) else { continue };
        let all = solution.stepwise_figure();
        for step in 1..=all.steps.len() {
            sheets += 1;
            wrong.extend(wrong_names(&solution, &all, step).iter().map(|what| format!("{name}: {what}")));
        }
    }
    assert!(sheets > 700, "only {sheets} sheets");
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

/// In an SVG with layers, what later names replace is in groups of its own, which are hidden: all groups together are
/// the finished figure.
#[test]
fn replaced_names_are_hidden_layers() {
    let text = files::read("templates/four-bar.json");
    let all = solved(&text).expect("a good scene").stepwise_figure();
    let svg = kinegon::format::layered_svg(&all, kinegon::format::Text::Letters);
    // The pole π has the name of the fixed points from the start; nothing grows in this plan.
    assert!(!svg.contains("-until-"));
    let text = files::read("tests/lecture/valve.json");
    let all = solved(&text).expect("a good scene").stepwise_figure();
    let svg = kinegon::format::layered_svg(&all, kinegon::format::Text::Letters);
    let groups: Vec<&str> = svg.lines().filter(|line| line.contains("-until-")).collect();
    assert!(!groups.is_empty());
    assert!(groups.iter().all(|line| line.contains("visibility=\"hidden\"")), "{groups:?}");
}

/// The scene may take a name's label from the figure; sentences name the point all the same.
#[test]
fn sentences_name_what_has_no_label() {
    let solution = solved(&files::read("examples/figure-2.json")).expect("it moves");
    let name = |label: &str| solution.scene.figure.labels.iter().any(|(name, text)| name == label && text.is_blank());
    assert!(name("k_b3"), "that name has a label now: take another");
    let all = solution.stepwise_figure();
    let captions: Vec<&String> = all.steps.iter().filter(|caption| caption.contains("k_b3")).collect();
    assert!(captions.len() >= 2, "{captions:?}");
    for (index, caption) in all.steps.iter().enumerate().filter(|(_, caption)| caption.contains("k_b3")) {
        let sheet = all.after_step(index + 1);
        let words = sheet.marks.iter().filter(|mark| mark.pen == Pen::Caption);
        let said = words.filter_map(|mark| match &mark.shape {
            Shape::Text(text) => Some(text.text.content()),
            _ => None,
        });
        assert!(said.collect::<Vec<_>>().iter().any(|text| text == "kb3"), "step {}: {caption}", index + 1);
    }
}
