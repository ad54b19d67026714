//! Four ways from lengths to rates, for mechanisms of all classes with pins and with sliders, ordinary and hard ones: how wrong each is, how
//! much larger than the error its bound is, and what it costs.

use super::lengths::six_links;
use super::planted::{Planted, pattern};
use super::random::Random;
use super::survey::median;
use crate::whole_errors::truth::{Real, Truth, error, rounded};
use kinegon::Order;
use kinegon::accuracy::{Bounds, bounds};
use kinegon::cycle::{Drive, Happening, Path, Steps, Sweep};
use kinegon::mechanism::{BodyId, Mechanism, Role, mechanism};
use kinegon::motion::{Motion, motion};
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The ways, from the quickest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    Table,
    Position,
    Proved,
    Reference,
}

impl Route {
    pub const ALL: [Route; 4] = [Route::Table, Route::Position, Route::Proved, Route::Reference];

    pub fn name(self) -> &'static str {
        ["f64", "f64 with bound", "proved", "256 bits"][self as usize]
    }

    pub fn says(self) -> &'static str {
        [
            "a row of a table: `cycle::Sweep`; also curves, films, the workbench while a joint is pulled",
            "one position with the condition and a bound of what its computation loses: `position::pose`, `motion::motion`",
            "the same with a proved bound of the whole error, from the text on: `accuracy::bounds`; all that `solve`, `steps` and `check` print",
            "the equations of all joints for all links at once, from that position on: `tests/support/whole_errors/truth.rs`; not in the library",
        ][self as usize]
    }
}

/// Why a mechanism is hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hardness {
    Ordinary,
    IllConditioned,
    Short,
    Far,
    Limit,
}

impl Hardness {
    pub const ALL: [Hardness; 5] =
        [Hardness::Ordinary, Hardness::IllConditioned, Hardness::Short, Hardness::Far, Hardness::Limit];

    pub fn name(self) -> &'static str {
        [
            "ordinary",
            "joint equations of condition 10⁴ to 10⁷",
            "a link of 10⁻⁶ of the others' size",
            "10⁶ times its size from the origin",
            "10⁻⁴° before a limit",
        ][self as usize]
    }
}

/// Classes of groups.
pub const CLASSES: [&str; 4] = ["II", "III", "IV", "higher"];

/// What was found of the mechanisms of one class, with or without sliders, hard for one reason.
pub struct Cell {
    pub class: &'static str,
    pub sliders: bool,
    pub hardness: Hardness,
    /// Mechanisms that were solved, of these those with a proof.
    pub solved: usize,
    pub proved: usize,
    pub condition: f64,
    /// By mechanism: the largest error of a row of a table and of one position, and the largest stated proved bound, all as
    /// parts of the largest ω or α.
    pub errors: Vec<[f64; 3]>,
    /// Stated over true error, of all rates that err.
    pub pessimism: Vec<f64>,
}

/// All cells, and by class the times of the ways for an ordinary mechanism, in nanoseconds.
pub struct Routes {
    pub cells: Vec<Cell>,
    pub times: [[f64; 4]; 4],
}

/// Mechanisms of a cell; of higher class, whose positions take a search, fewer.
const MECHANISMS: [usize; 2] = [24, 6];

/// Mechanisms that are thrown before a cell is given up: few have a limit nearby or an ill condition.
const THROWN: usize = 60_000;

/// Rows of the tables that are timed, and how far they reach, in degrees.
const ROWS: u32 = 512;
const REACH: f64 = 0.05;

/// Rounds that are timed; the quickest counts.
const ROUNDS: usize = 12;

/// Degrees before a limit.
const BEFORE_LIMIT: f64 = 1e-4;

impl Routes {
    pub fn new() -> Routes {
        Routes::with(MECHANISMS)
    }

    /// With so many mechanisms in a cell, and of higher class.
    pub fn with(mechanisms: [usize; 2]) -> Routes {
        let mut cells = Vec::new();
        let mut times = [[f64::NAN; 4]; 4];
        for (number, class) in CLASSES.into_iter().enumerate() {
            let mut ordinary = Vec::new();
            for sliders in [false, true] {
                for hardness in Hardness::ALL {
                    let wanted = mechanisms[usize::from(class == "higher")];
                    let found = found(class, sliders, hardness, wanted);
                    cells.push(Cell::new(class, sliders, hardness, &found));
                    if hardness == Hardness::Ordinary {
                        ordinary.extend(found);
                    }
                }
            }
            times[number] = Route::ALL.map(|route| time(&ordinary, route));
        }
        Routes { cells, times }
    }

    /// The cells of a class that are hard for this reason, pins only first.
    pub fn of(&self, class: &str, hardness: Hardness) -> impl Iterator<Item = &Cell> {
        self.cells.iter().filter(move |cell| cell.class == class && cell.hardness == hardness)
    }
}

/// A mechanism in its position.
struct Found {
    text: Value,
    scene: Scene,
    mechanism: Mechanism,
    pose: Pose,
    motion: Motion,
    angle: f64,
}

