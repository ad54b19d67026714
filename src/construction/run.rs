//! Carries out operations, in f64 with a hand's errors and mistakes, or with bounds of the rounding errors.

use super::number::{Equation, NumberId, Product};
use super::operation::{
    Along, ErrorUnit, LineId, MeasuredAs, Operation, OperationKind, PlaceId, Reference, Ruled, RuledEnd,
};
use crate::geometry::{Ball, Number, Pair, Vector, degrees_of, turn_of_degrees, without_sense};
use crate::sheet::PerSheet;
use smallvec::SmallVec;
use std::sync::Arc;

/// Limits of the errors of a careful hand; within the limits every error is equally likely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Limit for coordinates of a plotted point and for lengths laid off or measured, in millimetres of paper.
    pub mm: f64,
    /// Limit for directions drawn or read, in degrees.
    pub degrees: f64,
}

impl Tolerance {
    /// The largest limit of a hand's errors that makes sense, in mm or degrees.
    pub const LARGEST: f64 = 10.0;
}

impl Default for Tolerance {
    /// 0.3 mm and 0.3°: a sharp pencil, a ruler with millimetres, two set squares.
    fn default() -> Self {
        Tolerance { mm: 0.3, degrees: 0.3 }
    }
}

/// An error or a mistake in an operation.
#[derive(Clone, Debug)]
pub struct Disturbance {
    /// The index of the operation.
    pub operation: usize,
    /// The error or mistake.
    pub change: Change,
}

/// An error or a mistake in an operation.
#[derive(Clone, Debug)]
pub enum Change {
    /// An error of the hand: index among the operation's [`errors`](OperationKind::errors), and its size in millimetres of paper
    /// or degrees.
    Error(usize, f64),
    /// A mistake: the action carried out in place of the right one. It must make the same results and use none that are
    /// made later.
    Instead(Arc<OperationKind>),
    /// A number that the operation makes is multiplied by a factor.
    Times(NumberId, f64),
    /// A number that the operation makes is replaced by this value in later operations.
    Written(NumberId, f64),
    /// A line that the operation draws is displaced to its left by a product of numbers made before, in units of the
    /// sheet.
    Aside(LineId, Product),
}

/// A number type in which a construction can be carried out.
pub trait Drawable: Number + Default {
    /// A number that an operation has of itself: a place, a direction or a factor, as it is drawn.
    fn own(number: f64) -> Self;

    /// The number, rounded to f64.
    fn rounded(self) -> f64;
}

impl Drawable for f64 {
    fn own(number: f64) -> f64 {
        number
    }

    fn rounded(self) -> f64 {
        self
    }
}

impl Drawable for Ball {
    fn own(number: f64) -> Ball {
        Ball::within(number, 0.0)
    }

    fn rounded(self) -> f64 {
        self.high
    }
}

/// The results of operations: places and lines in units of their sheet, numbers in the scene's units; angles in
/// degrees, rates in rad.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values<S = f64> {
    pub(super) places: Vec<Pair<S>>,
    /// By line: a place of it and its unit direction.
    pub(super) lines: Vec<(Pair<S>, Pair<S>)>,
    pub(super) numbers: Vec<S>,
}

impl Values {
    /// A place, in units of its sheet.
    #[must_use]
    pub fn place(&self, id: PlaceId) -> Vector {
        let Pair { x, y } = self.places[id.0];
        Vector::new(x, y)
    }

    /// A line, in units of its sheet: a place of it and its unit direction.
    #[must_use]
    pub fn line(&self, id: LineId) -> (Vector, Vector) {
        let (place, along) = self.lines[id.0];
        (Vector::new(place.x, place.y), Vector::new(along.x, along.y))
    }

    /// A direction, of length 1.
    #[must_use]
    pub fn along(&self, along: &Along) -> Vector {
        let Pair { x, y } = self.direction(along, 0.0);
        Vector::new(x, y)
    }

    /// A number, in the scene's units; angles in degrees, rates in rad.
    #[must_use]
    pub fn number(&self, id: NumberId) -> f64 {
        self.numbers[id.0]
    }

    /// Replaces a place, in units of its sheet, by where it was found.
    pub(crate) fn put_place(&mut self, id: PlaceId, at: Vector) {
        self.places[id.0] = Pair { x: at.x, y: at.y };
    }

