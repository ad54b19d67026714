//! The errors that a result states of every angular and slide rate are never exceeded, and are not idle.
//!
//! The truth is that of the positions given, with 256 bits, from the joint equations of all links (`tests/support/speed_vs_error`).

use support::survey::{BOUNDED, on_all_cores};

use kinegon::Order;
use kinegon::Solution;
use kinegon::mechanism::{Mechanism, Role, mechanism};
use kinegon::motion::motion;
use kinegon::position::{Pose, pose};
use kinegon::scene::Scene;
use support::files;
use support::groups::{Base, Group};
use support::planted::{Planted, pattern};
use support::random::Random;
use support::speed_vs_error::families::Family;
use support::speed_vs_error::truth::{ROUNDING, Truth, error};
use support::stages::solved;

/// Mechanisms of each kind: few enough for every day, or a million in all.
fn count() -> u64 {
    BOUNDED.now()
}

/// Stated bounds must stay below this many times the error, in the middle of all numbers.
const WASTEFUL: f64 = 100.0;

/// What a set of mechanisms gave.
#[derive(Default)]
struct Seen {
    mechanisms: usize,
    /// Refused as singular, or without an assembly mode.
    refused: usize,
    /// Error over stated bound, where there is an error.
    shares: Vec<f64>,
    /// Numbers without any error.
    exact: usize,
    failures: Vec<String>,
}

impl Seen {
    /// Compares a mechanism's motion with the truth; `guides` are directions by slider of any length.
    fn see(&mut self, name: &str, mechanism: &Mechanism, pose: &Pose, guides: &[[f64; 2]]) {
        let Ok(motion) = motion(mechanism, pose, Order::Acceleration) else {
            self.refused += 1;
            return;
        };
        let points: Vec<[f64; 2]> = pose.points.iter().map(|p| [p.x, p.y]).collect();
        let Some(truth) = Truth::new(mechanism, &points, guides) else {
            self.failures.push(format!("{name}: singular, but solved"));
            return;
        };
        self.mechanisms += 1;
        for (id, body) in mechanism.links() {
            if matches!(body.role, Role::Member | Role::Pushed { .. }) {
                let (got, bounds, truth) = (motion.body(id), motion.errors[id.0], &truth.bodies[id.0]);
                let link = &body.name;
                self.number(error(got.omega, &truth.omega), bounds.omega, || format!("{name}: omega({link})"));
                self.number(error(got.alpha, &truth.alpha), bounds.alpha, || format!("{name}: alpha({link})"));
            }
        }
        for (index, slide) in motion.slides.iter().enumerate() {
            let [velocity, acceleration] = &truth.slides[index];
            self.number(error(slide.velocity, velocity), slide.velocity_error, || {
                format!("{name}: v_r of slider {index}")
            });
            self.number(error(slide.acceleration, acceleration), slide.acceleration_error, || {
                format!("{name}: a_r of slider {index}")
            });
        }
    }

    fn number(&mut self, error: f64, bound: f64, name: impl Fn() -> String) {
        if error < ROUNDING {
            self.exact += 1;
            return;
        }
        let share = error / bound;
        self.shares.push(share);
        if share.is_nan() || share > 1.0 {
            self.failures.push(format!("{}: error {error:e}, stated {bound:e}", name()));
        }
    }

    fn join(&mut self, other: Seen) {
        self.mechanisms += other.mechanisms;
        self.refused += other.refused;
        self.exact += other.exact;
        self.shares.extend(other.shares);
        self.failures.extend(other.failures);
    }

    fn demand(mut self, what: &str) {
        self.shares.sort_by(f64::total_cmp);
        let count = self.shares.len();
        let median = self.shares[count / 2];
        println!(
            "{what}: {} mechanisms, {} refused; {count} numbers with an error ({} exact): error / stated bound at most {:.3}, median 1/{:.1}",
            self.mechanisms,
            self.refused,
            self.exact,
            self.shares[count - 1],
            1.0 / median,
        );
        let failures = self.failures.len();
        self.failures.truncate(10);
        assert!(failures == 0, "{what}: {failures} failures\n{}", self.failures.join("\n"));
        assert!(median * WASTEFUL > 1.0, "{what}: the bounds say too little");
        assert!(10 * self.mechanisms > self.refused, "{what}");
    }
}

/// Cases by number on all cores: each has its own seed, so that how they are shared out changes nothing.
fn cases(case: impl Fn(u64, &mut Random, &mut Seen) + Sync) -> Seen {
    let mut all = Seen::default();
    // Neighbouring seeds of splitmix64 are streams shifted by one.
    let seen = on_all_cores(count(), |number, seen| case(number, &mut Random(Random(number).next()), seen));
    seen.into_iter().for_each(|seen| all.join(seen));
    all
}

