use super::act::{Act, Deed, Equation, Error, How, LineId, NumberId, PlaceId, Product, Reference, Sheet};
use super::writer::Drafting;
use crate::geometry::{Vector, cross, degrees_of, quarter_turn, turn_of_degrees, unit};
use nalgebra::{Matrix4, Vector4};
use smallvec::SmallVec;

/// The scales of the sheets, in units of the scene per millimetre of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetScales {
    /// Of the scheme, the velocity plan and the acceleration plan. One for a sheet that there is not: no error there means anything.
    pub per_mm: [f64; 3],
}

/// Something that goes otherwise than it should at an act.
#[derive(Clone, Debug)]
pub struct Disturbance<'a> {
    /// The index of the act.
    pub act: usize,
    /// What goes otherwise.
    pub change: Change<'a>,
}

/// What goes otherwise at an act.
#[derive(Clone, Debug)]
pub enum Change<'a> {
    /// An error of the hand: which of the deed's [`errors`](Deed::errors), and its size in millimetres of paper or degrees.
    Error(usize, f64),
    /// A mistake: this is done instead. It must make what the act makes and read nothing that is made later.
    Instead(&'a Act),
    /// A number that the act makes comes out so many times as large.
    Times(NumberId, f64),
    /// The person goes on with this value for a number that the act makes.
    Written(NumberId, f64),
}

/// Everything that stands on the sheets and beside them after a replay.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    places: Vec<Vector>,
    lines: Vec<(Vector, Vector)>,
    numbers: Vec<f64>,
}

impl Values {
    /// A place, in units of its sheet.
    #[must_use]
    pub fn place(&self, id: PlaceId) -> Vector {
        self.places[id.0]
    }

    /// A line, in units of its sheet: a place of it and its direction, of length 1.
    #[must_use]
    pub fn line(&self, id: LineId) -> (Vector, Vector) {
        self.lines[id.0]
    }

    /// A number, in the scene's units; angles in degrees, rates in rad.
    #[must_use]
    pub fn number(&self, id: NumberId) -> f64 {
        self.numbers[id.0]
    }
}