    /// Replaces a number by the one that somebody found.
    pub(crate) fn put_number(&mut self, id: NumberId, value: f64) {
        self.numbers[id.0] = value;
    }

    /// Carries out the operations from index `first` on; the results of those before it must be present. `disturbances`
    /// are sorted by operation. `scales` are in units of the scene per millimetre of paper; for a sheet that is not
    /// drawn, where errors of the hand have no meaning, 1.
    ///
    /// An impossible operation, as the crossing of parallel lines, yields numbers that are not finite, and so do the
    /// operations that use them.
    pub fn carry_out(
        &mut self,
        operations: &[Operation],
        first: usize,
        scales: PerSheet<f64>,
        disturbances: &[Disturbance],
    ) {
        let mut waiting = disturbances.iter().peekable();
        for (index, operation) in operations.iter().enumerate().skip(first) {
            let per_mm = scales[operation.sheet];
            if waiting.peek().is_none_or(|next| next.operation != index) {
                self.run(&operation.kind, [0.0; 2], per_mm);
                continue;
            }
            let (mut kind, mut errors) = (&operation.kind, [0.0; 2]);
            let mut afterwards: SmallVec<[&Change; 2]> = SmallVec::new();
            while let Some(next) = waiting.next_if(|d| d.operation == index) {
                match &next.change {
                    Change::Error(which, size) => errors[*which] += size,
                    Change::Instead(other) => kind = other,
                    number => afterwards.push(number),
                }
            }
            self.run(kind, errors, per_mm);
            for change in afterwards {
                match change {
                    Change::Times(number, factor) => self.numbers[number.0] *= factor,
                    Change::Written(number, value) => self.numbers[number.0] = *value,
                    Change::Aside(line, by) => {
                        let (place, along) = self.lines[line.0];
                        self.lines[line.0].0 = place + along.quarter_turn() * self.product(by);
                    }
                    Change::Error(..) | Change::Instead(_) => {}
                }
            }
        }
    }
}

impl Values {
    /// Carries out one operation, with errors in millimetres of paper or degrees; the results that it uses must be present.
    pub(crate) fn repeat(&mut self, operation: &Operation, errors: [f64; 2], scales: PerSheet<f64>) {
        self.run(&operation.kind, errors, scales[operation.sheet]);
    }

    /// Takes the results of an operation from other values.
    pub(crate) fn take(&mut self, Operation { kind, .. }: &Operation, from: &Values) {
        kind.place().iter().for_each(|place| self.places[place.0] = from.places[place.0]);
        kind.line().iter().for_each(|line| self.lines[line.0] = from.lines[line.0]);
        kind.numbers().iter().for_each(|number| self.numbers[number.0] = from.numbers[number.0]);
    }
}

impl<S: Drawable> Values<S> {
    /// Makes room for so many places, lines and numbers.
    pub(super) fn resize(&mut self, [places, lines, numbers]: [usize; 3]) {
        self.places.resize(places, Pair::default());
        self.lines.resize(lines, (Pair::default(), Pair::default()));
        self.numbers.resize(numbers, S::default());
    }

