//! Gear pairs: two wheels on pins of one carrier that roll on each other, a wheel on a rack, and wheels with a belt.

use super::{AngularConstraint, Belt, Guide, Joint, Mark, Pitch, Rack, Travel};
use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, cross};
use crate::mechanism::shape::direction;
use crate::mechanism::{BodyId, Mechanism, PointId, SliderId, says};
use crate::message::Message;
use crate::scene::{self, GivenBy, Scene};
use smallvec::{SmallVec, smallvec};

/// The radius of the larger of two wheels with a belt whose size is not given, in parts of the distance of their centres.
const LARGER_WHEEL: f64 = 0.3;

/// Two radii of a rim that differ by more than this part of the larger one are no shift of its teeth.
const UNLIKE: f64 = 0.03;

/// Adds the gear pairs of a scene.
pub(super) fn add(scene: &Scene, mechanism: &mut Mechanism) {
    let mut pairs: Vec<Joint> = scene.gears.iter().filter_map(|gear| joint(mechanism, gear)).collect();
    pairs.sort_by_key(|joint| (joint.bodies.iter().min().copied(), joint.bodies.iter().max().copied()));
    mechanism.joints.extend(pairs);
}

/// The joint of a pair.
fn joint(mechanism: &Mechanism, gear: &scene::Gear) -> Option<Joint> {
    let wheels = [mechanism.body_named(&gear.wheels[0])?, mechanism.body_named(&gear.wheels[1])?];
    let carrier = mechanism.body_named(&gear.on)?;
    let joint = Joint {
        letter: 'G',
        bodies: wheels,
        pin: None,
        slider: None,
        angular: None,
        pitch: None,
        rack: None,
        belt: None,
        marks: smallvec![],
    };
    match &gear.rack {
        Some(rack) => of_rack(mechanism, gear, rack, carrier, joint),
        None => of_wheels(mechanism, gear, carrier, joint),
    }
}

/// Two wheels: z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ_carrier = z₂ · phase, in the smallest whole numbers; with an open belt z₂ counts as negative.
fn of_wheels(mechanism: &Mechanism, gear: &scene::Gear, carrier: BodyId, joint: Joint) -> Option<Joint> {
    let centers = [mechanism.point(&gear.centers[0])?, mechanism.point(&gear.centers[1])?];
    let common = common_divisor(gear.teeth[0], gear.teeth[1]);
    let [first, second] = gear.teeth.map(|teeth| teeth / common);
    let second = if gear.belt == Some(scene::Belt::Open) { -second } else { second };
    let angular = AngularConstraint::phased(
        smallvec![(joint.bodies[0], first), (joint.bodies[1], second), (carrier, -(first + second))],
        second,
        gear.phase_deg,
    );
    let joint = Joint { angular: Some(angular), ..joint };
    if let Some(kind) = gear.belt {
        let away = distance(mechanism, carrier, centers).unwrap_or(0.0);
        let teeth = [first, second];
        let [first, second] = teeth.map(|teeth| f64::from(teeth.abs()));
        // A belt does not say how large its wheels are.
        let larger = LARGER_WHEEL * away / first.max(second);
        let unit = gear.belt_radius.map_or(larger, |radius| radius / first);
        let radii = [first * unit, second * unit];
        let marks = [0, 1].map(|index| Mark::Wheel { center: centers[index], radius: radii[index] });
        let (is_crossed, is_sized) = (kind == scene::Belt::Crossed, gear.belt_radius.is_some());
        let belt = Belt { centers, radii, teeth, is_crossed, is_sized };
        return Some(Joint { belt: Some(belt), marks: marks.into(), ..joint });
    }
    let pitch = Pitch { centers, teeth: [first, second], all_teeth: gear.teeth, pressure_deg: gear.pressure_deg };
    let share: f64 = pitch.share();
    let circle =
        |center: usize, part: f64| Mark::Circle { center: centers[center], towards: centers[1 - center], part };
    Some(Joint {
        pitch: Some(pitch),
        marks: smallvec![circle(0, share.abs()), circle(1, (1.0 - share).abs())],
        ..joint
    })
}

/// A wheel and its rack: r (θ − θ_carrier) = ± (s − position), with + where the pitch line lies to the right and the rack is what slides.
fn of_rack(
    mechanism: &Mechanism,
    gear: &scene::Gear,
    given: &scene::RackOf,
    carrier: BodyId,
    joint: Joint,
) -> Option<Joint> {
    let center = mechanism.point(&gear.centers[given.wheel])?;
    let last = mechanism.given_slider(*given.sliders.last()?)?;
    let side = side(mechanism, given, carrier, center)?;
    let along = guide_in_place(mechanism, last);
    let slides = given.sliders.iter().filter_map(|&index| mechanism.given_slider(index)).map(|id| {
        let slider = mechanism.slider(id);
        // As the carrier goes on along a guide, the rack falls back.
        let onwards = if slider.link == carrier { -side } else { side };
        let is_against = guide_in_place(mechanism, id).dot(&along) < 0.0;
        (id, if is_against { -onwards } else { onwards })
    });
    let slides: SmallVec<[(SliderId, f64); 2]> = slides.collect();
    let start = slides.last()?.1 * given.position;
    let travel = Travel { slides, start, radius: given.radius };
    let terms = smallvec![(carrier, -1), (joint.bodies[given.wheel], 1)];
    let (wheel, radius) = (given.wheel, given.radius);
    let rack =
        Rack { wheel, center, slider: last, side, radius, teeth: gear.teeth[wheel], pressure_deg: gear.pressure_deg };
    Some(Joint {
        angular: Some(AngularConstraint { travel: Some(travel), ..AngularConstraint::phased(terms, 0, 0.0) }),
        rack: Some(rack),
        marks: smallvec![Mark::Wheel { center, radius: given.radius }],
        ..joint
    })
}

