//! Gear pairs: two wheels on pins of one carrier that roll on each other without slip; their keys in the file, their checked form and the
//! checks.

use std::collections::HashSet;

use schemars::JsonSchema;
use serde::Deserialize;

use super::{JointKind, Meaning, On};
use crate::message::Message;
use crate::scene::error::Wrong;
use crate::scene::names::{Coordinates, Names};
use crate::scene::says;
use crate::scene::write::write_keys;

/// Most teeth of a wheel: more are a slip of the keyboard, and angles are multiplied by them.
const MOST_TEETH: i32 = 10_000;

/// The steepest line of action that a pair of teeth has, in degrees.
const STEEPEST: f64 = 45.0;

/// Two wheels that mesh: their pitch circles roll on each other without slip.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, expecting = r#"a gear pair as { "mesh": ["1", "2"], "teeth": [20, 40], "on": "ground" }"#)]
#[schemars(rename = "gear")]
pub(in crate::scene) struct GearFile {
    /// The two wheels: links, or "ground" for a wheel that is fixed to the frame.
    #[schemars(length(equal = 2))]
    pub mesh: Vec<String>,
    /// Their numbers of teeth, in the same order; that of a ring with inner teeth is negative. Wheels that only roll have whole numbers in
    /// the ratio of their radii.
    #[schemars(length(equal = 2))]
    pub teeth: Vec<f64>,
    /// The carrier on whose pins both turn: a link (the arm of a planetary train), or "ground".
    pub on: String,
    /// The angle of the second wheel's axis when that of the first stands at 0, both from the carrier's axis, in degrees; left out: 0.
    /// Not in a drawn configuration.
    pub phase: Option<f64>,
    /// The pressure angle in degrees, with which the teeth push each other apart; left out: 0, only the tangential force counts.
    pub pressure: Option<f64>,
}

write_keys!(GearFile { mesh, teeth, on, phase, pressure });

pub(super) const GEARS: JointKind = JointKind {
    list: "gears",
    keys: &[
        ("mesh", Some(Meaning::Link)),
        ("teeth", None),
        ("on", Some(Meaning::Link)),
        ("phase", None),
        ("pressure", None),
    ],
};

/// Two wheels on pins of one carrier that roll on each other.
///
/// With z₁ and z₂ teeth, that of a ring negative, angles keep to z₁ θ₁ + z₂ θ₂ − (z₁ + z₂) θ_carrier = z₂ · phase, and so do angular
/// velocities and accelerations, without the phase (R. Willis, 1841; Müller, *Epicyclic drive trains*, 1982).
#[derive(Debug, Clone, PartialEq)]
pub struct Gear {
    /// The bodies with the wheels.
    pub wheels: [On; 2],
    /// Their numbers of teeth, those of a ring with inner teeth negative; their sum is not zero.
    pub teeth: [i32; 2],
    /// The carrier.
    pub on: On,
    /// The points about which they turn on the carrier.
    pub centers: [String; 2],
    /// The angle of the second wheel when the first stands at zero, both from the carrier, in degrees; zero by default.
    pub phase_deg: f64,
    /// The pressure angle in degrees; zero by default.
    pub pressure_deg: f64,
}

/// The gear pairs of a scene; `is_drawn` in a drawn configuration.
pub(in crate::scene) fn gears(
    is_drawn: bool,
    names: &Names<'_>,
    coordinates: &Coordinates,
    file: Vec<GearFile>,
) -> Result<Vec<Gear>, Wrong> {
    let mut seen: HashSet<[String; 2]> = HashSet::new();
    let checked = file.into_iter().enumerate().map(|(index, given)| {
        let checked = gear(is_drawn, names, coordinates, given).and_then(|(mut pair, gear)| {
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
fn gear(
    is_drawn: bool,
    names: &Names<'_>,
    coordinates: &Coordinates,
    given: GearFile,
) -> Result<([String; 2], Gear), Wrong> {
    let GearFile { mesh, teeth, on, phase, pressure } = given;
    let mesh = <[String; 2]>::try_from(mesh).map_err(|mesh| Wrong::value(&["mesh"], says::two_wheels(mesh.len())))?;
    let teeth = <[f64; 2]>::try_from(teeth).map_err(|teeth| Wrong::value(&["teeth"], says::two_wheels(teeth.len())))?;
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
    let teeth = whole_teeth(teeth)?;
    let center = |wheel: &On, index: &str| center_of(names, wheel, &carrier, index);
    let centers = [center(&wheels[0], "0")?, center(&wheels[1], "1")?];
    let place = |point: &String| coordinates.get(point);
    if centers[0] == centers[1] || place(&centers[0]).is_some() && place(&centers[0]) == place(&centers[1]) {
        let message = says::wheels_on_one_axis(named(&wheels[0]), named(&wheels[1]));
        return Err(Wrong::value(&["mesh"], message).hint(says::mesh_over_a_wheel()));
    }
    if is_drawn && phase.is_some() {
        return Err(Wrong::key(&["phase"], says::phase_is_drawn()).hint(says::remove_it_drawn()));
    }
    let pressure_deg = pressure.unwrap_or(0.0);
    if !(0.0..=STEEPEST).contains(&pressure_deg) {
        return Err(Wrong::value(&["pressure"], says::no_pressure(pressure_deg)).hint(says::usual_pressure(STEEPEST)));
    }
    Ok((mesh, Gear { wheels, teeth, on: carrier, centers, phase_deg: phase.unwrap_or(0.0), pressure_deg }))
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
