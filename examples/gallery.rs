//! Draws every starting scene of `kinegon new` and every kind of picture, and writes docs/gallery.md with the pictures in docs/gallery.
//! Run with `cargo run --release --example gallery`.

use kinegon::Solution;
use kinegon::check::{AnswerKey, LENIENCY, Measured, check, redrawn};
use kinegon::construction::Tolerance;
use kinegon::cycle::{Curves, Drive, Hodographs, Path as Branch, PointPaths};
use kinegon::drawing::{Drawing, Overlay, curves, hodographs, overlay, paths};
use kinegon::exercise::Exercises;
use kinegon::format::{Text, structure, svg_with};
use kinegon::scene::{
    CentersShown, CoriolisName, DecimalMark, Figure, FrameName, LanguageName, LengthUnit, NotationName, Page, PageSize,
    ScalesFor, Scene, SlidingName, StyleName, TurnedName, ValuesShown,
};
use kinegon::{PerSheet, Scales, Sheet};
use std::error::Error;
use std::fmt::Write;
use std::fs;
use support::files as repository;

/// Kinds of `kinegon new` in its order, their scenes, and what each teaches.
const KINDS: [(&str, &str, &str); 31] = [
    (
        "four-bar",
        "templates/four-bar.json",
        "The first dyad: c lies where two rays cross, one normal to the coupler and one normal to the rocker.",
    ),
    (
        "slider-crank",
        "templates/slider-crank.json",
        "A slider's ray is parallel to its guide; the guide misses the crank's pivot by an offset.",
    ),
    (
        "slotted-lever",
        "templates/slotted-lever.json",
        "A block on a turning guide: the point of the lever under the block, sliding velocity, Coriolis acceleration.",
    ),
    (
        "whitworth",
        "templates/whitworth.json",
        "The lever turns fully because its pivot lies within the crank's circle; a second dyad drives the ram.",
    ),
    (
        "toggle-press",
        "templates/toggle-press.json",
        "Three links on one pin; the ram slows down, and its force grows, as the toggle straightens.",
    ),
    (
        "geared-five-bar",
        "templates/geared-five-bar.json",
        "Two cranks on wheels that mesh: the second turns twice as fast, the other way, and a dyad adds both.",
    ),
    (
        "gear-train",
        "templates/gear-train.json",
        "Where two wheels touch they have one velocity; the wheel between changes the sense alone.",
    ),
    (
        "planetary",
        "templates/planetary.json",
        "The planet rolls in the fixed ring: from its centre and its pitch point at rest to the sun's rim, on one velocity line.",
    ),
    (
        "planetary-sun-fixed",
        "templates/planetary-sun-fixed.json",
        "The same wheels as an overdrive: the planet rolls on the fixed sun and takes the ring along.",
    ),
    (
        "planetary-carrier-fixed",
        "templates/planetary-carrier-fixed.json",
        "The same wheels with the carrier held: ordinary gear pairs, and the ring turns the other way.",
    ),
    (
        "differential",
        "templates/differential.json",
        "Sun and ring drive: the planet's angular velocity from its two pitch points, then the arm's.",
    ),
    (
        "reverted-train",
        "templates/reverted-train.json",
        "A planet with two rims between two suns, of which one is fixed.",
    ),
    (
        "sun-and-planet",
        "templates/sun-and-planet.json",
        "The planet is fast on the rod of a four-bar linkage: the sun turns twice in each turn of the arm, a little faster and slower.",
    ),
    (
        "rack-and-pinion",
        "templates/rack-and-pinion.json",
        "A wheel rolls on a fixed rack, its lowest point at rest: the rack above moves twice as fast as its centre.",
    ),
    (
        "geneva",
        "templates/geneva.json",
        "A slot that ends: the wheel moves for a quarter of the crank's turn and rests for the others.",
    ),
    (
        "eccentric-cam",
        "templates/eccentric-cam.json",
        "A disc and a roller touch: the link between their centres moves as they do, in every position.",
    ),
    (
        "flat-follower",
        "templates/flat-follower.json",
        "A disc on a straight face: its centre slides along a line beside the face, with a Coriolis acceleration.",
    ),
    (
        "hydraulic-boom",
        "templates/hydraulic-boom.json",
        "Cylinder and rod are one link of changing length: sliding velocity, sliding and Coriolis acceleration are laid off before the ray.",
    ),
    (
        "watt-1",
        "templates/watt-1.json",
        "Two dyads, one after the other; the image of a ternary link is the link turned and scaled.",
    ),
    ("stephenson-3", "templates/stephenson-3.json", "A coupler point, found by its image, drives a second dyad."),
    ("five-bar", "templates/five-bar.json", "Two degrees of freedom, two drives: a dyad between two moving pins."),
    (
        "third-class",
        "templates/third-class.json",
        "No dyad to begin with: special points of the central link open the group.",
    ),
    (
        "fourth-class",
        "templates/fourth-class.json",
        "A closed contour of four links: special points of the two closure links open the group.",
    ),
    ("platform-3rrr", "templates/platform-3rrr.json", "Three drives move a third-class group by all its outer pins."),
    ("dyad-rrr", "templates/dyad-rrr.json", "Three pins: both rays are normal to links, and both outer pins may move."),
    ("dyad-rrp", "templates/dyad-rrp.json", "An outer slider: one ray is parallel to the guide."),
    (
        "dyad-rpr",
        "templates/dyad-rpr.json",
        "An inner slider: the ray of relative velocity is parallel to the lever, and Coriolis acceleration is normal to it.",
    ),
    ("dyad-prp", "templates/dyad-prp.json", "Two outer sliders: both rays are parallel to guides, of which one moves."),
    ("dyad-rpp", "templates/dyad-rpp.json", "A Scotch yoke: an inner and an outer slider, and no rotation at all."),
    (
        "paper-figure-1",
        "examples/figure-1.json",
        "The paper's fourth-class group with all joints revolute, as drawn, between two pins of known motion.",
    ),
    (
        "paper-figure-2",
        "examples/figure-2.json",
        "The paper's example: a fourth-class group with one slider, driven by a crank.",
    ),
];

