//! Gear pairs: two wheels on pins of one carrier that roll on each other.

use super::{AngularConstraint, Joint, Mark, Pitch};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, says};
use crate::message::Message;
use crate::scene::{self, GivenBy, On, Scene};
use smallvec::smallvec;

/// Two radii of a rim that differ by more than this part of the larger one are no shift of its teeth.
const UNLIKE: f64 = 0.03;

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
    let pitch = Pitch { centers, teeth: [first, second], all_teeth: gear.teeth, pressure_deg: gear.pressure_deg };
    let share: f64 = pitch.share();
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
        pitch: Some(pitch),
        marks: smallvec![circle(0, share.abs()), circle(1, (1.0 - share).abs())],
    })
}

/// Warnings of rims that would have to have two radii: the same number of teeth of a link in two pairs whose centre distances do not fit together.
/// Small differences are usual, as teeth may be shifted.
pub(in crate::mechanism) fn unlike_wheels(mechanism: &Mechanism) -> Vec<Message> {
    let mut rims: Vec<(BodyId, i32, f64)> = Vec::new();
    let mut found = Vec::new();
    for joint in &mechanism.joints {
        let (Some(pitch), Some(angular)) = (joint.pitch, joint.angular.as_ref()) else { continue };
        let carrier = angular.terms[2].0;
        let Some(distance) = distance(mechanism, carrier, pitch.centers) else { continue };
        for (wheel, teeth) in joint.bodies.into_iter().zip(pitch.all_teeth) {
            let radius = distance * f64::from(teeth.abs()) / f64::from(pitch.all_teeth.iter().sum::<i32>().abs());
            let is_same = |(other, own, _): &&(BodyId, i32, f64)| *other == wheel && *own == teeth;
            match rims.iter().find(is_same) {
                Some((.., other)) if (radius - other).abs() > UNLIKE * radius.max(*other) => {
                    let short = |radius: f64| format!("{radius:.4}");
                    let name = mechanism.body(wheel).name.as_str();
                    found.push(says::two_radii(name, i64::from(teeth.abs()), short(*other), short(radius)));
                }
                Some(_) => {}
                None => rims.push((wheel, teeth, radius)),
            }
        }
    }
    found
}

/// The distance of two points of a body; `None` where lengths do not say it.
fn distance(mechanism: &Mechanism, body: BodyId, [a, b]: [PointId; 2]) -> Option<f64> {
    let place = |point: PointId| match mechanism.given_by {
        GivenBy::Lengths => mechanism.body(body).local_of(point),
        GivenBy::Drawing => mechanism.given[point.0],
    };
    Some((place(a)? - place(b)?).norm())
}

fn common_divisor(a: i32, b: i32) -> i32 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}
