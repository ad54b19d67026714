//! The numbers of a mechanism in a kernel, and how they follow from the mechanism: in the same way for all of one kind.

use crate::geometry::{Point, Row, Turn, Vector, quarter_turn};
use crate::mechanism::{AngularConstraint, BodyId, GROUND, JointId, Mechanism, SliderId};
use smallvec::SmallVec;

/// The column that is zero, of unknowns that a loop does not contain.
pub(super) const ZERO: usize = 0;

/// A place in a body's frame, by what gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spot {
    Origin,
    /// A point, by its index among the body's points.
    Point(usize),
    /// The place from which the position of a slider on the body counts.
    Guide(SliderId),
}

/// The vector from one place of a body to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub body: BodyId,
    pub from: Spot,
    pub to: Spot,
}

/// Vectors that are added up.
pub(super) type Sum = SmallVec<[Span; 2]>;

/// The unit vector of a slider in the direction of increasing position, or against it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Way {
    pub slider: SliderId,
    pub is_back: bool,
}

/// The vector of a column in the frame of its class.
#[derive(Clone, Debug)]
pub(super) enum Column {
    /// That of a loop's member, turned by +90°.
    Member(Sum),
    /// The guide of a slider.
    Guide(Way),
}

/// What gives a body its rotation in its class: the fixed angle of a joint to another body, of which it is the second unless `is_back`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    pub by: BodyId,
    pub joint: JointId,
    pub is_back: bool,
}

/// How the numbers of a mechanism give those of its kernel.
#[derive(Clone, Debug, Default)]
pub(super) struct Recipe {
    /// The bodies, each after the one by which it is held; the first of a class is held by none.
    pub turns: Vec<(BodyId, Option<Held>)>,
    /// The places of the ground that have slots.
    pub fixed: Vec<Spot>,
    /// By placing.
    pub reaches: Vec<Span>,
    /// By placing.
    pub guides: Vec<Option<Way>>,
    /// The columns but [`ZERO`].
    pub columns: Vec<Column>,
    /// Members of loops that have been left out, as their vectors vanish.
    pub vanishing: Vec<Sum>,
}

/// The numbers of mechanisms of one kind, side by side. Vectors are in the frames of their classes.
#[derive(Clone, Debug)]
pub(super) struct Lengths<R> {
    /// The origin of the places in a block, a point of the ground: coordinates far from the fixed frame's origin would lose digits.
    pub origin: [R; 2],
    /// By body: cosine and sine of its rotation relative to its class.
    pub turns: Vec<[R; 2]>,
    /// The places of the ground that have slots, from the origin.
    pub fixed: Vec<[R; 2]>,
    /// By column, with all sliders at zero.
    pub columns: Vec<[R; 2]>,
    /// By placing: the vector between its points, with its slider at zero.
    pub reaches: Vec<[R; 2]>,
    /// By placing: the unit vector of its slider, if it has one.
    pub guides: Vec<[R; 2]>,
}

impl<R: Row> Lengths<R> {
    /// These of one mechanism at all positions.
    pub fn repeat(one: &Lengths<[f64; 1]>) -> Self {
        let pair = |[[x], [y]]: &[[f64; 1]; 2]| [R::splat(*x), R::splat(*y)];
        let all = |rows: &[[[f64; 1]; 2]]| rows.iter().map(pair).collect();
        Lengths {
            origin: pair(&one.origin),
            turns: all(&one.turns),
            fixed: all(&one.fixed),
            columns: all(&one.columns),
            reaches: all(&one.reaches),
            guides: all(&one.guides),
        }
    }
}

impl Recipe {
    /// No numbers yet.
    pub fn nothing(&self) -> Lengths<[f64; 1]> {
        let none = |count| vec![[[0.0]; 2]; count];
        Lengths {
            origin: [[0.0]; 2],
            turns: none(self.turns.len()),
            fixed: none(self.fixed.len()),
            columns: none(ZERO + 1 + self.columns.len()),
            reaches: none(self.reaches.len()),
            guides: none(self.guides.len()),
        }
    }

    /// The index of a new column.
    pub fn add_column(&mut self, column: Column) -> usize {
        self.columns.push(column);
        ZERO + self.columns.len()
    }

