//! Forces at several positions of a path at once.

use crate::forces::Posed;
use crate::geometry::{Many, Number, Pair, SEVERAL, Several, Vector};
use crate::kernel::{Block, Kernel};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, SliderId};
use crate::quantity::{ForceRead, Quantity, QuantityRequest};

/// What is asked for of forces, at the positions of a block.
pub(super) struct Together {
    /// By several positions, then by column: what was found of a force, none of other quantities. None where one of the positions has none.
    found: Vec<Option<Vec<Option<ForceRead<Several>>>>>,
}

impl Together {
    /// The forces at the first positions of a block, so many; `None` where none is asked for that is found so.
    pub fn new(
        (mechanism, kernel): (&Mechanism, &Kernel),
        (block, count): (&Block<Many>, usize),
        asked: &[QuantityRequest],
    ) -> Option<Together> {
        let compiled = asked.iter().find_map(QuantityRequest::force_of_links)?;
        let several = |first| {
            let here = Here { mechanism, kernel, block, first };
            let forces = compiled.forces(&here)?;
            let read = |asked: &QuantityRequest| {
                asked.force_of_links()?;
                asked.among(mechanism, &forces, &here)
            };
            Some(asked.iter().map(read).collect())
        };
        Some(Together { found: (0..count).step_by(SEVERAL).map(several).collect() })
    }

    /// The value of a column at a position; `None` where it is to be found by itself.
    pub fn value(&self, asked: &QuantityRequest, column: usize, lane: usize) -> Option<Option<Quantity>> {
        let found = self.found[lane / SEVERAL].as_ref()?[column].as_ref()?;
        Some(asked.of_one(found, lane % SEVERAL))
    }
}

/// Several positions of a block, from the first one on. Lengths are the same at all.
struct Here<'a> {
    mechanism: &'a Mechanism,
    kernel: &'a Kernel,
    block: &'a Block<Many>,
    first: usize,
}

impl Here<'_> {
    fn row(&self, row: &Many) -> Several {
        row.0[self.first..].first_chunk().map_or_else(Several::default, |numbers| Several(*numbers))
    }

    fn pair(&self, rows: &[Many; 2]) -> Pair<Several> {
        Pair { x: self.row(&rows[0]), y: self.row(&rows[1]) }
    }

    /// Cosine and sine of the angle of a body's frame.
    fn turn(&self, body: BodyId) -> Pair<Several> {
        let in_class = self.block.turn_in_class(body, 0);
        self.pair(&self.block.turns[self.kernel.seat(body).class]).turn(same(Vector::new(in_class.re, in_class.im)))
    }

    fn slot(&self, slot: usize) -> Pair<Several> {
        self.pair(&self.block.points[slot]) + same(self.block.origin(0))
    }

    fn omega(&self, body: BodyId) -> Several {
        self.row(&self.block.omegas[self.kernel.seat(body).class])
    }
}

/// A vector that is the same at all positions.
fn same(v: Vector) -> Pair<Several> {
    Pair { x: v.x.into(), y: v.y.into() }
}

impl Posed<Several> for Here<'_> {
    fn place(&self, point: PointId) -> Pair<Several> {
        self.slot(point.0)
    }

    fn guide(&self, slider: SliderId) -> Pair<Several> {
        let slider = self.mechanism.slider(slider);
        let (_, along) = slider.line();
        self.turn(slider.on).turn(same(along))
    }

    fn given(&self, number: f64) -> Several {
        number.into()
    }

    fn axis(&self, body: BodyId) -> Option<Pair<Several>> {
        let turn = self.turn(body);
        let length = turn.dot(turn).sqrt();
        (body != GROUND).then(|| Pair { x: turn.x / length, y: turn.y / length })
    }

    fn slide_position(&self, slider: SliderId) -> Option<Several> {
        Some(self.row(&self.block.slides[slider.0]))
    }

    fn local(&self, body: BodyId, point: PointId) -> Pair<Several> {
        same(self.mechanism.local(body, point).coords)
    }

    fn acceleration(&self, body: BodyId, place: Pair<Several>) -> Pair<Several> {
        let seat = self.kernel.seat(body);
        let (omega, alpha) = (self.omega(body), self.alpha(body));
        let arm = place - self.slot(seat.slot);
        self.pair(&self.block.point_accelerations[seat.slot]) + arm.quarter_turn() * alpha - arm * (omega * omega)
    }

    fn rates(&self, body: BodyId, place: Pair<Several>) -> (Pair<Several>, Several) {
        let seat = self.kernel.seat(body);
        let omega = self.omega(body);
        let arm = place - self.slot(seat.slot);
        (self.pair(&self.block.point_velocities[seat.slot]) + arm.quarter_turn() * omega, omega)
    }

    fn alpha(&self, body: BodyId) -> Several {
        self.row(&self.block.alphas[self.kernel.seat(body).class])
    }
}
