//! A construction carried out on the true position and motion, each number with the bound of its error.

use super::constructed::Construction;
use super::number::{End, NumberId, NumberKind, Product, Rate};
use super::operation::{Along, MeasuredAs, OperationKind, OperationRole, Reference};
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
        let origin = Pair::within(self.origin.coords, 0.0);
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
                _ => {
                    values.run(kind, [0.0; 2], 1.0);
                    if has_rounded_numbers(kind) {
                        values.forget(kind);
                    }
                }
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

/// Whether an operation has numbers of its own that are rounded, as a place plotted from the position in f64: nothing bounds how far
/// these are from the true ones.
fn has_rounded_numbers(kind: &OperationKind) -> bool {
    let is_given = |along: &Along| matches!(along.reference, Reference::Given(_));
    let is_rounded = |product: &Product| product.factor.trunc() != product.factor;
    match kind {
        OperationKind::Plot { .. } | OperationKind::ReadDirection { .. } => true,
        OperationKind::Draw { along, .. } | OperationKind::LayOff { along, .. } => is_given(along),
        OperationKind::Measure { how, .. } => matches!(how, MeasuredAs::Direction),
        OperationKind::Compute { sum, .. } => sum.iter().any(is_rounded),
        OperationKind::Solve { equations, .. } => equations.iter().any(|equation| {
            let left = equation.left.iter().map(|(_, product)| product);
            left.chain(&equation.right).any(is_rounded)
        }),
        _ => false,
    }
}

impl Values<Ball> {
    /// Leaves what an operation has made without bounds.
    fn forget(&mut self, kind: &OperationKind) {
        if let Some(place) = kind.place() {
            self.places[place.0] = self.places[place.0].widened(f64::INFINITY);
        }
        if let Some(line) = kind.line() {
            self.lines[line.0].1 = self.lines[line.0].1.widened(f64::INFINITY);
        }
        for number in kind.numbers() {
            self.numbers[number.0] = self.numbers[number.0].widened(f64::INFINITY);
        }
    }
}