impl Drafting {
    /// Carries out all acts, with `disturbances` in the order of the acts; without any the values are those of the plans.
    ///
    /// What cannot be done, as to cross parallel lines, gives numbers that are not finite, and so do the acts that build on it.
    #[must_use]
    pub fn replay(&self, scales: SheetScales, disturbances: &[Disturbance<'_>]) -> Values {
        let mut values = Values::default();
        self.replay_from(0, &mut values, scales, disturbances);
        values
    }

    /// Carries out the acts from that of index `first` on, on `values` that hold what those before it make.
    pub fn replay_from(
        &self,
        first: usize,
        values: &mut Values,
        scales: SheetScales,
        disturbances: &[Disturbance<'_>],
    ) {
        let [places, lines, numbers] = self.counts;
        values.places.resize(places, Vector::zeros());
        values.lines.resize(lines, (Vector::zeros(), Vector::zeros()));
        values.numbers.resize(numbers, 0.0);
        let mut waiting = disturbances.iter().peekable();
        for (index, act) in self.acts.iter().enumerate().skip(first) {
            let (mut act, mut errors) = (act, [0.0; 2]);
            let mut afterwards: SmallVec<[&Change<'_>; 2]> = SmallVec::new();
            while let Some(next) = waiting.next_if(|d| d.act == index) {
                match &next.change {
                    Change::Error(which, size) => errors[*which] += size,
                    Change::Instead(other) => act = other,
                    number => afterwards.push(number),
                }
            }
            values.act(act, errors, scales);
            for change in afterwards {
                match change {
                    Change::Times(number, factor) => values.numbers[number.0] *= factor,
                    Change::Written(number, value) => values.numbers[number.0] = *value,
                    Change::Error(..) | Change::Instead(_) => {}
                }
            }
        }
    }
}

impl Values {
    fn act(&mut self, act: &Act, errors: [f64; 2], scales: SheetScales) {
        let per_mm = scales.per_mm[act.sheet as usize];
        let lengths = Vector::from(errors) * per_mm;
        match &act.deed {
            Deed::Pole { place, at } => self.places[place.0] = *at,
            Deed::Plot { place, at } => self.places[place.0] = at + lengths,
            Deed::Join { line, from, towards } => {
                let (from, towards) = (self.place(*from), self.place(*towards));
                let along = unit(towards - from);
                self.lines[line.0] = (from, along.unwrap_or_else(not_there));
            }
            Deed::Draw { line, through, reference, quarter_turns } => {
                let along = self.direction(*reference, *quarter_turns, errors[0]);
                self.lines[line.0] = (self.place(*through), along);
            }
            Deed::Cross { place, lines } => {
                let [(p, d), (q, e)] = lines.map(|LineId(l)| self.lines[l]);
                // p + t d on the other line: t = ((q − p) × e) / (d × e).
                let t = cross(q - p, e) / cross(d, e);
                self.places[place.0] = p + d * t + lengths;
            }
            Deed::LayOff { place, from, size, reference, quarter_turns } => {
                let along = self.direction(*reference, *quarter_turns, errors[0]);
                let size = self.number(*size) + errors[1] * per_mm;
                self.places[place.0] = self.place(*from) + along * size;
            }
            Deed::Measure { number, from, to, how } => {
                let vector = self.place(*to) - self.place(*from);
                let error = errors[0] * per_mm;
                self.numbers[number.0] = match how {
                    How::Size => vector.norm() + error,
                    How::Along(LineId(line)) => vector.dot(&self.lines[*line].1) + error,
                    How::X => vector.x + error,
                    How::Y => vector.y + error,
                    How::Direction => degrees_of(vector) + errors[0],
                };
            }
            Deed::Take { number, value } => self.numbers[number.0] = *value,
            Deed::Compute { number, sum } => self.numbers[number.0] = self.sum(sum),
            Deed::Solve { unknowns, equations } => {
                let rates = self.solve(equations);
                for (number, rate) in unknowns.iter().zip(&rates) {
                    self.numbers[number.0] = *rate;
                }
            }
        }
    }

    fn direction(&self, reference: Reference, quarter_turns: u8, degrees: f64) -> Vector {
        let mut along = match reference {
            Reference::Line(LineId(line)) => self.lines[line].1,
            Reference::Given(direction) => direction,
        };
        for _ in 0..quarter_turns {
            along = quarter_turn(along);
        }
        if degrees == 0.0 { along } else { turn_of_degrees(degrees) * along }
    }

    fn product(&self, product: &Product) -> f64 {
        let numbers = product.of.iter().map(|&id| self.number(id));
        product.factor * numbers.product::<f64>()
    }

    fn sum(&self, sum: &[Product]) -> f64 {
        sum.iter().map(|p| self.product(p)).sum()
    }

    /// The solution of at most four equations, filled up with zeros; not finite where there is none.
    fn solve(&self, equations: &[Equation]) -> [f64; 4] {
        let mut matrix = Matrix4::identity();
        let mut right = Vector4::zeros();
        for (row, equation) in equations.iter().enumerate() {
            matrix[(row, row)] = 0.0;
            for (unknown, coefficient) in &equation.left {
                matrix[(row, *unknown)] += self.product(coefficient);
            }
            right[row] = self.sum(&equation.right);
        }
        let solution = matrix.full_piv_lu().solve(&right);
        solution.map_or([f64::NAN; 4], Into::into)
    }
}

/// The direction of a line that cannot be drawn.
fn not_there() -> Vector {
    Vector::repeat(f64::NAN)
}

impl Sheet {
    /// All sheets, in the order in which they are drawn.
    pub const ALL: [Sheet; 3] = [Sheet::Scheme, Sheet::Velocity, Sheet::Acceleration];
}

impl Error {
    /// Its limit where hands are as good as `tolerance` says.
    #[must_use]
    pub fn limit(self, tolerance: &super::band::Tolerance) -> f64 {
        match self {
            Error::Length => tolerance.mm,
            Error::Direction => tolerance.degrees,
        }
    }
}
