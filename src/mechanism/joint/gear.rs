//! Gear pairs: two wheels on pins of one carrier that roll on each other.

use super::{AngularConstraint, Joint, Mark, Pitch};
use crate::mechanism::{BodyId, GROUND, Mechanism};
use crate::scene::{self, On, Scene};
use smallvec::smallvec;

/// Adds the gear pairs of a scene.
pub(super) fn add(scene: &Scene, mechanism: &mut Mechanism) {
    let pairs: Vec<Joint> = scene.gears.iter().filter_map(|gear| joint(mechanism, gear)).collect();
    mechanism.joints.extend(pairs);
}

/// The joint of a pair: z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ_carrier = z₂ · phase, in the smallest whole numbers.
fn joint(mechanism: &Mechanism, gear: &scene::Gear) -> Option<Joint> {
    let body = |on: &On| match on {
        On::Ground => Some(GROUND),
        On::Link(name) => mechanism.link(name),
    };
    let wheels: [BodyId; 2] = [body(&gear.wheels[0])?, body(&gear.wheels[1])?];
    let centers = [mechanism.point(&gear.centers[0])?, mechanism.point(&gear.centers[1])?];
    let common = common_divisor(gear.teeth[0], gear.teeth[1]);
    let [first, second] = gear.teeth.map(|teeth| teeth / common);
    let share = f64::from(first) / f64::from(first + second);
    let circle =
        |center: usize, part: f64| Mark::Circle { center: centers[center], towards: centers[1 - center], part };
    Some(Joint {
        letter: 'G',
        bodies: wheels,
        pin: None,
        slider: None,
        angular: Some(AngularConstraint::degrees(
            smallvec![(wheels[0], first), (wheels[1], second), (body(&gear.on)?, -(first + second))],
            f64::from(second) * gear.phase_deg,
        )),
        pitch: Some(Pitch { centers, share, pressure_deg: gear.pressure_deg }),
        marks: smallvec![circle(0, share.abs()), circle(1, (1.0 - share).abs())],
    })
}

fn common_divisor(a: i32, b: i32) -> i32 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}