    /// By body: its rotation relative to its class.
    pub fn turns(&self, mechanism: &Mechanism) -> Vec<Turn> {
        let mut turns = vec![Turn::identity(); self.turns.len()];
        for (body, held) in &self.turns {
            turns[body.0] = held.map_or_else(Turn::identity, |held| held.turned(mechanism, turns[held.by.0]));
        }
        turns
    }

    /// Sets the numbers at one position to those of a mechanism; whether all vectors that have been left out vanish there, too.
    pub fn measure<R: Row>(&self, mechanism: &Mechanism, lengths: &mut Lengths<R>, position: usize) -> bool {
        let Lengths { origin, turns, fixed, columns, reaches, guides } = lengths;
        let set = |rows: &mut [R; 2], v: Vector| (rows[0][position], rows[1][position]) = (v.x, v.y);
        let turn_in = |turns: &[[R; 2]], body: BodyId| {
            let [cosine, sine] = &turns[body.0];
            Turn::from_cos_sin_unchecked(cosine[position], sine[position])
        };
        for (body, held) in &self.turns {
            let turn = held.map_or_else(Turn::identity, |held| held.turned(mechanism, turn_in(turns, held.by)));
            set(&mut turns[body.0], Vector::new(turn.re, turn.im));
        }
        let turn = |body: BodyId| turn_in(turns, body);
        let start = self.fixed.first().map_or_else(Point::origin, |spot| spot.place(mechanism, GROUND)).coords;
        set(origin, start);
        for (rows, spot) in fixed.iter_mut().zip(&self.fixed) {
            set(rows, spot.place(mechanism, GROUND).coords - start);
        }
        for (rows, span) in reaches.iter_mut().zip(&self.reaches) {
            set(rows, span.vector(mechanism, turn));
        }
        for (rows, way) in guides.iter_mut().zip(&self.guides) {
            if let Some(way) = way {
                set(rows, way.vector(mechanism, turn));
            }
        }
        for (rows, column) in columns[ZERO + 1..].iter_mut().zip(&self.columns) {
            let vector = match column {
                Column::Member(sum) => quarter_turn(total(sum, mechanism, turn)),
                Column::Guide(way) => way.vector(mechanism, turn),
            };
            set(rows, vector);
        }
        self.vanishing.iter().all(|sum| total(sum, mechanism, turn) == Vector::zeros())
    }
}

/// The sum of vectors of one class.
pub(super) fn total(sum: &Sum, mechanism: &Mechanism, turn: impl Fn(BodyId) -> Turn) -> Vector {
    sum.iter().fold(Vector::zeros(), |total, span| total + span.vector(mechanism, &turn))
}

impl Held {
    /// The rotation of the body relative to its class, from that of the body that holds it.
    fn turned(self, mechanism: &Mechanism, by: Turn) -> Turn {
        let angular = mechanism.joint(self.joint).angular.as_ref();
        let angle = angular.and_then(AngularConstraint::as_fixed_angle).map_or_else(Turn::identity, |(_, angle)| angle);
        by * if self.is_back { angle.inverse() } else { angle }
    }
}

impl Spot {
    /// Where it is in the body's frame.
    pub fn place(self, mechanism: &Mechanism, body: BodyId) -> Point {
        match self {
            Spot::Origin => Point::origin(),
            Spot::Point(index) => mechanism.body(body).local.get(index).copied().unwrap_or_else(Point::origin),
            Spot::Guide(slider) => mechanism.slider(slider).line().0,
        }
    }
}

impl Span {
    /// The vector in the frame of its class.
    fn vector(self, mechanism: &Mechanism, turn: impl Fn(BodyId) -> Turn) -> Vector {
        let Span { body, from, to } = self;
        turn(body) * (to.place(mechanism, body) - from.place(mechanism, body))
    }
}

impl Way {
    /// The vector in the frame of its class.
    fn vector(self, mechanism: &Mechanism, turn: impl Fn(BodyId) -> Turn) -> Vector {
        let slider = mechanism.slider(self.slider);
        let along = turn(slider.on) * slider.line().1;
        if self.is_back { -along } else { along }
    }
}
