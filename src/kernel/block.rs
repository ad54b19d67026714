use super::Kernel;
use super::action::{Action, Closing, Reducible, Reducing};
use super::lengths::{Lengths, ZERO};
use crate::geometry::{LinearSystem, Point, Row, Turn, Vector};
use crate::mechanism::{BodyId, Mechanism};

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
    /// By slot: the place of a point, relative to the origin.
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
            lengths: Lengths::repeat(&kernel.lengths),
            systems: vec![System::new(); kernel.unknowns.len()],
            columns: pairs(kernel.lengths.columns.len()),
            reaches: pairs(kernel.lengths.reaches.len()),
            sides: pairs(kernel.loops),
            tie_sides: numbers(kernel.ties),
            solution: numbers(2 * kernel.loops + kernel.ties),
        };
        (0..R::LEN).for_each(|position| block.use_lengths(position, kernel));
        block
    }

    /// Sets the lengths of one position to those of another mechanism of the kernel's kind, as [`Kernel::is_like`] says. `false` if it is not
    /// of that kind, as a vector does not vanish that vanishes in the kernel's own mechanism.
    pub fn set_lengths(&mut self, position: usize, kernel: &Kernel, mechanism: &Mechanism) -> bool {
        let is_like = kernel.recipe.measure(mechanism, &mut self.lengths, position);
        self.use_lengths(position, kernel);
        is_like
    }

    /// Brings what follows from lengths alone into line with them.
    fn use_lengths(&mut self, position: usize, kernel: &Kernel) {
        for (slot, place) in kernel.fixed.iter().zip(&self.lengths.fixed) {
            for (to, from) in self.points[*slot].iter_mut().zip(place) {
                to[position] = from[position];
            }
        }
        for action in &kernel.actions {
            if let Action::Close(closing) = action
                && let Some(columns) = own_columns(closing)
            {
                let squares = &mut self.systems[closing.group].inverse_squares;
                for (row, column) in squares.iter_mut().zip(columns).filter(|(_, column)| *column != ZERO) {
                    row[position] = 1.0 / vector(&self.lengths.columns[column], position).norm_squared();
                }
            }
        }
    }

    /// The origin of places, at one position.
    #[must_use]
    pub fn origin(&self, position: usize) -> Vector {
        vector(&self.lengths.origin, position)
    }

    /// The rotation of a body's frame relative to its class, at one position.
    #[must_use]
    pub fn turn_in_class(&self, body: BodyId, position: usize) -> Turn {
        let turn = vector(&self.lengths.turns[body.0], position);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The rotation of a class, at one position.
    #[must_use]
    pub fn turn(&self, class: usize, position: usize) -> Turn {
        let turn = vector(&self.turns[class], position);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The place of a slot relative to the origin, at one position.
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

/// The columns of the two loops' own unknowns; `None` for other groups.
fn own_columns(closing: &Closing) -> Option<[usize; 2]> {
    let Some(Reducing::Two(Reducible { columns, .. })) = closing.reduced else {
        return None;
    };
    Some(columns.map(|[own, ..]| own))
}

/// The vector at one position.
#[inline]
#[must_use]
pub fn vector<R: Row>(rows: &[R; 2], position: usize) -> Vector {
    Vector::new(rows[0][position], rows[1][position])
}