/// +1 where the guide of a rack, or of the carrier along it, lies to the right of the wheel's centre, looking along it, or passes through the
/// centre; −1 to the left.
fn side(mechanism: &Mechanism, given: &scene::RackOf, carrier: BodyId, center: PointId) -> Option<f64> {
    let ids: SmallVec<[SliderId; 2]> =
        given.sliders.iter().filter_map(|&index| mechanism.given_slider(index)).collect();
    let last = *ids.last()?;
    let slider = mechanism.slider(last);
    let off = match mechanism.given_by {
        GivenBy::Drawing => {
            let [at, center] = [slider.at, center].map(|point| mechanism.given[point.0]);
            cross(guide_in_place(mechanism, last), center? - at?)
        }
        GivenBy::Lengths => {
            let local = |body: BodyId| mechanism.body(body).local_of(center);
            let (through, along) = slider.line();
            // A carrier that slides: its centre's place in the frame of the guide's body, as far across the guide as in every position.
            let carried = |id: SliderId| -> Option<Point> {
                let slider = mechanism.slider(id);
                Some(slider.line().0 + slider.turn() * (local(carrier)? - mechanism.local(carrier, slider.at)))
            };
            match *ids.as_slice() {
                [only] if slider.link == carrier => cross(along, carried(only)? - through),
                [_] => cross(along, local(carrier)? - through),
                [first, ..] => cross(along, carried(first)? - through),
                [] => return None,
            }
        }
    };
    let size = distance_across(mechanism, carrier, given.radius);
    Some(if off < -UNIT_ROUNDOFF * 64.0 * size { -1.0 } else { 1.0 })
}

/// A length by which distances across a guide are judged to be none.
fn distance_across(mechanism: &Mechanism, carrier: BodyId, radius: f64) -> f64 {
    let body = mechanism.body(carrier);
    let places = body.points.iter().filter_map(|point| mechanism.given[point.0]).chain(body.local.iter().copied());
    places.map(|place| place.coords.amax()).fold(radius, f64::max)
}

/// The direction of a guide as far as it is known before positions are: in the frame of its body, or as drawn.
fn guide_in_place(mechanism: &Mechanism, id: SliderId) -> Vector {
    let place = |point: PointId| mechanism.given[point.0];
    match mechanism.slider(id).guide {
        Guide::Local { direction, .. } | Guide::Drawn(direction) => direction,
        Guide::DrawnBetween(a, b) => place(b).zip(place(a)).map_or_else(Vector::x, |(b, a)| direction(b - a)),
    }
}

/// Warnings of rims that would have to have two radii: the same number of teeth of a link in two pairs whose centre distances do not fit together.
/// Small differences are usual, as teeth may be shifted.
pub(in crate::mechanism) fn unlike_wheels(mechanism: &Mechanism) -> Vec<Message> {
    let mut rims: Vec<(BodyId, i32, f64)> = Vec::new();
    let mut found = Vec::new();
    let short = |radius: f64| format!("{radius:.4}");
    for joint in &mechanism.joints {
        let carrier = joint.related_bodies().find(|body| !joint.bodies.contains(body));
        let apart = |centers| distance(mechanism, carrier?, centers);
        let mut own = Vec::new();
        if let Some((pitch, distance)) = joint.pitch.and_then(|pitch| Some((pitch, apart(pitch.centers)?))) {
            let sum = f64::from(pitch.all_teeth.iter().sum::<i32>().abs());
            let radius = |teeth: i32| distance * f64::from(teeth.abs()) / sum;
            own.extend(
                joint.bodies.into_iter().zip(pitch.all_teeth).map(|(wheel, teeth)| (wheel, teeth, radius(teeth))),
            );
        }
        own.extend(joint.rack.map(|rack| (joint.bodies[rack.wheel], rack.teeth, rack.radius)));
        if let Some((belt, distance)) = joint.belt.and_then(|belt| Some((belt, apart(belt.centers)?))) {
            let [first, second] = belt.radii;
            let least = if belt.is_crossed { first + second } else { (first - second).abs() };
            if belt.is_sized && distance <= least {
                let [one, other] = joint.bodies.map(|body| mechanism.body(body).name.as_str());
                let radii = format!("{}, {}", short(first), short(second));
                found.push(says::belt_without_room(one, other, radii, short(distance)));
            }
        }
        for (wheel, teeth, radius) in own {
            let is_same = |(other, own, _): &&(BodyId, i32, f64)| *other == wheel && *own == teeth;
            match rims.iter().find(is_same) {
                Some((.., other)) if (radius - other).abs() > UNLIKE * radius.max(*other) => {
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