    /// Carries out one operation, with errors in millimetres or degrees; `per_mm` is the sheet's scale.
    pub(super) fn run(&mut self, kind: &OperationKind, errors: [f64; 2], per_mm: f64) {
        let pair = |v: Vector| Pair { x: S::own(v.x), y: S::own(v.y) };
        let offset = Vector::from(errors) * per_mm;
        match kind {
            OperationKind::Pole { place, at } => self.places[place.0] = pair(*at),
            OperationKind::Plot { place, at } => self.places[place.0] = pair(at + offset),
            OperationKind::Join { line, from, towards } => {
                let (from, towards) = (self.places[from.0], self.places[towards.0]);
                self.lines[line.0] = (from, unit(towards - from));
            }
            OperationKind::Draw { line, through, along } => {
                self.lines[line.0] = (self.places[through.0], self.direction(along, errors[0]));
            }
            OperationKind::Cross { place, lines } => {
                let lines = lines.map(|LineId(line)| self.lines[line]);
                self.places[place.0] = displaced(crossing(lines), offset);
            }
            OperationKind::Meet { place, lines } => {
                self.places[place.0] = displaced(crossing(lines.map(|line| self.ruled(line))), offset);
            }
            OperationKind::OnLine { place, line, near } => {
                let (through, along) = self.ruled(*line);
                let (turn, aside) = if line.is_drawn_along() { (errors[1], 0.0) } else { (0.0, offset.y) };
                let turn = turn_of_degrees(turn);
                let along = Pair { x: S::own(turn.re), y: S::own(turn.im) }.turn(along);
                let size = increased((pair(*near) - through).dot(along), offset.x);
                self.places[place.0] = through + along * size + along.quarter_turn() * S::own(aside);
            }
            OperationKind::Divide { place, ends, like } => {
                let [from, to] = ends.map(|PlaceId(end)| self.places[end]);
                let [first, second, point] = like.map(|PlaceId(point)| self.places[point]);
                let (line, arm) = (second - first, point - first);
                let divided = from + (to - from) * (arm.dot(line) / line.dot(line));
                let is_off = offset.x != 0.0;
                self.places[place.0] = if is_off { divided + unit(to - from) * S::own(offset.x) } else { divided };
            }
            OperationKind::LayOff { place, from, size, along } => {
                let direction = self.direction(along, errors[0]);
                let size = increased(self.numbers[size.0], errors[1] * per_mm);
                self.places[place.0] = self.places[from.0] + direction * size;
            }
            OperationKind::Measure { number, from, to, how } => {
                self.numbers[number.0] = self.measured(*from, *to, *how, errors[0], per_mm);
            }
            OperationKind::ReadDirection { number, along } => {
                let Pair { x, y } = self.direction(along, 0.0);
                let degrees = degrees_of(Vector::new(x.rounded(), y.rounded())) + errors[0];
                self.numbers[number.0] = S::own(without_sense(degrees, 0.0));
            }
            OperationKind::Take { number, value } => self.numbers[number.0] = S::own(*value),
            OperationKind::Compute { number, sum } => self.numbers[number.0] = self.sum(sum),
            OperationKind::Solve { unknowns, equations } => {
                let rates = self.solved(equations);
                for (index, number) in unknowns.iter().enumerate() {
                    self.numbers[number.0] = rates.get(index).copied().unwrap_or(S::own(f64::NAN));
                }
            }
        }
    }

    /// A place of a line that is ruled by mistake, and its unit direction; not finite where both ends are at infinity.
    fn ruled(&self, line: Ruled) -> (Pair<S>, Pair<S>) {
        let ends = match line {
            Ruled::Line(LineId(line)) => return self.lines[line],
            Ruled::Through(ends) => ends,
        };
        let place = |end: RuledEnd| match end {
            RuledEnd::Place(PlaceId(place)) => self.places[place],
            RuledEnd::At(at) => Pair { x: S::own(at.x), y: S::own(at.y) },
            RuledEnd::Towards(_) => Pair { x: S::own(f64::NAN), y: S::own(f64::NAN) },
        };
        match ends {
            [RuledEnd::Towards(along), end] | [end, RuledEnd::Towards(along)] => {
                (place(end), self.direction(&along, 0.0))
            }
            [from, towards] => (place(from), unit(place(towards) - place(from))),
        }
    }

    fn measured(&self, PlaceId(from): PlaceId, PlaceId(to): PlaceId, how: MeasuredAs, error: f64, per_mm: f64) -> S {
        let vector = self.places[to] - self.places[from];
        let length = |exact: S| increased(exact, error * per_mm);
        match how {
            MeasuredAs::Size => length(vector.dot(vector).sqrt()),
            MeasuredAs::Along(LineId(line)) => length(vector.dot(self.lines[line].1)),
            MeasuredAs::X => length(vector.x),
            MeasuredAs::Y => length(vector.y),
            MeasuredAs::Direction => S::own(degrees_of(Vector::new(vector.x.rounded(), vector.y.rounded())) + error),
        }
    }

    pub(super) fn direction(&self, along: &Along, degrees: f64) -> Pair<S> {
        let mut direction = match along.reference {
            Reference::Line(LineId(line)) => self.lines[line].1,
            Reference::Angle { base, from, to } => {
                let [base, from, to] = [base, from, to].map(|LineId(line)| self.lines[line].1);
                // The conjugate turns back.
                base.turn(to).turn(Pair { x: from.x, y: -from.y })
            }
            Reference::Given(direction) => Pair { x: S::own(direction.x), y: S::own(direction.y) },
        };
        for _ in 0..along.quarter_turns {
            direction = direction.quarter_turn();
        }
        if degrees == 0.0 {
            return direction;
        }
        let turn = turn_of_degrees(degrees);
        Pair { x: S::own(turn.re), y: S::own(turn.im) }.turn(direction)
    }

