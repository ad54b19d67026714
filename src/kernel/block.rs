use super::Kernel;
use super::action::{Action, Closing, Placing, ReducedColumns};
use crate::geometry::{LinearSystem, Point, Row, Turn, Vector};

/// Positions of mechanisms of one kind with their rates, side by side: a row of numbers for everything.
///
/// Angular rates in rad per unit of time; what has not been computed yet is zero. Vectors are a row of x and a row of y.
#[derive(Clone, Debug)]
pub struct Block<R: Row> {
    /// By class: cosine and sine of its angle.
    pub turns: Vec<[R; 2]>,
    /// By slider: its position along the guide.
    pub slides: Vec<R>,
    /// By slot: the place of a point, from the kernel's origin.
    pub points: Vec<[R; 2]>,
    /// By class: angular velocity.
    pub omegas: Vec<R>,
    /// By class: angular acceleration.
    pub alphas: Vec<R>,
    /// By slider: sliding velocity.
    pub speeds: Vec<R>,
    /// By slider: sliding acceleration.
    pub accelerations: Vec<R>,
    /// By slot: velocity of the point.
    pub point_velocities: Vec<[R; 2]>,
    /// By slot: acceleration of the point.
    pub point_accelerations: Vec<[R; 2]>,
    /// What does not change while the mechanisms move.
    pub(super) lengths: Lengths<R>,
    /// By group: its factored equations.
    pub(super) systems: Vec<System<R>>,
    /// Columns of loop equations: vectors of members a quarter turn on, and unit directions of guides in the direction of the walk.
    pub(super) columns: Vec<[R; 2]>,
    /// By placing: the vector from the point that it starts at.
    pub(super) reaches: Vec<[R; 2]>,
    /// Right sides of loops and of ties, and solutions for them.
    pub(super) sides: Vec<[R; 2]>,
    pub(super) tie_sides: Vec<R>,
    pub(super) solution: Vec<R>,
}

/// One position.
pub type Single = Block<[f64; 1]>;

/// Vectors in the frames of their classes.
#[derive(Clone, Debug)]
pub(super) struct Lengths<R> {
    /// Of columns, with all sliders at zero.
    pub columns: Vec<[R; 2]>,
    /// By placing.
    pub reaches: Vec<[R; 2]>,
    /// By placing: the direction of its slider, if it has one.
    pub ways: Vec<[R; 2]>,
}

/// A group's equations, factored.
#[derive(Clone, Debug)]
pub(super) struct System<R> {
    /// 1 over the determinant of what two loops or one reduce to.
    pub inverse_determinant: R,
    /// 1 over the squares of the columns of the two loops' own unknowns.
    pub inverse_squares: [R; 2],
    /// A group that does not reduce: one system for each position.
    pub general: Vec<Option<LinearSystem>>,
}

impl<R: Row> Block<R> {
    /// A block for `kernel`, the ground's points in their places and everything else at zero.
    #[must_use]
    pub fn new(kernel: &Kernel) -> Self {
        let zero = R::splat(0.0);
        let pairs = |count| vec![[zero; 2]; count];
        let numbers = |count| vec![zero; count];
        let mut block = Self {
            turns: vec![[R::splat(1.0), zero]; kernel.classes],
            slides: numbers(kernel.sliders),
            points: pairs(kernel.slots),
            omegas: numbers(kernel.classes),
            alphas: numbers(kernel.classes),
            speeds: numbers(kernel.sliders),
            accelerations: numbers(kernel.sliders),
            point_velocities: pairs(kernel.slots),
            point_accelerations: pairs(kernel.slots),
            lengths: Lengths {
                columns: pairs(kernel.columns),
                reaches: pairs(kernel.placings),
                ways: pairs(kernel.placings),
            },
            systems: vec![System::new(); kernel.unknowns.len()],
            columns: pairs(kernel.columns),
            reaches: pairs(kernel.placings),
            sides: pairs(kernel.loops),
            tie_sides: numbers(kernel.ties),
            solution: numbers(2 * kernel.loops + kernel.ties),
        };
        (0..R::LEN).for_each(|position| block.set_lengths(position, kernel));
        block
    }

    /// Gives one position the lengths of another mechanism of the same kind: that of [`Kernel::is_like`].
    pub fn set_lengths(&mut self, position: usize, kernel: &Kernel) {
        let set = |rows: &mut [R; 2], v: Vector| {
            rows[0][position] = v.x;
            rows[1][position] = v.y;
        };
        for (slot, place) in &kernel.fixed {
            set(&mut self.points[*slot], place.coords);
        }
        for action in &kernel.actions {
            match action {
                Action::Place(Placing { reach, local, slide, .. }) => {
                    set(&mut self.lengths.reaches[*reach], *local);
                    if let Some((_, way)) = slide {
                        set(&mut self.lengths.ways[*reach], *way);
                    }
                }
                Action::Close(closing) => {
                    for (column, length) in closing.lengths() {
                        set(&mut self.lengths.columns[column], length);
                    }
                    let squares = &mut self.systems[closing.group].inverse_squares;
                    for (row, square) in squares.iter_mut().zip(own_squares(closing)) {
                        row[position] = 1.0 / square;
                    }
                }
            }
        }
    }

    /// The angle of a class as a rotation, at one position.
    #[must_use]
    pub fn turn(&self, class: usize, position: usize) -> Turn {
        let turn = vector(&self.turns[class], position);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The place of a slot from the kernel's origin, at one position.
    #[must_use]
    pub fn place(&self, slot: usize, position: usize) -> Point {
        vector(&self.points[slot], position).into()
    }
}

impl<R: Row> System<R> {
    fn new() -> Self {
        System { inverse_determinant: R::splat(0.0), inverse_squares: [R::splat(1.0); 2], general: Vec::new() }
    }
}

/// Squares of the columns of both loops' own unknowns with all sliders at zero; 1 where there are none.
fn own_squares(closing: &Closing) -> [f64; 2] {
    let Some(ReducedColumns::Two { columns, .. }) = closing.reduced else {
        return [1.0; 2];
    };
    columns.map(|[own, ..]| {
        let length = closing.lengths().find(|(column, _)| *column == own);
        length.map_or(1.0, |(_, v)| v.norm_squared())
    })
}

/// The vector of one position.
#[inline]
#[must_use]
pub fn vector<R: Row>(rows: &[R; 2], position: usize) -> Vector {
    Vector::new(rows[0][position], rows[1][position])
}
