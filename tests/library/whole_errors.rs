//! Every stated error of a result holds against the truth of the scene as it is written: of positions, rates, velocities
//! and accelerations, from lengths and as drawn; and so does every digit of `--digits`.
//!
//! The truth has 256 bits and comes from equations of all joints for all links at once (`support::whole_errors::truth`). The mechanisms are
//! random (`support::whole_errors::grow`).

use kinegon::Solution;
use kinegon::construction::{Course, CutLine, Special};
use kinegon::format::{QuantityResult, ResultFile};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::thread;
use support::files;
use support::random::Random;
use support::stages::solved;
use support::survey::{WHOLE, WHOLE_POSITIONS};
use support::whole_errors::grow::Grown;
use support::whole_errors::truth::{self, Pair, Real, Truth, cross, error, minus, plus, rounded};

/// Mechanisms, each from lengths and as drawn.
fn count() -> u64 {
    WHOLE.now()
}

/// The stated bound is at most this many errors, in the middle of all numbers.
const WASTEFUL: f64 = 3.0;

/// Few numbers are off by more than this part of themselves …
const COARSE: f64 = 1e-9;

/// … and none by this.
const WRONG: f64 = 1e-3;

/// The two routes may differ by so many times as much as they do, in the middle of all groups.
const GENEROUS: f64 = 2000.0;

#[derive(Default)]
pub(crate) struct Seen {
    /// Solved from lengths, and as drawn.
    solved: [usize; 2],
    refused: usize,
    /// The truth could not be found: next to a singular position.
    untold: usize,
    /// By class of group.
    classes: BTreeMap<String, usize>,
    numbers: usize,
    /// Those of them that are rates of links and sliders.
    rates: usize,
    /// Off by more than [`COARSE`].
    coarse: usize,
    /// Without a bound.
    unbounded: usize,
    /// Groups, and those of which all is proved.
    groups: usize,
    proved: usize,
    exact: usize,
    /// Bound over error.
    shares: Vec<f64>,
    /// Lengths and segments that the construction measures.
    measured: usize,
    digits: usize,
    /// Difference that the two routes to a group's rates may have, over the difference that they have.
    routes: Vec<f64>,
    failures: Vec<String>,
}

impl Seen {
    pub(crate) fn refuse(&mut self, name: &str, why: &str) {
        println!("{name}: {why}");
        self.refused += 1;
    }

    pub(crate) fn untell(&mut self) {
        self.untold += 1;
    }

    pub(crate) fn solve(&mut self) {
        self.solved[0] += 1;
    }

    pub(crate) fn join(&mut self, other: Seen) {
        self.solved = [self.solved[0] + other.solved[0], self.solved[1] + other.solved[1]];
        self.refused += other.refused;
        self.untold += other.untold;
        for (class, count) in other.classes {
            *self.classes.entry(class).or_default() += count;
        }
        self.numbers += other.numbers;
        self.rates += other.rates;
        self.coarse += other.coarse;
        self.unbounded += other.unbounded;
        self.groups += other.groups;
        self.proved += other.proved;
        self.exact += other.exact;
        self.shares.extend(other.shares);
        self.measured += other.measured;
        self.digits += other.digits;
        self.routes.extend(other.routes);
        self.failures.extend(other.failures);
    }

    pub(crate) fn number(&mut self, name: impl Fn() -> String, value: f64, bound: f64, truth: &Real) {
        self.numbers += 1;
        if !bound.is_finite() {
            self.unbounded += 1;
            return;
        }
        let error = error(value, truth);
        // A stated error may be large, but not so large that the number is another one.
        let part = error / (1.0 + rounded(truth).abs());
        self.coarse += usize::from(part > COARSE);
        if part > WRONG {
            self.failures.push(format!("{} = {value:e}: truly {:e}", name(), rounded(truth)));
        }
        // The f64 next to a given decimal is printed as that decimal.
        let allowed = if bound == 0.0 { 0.5 * f64::EPSILON * value.abs() } else { bound };
        if error > allowed + 1e-40 {
            self.failures.push(format!("{} = {value:e}: error {error:e}, stated {bound:e}", name()));
        } else if error < 1e-40 {
            self.exact += 1;
        } else if bound > 0.0 {
            self.shares.push(bound / error);
        }
    }

    fn pair(&mut self, name: &str, value: Option<[f64; 2]>, bound: Option<f64>, truth: &Pair) {
        if let (Some(value), Some(bound)) = (value, bound) {
            for axis in 0..2 {
                self.number(|| format!("{name}.{}", ["x", "y"][axis]), value[axis], bound, &truth[axis]);
            }
        }
    }