/// A fourth-class group as drawn.
fn see_group(name: &str, group: &Group, seen: &mut Seen) {
    let scene = Scene::read(&group.scene().to_string()).expect("a good scene");
    let mechanism = mechanism(&scene).expect("a mechanism");
    let pose = pose(&mechanism, &scene.near).expect("it is drawn");
    let given: Vec<[f64; 2]> = group.guides.iter().flatten().copied().collect();
    let guides = mechanism.sliders.iter().map(|slider| given[slider.given.expect("a slider of the scene")]);
    let guides: Vec<[f64; 2]> = guides.collect();
    seen.see(name, &mechanism, &pose, &guides);
}

#[test]
fn hard_families() {
    let seen = cases(|number, dice, seen| {
        let family = Family::ALL[number as usize % Family::ALL.len()];
        let parameters = family.parameters();
        let parameter = parameters[dice.below(parameters.len())];
        let name = format!("{family:?} {parameter:e} {number}");
        see_group(&name, &family.group(parameter, dice), seen);
    });
    seen.demand("hard families");
}

#[test]
fn random_groups_with_prismatic_joints() {
    let seen = cases(|number, dice, seen| {
        see_group(&number.to_string(), &Group::any(dice, 40), seen);
    });
    seen.demand("random groups");
}

/// Groups of all classes on a frame and a crank, from lengths.
#[test]
fn dyads_triads_and_fourth_class_groups_on_a_crank() {
    let seen = cases(|number, dice, seen| {
        let class = ["II", "III", "IV"][number as usize % 3];
        let (kinds, joints) = pattern(dice, class);
        let text = Planted::new(dice, &kinds, &joints).scene();
        see_scene(&format!("{kinds} {number}"), &text, 10.0, dice, seen);
    });
    seen.demand("groups on a crank");
}

/// Groups that hang on other groups, and hydraulic cylinders: the starting scenes and those of `tests/driven_sliders`, with their
/// cranks anywhere.
#[test]
fn groups_on_groups_and_driven_sliders() {
    // Wheels within loops are held to their own truth: gears.rs, racks.rs.
    let has_loops = |(name, _): &(String, String)| !["sun-and-planet", "rack-and-pinion"].contains(&name.as_str());
    let mut scenes: Vec<_> = files::templates().into_iter().filter(has_loops).collect();
    scenes.extend(files::scenes("tests/driven_sliders"));
    let seen = cases(|number, dice, seen| {
        let (name, text) = &scenes[number as usize % scenes.len()];
        see_scene(&format!("{name} {number}"), text, 180.0, dice, seen);
    });
    seen.demand("groups on groups");
}

/// Where a very long link is turned by one equation without any long arm in it, normal accelerations along that link cancel: with f64
/// alone four digits of α would be lost.
#[test]
fn a_long_link_costs_no_digits() {
    let [long, base] = [1e5, 8.3125];
    let moving = |velocity, acceleration| Base { velocity, acceleration, spin: None };
    let group = Group {
        places: [[15.75, base], [7.875, 9.4375], [long, 0.99 * long], [0.0, 0.0], [1.2 * long, 0.0], [13.5, base]],
        guides: [None; 6],
        bases: [moving([0.75, -4.0], [1.3125, -3.25]), moving([-7.0625, 0.0], [7.8125, 1.25])],
    };
    let mut seen = Seen::default();
    let Solution { mechanism, pose, motion, .. } = solved(&group.scene().to_string()).expect("it is not singular");
    seen.see("a long link", &mechanism, &pose, &[]);
    let link = mechanism.link("4").expect("a link of the group");
    let relative = motion.error(link).alpha / motion.body(link).alpha.abs();
    assert!(relative <= f64::EPSILON, "{relative:e}");
    assert!(seen.failures.is_empty(), "{:?}", seen.failures);
}

/// A scene from lengths with its cranks turned by up to `turn` degrees and at any rates.
fn see_scene(name: &str, text: &str, turn: f64, dice: &mut Random, seen: &mut Seen) {
    let Ok(scene) = Scene::read(text) else { panic!("{name} is no scene") };
    let Ok(mut mechanism) = mechanism(&scene) else {
        seen.refused += 1;
        return;
    };
    // The truth has pins and guides alone; `gears` holds the bounds of wheels to its own.
    if mechanism.joints.iter().any(|joint| joint.pitch.is_some()) {
        return;
    }
    for body in &mut mechanism.bodies {
        if let Role::Driver { angle, omega, alpha, .. } = &mut body.role {
            *angle = angle.map(|a| a + dice.within(turn));
            (*omega, *alpha) = (dice.within(8.0), dice.within(8.0));
        }
    }
    let Ok(pose) = pose(&mechanism, &scene.near) else {
        seen.refused += 1;
        return;
    };
    let guides: Vec<[f64; 2]> = pose.guides.iter().map(|g| [g.x, g.y]).collect();
    seen.see(name, &mechanism, &pose, &guides);
}
