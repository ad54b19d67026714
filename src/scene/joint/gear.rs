//! Gear pairs: two wheels on pins of one carrier that roll on each other without slip, or a wheel on a rack, or two wheels with a belt; their keys
//! in the file, their checked form and the checks.

use std::collections::HashSet;

use serde::Deserialize;

use super::{Along, JointKind, Meaning, On, Slider};
use crate::geometry::{Vector, cross, direction_of_degrees};
use crate::message::Message;
use crate::scene::error::{Wrong, number};
use crate::scene::names::{Coordinates, Names};
use crate::scene::says;
use crate::scene::value::{Direction, OneOf, choice, several_forms};
use crate::scene::write::{write_forms, write_keys};

/// Most teeth of a wheel: more are a slip of the keyboard, and angles are multiplied by them.
const MOST_TEETH: i32 = 10_000;

/// The steepest line of action that a pair of teeth has, in degrees.
const STEEPEST: f64 = 45.0;

/// A radius below this, in any unit of length, is a slip of the keyboard: an angle would be a position divided by it.
const LEAST_RADIUS: f64 = 1e-30;

/// The sine of the largest angle between guides that count as parallel.
const PARALLEL: f64 = 1e-9;

/// A number of teeth as the file writes it.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) enum Teeth {
    Count(f64),
    Rack,
}

several_forms!(Teeth, "teeth", OneOf {
    expecting: "a number of teeth, or \"rack\"",
    from: |given| match given {
        Direction::Degrees(count) => Some(Teeth::Count(count)),
        Direction::Points(word) if word == "rack" => Some(Teeth::Rack),
        Direction::Points(_) | Direction::Vector(_) => None,
    },
}, _generator => {
    "description": "A number of teeth, that of a ring negative; or \"rack\"",
    "anyOf": [{ "type": "number" }, { "const": "rack" }]
});

write_forms! {
    Teeth { Teeth::Count(count) => count, Teeth::Rack => "rack" }
}

choice!(
    /// How a belt, a rope or a chain runs around two wheels.
    Belt {
        /// Both wheels turn the same way.
        Open = "open",
        /// They turn against each other.
        Crossed = "crossed",
    }
);

/// Two wheels that mesh: their pitch circles roll on each other without slip; or a wheel that rolls on a rack; or two wheels with a belt.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(rename = "gear"))]
#[serde(deny_unknown_fields, expecting = r#"a gear pair as { "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" }"#)]
pub(in crate::scene) struct GearFile {
    /// The two wheels: links, or "ground" for a wheel that is fixed to the frame.
    #[cfg_attr(feature = "schemas", schemars(length(equal = 2)))]
    pub mesh: Vec<String>,
    /// Their numbers of teeth, in the same order; that of a ring with inner teeth is negative. Wheels that only roll, and those of belts, have
    /// whole numbers in the ratio of their radii. "rack" stands for a straight rack, which slides on the carrier, or on which the carrier slides.
    #[cfg_attr(feature = "schemas", schemars(length(equal = 2)))]
    pub teeth: Vec<Teeth>,
    /// The carrier on whose pins both turn: a link (the arm of a planetary train), or "ground".
    pub on: String,
    /// How a belt or a chain runs around the wheels, in place of teeth that mesh.
    pub belt: Option<Belt>,
    /// The radius of the wheel's pitch circle on a rack; of wheels with a belt that of the first, which is only drawn.
    #[cfg_attr(feature = "schemas", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Option<f64>,
    /// The rack's position along its guide, or the carrier's along the rack, where the wheel's axis stands at 0 from the carrier's; left out: 0.
    /// Not in a drawn configuration.
    pub position: Option<f64>,
    /// The angle of the second wheel's axis when that of the first stands at 0, both from the carrier's axis, in degrees; left out: 0.
    /// Not in a drawn configuration.
    pub phase: Option<f64>,
    /// The pressure angle in degrees, with which the teeth push each other apart; left out: 0, only the tangential force counts.
    pub pressure: Option<f64>,
}