    /// Says what was seen, and fails where a stated error is exceeded.
    fn report(&mut self) {
        self.shares.sort_by(f64::total_cmp);
        self.routes.sort_by(f64::total_cmp);
        println!(
            "{:?} solved from lengths and as drawn, {} refused, {} too near a singular position for the truth, groups {:?}",
            self.solved, self.refused, self.untold, self.classes,
        );
        println!(
            "{} numbers, {} of them rates, {} without a bound, {} coarse, {} comparisons exact; bound / error: least {:.3}, median {:.1}, 90 % below {:.0}; {} lengths and segments measured; {} printed digits compared; {} failures",
            self.numbers,
            self.rates,
            self.unbounded,
            self.coarse,
            self.exact,
            self.shares[0],
            self.shares[self.shares.len() / 2],
            self.shares[self.shares.len() * 9 / 10],
            self.measured,
            self.digits,
            self.failures.len(),
        );
        println!("{} of {} groups proved", self.proved, self.groups);
        let failures = self.failures.len();
        self.failures.truncate(20);
        assert!(failures == 0, "{failures} failures\n{}", self.failures.join("\n"));
    }

    /// How many rates were compared; none exceeds its stated error, and nearly all have one: all but this part.
    pub(crate) fn holds(mut self, unbounded: f64) -> usize {
        self.report();
        assert!(self.untold * 20 <= self.solved[0], "{} of {} positions are untold", self.untold, self.solved[0]);
        let without = self.unbounded as f64 / self.numbers as f64;
        assert!(without <= unbounded, "{} of {} numbers have no bound", self.unbounded, self.numbers);
        self.rates
    }

    /// The same of all numbers.
    pub(crate) fn holds_numbers(self, unbounded: f64) -> usize {
        let numbers = self.numbers;
        self.holds(unbounded);
        numbers
    }

    fn demand(mut self) {
        self.report();
        let (median, routes) = (self.shares[self.shares.len() / 2], self.routes[self.routes.len() / 2]);
        println!("allowed over actual difference of the two routes: least {:.1}, median {routes:.0}", self.routes[0]);
        assert!(median < WASTEFUL, "the bounds say too little: {median}");
        assert!(self.routes[0] >= 1.0 && routes < GENEROUS, "the routes may differ by too much: {routes}");
        assert!(self.coarse * 1000 < self.numbers, "{} of {} numbers are coarse", self.coarse, self.numbers);
        assert!(self.measured > 0, "nothing was measured");
        assert!((self.groups - self.proved) * 1000 <= self.groups, "{} of {} groups proved", self.proved, self.groups);
        assert!(self.unbounded * 1000 <= self.numbers, "{} of {} numbers have no bound", self.unbounded, self.numbers);
    }
}

#[test]
fn of_random_mechanisms_from_lengths_and_as_drawn() {
    let cores = thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let mut all = Seen::default();
    thread::scope(|scope| {
        let work = |core: u64| {
            scope.spawn(move || {
                let mut seen = Seen::default();
                let mut number = core;
                // Until each core has its share of solved mechanisms.
                while (seen.solved[0] as u64) < count() / cores {
                    see(number, &mut seen);
                    number += cores;
                }
                seen
            })
        };
        for thread in (0..cores).map(work).collect::<Vec<_>>() {
            all.join(thread.join().expect("a case went through"));
        }
    });
    all.demand();
}

/// Scenes with groups of higher class, cylinders and levers among them, with their cranks anywhere.
#[test]
fn of_starting_scenes_and_driven_sliders() {
    let mut scenes = files::templates();
    scenes.extend(files::scenes("tests/driven_sliders"));
    let mut seen = Seen::default();
    let dice = &mut Random(16);
    for (name, text) in &scenes {
        let mut scene: Value = serde_json::from_str(text).expect("a scene is JSON");
        remove_notes(&mut scene);
        // The truth has pins and guides alone; `gears` holds wheels to their own, `cams` profiles.
        if ["points", "gears", "contacts"].into_iter().any(|key| scene.get(key).is_some()) {
            continue;
        }
        for turn in 0..WHOLE_POSITIONS.now() {
            let mut scene = scene.clone();
            scene.as_object_mut().expect("an object").shift_remove("want");
            for link in scene["links"].as_object_mut().expect("links").values_mut() {
                if let Some(angle) = link.get_mut("drive").and_then(|drive| drive.get_mut("angle")) {
                    let turned = angle.as_f64().expect("degrees") + dice.within(20.0);
                    *angle = json!((turned * 10.0).round() / 10.0);
                }
            }
            match solved(&scene.to_string()) {
                Ok(solution) => compare(&format!("lengths {name} {turn}"), &scene, &solution, 0, &mut seen),
                Err(_) => seen.refused += 1,
            }
        }
    }
    seen.demand();
}