/// A kind of picture.
enum Kind {
    /// The figure, asked for in this way.
    Figure(fn(&mut Figure)),
    /// The sheet after this step.
    Step(usize),
    /// The sheet after this coarse step, asked for in this way.
    Passage(usize, fn(&mut Figure)),
    /// Quantities over the cycle.
    Curves(&'static [&'static str]),
    /// Ways of vectors' tips.
    Hodographs(&'static [&'static str]),
    /// Paths of points, as charts.
    Paths(&'static [&'static str]),
    /// The values of that form over the right figure.
    Check(&'static str),
    /// The sheet of the first exercise with that seed.
    Exercise(u64),
    /// The values of that form over the right figure of the first exercise with that seed.
    Marked(u64, &'static str),
}

/// The other kinds of pictures: name, scene, the command that draws it, what it is for.
const PICTURES: [(&str, &str, &str, &str, Kind); 35] = [
    (
        "style-paper",
        "templates/whitworth.json",
        "draw scene.json --style paper",
        "The standard style: black lines with a few dark accents.",
        Kind::Figure(|figure| figure.style = StyleName::Paper),
    ),
    (
        "style-print",
        "templates/whitworth.json",
        "draw scene.json --style print",
        "For the photocopier: widths, dashes and heads tell what is what.",
        Kind::Figure(|figure| figure.style = StyleName::Print),
    ),
    (
        "style-lecture",
        "templates/whitworth.json",
        "draw scene.json --style lecture",
        "A colour for each link, the same in its images.",
        Kind::Figure(|figure| figure.style = StyleName::Lecture),
    ),
    (
        "style-board",
        "templates/whitworth.json",
        "draw scene.json --style board",
        "Chalk on a dark ground.",
        Kind::Figure(|figure| figure.style = StyleName::Board),
    ),
    (
        "hall",
        "templates/whitworth.json",
        "draw scene.json --style lecture --page 16x9",
        "For the hall: large letters, thick lines, a sheet with the proportions of the projector.",
        Kind::Figure(|figure| (figure.style, figure.page) = (StyleName::Lecture, wide())),
    ),
    (
        "hall-focus",
        "templates/watt-1.json",
        "draw scene.json --style lecture --page 16x9 --focus velocity",
        "One large plan at a time, with the scheme beside it.",
        Kind::Figure(|figure| {
            (figure.style, figure.page, figure.focus) = (StyleName::Lecture, wide(), Some(Sheet::Velocity));
        }),
    ),
    (
        "hall-step",
        "templates/four-bar.json",
        "draw scene.json --style lecture --page 16x9 --focus velocity --steps coarse",
        "A coarse step: both rays and their crossing on one sheet.",
        Kind::Passage(2, |figure| {
            (figure.style, figure.page, figure.focus) = (StyleName::Lecture, wide(), Some(Sheet::Velocity));
        }),
    ),
    (
        "images",
        "tests/lecture/jansen.json",
        "draw scene.json",
        "Every point of every link has its image: the foot F by two rays over its link's triangle.",
        Kind::Figure(|_| ()),
    ),
    (
        "higher-class",
        "tests/driven_sliders/scissor-lift.json",
        "draw scene.json",
        "A group of higher class: no construction by rays, but plans laid off from its rates, link by link.",
        Kind::Figure(|_| ()),
    ),
    (
        "values",
        "tests/lecture/shaper.json",
        "draw scene.json --values=m",
        "Values at vectors, links and lengths, in metres; the results in a list. The Coriolis acceleration has the direction of a_c(2/3) in the results.",
        Kind::Figure(|figure| figure.values = Some(ValuesShown::Shown(Some(LengthUnit::M)))),
    ),
    (
        "cycle-scales",
        "templates/slider-crank.json",
        "draw scene.json --scales cycle",
        "Scales for the largest plans of the whole cycle: this position and all others at the same ones.",
        Kind::Figure(|figure| figure.scales = ScalesFor::Cycle),
    ),
    (
        "far-point",
        "tests/lecture/valve.json",
        "draw scene.json",
        "A special point whose images lie far away: broken lines run towards them, with their distances on paper.",
        Kind::Figure(|_| ()),
    ),
    (
        "worded",
        "examples/figure-2.json",
        "draw scene.json --language es --decimal comma --notation german",
        "In Spanish, with decimal commas, poles P_v and P_a.",
        Kind::Figure(|figure| {
            figure.language = LanguageName::Spanish;
            figure.decimal = DecimalMark::Comma;
            figure.notation = NotationName::German;
        }),
    ),
    (
        "points",
        "templates/slotted-lever.json",
        "draw scene.json --sliding points --coriolis C --frame 0 --values",
        "Motions along a guide by the points of both links, the frame as link 0.",
        Kind::Figure(|figure| {
            figure.sliding = SlidingName::Points;
            figure.coriolis = Some(CoriolisName::Capital);
            figure.frame = Some(FrameName::Zero);
            figure.values = Some(ValuesShown::Shown(None));
        }),
    ),
    (
        "turned",
        "templates/slider-crank.json",
        "draw scene.json --turned clockwise",
        "Turned velocities: the plan's lines are parallel to the links.",
        Kind::Figure(|figure| figure.turned = Some(TurnedName::Clockwise)),
    ),
    (
        "forces",
        "tests/forces/figure-2.json",
        "draw scene.json",
        "What the joints of the paper's group carry under loads: Ritter's moment on a drag link, then polygon by polygon.",
        Kind::Figure(|_| ()),
    ),
    (
        "lever",
        "tests/forces/figure-2.json",
        "draw scene.json",
        "With the panels scheme and lever: the velocity plan turned by 90°, each force at the image of its point.",
        Kind::Figure(|figure| figure.panels = vec![Sheet::Scheme, Sheet::Lever]),
    ),
    (
        "profiles",
        "tests/cams/profiles.json",
        "draw scene.json",
        "Two profiles of which the contact alone is known, as drawn: arcs about their centres of curvature, and the link that is equivalent to them.",
        Kind::Figure(|_| ()),
    ),
    (
        "friction-press",
        "tests/forces/friction-press.json",
        "draw scene.json",
        "Coulomb friction: forces touch the circles of friction at the pins, and lean at the guide by its angle.",
        Kind::Figure(|_| ()),
    ),
    (
        "loaded-train",
        "tests/forces/loaded-train.json",
        "draw scene.json",
        "Polygons of the forces on each wheel: the pin of the wheel between carries both forces of its teeth.",
        Kind::Figure(|_| ()),
    ),
    (
        "step",
        "examples/figure-2.json",
        "draw scene.json --upto 14",
        "A step of the construction: what is new stands out, what is known is underlined.",
        Kind::Step(14),
    ),
    (
        "worksheet",
        "examples/figure-2.json",
        "draw scene.json --worksheet",
        "A sheet to measure on: every measured length in millimetres and as a value, and a ruler to test the printer.",
        Kind::Figure(|figure| figure.worksheet = true),
    ),
    (
        "curves",
        "templates/whitworth.json",
        "curves scene.json --want \"omega(3), v_r(5/ground), a_r(5/ground)\"",
        "Quantities over the cycle, with extremes and dead centres.",
        Kind::Curves(&["omega(3)", "v_r(5/ground)", "a_r(5/ground)"]),
    ),
    (
        "hodograph",
        "templates/four-bar.json",
        "curves scene.json --hodograph \"v(C), a(C)\"",
        "The ways of vectors' tips over the cycle, marked every 30° of the crank.",
        Kind::Hodographs(&["v(C)", "a(C)"]),
    ),
    (
        "paths",
        "tests/lecture/jansen.json",
        "draw scene.json --trace F --ghosts 12 --style lecture",
        "The path of a point over the cycle, with strokes at equal times, and the links pale in other positions.",
        Kind::Figure(|figure| {
            figure.trace = owned(&["F"]);
            figure.ghosts = Some(12);
            figure.style = StyleName::Lecture;
        }),
    ),
    (
        "path",
        "tests/lecture/jansen.json",
        "curves scene.json --path \"F, E\"",
        "Paths as charts, y over x at one scale, marked every 30° of the crank.",
        Kind::Paths(&["F", "E"]),
    ),
    (
        "centers",
        "examples/figure-2.json",
        "draw scene.json --centers=all",
        "All instant centres by Kennedy's lines, in the order of the circle diagram; far ones at arrows.",
        Kind::Figure(|figure| {
            figure.panels = vec![Sheet::Scheme, Sheet::Centers];
            figure.centers = CentersShown::All;
        }),
    ),
    (
        "curvature",
        "tests/worked/SC01-khurmi-7.2/scene.json",
        "draw scene.json --centers=\"P(2,ground)\" --curvature E",
        "The centre of curvature of a coupler point's path by Bobillier's construction: no length is measured.",
        Kind::Figure(|figure| {
            figure.panels = vec![Sheet::Scheme, Sheet::Centers];
            (figure.centers, figure.curvature) = (CentersShown::Named(owned(&["P(2,ground)"])), owned(&["E"]));
        }),
    ),
    (
        "exercise",
        "templates/four-bar.json",
        "exercise four-bar --seed 11 -o class/",
        "An exercise: what is given, and a box for every value to be found.",
        Kind::Exercise(11),
    ),
    (
        "check",
        "examples/figure-2.json",
        "check scene.json values.json --draw out/ --mu-l 5 --mu-v 2.5 --mu-a 2.5",
        "A drawing by hand, checked: what is probably elsewhere, dashed, over the right figure.",
        Kind::Check("examples/paper-as-student.json"),
    ),
    // Those of docs/tutorial.md.
    (
        "tutorial-wiper",
        "examples/wiper.json",
        "draw scene.json",
        "A windscreen wiper: crank, rod, and a lever with its blade.",
        Kind::Figure(|_| ()),
    ),
    (
        "tutorial-step",
        "examples/wiper.json",
        "draw scene.json --style lecture --page 16x9 --focus velocity --steps coarse",
        "Its second step, for the hall.",
        Kind::Passage(2, |figure| {
            (figure.style, figure.page, figure.focus) = (StyleName::Lecture, wide(), Some(Sheet::Velocity));
        }),
    ),
    (
        "tutorial-way",
        "examples/wiper.json",
        "draw scene.json --style lecture --page 16x9 --focus scheme --trace E --ghosts 12",
        "The way of the blade's end, with strokes at equal times.",
        Kind::Figure(|figure| {
            (figure.style, figure.page, figure.focus) = (StyleName::Lecture, wide(), Some(Sheet::Scheme));
            (figure.trace, figure.ghosts) = (owned(&["E"]), Some(12));
        }),
    ),
    (
        "tutorial-sheet",
        "examples/wiper.json",
        "exercise scene.json --seed 3 -o class/",
        "An exercise of it, with other numbers.",
        Kind::Exercise(3),
    ),
    (
        "tutorial-check",
        "examples/wiper.json",
        "check scene.json values.json --draw out/",
        "A student's plan of that exercise over the right one: the mistake is marked where it was made.",
        Kind::Marked(3, "examples/wiper-as-student.json"),
    ),
];

/// Pictures look the same whatever fonts the reader has.
const PICTURE: Text = Text::Glyphs;

/// The sheet for a projector.
fn wide() -> Page {
    Page { size: PageSize::Wide, landscape: true }
}

/// The scene of a file, with what is asked of its figure, solved.
fn solution(path: &str, asked: impl Fn(&mut Figure)) -> Result<Solution, Box<dyn Error>> {
    let mut scene = Scene::read(&fs::read_to_string(repository::path(path))?)?;
    asked(&mut scene.figure);
    Ok(kinegon::solve(&scene)?)
}

/// The branch of the scene's own position over a whole turn from 0°, as `kinegon curves` follows it.
fn turned(solution: &Solution) -> Result<Branch<'_>, Box<dyn Error>> {
    let drive = Drive::new(&solution.mechanism, None)?;
    let mut branch = Branch::new(&solution.mechanism, &solution.pose, drive)?;
    branch.cover(None, None)?;
    branch.follow_to(0.0);
    Ok(branch)
}