    fn product(&self, product: &Product) -> S {
        product.of.iter().fold(S::own(product.factor), |all, &NumberId(number)| all * self.numbers[number])
    }

    fn sum(&self, sum: &[Product]) -> S {
        sum.iter().fold(S::default(), |all, product| all + self.product(product))
    }

    /// Solution of linear equations by Gaussian elimination with complete pivoting; NaN where they are singular.
    ///
    /// Independent of the solver of the loop equations, with which the results are compared.
    fn solved(&self, equations: &[Equation]) -> SmallVec<[S; 4]> {
        let count = equations.len();
        // By row: the coefficients of the unknowns, and the right side.
        let mut rows = [[S::default(); 5]; 4];
        for (row, equation) in rows.iter_mut().zip(equations) {
            *row = self.coefficients_and_side(equation);
        }
        let mut columns = [0, 1, 2, 3];
        for step in 0..count {
            let (mut pivot_row, mut pivot_column, mut largest) = (step, step, 0.0);
            for (row, numbers) in rows.iter().enumerate().take(count).skip(step) {
                for (column, &unknown) in columns.iter().enumerate().take(count).skip(step) {
                    let size = numbers[unknown].rounded().abs();
                    if size >= largest {
                        (pivot_row, pivot_column, largest) = (row, column, size);
                    }
                }
            }
            rows.swap(step, pivot_row);
            columns.swap(step, pivot_column);
            let pivot = rows[step];
            for row in &mut rows[step + 1..count] {
                let part = row[columns[step]] / pivot[columns[step]];
                for &column in columns[step + 1..count].iter().chain(&[RIGHT]) {
                    row[column] = row[column].minus_product(part, pivot[column]);
                }
            }
        }
        let mut solution: SmallVec<[S; 4]> = SmallVec::from_elem(S::default(), count);
        for step in (0..count).rev() {
            let later = columns[step + 1..count].iter();
            let rest = later.fold(rows[step][RIGHT], |rest, &c| rest.minus_product(rows[step][c], solution[c]));
            solution[columns[step]] = rest / rows[step][columns[step]];
        }
        solution
    }

    fn coefficients_and_side(&self, equation: &Equation) -> [S; 5] {
        let mut row = [S::default(); 5];
        for (unknown, coefficient) in &equation.left {
            row[*unknown] = row[*unknown] + self.product(coefficient);
        }
        row[RIGHT] = self.sum(&equation.right);
        row
    }
}

/// Where two lines cross: a place p + t d of the first is on the second, through q along e, for t = ((q − p) × e) / (d × e).
fn crossing<S: Drawable>([(p, d), (q, e)]: [(Pair<S>, Pair<S>); 2]) -> Pair<S> {
    p + d * ((q - p).cross(e) / d.cross(e))
}

/// Column of the right side, after the coefficients of at most four unknowns.
const RIGHT: usize = 4;

/// Adds an exact amount; for zero the number stays as it is, without a rounding.
fn increased<S: Drawable>(number: S, by: f64) -> S {
    if by == 0.0 { number } else { number + S::own(by) }
}

fn displaced<S: Drawable>(place: Pair<S>, by: Vector) -> Pair<S> {
    Pair { x: increased(place.x, by.x), y: increased(place.y, by.y) }
}

/// The unit vector in the same direction; NaN for the zero vector.
fn unit<S: Drawable>(v: Pair<S>) -> Pair<S> {
    // Scaled first, so that the squares stay within the range of f64.
    let largest = S::own(v.x.rounded().abs().max(v.y.rounded().abs()));
    let scaled = Pair { x: v.x / largest, y: v.y / largest };
    let size = scaled.dot(scaled).sqrt();
    Pair { x: scaled.x / size, y: scaled.y / size }
}

impl ErrorUnit {
    /// Limit of an error of this unit.
    #[must_use]
    pub fn limit(self, tolerance: &Tolerance) -> f64 {
        match self {
            ErrorUnit::Length => tolerance.mm,
            ErrorUnit::Direction => tolerance.degrees,
        }
    }
}