/// Notes may stand in every object, beside points too.
pub(crate) fn remove_notes(value: &mut Value) {
    if let Some(object) = value.as_object_mut() {
        object.shift_remove("note");
        object.values_mut().for_each(remove_notes);
    }
    if let Some(list) = value.as_array_mut() {
        list.iter_mut().for_each(remove_notes);
    }
}

fn see(number: u64, seen: &mut Seen) {
    let dice = &mut Random(Random(number).next());
    let grown = Grown::new(dice);
    let free: Vec<usize> = (1..grown.links()).filter(|&link| !grown.is_driven(link)).collect();
    let given_angle = (grown.cranks() == 1 && dice.below(4) == 0).then(|| free[dice.below(free.len())]);
    let scene = grown.scene(dice, given_angle);
    let Ok(solution) = solved(&scene.to_string()) else {
        seen.refused += 1;
        return;
    };
    compare(&format!("lengths {number}"), &scene, &solution, 0, seen);
    let drawn = drawn(&scene, &solution);
    if let Ok(solution) = solved(&drawn.to_string()) {
        compare(&format!("drawn {number}"), &drawn, &solution, 1, seen);
    }
}

/// The scene as drawn in the position found, with coordinates of a few digits.
fn drawn(scene: &Value, solution: &Solution) -> Value {
    let mechanism = &solution.mechanism;
    let short = |x: f64| (x * 100.0).round() / 100.0;
    let points: Map<String, Value> = (mechanism.points.iter().zip(&solution.pose.points))
        .map(|(name, p)| (name.clone(), json!([short(p.x), short(p.y)])))
        .collect();
    let without = |value: &Value, keys: &[&str]| {
        let mut value = value.clone();
        for key in keys {
            value.as_object_mut().expect("an object").shift_remove(*key);
        }
        value
    };
    let links = scene["links"].as_object().expect("links").iter().map(|(name, link)| {
        let names = link["shape"].as_object().map(|shape| shape.keys().cloned().collect::<Vec<_>>());
        let mut given = json!({ "points": names.map_or(link["points"].clone(), |names| json!(names)) });
        if let Some(drive) = link.get("drive") {
            given["drive"] = without(drive, &["angle"]);
        }
        (name.clone(), given)
    });
    let sliders = scene["sliders"].as_array().expect("sliders").iter().enumerate().map(|(index, slider)| {
        let mut given = without(slider, &["turned", "through"]);
        // In the fixed frame.
        let along = solution.pose.guides[index];
        given["along"] = json!([short(along.x * 100.0), short(along.y * 100.0)]);
        if let Some(drive) = slider.get("drive") {
            given["drive"] = without(drive, &["position"]);
        }
        given
    });
    let ground: Vec<&String> = scene["ground"].as_object().expect("ground").keys().collect();
    json!({
        "kinegon": 1, "units": scene["units"], "points": points, "ground": ground,
        "links": links.collect::<Map<_, _>>(), "sliders": sliders.collect::<Vec<_>>(),
    })
}

/// The truth of a scene next to its solution.
pub(crate) fn truth_of(scene: &Value, solution: &Solution) -> Option<Truth> {
    let mechanism = &solution.mechanism;
    let points = mechanism.points.iter().zip(&solution.pose.points);
    let places: BTreeMap<String, [f64; 2]> = points.map(|(name, p)| (name.clone(), [p.x, p.y])).collect();
    let axes = mechanism.links().filter_map(|(id, body)| {
        let axis = solution.pose.axes[id.0]?;
        Some((body.name.clone(), [axis.x, axis.y]))
    });
    let axes: BTreeMap<String, [f64; 2]> = axes.collect();
    Truth::new(scene, &places, &axes)
}

pub(crate) fn compare(name: &str, scene: &Value, solution: &Solution, form: usize, seen: &mut Seen) {
    let mechanism = &solution.mechanism;
    let Some(truth) = truth_of(scene, solution) else {
        seen.untold += 1;
        return;
    };
    seen.solved[form] += 1;
    seen.routes.extend(
        solution
            .construction
            .agreement
            .iter()
            .flatten()
            .filter(|a| a.difference > 0.0)
            .map(|a| a.allowed / a.difference),
    );
    for group in &mechanism.groups {
        *seen.classes.entry(group.class.numeral().to_owned()).or_default() += 1;
    }
    let result = solution.whole_result().expect("all that is measured has a value");
    seen.groups += result.groups.len();
    seen.proved += result.groups.iter().filter(|group| group.proved).count();
    compare_result(name, &result, &truth, seen);
    compare_special(name, solution, &result, &truth, seen);
    compare_digits(name, &solution.digits(), &result, &truth, seen);
}

