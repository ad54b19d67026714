//! Every starting scene, the paper's figures and the mechanisms with cylinders in some positions of its crank, measured as readers see it: no label touches a label, a joint or an arrowhead or leaves
//! its panel, no word is too small, no arrowhead longer than its vector, every point of a plan has its name, files are small in every style.
//!
//! Styles move nothing, so only what they change is measured in each.

use indexmap::IndexMap;
use kinegon::Order;
use kinegon::construction::{Construction, Plan, PointRole};
use kinegon::cycle::Animation;
use kinegon::drawing::{Drawing, Mark, Shape, Style};
use kinegon::scene::StyleName;
use kinegon::text::Untrusted;
use std::path::PathBuf;
use support::faults::{MOST_BYTES, faults, id};
use support::files;
use support::stages::solved;
use support::survey::GALLERY;

/// Each figure with what it is called and what it shows.
fn figures() -> Vec<(String, Drawing, Construction, IndexMap<String, Untrusted>)> {
    let mut all = Vec::new();
    let examples = [1, 2].map(|number| {
        let name = format!("figure-{number}");
        let text = files::read(&format!("examples/{name}.json"));
        (name, text)
    });
    let folders = ["templates", "tests/driven_sliders"];
    let scenes = folders.into_iter().flat_map(files::scenes);
    for (name, text) in scenes.chain(examples) {
        let solution = solved(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let animation =
            Animation::new(&solution, None, GALLERY.now()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let positions = animation.values.iter().zip(animation.positions);
        for (value, solution) in positions {
            let drawing = solution.figure();
            all.push((format!("{name} at {value:.1}"), drawing, solution.construction, solution.scene.figure.labels));
        }
    }
    all
}

/// How many names a plan's points should show: no point of the ground under a slider, which is the pole, and no vanished normal part.
fn names_of(plan: &Plan, labels: &IndexMap<String, Untrusted>) -> usize {
    let is_pole = |name: &str| name.ends_with("_ground") && plan.points[name].vector.norm() == 0.0;
    let vanished = |name: &str| {
        let own = &plan.points[name];
        let mut others = plan.points.values();
        own.role == PointRole::Normal && others.any(|p| p.role != PointRole::Normal && p.vector == own.vector)
    };
    let names = plan.points.keys();
    let is_blank = |name: &str| labels.get(name).is_some_and(Untrusted::is_blank);
    names.filter(|name| !is_pole(name) && !vanished(name) && !is_blank(name)).count()
}

/// How many names the labels of a panel show, alone or several in one.
fn names_in(drawing: &Drawing, panel: &str) -> usize {
    let prefix = format!("{panel}-label-");
    let labels = drawing.marks.iter().filter(|mark| id(mark).starts_with(&prefix));
    let names = labels.map(|mark| match &mark.shape {
        Shape::Text(text) => text.text.content().split(',').count(),
        _ => 0,
    });
    names.sum()
}

#[test]
fn figures_are_readable_in_every_position() {
    let figures = figures();
    assert!(figures.len() >= 25 * GALLERY.now(), "only {} figures", figures.len());
    let mut wrong = Vec::new();
    for (name, drawing, construction, labels) in &figures {
        let before = wrong.len();
        wrong.extend(faults(drawing).iter().map(|fault| format!("{name}: {fault}")));
        for plan in construction.plans() {
            let panel = match plan.order {
                Order::Velocity => "velocity",
                _ => "acceleration",
            };
            let prefix = format!("{panel}-");
            let is_of_panel = |mark: &Mark| mark.id.as_ref().is_some_and(|id| id.starts_with(&prefix));
            if !drawing.marks.iter().any(is_of_panel) {
                continue;
            }
            let (shown, wanted) = (names_in(drawing, panel), names_of(plan, labels));
            if shown != wanted {
                wrong.push(format!("{name}: {shown} of {wanted} names in the {panel} plan"));
            }
        }
        let mut styled = drawing.clone();
        for style in StyleName::ALL {
            styled.style = Style::named(style);
            let bytes = styled.svg().len();
            if bytes > MOST_BYTES {
                wrong.push(format!("{name}: {bytes} bytes in {}", style.as_str()));
            }
        }
        if wrong.len() > before {
            // Left for a look.
            let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.svg"));
            std::fs::write(path, drawing.svg()).expect("the test's folder can be written");
        }
    }
    // In a few positions a name has no free place.
    assert!(
        wrong.len() <= figures.len() / 40,
        "{} faults in {} figures\n{}",
        wrong.len(),
        figures.len(),
        wrong.join("\n")
    );
}
