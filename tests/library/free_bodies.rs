//! Forces of random mechanisms of classes II, III and IV, with their stated errors, against a solver of its own in numbers of 256 bits: velocities
//! and accelerations from all joints' equations at once, forces from the three equations of equilibrium of every link at once. Scenes are
//! drawn, so that coordinates are exact, and nothing hangs on how positions are found. With friction the solver puts what rubs among the loads and
//! solves again until nothing changes: as hands do it, and not by forces that lean.

use dashu_float::round::mode::HalfEven;
use serde_json::{Value, json};
use support::comparison::entries;
use support::planted::{KNOWN, pattern};
use support::random::Random;
use support::stages::solved;
use support::survey::FREE_BODIES;

type Big = dashu_float::FBig<HalfEven, 2>;

/// Bits of the solver's numbers.
const BITS: usize = 256;

/// What is left by the solver's own rounding, in parts of the largest number.
const OWN: f64 = 1e-40;

/// How often what rubs is put among the loads before it counts as locking.
const MOST: usize = 150;

/// A factor from mm kg/s² to N.
const UNIT: i64 = 1000;

fn big(number: i64) -> Big {
    Big::from(number).with_precision(BITS).value()
}

/// A number of thousandths, as the scene writes it.
fn milli(number: i64) -> Big {
    big(number) / big(1000)
}

/// The solution of a square system, by elimination with the largest pivot; `None` where it is singular.
fn solve(mut rows: Vec<Vec<Big>>) -> Option<Vec<Big>> {
    let size = rows.len();
    let absolute = |x: &Big| if *x < big(0) { -x.clone() } else { x.clone() };
    for step in 0..size {
        let pivot = (step..size).max_by(|&a, &b| absolute(&rows[a][step]).cmp(&absolute(&rows[b][step])))?;
        rows.swap(step, pivot);
        if rows[step][step] == big(0) {
            return None;
        }
        let own = rows[step].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(index, _)| *index != step) {
            let factor = row[step].clone() / own[step].clone();
            if factor != big(0) {
                for (x, y) in row.iter_mut().zip(&own).skip(step) {
                    *x = x.clone() - factor.clone() * y.clone();
                }
            }
        }
    }
    Some((0..size).map(|step| rows[step][size].clone() / rows[step][step].clone()).collect())
}

/// A joint between two bodies, at a place in thousandths: a pin, or a guide of the second body with its direction.
struct Joint {
    name: String,
    bodies: [usize; 2],
    at: [i64; 2],
    along: Option<[i64; 2]>,
    /// A coefficient of friction, and the radius of a pin's journal.
    friction: Option<[i64; 2]>,
}

/// Body 0 is the ground, body 1 a crank that turns about the first joint.
struct Mechanism {
    bodies: usize,
    joints: Vec<Joint>,
    omega: i64,
    gravity: i64,
    /// By body: mass, moment of inertia, place of the centre.
    masses: Vec<(i64, i64, [i64; 2])>,
    /// Body, place, force, couple.
    loads: Vec<(usize, [i64; 2], [i64; 2], i64)>,
}

impl Mechanism {
    fn random(dice: &mut Random, class: &str, has_friction: bool) -> Mechanism {
        let (kinds, pairs) = pattern(dice, class);
        let mut whole = |bound: i64| dice.below(2 * bound as usize + 1) as i64 - bound;
        let mut place = || [whole(200_000), whole(200_000)];
        let mut joints = vec![Joint { name: "O".to_owned(), bodies: [1, 0], at: place(), along: None, friction: None }];
        for (index, (&(a, b), kind)) in pairs.iter().zip(kinds.chars()).enumerate() {
            let at = place();
            let along = (kind != 'R').then(|| place().map(|x| x / 100 + 1));
            // One half hangs on the ground, the first on the crank: with friction all others, as what hangs on the crank alone is at rest on it.
            let known = match (index, has_friction) {
                (0, _) => 1,
                (_, true) => 0,
                (_, false) => at[0].rem_euclid(2) as usize,
            };
            let on = if b == KNOWN { known } else { b + 2 };
            joints.push(Joint { name: format!("J{index}"), bodies: [a + 2, on], at, along, friction: None });
        }
        let bodies = 1 + joints.iter().flat_map(|joint| joint.bodies).max().unwrap_or(1);
        let mut positive = |most: i64| 1 + whole(most).abs();
        let masses = (0..bodies).map(|_| (positive(5000), positive(5_000_000), [positive(90_000), positive(90_000)]));
        let masses = masses.collect();
        let loads = (1..bodies)
            .map(|body| (body, [whole(90_000), whole(90_000)], [whole(300_000), whole(300_000)], whole(900_000)));
        let loads: Vec<_> = loads.collect();
        for joint in joints.iter_mut().filter(|_| has_friction) {
            joint.friction = Some([1 + whole(200).abs(), 1 + whole(9_000).abs()]);
        }
        Mechanism { bodies, joints, omega: 1 + whole(20_000).abs(), gravity: -9_810_000, masses, loads }
    }