write_keys!(GearFile { mesh, teeth, on, belt, radius, position, phase, pressure });

pub(super) const GEARS: JointKind = JointKind {
    list: "gears",
    keys: &[
        ("mesh", Some(Meaning::Link)),
        ("teeth", None),
        ("on", Some(Meaning::Link)),
        ("belt", None),
        ("radius", None),
        ("position", None),
        ("phase", None),
        ("pressure", None),
    ],
};

/// Two wheels on pins of one carrier that roll on each other, a wheel and its rack, or two wheels with a belt.
///
/// With z₁ and z₂ teeth, that of a ring negative, angles keep to z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ_carrier = z₂ · phase, and so do angular
/// velocities and accelerations, without the phase (R. Willis, 1841; Müller, *Epicyclic drive trains*, 1982). With an open belt z₂ counts as
/// negative. A wheel of radius r on a rack keeps to r (θ − θ_carrier) = ± (s − position), with + where the pitch line lies to the right of the
/// wheel's centre, looking along the guide, and the rack is what slides.
#[derive(Debug, Clone, PartialEq)]
pub struct Gear {
    /// The bodies with the wheels.
    pub wheels: [On; 2],
    /// Their numbers of teeth, those of a ring with inner teeth negative; their sum is not zero. Zero of a rack.
    pub teeth: [i32; 2],
    /// The carrier.
    pub on: On,
    /// The points about which they turn on the carrier; for a rack that of its wheel.
    pub centers: [String; 2],
    /// How the wheel rolls on a rack, if one of the two is one.
    pub rack: Option<RackOf>,
    /// How a belt runs around them, if they do not mesh.
    pub belt: Option<Belt>,
    /// The radius of the first wheel of a belt, if it is given.
    pub belt_radius: Option<f64>,
    /// The angle of the second wheel when the first stands at zero, both from the carrier, in degrees; zero by default.
    pub phase_deg: f64,
    /// The pressure angle in degrees; zero by default.
    pub pressure_deg: f64,
}

/// A wheel on a rack.
#[derive(Debug, Clone, PartialEq)]
pub struct RackOf {
    /// Which of the two is the wheel.
    pub wheel: usize,
    /// The indices of the sliders that let the rack slide against the carrier: one between them, or that of the carrier and that of the rack, both on
    /// the ground.
    pub sliders: Vec<usize>,
    /// The radius of the wheel's pitch circle.
    pub radius: f64,
    /// The position of the last of the sliders where the wheel stands at 0 from the carrier; zero by default.
    pub position: f64,
}

/// What of the scene gear pairs refer to.
struct Around<'a> {
    is_drawn: bool,
    names: &'a Names<'a>,
    coordinates: &'a Coordinates,
    sliders: &'a [Slider],
}

/// The gear pairs of a scene; `is_drawn` in a drawn configuration.
pub(in crate::scene) fn gears(
    is_drawn: bool,
    names: &Names<'_>,
    coordinates: &Coordinates,
    sliders: &[Slider],
    file: Vec<GearFile>,
) -> Result<Vec<Gear>, Wrong> {
    let mut seen: HashSet<[String; 2]> = HashSet::new();
    let around = Around { is_drawn, names, coordinates, sliders };
    let checked = file.into_iter().enumerate().map(|(index, given)| {
        let checked = gear(&around, given).and_then(|(mut pair, gear)| {
            pair.sort_unstable();
            let [first, second] = &pair;
            let again = Wrong::value(&["mesh"], says::meshed_twice(first, second)).hint(says::remove_one_mesh());
            if seen.insert(pair) { Ok(gear) } else { Err(again) }
        });
        checked.map_err(|wrong| wrong.inside(&["gears", &index.to_string()]))
    });
    checked.collect()
}