fn compare_result(name: &str, result: &ResultFile, truth: &Truth, seen: &mut Seen) {
    for (link, got) in &result.links {
        let Some(([omega, alpha], axis)) = truth.link(link) else { continue };
        seen.rates += 2;
        seen.number(|| format!("{name}: omega({link})"), got.omega, got.omega_error, &omega);
        let (number, bound) = (got.alpha.expect("α"), got.alpha_error.expect("its bound"));
        seen.number(|| format!("{name}: alpha({link})"), number, bound, &alpha);
        // Angles of one-point links as drawn are those of their guides; others from lengths only.
        if let (Some(angle), Some(bound), true) = (got.angle, got.angle_error, name.starts_with("lengths")) {
            let shown = truth::direction(&Value::from(angle));
            let off = rounded(&cross(&shown, &axis)).abs().to_degrees();
            seen.numbers += 1;
            // Degrees are found from a rounded sine.
            if bound.is_finite() && off > bound * (1.0 + 1e-9) + 1e-40 {
                seen.failures.push(format!("{name}: angle({link}) = {angle}: error {off:e}, stated {bound:e}"));
            }
        }
    }
    for (point, got) in &result.points {
        if got.on.is_some() {
            continue;
        }
        let all = truth.point(point).expect("a point");
        seen.pair(&format!("{name}: {point}"), got.position, got.position_error, &all.place);
        seen.pair(&format!("{name}: v({point})"), got.velocity, got.velocity_error, &all.motion[0]);
        seen.pair(&format!("{name}: a({point})"), got.acceleration, got.acceleration_error, &all.motion[1]);
    }
    let sliders: Vec<_> = truth.sliders().collect();
    for (slider, got) in &result.sliders {
        // Of several between the same two the second is `P/3#2`.
        let (name_of_first, number) = slider.split_once('#').unwrap_or((slider, "1"));
        let number: usize = number.parse().expect("a number");
        let all = sliders.iter().filter(|own| own.name == name_of_first).nth(number - 1).expect("its truth");
        seen.rates += 2;
        seen.number(|| format!("{name}: v_r({slider})"), got.velocity, got.velocity_error, &all.rates[0]);
        let (second, bound) = (got.acceleration.expect("a_r"), got.acceleration_error.expect("its bound"));
        seen.number(|| format!("{name}: a_r({slider})"), second, bound, &all.rates[1]);
        if let (Some(position), Some(bound), Some(truth)) = (got.position, got.position_error, &all.position) {
            seen.number(|| format!("{name}: position({slider})"), position, bound, truth);
        }
        seen.pair(&format!("{name}: a_c({slider})"), got.coriolis, got.coriolis_error, &all.coriolis);
    }
}

/// Special points: the crossings of their cut lines, and the motion of their links there.
fn compare_special(name: &str, solution: &Solution, result: &ResultFile, truth: &Truth, seen: &mut Seen) {
    let mechanism = &solution.mechanism;
    for special in solution.construction.special.iter().filter(|s| s.is_assur) {
        let got = &result.points[&special.name];
        let line = |cut: &CutLine| -> Option<[Pair; 2]> {
            let place = |point: kinegon::mechanism::PointId| truth.point(&mechanism.points[point.0]).map(|p| p.place);
            match cut.course {
                Course::Through(from, to) => {
                    let from = place(from)?;
                    Some([from.clone(), minus(&place(to?)?, &from)])
                }
                Course::Normal(slider, at) => {
                    let [x, y] = truth.along(mechanism.sliders[slider.0].given.expect("a slider of the scene"));
                    Some([place(at)?, [-y, x]])
                }
                Course::AtInfinity => None,
            }
        };
        let crossing = || -> Option<Pair> {
            let ([start, along], [other, across]) = (line(&special.cuts[0])?, line(&special.cuts[1])?);
            let t = cross(&minus(&other, &start), &across) / cross(&along, &across);
            Some(plus(&start, &[&along[0] * &t, &along[1] * &t]))
        };
        let Some(place) = crossing() else { continue };
        // A link that stands for a contact is none of the truth's.
        let Some([velocity, acceleration]) = truth.point_of(&mechanism.body(special.link).name, &place) else {
            continue;
        };
        let label = format!("{name}: {}", special.name);
        seen.pair(&label, got.position, got.position_error, &place);
        seen.pair(&format!("{label} v"), got.velocity, got.velocity_error, &velocity);
        seen.pair(&format!("{label} a"), got.acceleration, got.acceleration_error, &acceleration);
        compare_measured(name, solution, result, (special, &place, [velocity, acceleration]), truth, seen);
    }
}

