//! Errors of ω and α of mechanisms of all classes: where positions are given, and where they are found from lengths; along cycles,
//! towards a limit position and towards a change point.

use super::assembled::{general, general_at, truth};
use super::joints::Given;
use super::planted::{KNOWN, Planted, pattern};
use super::random::Random;
use super::truth::{Truth, error, rounded};
use kinegon::Order;
use kinegon::cycle::{Drive, Path, Steps, Sweep};
use kinegon::mechanism::{BodyId, Mechanism, Role, mechanism};
use kinegon::motion::motion;
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;

/// Ways from lengths to rates.
pub const WAYS: [&str; 3] = ["Kinegon, one position", "Kinegon, table", "joint equations, Newton and LU"];

/// What they are, each with its source.
pub const WAYS_SAY: [&str; 3] = [
    "`position::pose` or `cycle::Walker` and `motion::motion`, with bounds (`src/motion/solve.rs`)",
    "`cycle::Sweep`, the batch kernel in registers (`src/kernel/close.rs`, \
     `src/kernel/rates.rs`)",
    "all joints' equations in f64: Newton's method for positions, nalgebra's LU \
     (`tests/support/speed_vs_error/assembled.rs`)",
];

/// Errors at one position: |computed − true| over the largest true number of that kind, ω or α, the worst of both.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// The largest condition of a group, as the library states it.
    pub condition: f64,
    /// By way; infinite where it has no number.
    pub errors: [f64; 3],
}

/// Mechanisms of a class that were tried.
pub struct Class {
    pub name: &'static str,
    /// Positions given: by `motion::motion`, and by the equations of all joints.
    pub given: Vec<(f64, [f64; 2])>,
    pub lengths: Vec<Reading>,
}

/// A motion that was followed.
pub struct Followed {
    pub name: String,
    pub readings: Vec<Reading>,
}

/// Approach to a singular position.
pub struct Approach {
    pub name: &'static str,
    /// Distance in degrees of the crank.
    pub rows: Vec<(f64, Reading)>,
}

/// Everything that is measured from lengths.
pub struct Lengths {
    pub classes: Vec<Class>,
    pub cycles: Vec<Followed>,
    pub approaches: Vec<Approach>,
}

/// Random mechanisms of each class; of higher ones, whose positions take a search, fewer.
const MECHANISMS: [usize; 2] = [60, 12];

/// Positions of a cycle.
const POSITIONS: u32 = 90;

/// Condition up to which mechanisms are taken: beyond, rounded lengths determine few digits.
const CONDITION: f64 = 1e7;

/// An error below this, of the largest number of its kind, is the rounding of a true zero.
const NOTHING: f64 = 1e-30;

/// Scenes whose cycle is followed.
const CYCLES: [(&str, &str); 9] = [
    ("four-bar: II (RRR)", include_str!("../../../templates/four-bar.json")),
    ("slider-crank: II (RRP)", include_str!("../../../templates/slider-crank.json")),
    ("slotted lever: II (RPR)", include_str!("../../../templates/slotted-lever.json")),
    ("Whitworth: II (RPR), II (RRP)", include_str!("../../../templates/whitworth.json")),
    ("Watt: II (RRR), II (RRR)", include_str!("../../../templates/watt-1.json")),
    ("toggle press: II (RRR), II (RRP)", include_str!("../../../templates/toggle-press.json")),
    ("third class: III (RR-RR-RR)", include_str!("../../../templates/third-class.json")),
    ("fourth class: IV (RRR-RRR)", include_str!("../../../templates/fourth-class.json")),
    ("the paper's: IV (RPR-RRR)", PAPER),
];

const PAPER: &str = include_str!("../../../examples/figure-2.json");

/// Where the paper's crank stops, in degrees.
const LIMIT: f64 = 137.582_082_139_174;

/// A parallelogram: at [`CHANGE`] all links lie in line.
const PARALLELOGRAM: &str = r#"{ "kinegon": 1, "units": { "length": "mm", "time": "s" }, "ground": { "A": [0, 0], "D": [120, 90] },
    "links": { "1": { "points": ["A", "B"], "lengths": { "AB": 60 }, "drive": { "angle": 100, "omega": 1, "alpha": 1 } },
               "2": { "points": ["B", "C"], "lengths": { "BC": 150 } }, "3": { "points": ["D", "C"], "lengths": { "CD": 60 } } },
    "near": { "C": [110, 149] } }"#;

/// The direction of the parallelogram's ground, 4 to 3, in degrees.
const CHANGE: f64 = 36.869_897_645_844_02;

impl Lengths {
    pub fn new() -> Lengths {
        Lengths::with(MECHANISMS, POSITIONS)
    }