/// A gear pair, and the names of its wheels as the file has them.
fn gear(around: &Around<'_>, given: GearFile) -> Result<([String; 2], Gear), Wrong> {
    let GearFile { mesh, teeth, on, belt, radius, position, phase, pressure } = given;
    let names = around.names;
    let mesh = <[String; 2]>::try_from(mesh).map_err(|mesh| Wrong::value(&["mesh"], says::two_wheels(mesh.len())))?;
    let teeth =
        <[Teeth; 2]>::try_from(teeth).map_err(|teeth| Wrong::value(&["teeth"], says::two_wheels(teeth.len())))?;
    let body = |path: &[&str], name: &str| match name {
        "ground" => Ok(On::Ground),
        link => names.link(path, link).map(|_| On::Link(link.to_owned())),
    };
    let wheels = [body(&["mesh", "0"], &mesh[0])?, body(&["mesh", "1"], &mesh[1])?];
    let carrier = body(&["on"], &on)?;
    if wheels[0] == wheels[1] {
        return Err(Wrong::value(&["mesh"], says::meshes_with_itself(named(&wheels[0]))));
    }
    if wheels.contains(&carrier) {
        return Err(Wrong::value(&["on"], says::wheel_carries_itself(named(&carrier))).hint(says::name_the_carrier()));
    }
    let keys = RackKeys { belt, radius, position, phase };
    let (teeth, centers, rack) = match teeth {
        [Teeth::Count(first), Teeth::Count(second)] => {
            let teeth = if belt.is_some() { belt_teeth([first, second])? } else { whole_teeth([first, second])? };
            let centers = wheel_centers(around, &wheels, &carrier)?;
            keys.check_without_rack()?;
            (teeth, centers, None)
        }
        [Teeth::Count(count), Teeth::Rack] => rack(around, &wheels, 0, count, &carrier, keys)?,
        [Teeth::Rack, Teeth::Count(count)] => rack(around, &wheels, 1, count, &carrier, keys)?,
        [Teeth::Rack, Teeth::Rack] => {
            return Err(Wrong::value(&["teeth"], says::two_racks()).hint(says::one_rack()));
        }
    };
    if around.is_drawn && phase.is_some() {
        return Err(Wrong::key(&["phase"], says::phase_is_drawn()).hint(says::remove_it_drawn()));
    }
    let pressure_deg = pressure.unwrap_or(0.0);
    if !(0.0..=STEEPEST).contains(&pressure_deg) {
        return Err(Wrong::value(&["pressure"], says::no_pressure(pressure_deg)).hint(says::usual_pressure(STEEPEST)));
    }
    if belt.is_some() && pressure.is_some() {
        return Err(Wrong::key(&["pressure"], says::belt_without_teeth()).hint(says::leave_key_out()));
    }
    let phase_deg = phase.unwrap_or(0.0);
    let belt_radius = radius.filter(|_| belt.is_some());
    Ok((mesh, Gear { wheels, teeth, on: carrier, centers, rack, belt, belt_radius, phase_deg, pressure_deg }))
}

/// The centres of two wheels, if they are two.
fn wheel_centers(around: &Around<'_>, wheels: &[On; 2], carrier: &On) -> Result<[String; 2], Wrong> {
    let center = |wheel: &On, index: &str| center_of(around.names, wheel, carrier, index);
    let centers = [center(&wheels[0], "0")?, center(&wheels[1], "1")?];
    let place = |point: &String| around.coordinates.get(point);
    if centers[0] == centers[1] || place(&centers[0]).is_some() && place(&centers[0]) == place(&centers[1]) {
        let message = says::wheels_on_one_axis(named(&wheels[0]), named(&wheels[1]));
        return Err(Wrong::value(&["mesh"], message).hint(says::mesh_over_a_wheel()));
    }
    Ok(centers)
}

/// The keys that racks have in place of others.
#[derive(Clone, Copy)]
struct RackKeys {
    belt: Option<Belt>,
    radius: Option<f64>,
    position: Option<f64>,
    phase: Option<f64>,
}

