//! The force plan beside the equations of equilibrium.

use super::statics::Statics;
use crate::construction::constructed::Agreement;
use crate::geometry::{Ball, Pair, UNIT_ROUNDOFF};

/// How much what is left out as nothing may do in the end, in parts of it.
const FOLLOWS: f64 = 100.0;

impl Statics<'_, '_> {
    /// Compares all that polygons and moments have found, in parts of the largest force; couples over the mechanism's size.
    pub fn compare(&mut self) {
        let mechanism = self.mechanism();
        let mut seen: Vec<(Ball, Ball, f64)> = Vec::new();
        let exact = &self.writer.construction.record.exact;
        for &(joint, on, ends) in &self.plan.joints {
            let force = ends.map_or(Pair::default(), |[from, to]| exact.places[to.0] - exact.places[from.0]);
            let carried = self.computed.joints[joint.0].force;
            let carried = if mechanism.joint(joint).bodies[1] == on { carried } else { -carried };
            seen.extend([(force.x, carried.x, 1.0), (force.y, carried.y, 1.0)]);
        }
        for (&slider, couple) in &self.couples {
            let found = exact.numbers[couple.size.0].signed(couple.sign);
            seen.push((found, self.computed.couple(mechanism, slider), self.writer.size));
            self.plan.numbers.couples.insert(slider, (couple.size, couple.sign));
        }
        for (&body, torque) in &self.plan.numbers.torques {
            seen.push((exact.numbers[torque.0], self.computed.torque(body), self.writer.size));
        }
        if seen.is_empty() || self.largest == 0.0 {
            return;
        }
        let left_out = FOLLOWS * self.left_out / self.largest + UNIT_ROUNDOFF;
        let none = Agreement { difference: 0.0, allowed: left_out };
        let worst = seen.into_iter().fold(none, |worst, (found, computed, size)| {
            let scale = self.largest * size;
            let difference = (found - computed).high.abs() / scale;
            let allowed = left_out + (found.error() + computed.error()) / scale;
            // `max` ignores NaN, which is no agreement.
            let difference = if difference.is_nan() { f64::MAX } else { difference };
            let (difference, allowed) = (worst.difference.max(difference), worst.allowed.max(allowed));
            Agreement { difference, allowed }
        });
        self.plan.agreement = Some(worst);
    }
}
