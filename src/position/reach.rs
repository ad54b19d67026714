//! Where the drive of a mechanism could stand that cannot be assembled as it stands.

use super::assemble::can_be_assembled;
use crate::mechanism::{Class, Mechanism, Role};

/// Degrees from one angle that is tried to the next: what reaches over less is not found.
const STEP: f64 = 1.0;
/// Ends of a range are found to so many degrees.
const EXACT: f64 = 1e-4;
/// Most links of a mechanism that is tried at all these angles.
const LINKS: usize = 40;

/// The ranges of the one drive's angle, in degrees, in which a mechanism of dyads can be assembled; one may begin below 0. None where there are several
/// drives or other groups, and where no angle is found.
pub(super) fn ranges(mechanism: &Mechanism) -> Vec<[f64; 2]> {
    let drives = || mechanism.bodies.iter().filter(|body| !matches!(body.role, Role::Ground | Role::Member));
    let is_of_dyads = mechanism.groups.iter().all(|group| group.class == Class::Second);
    let one = drives().count() == 1 && mechanism.placing.is_none() && mechanism.bodies.len() <= LINKS;
    let driver = mechanism.bodies.iter().position(|body| matches!(body.role, Role::Driver { angle: Some(_), .. }));
    let Some(driver) = driver.filter(|_| one && is_of_dyads) else { return Vec::new() };
    let mut moved = mechanism.clone();
    let mut can = |degrees: f64| {
        if let Role::Driver { angle, .. } = &mut moved.bodies[driver].role {
            *angle = Some(degrees);
        }
        can_be_assembled(&moved)
    };
    let count = (360.0 / STEP) as usize;
    let tried: Vec<bool> = (0..count).map(|k| can(k as f64 * STEP)).collect();
    let mut end = |mut inside: f64, mut outside: f64| {
        while (outside - inside).abs() > EXACT {
            let middle = 0.5 * (inside + outside);
            *(if can(middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    };
    let begins = (0..count).filter(|&k| tried[k] && !tried[(k + count - 1) % count]);
    let ranges = begins.map(|first| {
        let length = (1..count).take_while(|more| tried[(first + more) % count]).count();
        let (first, last) = (first as f64 * STEP, (first + length) as f64 * STEP);
        let turn = if last >= 360.0 { 360.0 } else { 0.0 };
        [end(first, first - STEP), end(last, last + STEP)].map(|degrees| degrees - turn)
    });
    ranges.collect()
}