impl RackKeys {
    /// Refuses what belongs to a rack.
    fn check_without_rack(self) -> Result<(), Wrong> {
        if self.position.is_some() {
            return Err(Wrong::key(&["position"], says::position_without_rack()).hint(says::give_phase()));
        }
        match self.radius {
            Some(_) if self.belt.is_none() => {
                Err(Wrong::key(&["radius"], says::radius_without_rack()).hint(says::leave_key_out()))
            }
            Some(radius) => checked_radius(radius).map(drop),
            None => Ok(()),
        }
    }

    /// The radius on a rack; refuses what does not belong to one.
    fn on_rack(self, is_drawn: bool) -> Result<f64, Wrong> {
        if self.belt.is_some() {
            return Err(Wrong::key(&["belt"], says::belt_on_rack()).hint(says::leave_key_out()));
        }
        if self.phase.is_some() {
            return Err(Wrong::key(&["phase"], says::phase_of_rack()).hint(says::give_position_of_rack()));
        }
        if is_drawn && self.position.is_some() {
            let hint = says::remove_drawn("position");
            return Err(Wrong::key(&["position"], says::position_is_drawn()).hint(hint));
        }
        match self.radius {
            None => Err(Wrong::value(&[], says::missing("radius")).hint(says::give_radius())),
            Some(radius) => checked_radius(radius),
        }
    }
}

/// A radius that a wheel can have.
fn checked_radius(radius: f64) -> Result<f64, Wrong> {
    let wrong = || Wrong::value(&["radius"], says::no_radius(number(radius)));
    match radius {
        LEAST_RADIUS.. => Ok(radius),
        _ if radius > 0.0 => Err(wrong().hint(says::give_larger_radius(number(LEAST_RADIUS)))),
        _ => Err(wrong().hint(says::give_radius())),
    }
}

/// Numbers of teeth, centres and the rack of a pair in which the other one than `wheel` is a rack.
#[expect(clippy::type_complexity, reason = "the three parts of a pair that racks have otherwise")]
fn rack(
    around: &Around<'_>,
    wheels: &[On; 2],
    wheel: usize,
    count: f64,
    carrier: &On,
    keys: RackKeys,
) -> Result<([i32; 2], [String; 2], Option<RackOf>), Wrong> {
    let index = ["0", "1"][wheel];
    if !(1.0..=f64::from(MOST_TEETH)).contains(&count) || libm::trunc(count) != count {
        let hint = says::teeth_of_pinion(i64::from(MOST_TEETH));
        return Err(Wrong::value(&["teeth", index], says::no_teeth(count)).hint(hint));
    }
    let center = center_of(around.names, &wheels[wheel], carrier, index)?;
    let radius = keys.on_rack(around.is_drawn)?;
    let sliders = rack_sliders(around, &wheels[1 - wheel], carrier, ["1", "0"][wheel])?;
    let mut teeth = [0; 2];
    teeth[wheel] = count as i32;
    let rack = RackOf { wheel, sliders, radius, position: keys.position.unwrap_or(0.0) };
    Ok((teeth, [center.clone(), center], Some(rack)))
}

/// The sliders that let a rack slide against the carrier.
fn rack_sliders(around: &Around<'_>, rack: &On, carrier: &On, index: &str) -> Result<Vec<usize>, Wrong> {
    let sliding = |link: &Option<String>, body: &On| matches!((link, body), (Some(link), On::Link(own)) if link == own);
    let find = |on: &On, link: &On| {
        let mut sliders = around.sliders.iter();
        sliders.position(|slider| slider.on == *on && sliding(&slider.link, link))
    };
    if let Some(direct) = find(carrier, rack).or_else(|| find(rack, carrier)) {
        return Ok(vec![direct]);
    }
    let path = ["mesh", index];
    let (Some(of_carrier), Some(of_rack)) = (find(&On::Ground, carrier), find(&On::Ground, rack)) else {
        let message = says::rack_without_slider(named(rack), named(carrier));
        return Err(Wrong::value(&path, message).hint(says::let_rack_slide()));
    };
    let ways = [of_carrier, of_rack].map(|slider| on_ground(&around.sliders[slider], around.coordinates));
    match ways {
        [Some(first), Some(second)] if cross(first, second).abs() <= PARALLEL => Ok(vec![of_carrier, of_rack]),
        _ => {
            let message = says::rack_not_parallel(named(rack), named(carrier));
            Err(Wrong::value(&path, message).hint(says::let_rack_slide()))
        }
    }
}