impl Found {
    fn new(text: &str) -> Option<Found> {
        let mut text: Value = serde_json::from_str(text).ok()?;
        shorten(&mut text);
        let scene = Scene::read(&text.to_string()).ok()?;
        let mechanism = mechanism(&scene).ok()?;
        let pose = pose(&mechanism, &scene.near).ok()?;
        let motion = motion(&mechanism, &pose, Order::Acceleration).ok()?;
        let angle = mechanism.bodies.iter().find_map(|body| match body.role {
            Role::Driver { angle, .. } => angle,
            _ => None,
        })?;
        Some(Found { text, scene, mechanism, pose, motion, angle })
    }

    fn condition(&self) -> f64 {
        self.motion.conditions.iter().copied().fold(1.0, f64::max)
    }

    /// Whether some link neither rests nor moves with the crank, so that there is something to err.
    fn is_moved(&self) -> bool {
        let omegas = self.members().into_iter().map(|id| self.motion.body(id).omega);
        omegas.into_iter().any(|omega| omega.abs() > 1e-6 && (omega - 1.0).abs() > 1e-6)
    }

    fn bounds(&self) -> Bounds<'_> {
        bounds(&self.scene, &self.mechanism, &self.pose, &self.motion)
    }

    fn path(&self) -> Option<Path<'_>> {
        Path::new(&self.mechanism, &self.pose, Drive::new(&self.mechanism, None).ok()?).ok()
    }

    /// Links of the group.
    fn members(&self) -> Vec<BodyId> {
        let links = self.mechanism.links().filter(|(_, body)| matches!(body.role, Role::Member));
        links.map(|(id, _)| id).collect()
    }

    /// Names of the members' rates, ω and α of each in turn.
    fn names(&self) -> Vec<String> {
        let members = self.members().into_iter();
        members
            .flat_map(|id| ["omega", "alpha"].map(|head| format!("{head}({})", self.mechanism.body(id).name)))
            .collect()
    }

    /// The members' rates in a table at the scene's own position.
    fn table(&self) -> Option<Vec<f64>> {
        let mut path = self.path()?;
        path.follow_to(self.angle + 1e-6);
        let sweep = Sweep::new(&path, Steps::new(self.angle, self.angle, 1.0).ok()?, Some(&self.names())).ok()?;
        let numbers: Option<Vec<f64>> = sweep.rows(0..1).into_iter().collect();
        Some(numbers?.split_off(1))
    }

    fn truth(&self) -> Option<Truth> {
        let points = self.mechanism.points.iter().zip(&self.pose.points);
        let places: BTreeMap<String, [f64; 2]> = points.map(|(name, p)| (name.clone(), [p.x, p.y])).collect();
        let axes = self.mechanism.links().filter_map(|(id, body)| {
            let axis = self.pose.axes[id.0]?;
            Some((body.name.clone(), [axis.x, axis.y]))
        });
        Truth::new(&self.text, &places, &axes.collect())
    }

    /// The scene with its crank just before the limit that it runs into, if it does within a turn.
    fn before_limit(&self) -> Option<String> {
        let mut path = self.path()?;
        path.follow_to(self.angle + 360.0);
        let end = path.end(true)?;
        let angle = end.at - BEFORE_LIMIT;
        if !matches!(end.what, Happening::Limit(_)) || angle < self.angle {
            return None;
        }
        let mut walker = path.walker();
        let pose = walker.position(angle)?.pose();
        let mut text = self.text.clone();
        for (name, near) in text["near"].as_object_mut()? {
            let place = pose.point(self.mechanism.point(name)?);
            *near = json!([place.x, place.y]);
        }
        text["links"]["b1"]["drive"]["angle"] = json!(angle);
        Some(text.to_string())
    }
}

/// Numbers of a scene with 13 digits: of longer ones serde_json may read the last bit wrong, and then the truth is another scene's.
fn shorten(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let short: Option<f64> = number.as_f64().and_then(|x| format!("{x:.12e}").parse().ok());
            *value = json!(short);
        }
        Value::Array(all) => all.iter_mut().for_each(shorten),
        Value::Object(all) => all.values_mut().for_each(shorten),
        _ => {}
    }
}

/// A mechanism by lot, made hard; most are none of this kind.
fn thrown(dice: &mut Random, class: &str, sliders: bool, hardness: Hardness) -> Option<Found> {
    let (kinds, joints) = if class == "higher" { six_links(dice, sliders) } else { pattern(dice, class) };
    let kinds = if sliders { kinds } else { "R".repeat(joints.len()) };
    if kinds.contains('P') != sliders {
        return None;
    }
    let mut planted = Planted::new(dice, &kinds, &joints);
    planted.scale = 100.0;
    let condition = planted.condition();
    let conditions = if hardness == Hardness::IllConditioned { 1e4..1e7 } else { 1.0..300.0 };
    if !conditions.contains(&condition) {
        return None;
    }
    match hardness {
        Hardness::Short => planted.shrink(2 + dice.below(planted.bodies.len() - 2), 1e-6),
        Hardness::Far => planted.shift([1e6, -1e6]),
        _ => {}
    }
    let found = Found::new(&planted.scene())?;
    let [group] = found.mechanism.groups.as_slice() else { return None };
    if group.class.numeral() != class || !found.is_moved() {
        return None;
    }
    if hardness == Hardness::Limit { Found::new(&found.before_limit()?) } else { Some(found) }
}