/// What is measured for a special point: lengths from the joints of its legs, and segments along its rays. Of the acceleration relative to a leg's joint
/// the ray has what is across the cut line, whatever the parts that lead to its start.
fn compare_measured(
    name: &str,
    solution: &Solution,
    result: &ResultFile,
    (special, place, motion): (&Special, &Pair, [Pair; 2]),
    truth: &Truth,
    seen: &mut Seen,
) {
    let mechanism = &solution.mechanism;
    for (side, cut) in special.cuts.iter().enumerate() {
        let Course::Through(from, Some(to)) = cut.course else { continue };
        let [first, second] = [from, to].map(|point| &mechanism.points[point.0]);
        let (Some(start), Some(end)) = (truth.point(first), truth.point(second)) else { continue };
        let along = minus(&end.place, &start.place);
        let norm = |v: &Pair| (&v[0] * &v[0] + &v[1] * &v[1]).sqrt();
        let length = norm(&minus(place, &end.place));
        let mut of = |quantity: String, truth: &Real| {
            let (Some(QuantityResult::Number(value)), Some(bound)) =
                (result.quantities.get(&quantity), result.quantity_errors.get(&quantity))
            else {
                return;
            };
            // A flat crossing loses digits; the bound says so.
            let coarse = seen.coarse;
            seen.number(|| format!("{name}: {quantity}"), *value, *bound, truth);
            (seen.coarse, seen.measured) = (coarse, seen.measured + 1);
        };
        of(format!("L({second},{})", special.name), &length);
        let image = special.name.to_lowercase();
        let [velocity, acceleration] = [0, 1].map(|order| minus(&motion[order], &start.motion[order]));
        if cut.slides.is_empty() && mechanism.body(cut.leg.base).points.contains(&from) {
            of(format!("vplan({},{image})", first.to_lowercase()), &norm(&velocity));
            let across = cross(&along, &acceleration) / norm(&along);
            let across = if across < Real::ZERO { -across } else { across };
            // Both legs may begin at one joint.
            let other = &special.cuts[0];
            let is_second = side == 1 && (other.start(), other.leg.base) == (cut.start(), cut.leg.base);
            let prime = if is_second { "'" } else { "" };
            let link = special.name.trim_start_matches('S');
            of(format!("aplan(n{prime}_{}{link},{image})", first.to_lowercase()), &across);
        }
    }
}

/// Every printed number is right to one unit of its last digit.
fn compare_digits(name: &str, table: &str, result: &ResultFile, truth: &Truth, seen: &mut Seen) {
    let mut truths: BTreeMap<String, Real> = BTreeMap::new();
    for link in result.links.keys() {
        if let Some(([omega, alpha], _)) = truth.link(link) {
            truths.insert(format!("omega({link})"), omega);
            truths.insert(format!("alpha({link})"), alpha);
        }
    }
    for (point, got) in &result.points {
        if let (None, Some(point_truth)) = (&got.on, truth.point(point)) {
            for (letter, motion) in ["v", "a"].into_iter().zip(point_truth.motion) {
                let [x, y] = motion;
                truths.insert(format!("{letter}({point}).size"), (&x * &x + &y * &y).sqrt());
                truths.insert(format!("{letter}({point}).x"), x);
                truths.insert(format!("{letter}({point}).y"), y);
            }
        }
    }
    for line in table.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some(truth) = truths.get(words[0]) else { continue };
        if words[1] == "0" || words[1].parse::<f64>().is_err() {
            continue;
        }
        let (digits, power) = words[1].split_once('e').unwrap_or((words[1], "0"));
        let decimals = digits.split_once('.').map_or(0, |(_, low)| low.len()) as i32;
        let unit = libm::pow(10.0, f64::from(power.parse::<i32>().expect("a power") - decimals));
        let off = rounded(&(truth::decimal(words[1]) - truth.clone())).abs();
        seen.digits += 1;
        if off > unit * (1.0 + 1e-9) {
            seen.failures.push(format!("{name}: {line}: off by {off:e}"));
        }
    }
}
