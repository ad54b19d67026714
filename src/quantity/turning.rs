//! Names of the quantities of links that turn: ratios of speeds, speeds seen from a carrier, revolutions a minute.

use crate::mechanism::{BodyId, GROUND, Mechanism, Role};
use crate::scene::Head;
use indexmap::IndexSet;

/// Names of what trains of wheels and linkages with several links that turn in the frame are asked for besides rates: ratios to the speed
/// of the drive; of wheels on an arm the rates seen from that, as `omega(2/1)`; of trains revolutions a minute. None where one link alone turns.
#[must_use]
pub fn turning_names(mechanism: &Mechanism) -> Vec<String> {
    let (mut wheels, mut on_arms) = (IndexSet::new(), IndexSet::new());
    for joint in mechanism.joints.iter().filter(|joint| joint.pitch.is_some() || joint.belt.is_some()) {
        // The carrier is the third of an equation of teeth.
        let carrier = joint.angular.as_ref().and_then(|teeth| teeth.terms.get(2)).map_or(GROUND, |(body, _)| *body);
        for wheel in joint.bodies.into_iter().filter(|body| *body != GROUND) {
            wheels.insert(wheel);
            on_arms.extend((carrier != GROUND).then_some([wheel, carrier]));
        }
    }
    let in_frame = |body: &BodyId| {
        let fixed = &mechanism.body(GROUND).points;
        mechanism.body(*body).points.iter().any(|point| fixed.contains(point))
    };
    let links = mechanism.links().map(|(id, _)| id);
    let turning: Vec<BodyId> = links.filter(|body| wheels.contains(body) || in_frame(body)).collect();
    let is_driver = |body: &&BodyId| matches!(mechanism.body(**body).role, Role::Driver { .. });
    let Some(driver) = turning.iter().find(is_driver).or(turning.first()) else { return Vec::new() };
    let name = |body: &BodyId| &mechanism.body(*body).name;
    let followers = turning.iter().filter(|body| *body != driver);
    let mut names: Vec<String> = followers.map(|body| Head::SpeedRatio.of_two(name(body), name(driver))).collect();
    for [wheel, arm] in &on_arms {
        names.extend([Head::Omega, Head::Alpha].map(|head| head.of_two(name(wheel), name(arm))));
    }
    if !wheels.is_empty() {
        names.extend(turning.iter().map(|body| Head::Rpm.of(name(body))));
    }
    names
}