    fn scene(&self) -> Value {
        let written = |number: i64| number as f64 / 1000.0;
        let pair = |pair: [i64; 2]| json!(pair.map(written));
        let name = |body: usize| if body == 0 { "ground".to_owned() } else { format!("b{body}") };
        let of = |body: usize| {
            let own = |joint: &&Joint| match joint.along {
                None => joint.bodies.contains(&body),
                Some(_) => joint.bodies[0] == body,
            };
            self.joints.iter().filter(own).map(|joint| joint.name.clone()).collect::<Vec<_>>()
        };
        let links = (1..self.bodies).map(|body| {
            let (mass, inertia, center) = self.masses[body];
            let mut link = json!({ "points": of(body), "mass": written(mass), "inertia": written(inertia), "center": pair(center) });
            if body == 1 {
                link["drive"] = json!({ "omega": written(self.omega) });
            }
            (name(body), link)
        });
        let sliders = self.joints.iter().filter_map(|joint| {
            let along = pair(joint.along?);
            let [link, on] = joint.bodies.map(name);
            Some(json!({ "link": link, "at": joint.name, "on": on, "along": along }))
        });
        let loads = self.loads.iter().map(|&(body, at, force, couple)| {
            json!({ "on": name(body), "at": pair(at), "force": pair(force), "couple": written(couple) })
        });
        let friction = self.joints.iter().filter_map(|joint| {
            let [coefficient, radius] = joint.friction?.map(written);
            let [link, on] = joint.bodies.map(name);
            Some(match joint.along {
                None => json!({ "pin": joint.name, "coefficient": coefficient, "radius": radius }),
                Some(_) => json!({ "guide": format!("{link}/{on}"), "coefficient": coefficient }),
            })
        });
        json!({
            "kinegon": 1, "units": { "length": "mm", "time": "s", "mass": "kg", "force": "N" },
            "ground": of(0), "links": links.collect::<serde_json::Map<_, _>>(),
            "points": self.joints.iter().map(|joint| (joint.name.clone(), pair(joint.at))).collect::<serde_json::Map<_, _>>(),
            "sliders": sliders.collect::<Vec<_>>(), "gravity": [0, written(self.gravity)],
            "forces": loads.collect::<Vec<_>>(), "friction": friction.collect::<Vec<_>>(),
        })
    }

    /// By joint, the products of a body's rates (of its point in the origin, and ω) that the joint equates between its two bodies, and what
    /// each of them leaves.
    fn rates(&self, left: impl Fn(&Joint) -> [Big; 2]) -> Option<Vec<[Big; 3]>> {
        let size = 3 * (self.bodies - 1);
        let mut rows = Vec::new();
        for joint in &self.joints {
            let [x, y] = joint.at.map(milli);
            let equations = match joint.along.map(|along| along.map(milli)) {
                None => [[big(1), big(0), -y], [big(0), big(1), x]],
                Some([u, v]) => [[-v.clone(), u.clone(), u * x + v * y], [big(0), big(0), big(1)]],
            };
            for (equation, left) in equations.into_iter().zip(left(joint)) {
                let mut row = vec![big(0); size + 1];
                for (body, sign) in [(joint.bodies[0], 1), (joint.bodies[1], -1)] {
                    for (k, value) in equation.iter().enumerate().filter(|_| body > 0) {
                        row[3 * (body - 1) + k] = value.clone() * big(sign);
                    }
                }
                row[size] = left;
                rows.push(row);
            }
        }
        // The crank's own rate.
        let mut row = vec![big(0); size + 1];
        row[2] = big(1);
        row[size] =
            left(&Joint { name: String::new(), bodies: [1, 1], at: [0, 0], along: None, friction: None })[0].clone();
        rows.push(row);
        let found = solve(rows)?;
        let ground = [big(0), big(0), big(0)];
        Some(std::iter::once(ground).chain(found.chunks(3).map(|rates| [0, 1, 2].map(|k| rates[k].clone()))).collect())
    }