    /// With so many mechanisms of a class, and of higher class, and so many positions of a cycle.
    pub fn with(mechanisms: [usize; 2], positions: u32) -> Lengths {
        let limit = [10.0, 1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5].map(|d| (d, LIMIT - d));
        let change = [30.0, 10.0, 3.0, 1.0, 0.3, 0.1, 0.05].map(|d| (d, CHANGE + d));
        Lengths {
            classes: ["II", "III", "IV", "higher"].map(|name| class(name, mechanisms)).into(),
            cycles: CYCLES.map(|(name, text)| cycle(name, text, positions)).into(),
            approaches: vec![
                approach("Towards a limit position", PAPER, &limit),
                approach("Towards a change point", PARALLELOGRAM, &change),
            ],
        }
    }

    /// All readings.
    pub fn readings(&self) -> impl Iterator<Item = &Reading> {
        let classes = self.classes.iter().flat_map(|c| &c.lengths);
        let cycles = self.cycles.iter().flat_map(|c| &c.readings);
        classes.chain(cycles).chain(self.approaches.iter().flat_map(|a| a.rows.iter().map(|(_, reading)| reading)))
    }
}

/// The members of a mechanism.
fn members(mechanism: &Mechanism) -> Vec<BodyId> {
    let links = mechanism.links().filter(|(_, body)| matches!(body.role, Role::Member));
    links.map(|(id, _)| id).collect()
}

/// The error of the rates of the members, as [`Reading`] says; the driven link counts among the largest.
fn worst(mechanism: &Mechanism, truth: &Truth, rates: impl Fn(BodyId) -> [f64; 2]) -> f64 {
    let of = |id: BodyId| [&truth.bodies[id.0].omega, &truth.bodies[id.0].alpha];
    let links = || mechanism.links().map(|(id, _)| id);
    let largest = |k: usize| links().map(|id| rounded(of(id)[k]).abs()).fold(0.0, f64::max);
    // Where nothing is accelerated, the normal acceleration's ω² stands for α.
    let sizes = [largest(0), largest(1).max(largest(0) * largest(0))];
    let off = members(mechanism).into_iter().flat_map(|id| {
        let rates = rates(id);
        [0, 1].map(|k| error(rates[k], of(id)[k]) / sizes[k])
    });
    let worst = off.fold(0.0, |worst: f64, off| if off.is_nan() { f64::INFINITY } else { worst.max(off) });
    if worst < NOTHING { 0.0 } else { worst }
}

/// The errors at a pose, with the rates that a table has there, by member.
fn reading(mechanism: &Mechanism, pose: &Pose, angle: f64, table: Option<&[[f64; 2]]>) -> Option<Reading> {
    let moved = motion(mechanism, pose, Order::Acceleration).ok()?;
    let condition = moved.conditions.iter().copied().fold(1.0, f64::max);
    let truth = truth(mechanism, pose, |_| angle)?;
    let members = members(mechanism);
    let of_table = |id: BodyId| {
        let index = members.iter().position(|m| *m == id);
        index.zip(table).map_or([f64::INFINITY; 2], |(index, table)| table[index])
    };
    let general = general(mechanism, pose, |_| angle);
    let of_general = |id: BodyId| general.as_ref().map_or([f64::INFINITY; 2], |rates| rates[id.0]);
    let errors = [
        worst(mechanism, &truth, |id| [moved.body(id).omega, moved.body(id).alpha]),
        worst(mechanism, &truth, of_table),
        worst(mechanism, &truth, of_general),
    ];
    Some(Reading { condition, errors })
}

/// Rates of the members in a table with one row, at this value of the drive.
fn row(path: &Path, mechanism: &Mechanism, value: f64) -> Option<Vec<[f64; 2]>> {
    let names = members(mechanism).into_iter().flat_map(|id| {
        let link = &mechanism.body(id).name;
        ["omega", "alpha"].map(|head| format!("{head}({link})"))
    });
    let steps = Steps::new(value, value, 1.0).ok()?;
    let sweep = Sweep::new(path, steps, Some(&names.collect::<Vec<_>>())).ok()?;
    let numbers: Option<Vec<f64>> = sweep.rows(0..1).into_iter().collect();
    Some(numbers?[1..].chunks(2).map(|pair| [pair[0], pair[1]]).collect())
}

/// The drive's angle that a scene gives.
fn driven_to(mechanism: &Mechanism) -> Option<f64> {
    mechanism.bodies.iter().find_map(|body| match body.role {
        Role::Driver { angle, .. } => angle,
        _ => None,
    })
}