fn curves_of(solution: &Solution, names: &[&str]) -> Result<Drawing, Box<dyn Error>> {
    let branch = turned(solution)?;
    let sampled = Curves::new(&branch, [0.0, 360.0], Some(&owned(names)))?;
    Ok(curves(&solution.scene, &sampled, None)?)
}

fn hodographs_of(solution: &Solution, names: &[&str]) -> Result<Drawing, Box<dyn Error>> {
    let branch = turned(solution)?;
    let sampled = Hodographs::new(&branch, [0.0, 360.0], &owned(names))?;
    Ok(hodographs(&solution.scene, &sampled, None)?)
}

fn paths_of(solution: &Solution, names: &[&str]) -> Result<Drawing, Box<dyn Error>> {
    let branch = turned(solution)?;
    let sampled = PointPaths::new(&branch, [0.0, 360.0], &owned(names))?;
    Ok(paths(&solution.scene, &sampled, None)?)
}

/// What is probably elsewhere in the drawing from which the values of a form were read, over the right figure; scales as in the command.
fn checked(path: &str, form: &str) -> Result<Drawing, Box<dyn Error>> {
    let mut solution = solution(path, |_| ())?;
    let own = drawn_by_hand(&solution, solution.scales(), form)?;
    let figure = &mut solution.scene.figure;
    figure.mu = PerSheet::from_fn(|sheet| Some(if sheet == Sheet::Scheme { 5.0 } else { 2.5 }));
    Ok(overlay(&solution, &own).swap_remove(0))
}

