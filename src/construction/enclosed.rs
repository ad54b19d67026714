//! A construction carried out on the true position and motion, each number with the bound of its error.

use super::constructed::Construction;
use super::number::{End, NumberId, NumberKind, Rate};
use super::operation::{OperationKind, OperationRole};
use super::run::Values;
use crate::geometry::{Ball, Number, Pair};
use crate::mechanism::{BodyId, PointId, SliderId};
use crate::sheet::Order;

/// What is known of a true position and its motion; bounds are infinite where nothing is.
pub(crate) trait Truth {
    /// The place of a point.
    fn place(&self, point: PointId) -> Pair<Ball>;
    /// The unit direction of a slider's guide.
    fn guide(&self, slider: SliderId) -> Pair<Ball>;
    /// A rate of a link or a slider.
    fn rate(&self, rate: Rate) -> Ball;
    /// Velocity or acceleration of the body's point at a point.
    fn motion(&self, order: Order, body: BodyId, point: PointId) -> Pair<Ball>;
}

impl Construction {
    /// The results of all operations where joints, guides and rates are the true ones. What a plan shows of a point's
    /// motion and what is solved for is taken from `truth`, so that no bound grows from crossing to crossing; only what
    /// is laid off and crossed in between is carried out.
    pub(crate) fn enclosed(&self, truth: &impl Truth) -> Values<Ball> {
        let mut values = Values::default();
        values.resize(self.counts());
        // By place: the motion whose end it is.
        let mut ends = vec![None; values.places.len()];
        self.record.motions.iter().for_each(|(&motion, place)| ends[place.0] = Some(motion));
        let origin = Pair { x: self.origin.x.into(), y: self.origin.y.into() };
        for operation in &self.operations {
            let kind = &operation.kind;
            match (kind, operation.role) {
                (OperationKind::Plot { place, .. }, OperationRole::Joint(point)) => {
                    values.places[place.0] = truth.place(point) - origin;
                }
                (OperationKind::Take { number, .. }, _) => {
                    values.numbers[number.0] = self.taken(*number, truth);
                }
                // A pitch radius is computed from a true length.
                (OperationKind::Solve { unknowns, .. }, _)
                    if unknowns.iter().all(|number| matches!(self.numbers[number.0], NumberKind::Rate(_))) =>
                {
                    for &number in unknowns {
                        values.numbers[number.0] = self.taken(number, truth);
                    }
                }
                _ => values.run(kind, [0.0; 2], 1.0),
            }
            if let (OperationRole::Guide(slider), Some(line)) = (operation.role, kind.line()) {
                values.lines[line.0].1 = truth.guide(slider);
            }
            if let Some(place) = kind.place()
                && let Some((order, body, point)) = ends[place.0]
            {
                values.places[place.0] = truth.motion(order, body, point);
            }
        }
        values
    }

    /// A number that is given, taken from the motion, or solved for. Sizes of vectors that are taken with it count by the
    /// vectors' ends alone.
    fn taken(&self, number: NumberId, truth: &impl Truth) -> Ball {
        match &self.numbers[number.0] {
            NumberKind::Rate(rate) => truth.rate(*rate),
            NumberKind::RateByCenters(link) => truth.rate(Rate::Angular(Order::Velocity, *link)),
            NumberKind::Length([End::Joint(a), End::Joint(b)]) => {
                let arm = truth.place(*b) - truth.place(*a);
                arm.dot(arm).sqrt()
            }
            _ => Ball::default().widened(f64::INFINITY),
        }
    }

    /// The vector from one plan point to another among these values; `None` for an unknown name.
    pub(crate) fn enclosed_segment(&self, values: &Values<Ball>, order: Order, ends: [&str; 2]) -> Option<Pair<Ball>> {
        let [from, to] = ends.map(|name| self.place(order, self.plan_name(order, name)));
        Some(values.places[to?.0] - values.places[from?.0])
    }
}