fn found(class: &'static str, sliders: bool, hardness: Hardness, wanted: usize) -> Vec<Found> {
    let mut dice = Random(700 + class.len() as u64 + 10 * u64::from(sliders) + 20 * hardness as u64);
    let thrown = (0..THROWN).filter_map(|_| thrown(&mut dice, class, sliders, hardness));
    thrown.take(wanted).collect()
}

impl Cell {
    fn new(class: &'static str, sliders: bool, hardness: Hardness, found: &[Found]) -> Cell {
        let mut cell = Cell {
            class,
            sliders,
            hardness,
            solved: 0,
            proved: 0,
            condition: median(found.iter().map(Found::condition)).unwrap_or(f64::NAN),
            errors: Vec::new(),
            pessimism: Vec::new(),
        };
        for one in found {
            cell.see(one);
        }
        cell
    }

    fn see(&mut self, found: &Found) {
        let (Some(truth), Some(table)) = (found.truth(), found.table()) else { return };
        self.solved += 1;
        let bounds = found.bounds();
        self.proved += usize::from(bounds.is_proved(0));
        let of = |id: BodyId| truth.link(&found.mechanism.body(id).name).map(|(rates, _)| rates);
        let size = |order: usize| {
            let links = found.mechanism.links().filter_map(|(id, _)| of(id));
            links.map(|rates| rounded(&rates[order]).abs()).fold(0.0, f64::max)
        };
        // Where nothing is accelerated, the normal acceleration's ω² stands for α.
        let sizes = [size(0), size(1).max(size(0) * size(0))];
        let mut worst = [0.0_f64; 3];
        for (index, id) in found.members().into_iter().enumerate() {
            let Some(rates) = of(id) else { continue };
            let body = found.motion.body(id);
            let stated = bounds.angular_rates(id);
            for (order, got) in [body.omega, body.alpha].into_iter().enumerate() {
                let off = error(got, &rates[order]);
                let of_table = error_or_infinite(table[2 * index + order], &rates[order]);
                for (worst, part) in worst.iter_mut().zip([of_table, off, stated[order]]) {
                    *worst = worst.max(part / sizes[order]);
                }
                // Errors below are the roundings of zeros.
                if off > 1e-25 * sizes[order] && stated[order].is_finite() {
                    self.pessimism.push(stated[order] / off);
                }
            }
        }
        // Less than this is the rounding of a true zero.
        self.errors.push(worst.map(|part| if part < 1e-25 { 0.0 } else { part }));
    }

    /// Median and largest error of a way; the last is what is stated.
    pub fn errors_of(&self, way: usize) -> [f64; 2] {
        let errors = || self.errors.iter().map(|errors| errors[way]);
        [median(errors()).unwrap_or(f64::NAN), errors().fold(0.0, f64::max)]
    }
}

fn error_or_infinite(number: f64, truth: &Real) -> f64 {
    if number.is_finite() { error(number, truth) } else { f64::INFINITY }
}

/// Nanoseconds that a way takes for one of these mechanisms, in the mean.
fn time(found: &[Found], route: Route) -> f64 {
    let rounds = if route == Route::Reference { 1 } else { ROUNDS };
    let total: f64 = found.iter().map(|one| quickest(one, route, rounds)).sum();
    total / found.len() as f64
}

fn quickest(found: &Found, route: Route, rounds: usize) -> f64 {
    let timed = |work: &mut dyn FnMut()| {
        let once = |_| {
            let start = Instant::now();
            work();
            start.elapsed()
        };
        (0..rounds).map(once).min().unwrap_or(Duration::ZERO).as_secs_f64() * 1e9
    };
    let posed = || {
        let pose = pose(&found.mechanism, &found.scene.near).expect("it was found before");
        let motion = motion(&found.mechanism, &pose, Order::Acceleration).expect("it was regular");
        (pose, motion)
    };
    match route {
        Route::Table => {
            let Some(mut path) = found.path() else { return f64::NAN };
            path.follow_to(found.angle + REACH);
            let step = REACH / f64::from(ROWS);
            let steps = Steps::new(found.angle, found.angle + REACH - step, step).expect("a range");
            let sweep = Sweep::new(&path, steps, Some(&found.names())).expect("rates of its links");
            let mut rows = 0;
            let all = timed(&mut || rows = black_box(sweep.rows(0..ROWS as usize)).len());
            if rows == 0 { f64::NAN } else { all / f64::from(ROWS) }
        }
        Route::Position => timed(&mut || {
            black_box(posed());
        }),
        Route::Proved => timed(&mut || {
            let (pose, motion) = posed();
            let bounds = bounds(&found.scene, &found.mechanism, &pose, &motion);
            black_box(found.members().into_iter().map(|id| bounds.angular_rates(id)).collect::<Vec<_>>());
        }),
        Route::Reference => timed(&mut || {
            black_box(found.truth());
        }),
    }
}