/// Joints of six links for a group of higher class, to known bodies and between each other, as the lot will have it; with sliders among them, or pins only.
pub(super) fn six_links(dice: &mut Random, sliders: bool) -> (String, Vec<(usize, usize)>) {
    let outer = 2 + dice.below(3);
    let mut joints: Vec<(usize, usize)> = Vec::new();
    while joints.len() < 9 {
        let (a, b) = (dice.below(6), if joints.len() < outer { KNOWN } else { dice.below(6) });
        let again = b != KNOWN && (joints.contains(&(a, b)) || joints.contains(&(b, a)));
        if a != b && !again {
            joints.push((a, b));
        }
    }
    let kinds = joints.iter().map(|_| if sliders && dice.below(4) == 0 { 'P' } else { 'R' }).collect();
    (kinds, joints)
}

fn class(name: &'static str, mechanisms: [usize; 2]) -> Class {
    let mut dice = Random(500 + name.len() as u64);
    let mut class = Class { name, given: Vec::new(), lengths: Vec::new() };
    let wanted = mechanisms[usize::from(name == "higher")];
    while class.lengths.len() < wanted {
        let (kinds, joints) = if name == "higher" { six_links(&mut dice, true) } else { pattern(&mut dice, name) };
        let planted = Planted::new(&mut dice, &kinds, &joints);
        let condition = planted.condition();
        if condition.is_nan() || condition > CONDITION {
            continue;
        }
        let Ok(scene) = Scene::read(&planted.scene()) else { continue };
        let Ok(mechanism) = mechanism(&scene) else { continue };
        if !matches!(mechanism.groups.as_slice(), [group] if group.class.numeral() == name) {
            continue;
        }
        let Ok(pose) = pose(&mechanism, &scene.near) else { continue };
        let Some(angle) = driven_to(&mechanism) else { continue };
        let Some((condition, errors)) = given(&mechanism, &pose) else { continue };
        let table = || {
            let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).ok()?).ok()?;
            path.follow_to(angle + 1e-3);
            row(&path, &mechanism, angle)
        };
        let Some(reading) = reading(&mechanism, &pose, angle, table().as_deref()) else { continue };
        class.given.push((condition, errors));
        class.lengths.push(reading);
    }
    class
}

/// Condition and errors where the pose counts as given.
fn given(mechanism: &Mechanism, pose: &Pose) -> Option<(f64, [f64; 2])> {
    let moved = motion(mechanism, pose, Order::Acceleration).ok()?;
    let points: Vec<[f64; 2]> = pose.points.iter().map(|p| [p.x, p.y]).collect();
    let guides: Vec<[f64; 2]> = pose.guides.iter().map(|g| [g.x, g.y]).collect();
    let truth = Truth::new(mechanism, &points, &guides)?;
    let general = general_at(mechanism, &Given::new(mechanism, &points, &guides))?;
    let condition = moved.conditions.iter().copied().fold(1.0, f64::max);
    let errors = [
        worst(mechanism, &truth, |id| [moved.body(id).omega, moved.body(id).alpha]),
        worst(mechanism, &truth, |id| general[id.0]),
    ];
    Some((condition, errors))
}

/// The scene's mechanism at its own position.
fn scene(text: &str) -> (Mechanism, Pose) {
    let scene = Scene::read(text).expect("a good scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let pose = pose(&mechanism, &scene.near).expect("it can be assembled");
    (mechanism, pose)
}

/// Readings at values of the drive, which the path has reached.
fn readings(mechanism: &Mechanism, path: &Path, values: impl Iterator<Item = f64>) -> Vec<(f64, Reading)> {
    let mut walker = path.walker();
    let mut read = |value: f64| {
        let pose = walker.position(value)?.pose();
        Some((value, reading(mechanism, &pose, value, row(path, mechanism, value).as_deref())?))
    };
    values.filter_map(&mut read).collect()
}

fn cycle(name: &str, text: &str, positions: u32) -> Followed {
    let (mechanism, pose) = scene(text);
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a drive")).expect("regular");
    path.cover(None, None).expect("it can be followed");
    let [low, high] = [path.low(), path.high()];
    let values = (0..positions).map(|k| low + (high - low) * (f64::from(k) + 0.5) / f64::from(positions));
    let readings = readings(&mechanism, &path, values).into_iter().map(|(_, reading)| reading).collect();
    Followed { name: name.to_owned(), readings }
}

fn approach(name: &'static str, text: &str, places: &[(f64, f64)]) -> Approach {
    let (mechanism, pose) = scene(text);
    let mut path = Path::new(&mechanism, &pose, Drive::new(&mechanism, None).expect("a drive")).expect("regular");
    path.follow_to(30.0);
    path.follow_to(140.0);
    let read = |(distance, value): &(f64, f64)| {
        let found = readings(&mechanism, &path, std::iter::once(*value)).pop()?;
        Some((*distance, found.1))
    };
    Approach { name, rows: places.iter().filter_map(read).collect() }
}
