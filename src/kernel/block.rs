use super::Kernel;
use crate::geometry::{Lanes, Pairs, Point, Turn, Vector, lane};

/// N positions of one mechanism, with their rates, side by side.
///
/// Angular rates in rad per unit of time; what has not been computed yet is zero.
#[derive(Clone, Debug)]
pub struct Block<const N: usize> {
    /// By class: cosine and sine of its angle.
    pub turns: Vec<Pairs<N>>,
    /// By slider: its position along the guide.
    pub slides: Vec<Lanes<N>>,
    /// By slot: the place of a point.
    pub points: Vec<Pairs<N>>,
    /// By class: angular velocity.
    pub omegas: Vec<Lanes<N>>,
    /// By class: angular acceleration.
    pub alphas: Vec<Lanes<N>>,
    /// By slider: sliding velocity.
    pub speeds: Vec<Lanes<N>>,
    /// By slider: sliding acceleration.
    pub accelerations: Vec<Lanes<N>>,
    /// By slot: velocity of the point.
    pub point_velocities: Vec<Pairs<N>>,
    /// By slot: acceleration of the point.
    pub point_accelerations: Vec<Pairs<N>>,
    /// By group: determinant of its loop equations, whose sign changes where two branches meet.
    pub determinants: Vec<Lanes<N>>,
    /// By group: the square of Hadamard's ratio, from 1 down to 0 in a singular position.
    pub squared_sharpness: Vec<Lanes<N>>,
    /// By member of a loop: its vector.
    pub(super) arms: Vec<Pairs<N>>,
    /// By slide of a loop's member: the unit direction of its guide in the direction of the walk.
    pub(super) rails: Vec<Pairs<N>>,
    /// By placing: the vector from the point that it starts at.
    pub(super) reaches: Vec<Pairs<N>>,
}

impl<const N: usize> Block<N> {
    /// A block for `kernel`, the ground's points in their places and everything else at zero.
    #[must_use]
    pub fn new(kernel: &Kernel) -> Self {
        let pairs = |count| vec![[[0.0; N]; 2]; count];
        let lanes = |count| vec![[0.0; N]; count];
        let mut points = pairs(kernel.slots);
        for (slot, place) in &kernel.fixed {
            points[*slot] = [[place.x; N], [place.y; N]];
        }
        Self {
            turns: vec![[[1.0; N], [0.0; N]]; kernel.classes],
            slides: lanes(kernel.sliders),
            points,
            omegas: lanes(kernel.classes),
            alphas: lanes(kernel.classes),
            speeds: lanes(kernel.sliders),
            accelerations: lanes(kernel.sliders),
            point_velocities: pairs(kernel.slots),
            point_accelerations: pairs(kernel.slots),
            determinants: lanes(kernel.groups),
            squared_sharpness: lanes(kernel.groups),
            arms: pairs(kernel.arms),
            rails: pairs(kernel.rails),
            reaches: pairs(kernel.placings),
        }
    }

    /// The angle of a class as a rotation.
    #[must_use]
    pub fn turn(&self, class: usize, index: usize) -> Turn {
        let turn = lane(&self.turns[class], index);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The place of a slot.
    #[must_use]
    pub fn place(&self, slot: usize, index: usize) -> Point {
        lane(&self.points[slot], index).into()
    }
}

/// `local` turned, in one lane.
#[inline(always)]
pub(super) fn turned<const N: usize>(turn: &Pairs<N>, local: Vector, i: usize) -> Vector {
    let (c, s) = (turn[0][i], turn[1][i]);
    Vector::new(c * local.x - s * local.y, s * local.x + c * local.y)
}