    /// The forces in the joints, by joint those on its first body and the couple there, and the crank's torque.
    fn truth(&self) -> Option<(Vec<[Big; 3]>, Big)> {
        let is_drive = |joint: &Joint| joint.bodies == [1, 1];
        let velocities = self.rates(|joint| [if is_drive(joint) { milli(self.omega) } else { big(0) }, big(0)])?;
        let at = |rates: &[Big; 3], [x, y]: [Big; 2]| {
            [rates[0].clone() - rates[2].clone() * y, rates[1].clone() + rates[2].clone() * x]
        };
        // Accelerations of two bodies' points in one place differ by what ω² r and, in a guide, 2 ω v leave.
        let left = |joint: &Joint| {
            if is_drive(joint) {
                return [big(0), big(0)];
            }
            let place = joint.at.map(milli);
            let [own, other] = joint.bodies.map(|body| &velocities[body]);
            let squares = own[2].clone() * own[2].clone() - other[2].clone() * other[2].clone();
            let [x, y] = place.clone().map(|along| squares.clone() * along);
            match joint.along.map(|along| along.map(milli)) {
                None => [x, y],
                Some([u, v]) => {
                    let [[a, b], [c, d]] = [own, other].map(|rates| at(rates, place.clone()));
                    let slip = (a - c) * u.clone() + (b - d) * v.clone();
                    // Along the normal (−v, u), of a vector (u, v) that need not have length 1.
                    let coriolis = big(2) * other[2].clone() * slip;
                    [u * y - v * x + coriolis, big(0)]
                }
            }
        };
        let accelerations = self.rates(left)?;
        let all = self.joints.iter().map(|joint| resisting(joint, &velocities, at));
        let resisting = all.collect::<Option<Vec<[Big; 3]>>>()?;
        let mut friction = vec![[big(0), big(0), big(0)]; self.joints.len()];
        let has_friction = self.joints.iter().any(|joint| joint.friction.is_some());
        for _ in 0..MOST {
            let (carried, torque) = self.in_equilibrium(&velocities, &accelerations, &friction)?;
            let next: Vec<[Big; 3]> = carried
                .iter()
                .zip(&resisting)
                .map(|([x, y, _], by_size)| {
                    let size = (x.clone() * x + y.clone() * y).sqrt();
                    by_size.clone().map(|part| part * size.clone())
                })
                .collect();
            let change = next.iter().flatten().zip(friction.iter().flatten());
            let change = change.map(|(a, b)| (a.clone() - b.clone()).to_f64().value().abs()).fold(0.0, f64::max);
            let largest = carried.iter().flatten().map(|x| x.to_f64().value().abs()).fold(0.0, f64::max);
            if !has_friction || change <= 1e-30 * largest {
                return Some((carried, torque));
            }
            friction = next;
        }
        None
    }

