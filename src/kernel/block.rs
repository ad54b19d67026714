use super::Kernel;
use super::action::{Action, Closing, Placing, Reducible, Reducing};
use crate::geometry::{LinearSystem, Point, Row, Turn, Vector};

/// Positions and rates of mechanisms of one kind, side by side: a row of numbers for each quantity.
///
/// Angular rates are in rad per unit of time; what has not been computed is zero. A vector is a row of x and a row of
/// y.
#[derive(Clone, Debug)]
pub struct Block<R: Row> {
    /// By class: cosine and sine of its angle.
    pub turns: Vec<[R; 2]>,
    /// By slider: its position along the guide.
    pub slides: Vec<R>,
    /// By slot: the place of a point, relative to the kernel's origin.
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
    /// Lengths, constant in all positions of a mechanism.
    pub(super) lengths: Lengths<R>,
    /// By group: its factored equations.
    pub(super) systems: Vec<System<R>>,
    /// Columns of loop equations in the fixed frame: members' vectors turned by +90°, and guides' unit vectors along
    /// the loop.
    pub(super) columns: Vec<[R; 2]>,
    /// By placing: the vector from the earlier point to the placed one.
    pub(super) reaches: Vec<[R; 2]>,
    /// Right sides of the equations of loops and of ties, and their solution.
    pub(super) sides: Vec<[R; 2]>,
    pub(super) tie_sides: Vec<R>,
    pub(super) solution: Vec<R>,
}

/// A block of one position.
pub type Single = Block<[f64; 1]>;

/// Vectors in the frames of their classes.
#[derive(Clone, Debug)]
pub(super) struct Lengths<R> {
    /// By column, with all sliders at zero.
    pub columns: Vec<[R; 2]>,
    /// By placing: the vector between its points, with its slider at zero.
    pub reaches: Vec<[R; 2]>,
    /// By placing: the unit vector of its slider, if it has one.
    pub guides: Vec<[R; 2]>,
}

/// A group's equations, factored.
#[derive(Clone, Debug)]
pub(super) struct System<R> {
    /// The inverse determinant of the reduced equations.
    pub inverse_determinant: R,
    /// The inverse squares of the columns of the two loops' own unknowns.
    pub inverse_squares: [R; 2],
    /// For a group that does not reduce: by position, the factored system; none where it is singular.
    pub general: Vec<Option<LinearSystem>>,
}

impl<R: Row> Block<R> {
    /// A block for `kernel` with the ground's points in their places, zero angles and zero for everything else.
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
                guides: pairs(kernel.placings),
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

    /// Sets the lengths of one position to those of another mechanism of the same kind, as [`Kernel::is_like`] says.
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
                        set(&mut self.lengths.guides[*reach], *way);
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

    /// The rotation of a class, at one position.
    #[must_use]
    pub fn turn(&self, class: usize, position: usize) -> Turn {
        let turn = vector(&self.turns[class], position);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The place of a slot relative to the kernel's origin, at one position.
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

/// Squares of the columns of the two loops' own unknowns with all sliders at zero; 1 for other groups.
fn own_squares(closing: &Closing) -> [f64; 2] {
    let Some(Reducing::Two(Reducible { columns, .. })) = closing.reduced else {
        return [1.0; 2];
    };
    columns.map(|[own, ..]| {
        let length = closing.lengths().find(|(column, _)| *column == own);
        length.map_or(1.0, |(_, v)| v.norm_squared())
    })
}

/// The vector at one position.
#[inline]
#[must_use]
pub fn vector<R: Row>(rows: &[R; 2], position: usize) -> Vector {
    Vector::new(rows[0][position], rows[1][position])
}