/// The unit direction of a guide on the ground.
fn on_ground(slider: &Slider, coordinates: &Coordinates) -> Option<Vector> {
    let way = match &slider.along {
        Along::Degrees(degrees) => direction_of_degrees(*degrees),
        Along::Direction(way) => Vector::from(*way),
        Along::Points(from, to) => {
            let place = |point: &String| coordinates.get(point).map(|&place| Vector::from(place));
            place(to)? - place(from)?
        }
    };
    way.try_normalize(0.0)
}

/// The numbers of teeth, or of parts of radii, of wheels with a belt.
fn belt_teeth(given: [f64; 2]) -> Result<[i32; 2], Wrong> {
    for (index, teeth) in ["0", "1"].into_iter().zip(given) {
        if !(1.0..=f64::from(MOST_TEETH)).contains(&teeth) || libm::trunc(teeth) != teeth {
            let hint = says::teeth_of_belt(i64::from(MOST_TEETH));
            return Err(Wrong::value(&["teeth", index], says::no_teeth(teeth)).hint(hint));
        }
    }
    Ok(given.map(|teeth| teeth as i32))
}

/// The numbers of teeth, if wheels with these can mesh.
fn whole_teeth(given: [f64; 2]) -> Result<[i32; 2], Wrong> {
    for (index, teeth) in ["0", "1"].into_iter().zip(given) {
        if teeth == 0.0 || teeth.abs() > f64::from(MOST_TEETH) || libm::trunc(teeth) != teeth {
            return Err(
                Wrong::value(&["teeth", index], says::no_teeth(teeth)).hint(says::teeth_up_to(i64::from(MOST_TEETH)))
            );
        }
    }
    match given.map(|teeth| teeth as i32) {
        [first, second] if first < 0 && second < 0 => {
            Err(Wrong::value(&["teeth"], says::two_rings()).hint(says::one_ring()))
        }
        [first, second] if first + second == 0 => {
            Err(Wrong::value(&["teeth"], says::ring_of_the_same_size()).hint(says::ring_larger()))
        }
        // A ring holds the wheel inside of it.
        [first, second] if first + second > 0 && (first < 0 || second < 0) => Err(Wrong::value(
            &["teeth"],
            says::ring_smaller(i64::from(first.min(second).abs()), i64::from(first.max(second))),
        )
        .hint(says::ring_larger())),
        whole => Ok(whole),
    }
}

/// "link 2" or "the ground".
fn named(body: &On) -> Message {
    match body {
        On::Ground => says::the_ground(),
        On::Link(link) => says::link_named(link),
    }
}

/// The point about which a wheel turns on its carrier: the one that both have.
fn center_of(names: &Names<'_>, wheel: &On, carrier: &On, index: &str) -> Result<String, Wrong> {
    let has = |body: &On, point: &str| match body {
        On::Ground => names.on_ground(point),
        On::Link(link) => names.on_link(link, point),
    };
    let points = match wheel {
        On::Ground => names.ground,
        On::Link(link) => names.links.get(link).map_or(&[][..], |link| &link.points),
    };
    let mut common = points.iter().filter(|point| has(carrier, point));
    let path = ["mesh", index];
    match (common.next(), common.next()) {
        (Some(center), None) => Ok(center.clone()),
        (None, _) => {
            let message = says::wheel_not_on_carrier(named(wheel), named(carrier));
            Err(Wrong::value(&path, message).hint(says::pin_the_wheel()))
        }
        (Some(first), Some(second)) => {
            let message = says::two_wheel_pins(named(wheel), named(carrier), first, second);
            Err(Wrong::value(&path, message).hint(says::one_wheel_pin()))
        }
    }
}