    /// The forces with these on the first bodies of joints beside, each with its couple about the joint's place.
    fn in_equilibrium(
        &self,
        velocities: &[[Big; 3]],
        accelerations: &[[Big; 3]],
        friction: &[[Big; 3]],
    ) -> Option<(Vec<[Big; 3]>, Big)> {
        let at = |rates: &[Big; 3], [x, y]: [Big; 2]| {
            [rates[0].clone() - rates[2].clone() * y, rates[1].clone() + rates[2].clone() * x]
        };
        // Unknowns: two for each joint, on its first body, then the torque.
        let size = 2 * self.joints.len() + 1;
        let mut rows = Vec::new();
        for body in 1..self.bodies {
            let (mass, inertia, center) = &self.masses[body];
            let [x, y] = center.map(milli);
            let [_, _, omega] = &velocities[body];
            let rates = &accelerations[body];
            let square = omega.clone() * omega.clone();
            let [a, b] = at(rates, [x.clone(), y.clone()]);
            let [a, b] = [a - square.clone() * x.clone(), b - square * y.clone()];
            let mass = milli(*mass) / big(UNIT);
            let weight = mass.clone() * milli(self.gravity);
            let [mut p, mut q] = [-(mass.clone() * a), weight - mass * b];
            let mut moment = x * q.clone() - y * p.clone() - milli(*inertia) / big(UNIT) * rates[2].clone();
            for (_, place, force, couple) in self.loads.iter().filter(|load| load.0 == body) {
                let ([x, y], [f, g]) = (place.map(milli), force.map(milli));
                moment = moment + x * g.clone() - y * f.clone() + milli(*couple);
                (p, q) = (p + f, q + g);
            }
            let mut equations: [Vec<Big>; 3] = [0, 1, 2].map(|_| vec![big(0); size + 1]);
            for (index, joint) in self.joints.iter().enumerate() {
                let Some(end) = joint.bodies.iter().position(|&own| own == body) else { continue };
                let sign = if end == 0 { big(1) } else { big(-1) };
                let [x, y] = joint.at.map(milli);
                let [f, g, couple] = friction[index].clone().map(|part| part * sign.clone());
                moment = moment + x.clone() * g.clone() - y.clone() * f.clone() + couple;
                (p, q) = (p + f, q + g);
                let columns = match joint.along.map(|along| along.map(milli)) {
                    None => [[big(1), big(0), -y], [big(0), big(1), x]],
                    Some([u, v]) => [[-v.clone(), u.clone(), x * u + y * v], [big(0), big(0), big(1)]],
                };
                for (column, wrench) in columns.into_iter().enumerate() {
                    for (equation, value) in equations.iter_mut().zip(wrench) {
                        equation[2 * index + column] = value * sign.clone();
                    }
                }
            }
            if body == 1 {
                equations[2][size - 1] = big(1);
            }
            for (equation, load) in equations.iter_mut().zip([p, q, moment]) {
                equation[size] = -load;
            }
            rows.extend(equations);
        }
        let mut found = solve(rows)?;
        let torque = found.pop()?;
        // Of a guide the multiple of (−v, u), then the couple: the force across it, of a unit normal.
        let carried = self.joints.iter().zip(found.chunks(2)).map(|(joint, pair)| {
            match joint.along.map(|along| along.map(milli)) {
                None => [pair[0].clone(), pair[1].clone(), big(0)],
                Some([u, v]) => {
                    let length = (u.clone() * u + v.clone() * v).sqrt();
                    [pair[0].clone() * length, big(0), pair[1].clone()]
                }
            }
        });
        Some((carried.collect(), torque))
    }
}

/// Speeds below this one are what is left of none.
const NONE: f64 = 1e-40;

/// By the size of what a joint carries: the friction on its first body, and its couple. `None` of a joint at rest, whose friction nobody knows.
fn resisting(joint: &Joint, velocities: &[[Big; 3]], at: impl Fn(&[Big; 3], [Big; 2]) -> [Big; 2]) -> Option<[Big; 3]> {
    let none = [big(0), big(0), big(0)];
    let Some([coefficient, radius]) = joint.friction.map(|friction| friction.map(milli)) else { return Some(none) };
    let against = |speed: Big| match speed.to_f64().value() {
        speed if speed.abs() < NONE => None,
        speed => Some(if speed > 0.0 { big(-1) } else { big(1) }),
    };
    let [own, other] = joint.bodies.map(|body| &velocities[body]);
    match joint.along.map(|along| along.map(milli)) {
        None => {
            let sine = coefficient.clone() / (big(1) + coefficient.clone() * coefficient).sqrt();
            Some([big(0), big(0), against(own[2].clone() - other[2].clone())? * radius * sine])
        }
        Some([u, v]) => {
            let [[a, b], [c, d]] = [own, other].map(|rates| at(rates, joint.at.map(milli)));
            let sense = against((a - c) * u.clone() + (b - d) * v.clone())?;
            let length = (u.clone() * u.clone() + v.clone() * v.clone()).sqrt();
            let by = sense * coefficient / length;
            Some([u * by.clone(), v * by, big(0)])
        }
    }
}

/// How many numbers were compared and how many of them had a bound, and the worst error in parts of its bound.
#[derive(Default)]
struct Seen {
    compared: usize,
    told: usize,
    worst: f64,
}