/// The same of an exercise, at its scales.
fn marked(path: &str, seed: u64, form: &str) -> Result<Drawing, Box<dyn Error>> {
    let exercise = Exercises::new(&solution(path, |_| ())?, None, seed)?.next()?;
    Ok(overlay(&exercise.solution, &drawn_by_hand(&exercise.solution, exercise.scales, form)?).swap_remove(0))
}

/// The drawing from which the values of a form were read; causes are looked for as deep as the program does.
fn drawn_by_hand(solution: &Solution, scales: Scales, form: &str) -> Result<Overlay, Box<dyn Error>> {
    let measured = Measured::read_json(&fs::read_to_string(repository::path(form))?)?;
    let key = AnswerKey { solution, scales, tolerance: Tolerance::default(), leniency: LENIENCY, depth: 5 };
    Ok(redrawn(&measured, &key, &check(&measured, &key)?)?)
}

fn exercise(path: &str, seed: u64) -> Result<Drawing, Box<dyn Error>> {
    let mut exercises = Exercises::new(&solution(path, |_| ())?, None, seed)?;
    Ok(exercises.next()?.sheets("").swap_remove(0))
}

fn owned(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// A file of the gallery: where it goes, from the root of the repository, and what it says.
pub type File = (String, String);

/// The page and its pictures.
///
/// # Errors
/// Only if one of the scenes has been changed so that it cannot be drawn.
pub fn files() -> Result<Vec<File>, Box<dyn Error>> {
    let mut page = String::from(
        "# Gallery\n\n\
         Every kind of `kinegon new KIND`, with its Assur groups in solving order (`kinegon structure`) and its figure \
         (`kinegon draw`); then [every kind of picture](#kinds-of-pictures) with the command that draws it.\n\
         This page and its pictures are made by `cargo run --release --example gallery`.\n",
    );
    let mut pictures = Vec::new();
    for (kind, path, teaches) in KINDS {
        let solution = solution(path, |_| ())?;
        let drawing = solution.figure();
        let structure = structure(&solution.mechanism, &solution.wording());
        let title = solution.scene.title.map_or_else(|| kind.to_owned(), |title| title.for_terminal());
        let formula = structure.lines().next().unwrap_or_default();
        let _ = write!(
            page,
            "\n## {title}\n\n{teaches}\n\n`{kind}`: {formula}\n\n![{title}. {}](gallery/{kind}.svg)\n",
            drawing.description
        );
        pictures.push((format!("docs/gallery/{kind}.svg"), svg_with(&drawing, PICTURE)));
    }
    page.push_str("\n## Kinds of pictures\n");
    for (name, path, command, purpose, kind) in PICTURES {
        let drawing = match kind {
            Kind::Figure(asked) => solution(path, asked)?.figure(),
            Kind::Step(number) => solution(path, |_| ())?.stepwise_figure().after_step(number),
            Kind::Passage(number, asked) => solution(path, asked)?.coarse_figure().after_step(number),
            Kind::Curves(names) => curves_of(&solution(path, |_| ())?, names)?,
            Kind::Hodographs(names) => hodographs_of(&solution(path, |_| ())?, names)?,
            Kind::Paths(names) => paths_of(&solution(path, |_| ())?, names)?,
            Kind::Check(form) => checked(path, form)?,
            Kind::Exercise(seed) => exercise(path, seed)?,
            Kind::Marked(seed, form) => marked(path, seed, form)?,
        };
        let description = if drawing.description.is_empty() { purpose } else { &drawing.description };
        let _ = write!(page, "\n{purpose}\n\n`kinegon {command}`\n\n![{description}](gallery/{name}.svg)\n");
        pictures.push((format!("docs/gallery/{name}.svg"), svg_with(&drawing, PICTURE)));
    }
    pictures.insert(0, ("docs/gallery.md".to_owned(), page));
    Ok(pictures)
}

fn main() -> Result<(), Box<dyn Error>> {
    for (path, text) in files()? {
        let path = repository::path(&path);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(path, text)?;
    }
    Ok(())
}
