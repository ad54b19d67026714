//! Random groups of every class followed over a turn of their crank: position for position the nearest of all assembly modes, which are
//! found anew and know nothing of a path.

use super::{TURN, followed, path, posed, scenes};
use kinegon::cycle::{Event, Happening, Path};
use kinegon::geometry::{degrees_of, span};
use kinegon::mechanism::{Mechanism, Role};
use kinegon::position::{Pose, poses};
use kinegon::scene::Near;
use support::exact::exceeds;
use support::planted::{Planted, pattern};
use support::random::Random;
use support::survey::{BRANCH_ENDS, BRANCH_STEP, BRANCH_UNCLEAR, BRANCHES};

/// Mechanisms of each class.
fn enough() -> usize {
    BRANCHES.now()
}

/// The largest condition number of a planted position.
const CONDITION: f64 = 1e3;

/// The drive's step in turns, or sizes of the mechanism.
fn step() -> f64 {
    BRANCH_STEP.now()
}

/// The nearest mode counts as the next position where the next but one is this many times as far.
const CLEARLY: f64 = 5.0;

/// How far a position may be from the same found otherwise, in sizes of the mechanism; the worst seen is 2e-14.
const SAME: f64 = 1e-12;

/// The mechanism with its crank at another angle.
fn turned(mechanism: &Mechanism, value: f64) -> Mechanism {
    let mut turned = mechanism.clone();
    for body in &mut turned.bodies {
        if let Role::Driver { angle, .. } = &mut body.role {
            *angle = Some(value);
        }
    }
    turned
}

/// The mechanism with all drives as they stand in a position.
fn standing(mechanism: &Mechanism, position: &Pose) -> Mechanism {
    let mut standing = mechanism.clone();
    for (id, body) in standing.bodies.iter_mut().enumerate() {
        if let Role::Driver { angle, .. } = &mut body.role {
            *angle = position.axes[id].map(degrees_of);
        }
    }
    for (id, slider) in standing.sliders.iter_mut().enumerate() {
        if let Some(drive) = &mut slider.drive {
            drive.position = position.slides[id];
        }
    }
    standing
}

fn modes(mechanism: &Mechanism, value: f64) -> Vec<Pose> {
    poses(&turned(mechanism, value), &Near::default()).unwrap_or_default()
}