impl Seen {
    fn compare(&mut self, what: &str, found: &Value, error: &Value, truth: &Big, size: f64) {
        let value = found.as_f64().unwrap_or_else(|| panic!("{what} is {found}"));
        let Some(error) = error.as_f64() else {
            self.told += 1;
            return;
        };
        let off = (Big::try_from(value).expect("a number").with_precision(BITS).value() - truth.clone())
            .to_f64()
            .value()
            .abs();
        assert!(off <= error + OWN * size, "{what} is {value} ± {error:e}, off by {off:e}");
        self.compared += 1;
        self.worst = self.worst.max(if error > OWN * size { off / error } else { 0.0 });
    }
}

#[test]
fn stated_errors_hold_those_against_256_bits() {
    let (told, compared, solved_ones, count) = compared(20_261, FREE_BODIES.now(), false);
    assert!(solved_ones * 10 > count * 7, "only {solved_ones}");
    assert!(told * 100 < compared, "{told} of {compared} without a bound");
}

#[test]
fn stated_errors_with_friction_hold_those_against_256_bits() {
    let (told, compared, solved_ones, count) = compared(7_261, FREE_BODIES.now() / 4, true);
    assert!(solved_ones * 10 > count * 5, "only {solved_ones}");
    assert!(told * 50 < compared, "{told} of {compared} without a bound");
}

/// How many numbers of random mechanisms have no bound, how many were compared, of how many mechanisms among how many.
fn compared(seed: u64, count: u64, has_friction: bool) -> (usize, usize, u64, u64) {
    let (mut dice, mut seen, mut solved_ones) = (Random(seed), Seen::default(), 0);
    let (mut no_scene, mut no_truth) = (0, 0);
    for number in 0..count {
        let mechanism = Mechanism::random(&mut dice, ["II", "III", "IV"][number as usize % 3], has_friction);
        let scene = mechanism.scene();
        let solution = match solved(&scene.to_string()) {
            Ok(solution) => solution,
            Err(_) => {
                no_scene += 1;
                continue;
            }
        };
        let Some((carried, torque)) = mechanism.truth() else {
            no_truth += 1;
            continue;
        };
        let result = serde_json::to_value(solution.result()).expect("a result is JSON");
        let found = &result["forces"];
        if found.is_null() {
            // Nearly singular: nothing is said in place of a number without a bound.
            seen.told += 1;
            continue;
        }
        solved_ones += 1;
        let size = carried.iter().flatten().map(|x| x.to_f64().value().abs()).fold(1.0, f64::max);
        for (joint, truth) in mechanism.joints.iter().zip(&carried) {
            let own = format!("b{}", joint.bodies[0]);
            if joint.along.is_none() {
                let force = &found["reactions"][&joint.name][&own];
                for axis in 0..2 {
                    let what = format!("R({},{own})[{axis}] in\n{scene}\n", joint.name);
                    seen.compare(&what, &force["force"][axis], &force["force_error"], &truth[axis], size);
                }
                continue;
            }
            let on = if joint.bodies[1] == 0 { "ground".to_owned() } else { format!("b{}", joint.bodies[1]) };
            let name = format!("{own}/{on}");
            let is_it = |(key, _): &(&str, &Value)| *key == name;
            let Some((_, slider)) = entries(&found["sliders"]).find(is_it) else { panic!("no slider {name}\n{found}") };
            let what = format!("N({name}) in\n{scene}\n");
            seen.compare(&what, &slider["normal"], &slider["normal_error"], &truth[0], size);
            let what = format!("M({name}) in\n{scene}\n");
            // The couple about the slider's point: the joint's force is taken there.
            seen.compare(&what, &slider["couple"], &slider["couple_error"], &truth[2], 1e3 * size);
        }
        let drive = &found["drives"]["b1"];
        let what = format!("T(b1) in\n{scene}\n");
        seen.compare(&what, &drive["torque"], &drive["error"], &torque, 1e3 * size);
    }
    let Seen { compared, told, worst } = seen;
    eprintln!(
        "{solved_ones} of {count} mechanisms: {compared} numbers, {told} told, worst error {worst:.3} of what is stated; \
         {no_scene} without definite motion, {no_truth} without forces"
    );
    (told, compared, solved_ones, count)
}