/// The largest distance of a point from one pose to another.
fn distance(a: &Pose, b: &Pose) -> f64 {
    let points = a.points.iter().zip(&b.points);
    points.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// What all mechanisms of a class gave.
#[derive(Default, Debug)]
struct Seen {
    positions: usize,
    unclear: usize,
    turns: usize,
    limits: usize,
    run_off: usize,
    largest_error: f64,
    problems: Vec<String>,
}

impl Seen {
    /// Compares every position with the mode nearest to the position before.
    fn is_nearest(&mut self, path: &Path, size: f64) {
        let mut walker = path.walker();
        let mut before: Option<Pose> = None;
        let wide = path.high() - path.low();
        let unit = if path.drive.is_angle { TURN } else { size };
        let steps = (wide / unit / step()) as usize;
        for k in 0..steps {
            let value = path.low() + wide * k as f64 / steps as f64;
            let Some(position) = walker.position(value) else {
                self.problems.push(format!("no position at {value}"));
                return;
            };
            let here = position.pose();
            if let Some(before) = before {
                let mut all = poses(&standing(&path.mechanism, &here), &Near::default()).unwrap_or_default();
                all.sort_by(|a, b| distance(a, &before).total_cmp(&distance(b, &before)));
                let away = |i: usize| all.get(i).map_or(f64::INFINITY, |p| distance(p, &before));
                if away(0) < (away(1) / CLEARLY).min(0.2 * size) {
                    self.positions += 1;
                    self.same(&all[0], &here, size, value);
                } else {
                    self.unclear += 1;
                }
            }
            before = Some(here);
        }
    }

    fn same(&mut self, a: &Pose, b: &Pose, size: f64, value: f64) {
        let off = distance(a, b) / size;
        self.largest_error = self.largest_error.max(off);
        if exceeds(off, SAME) {
            self.problems.push(format!("{off:e} off at {value}"));
        }
    }

    /// At a limit two modes meet and are gone beyond; where places run off to infinity there is no limit.
    fn ends(&mut self, path: &Path) {
        for (above, beyond) in [(false, -1e-4), (true, 1e-4)] {
            let Some(end) = path.end(above) else {
                self.turns += 1;
                continue;
            };
            let [inside, outside] = [-beyond, beyond].map(|by| modes(&path.mechanism, end.at + by).len());
            match end.what {
                Happening::Limit(_) if inside == outside + 2 => self.limits += 1,
                Happening::RunsOff(_) if inside == outside => self.run_off += 1,
                _ => {
                    let text = format!("{end:?}: {inside} modes before, {outside} after");
                    self.problems.push(text);
                }
            }
        }
    }

    /// A path that starts at another of its positions is the same path, with the same ends.
    fn starts_anywhere(&mut self, path: &Path, size: f64) {
        let [low, high] = [path.low(), path.high()];
        let at = |part: f64| low + part * (high - low);
        for start in [0.001, 0.4, 0.999].map(at) {
            let mut walker = path.walker();
            let pose = walker.position(start).expect("it is on the path").pose();
            let mechanism = turned(&path.mechanism, start);
            let mut other = self::path(&mechanism, &pose);
            other.follow_to(low - 1.0);
            other.follow_to(high + 1.0);
            for value in (1..20).map(|k| at(0.05 * f64::from(k))) {
                let mut others = other.walker();
                let (here, there) = (walker.position(value), others.position(value));
                match (here, there) {
                    (Some(a), Some(b)) => self.same(&a.pose(), &b.pose(), size, value),
                    _ => self.problems.push(format!("from {start}: no position at {value}")),
                }
            }
            for above in [false, true] {
                let [a, b] = [path, &other].map(|p| p.end(above).map(|e| e.at));
                let apart = a.zip(b).map(|(a, b)| (a - b).abs());
                if a.is_some() && !apart.is_some_and(|apart| apart < 1e-12 * TURN) {
                    self.problems.push(format!("from {start}: it ends at {b:?}, not {a:?}"));
                }
            }
        }
    }
}

fn follow(class: &str, seed: u64) {
    let mut random = Random(seed);
    let mut seen = Seen::default();
    let mut mechanisms = 0;
    while mechanisms < enough() {
        let (kinds, joints) = pattern(&mut random, class);
        let planted = Planted::new(&mut random, &kinds, &joints);
        let condition = planted.condition();
        if condition.is_nan() || condition > CONDITION {
            continue;
        }
        mechanisms += 1;
        let (mechanism, pose) = posed(&planted.scene());
        // Places are within ±1, times the scale.
        let size = 2.0 * planted.scale;
        let mut path = path(&mechanism, &pose);
        path.cover(None, None).expect("a turn can be followed");
        let problems = seen.problems.len();
        seen.is_nearest(&path, size);
        seen.ends(&path);
        seen.starts_anywhere(&path, size);
        let turns_back = |e: &Event| matches!(e.what, Happening::TurnsBack { .. } | Happening::SlidesBack { .. });
        if let Some(event) = path.events().iter().find(|e| !e.is_end() && !turns_back(e)) {
            seen.problems.push(format!("{event:?}"));
        }
        if seen.problems.len() > problems {
            seen.problems.push(format!("{kinds}\n{}", planted.scene()));
        }
    }
    let Seen { positions, unclear, turns, limits, run_off, largest_error, .. } = seen;
    println!(
        "{class}: {positions} positions, {unclear} unclear, largest error {largest_error:.1e}; \
         ends: {turns} full turns, {limits} limits, {run_off} to infinity"
    );
    let count = seen.problems.len();
    seen.problems.truncate(12);
    assert!(count == 0, "{count}:\n{}", seen.problems.join("\n"));
    assert!(unclear * BRANCH_UNCLEAR.now() < positions && turns.min(limits) * BRANCH_ENDS.now() > enough());
}

#[test]
fn dyads() {
    follow("II", 0x21);
}

#[test]
fn third_class() {
    follow("III", 0x22);
}

#[test]
fn fourth_class() {
    follow("IV", 0x23);
}

/// Starting scenes: chains of groups, sliders that drive, several drives.
#[test]
fn starting_scenes() {
    for (name, text) in scenes() {
        let (mechanism, pose) = posed(&text);
        let mut seen = Seen::default();
        let size = span(pose.points.iter().copied());
        seen.is_nearest(&followed(&mechanism, &pose), size);
        let Seen { positions, unclear, largest_error, problems, .. } = seen;
        println!("{name}: {positions} positions, {unclear} unclear, largest error {largest_error:.1e}");
        assert!(problems.is_empty(), "{name}: {}", problems.join("\n"));
        assert!(unclear * 20 < positions, "{name}");
    }
}
