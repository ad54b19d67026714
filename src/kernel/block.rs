use super::Kernel;
use super::close::System;
use crate::geometry::{Number, Pair, Point, Turn, Vector};

/// Positions of one mechanism, with their rates, side by side: M numbers of type T for everything.
///
/// Angular rates in rad per unit of time; what has not been computed yet is zero.
#[derive(Clone, Debug)]
pub struct Block<T: Number, const M: usize> {
    /// By class: cosine and sine of its angle.
    pub turns: Vec<[Pair<T>; M]>,
    /// By slider: its position along the guide.
    pub slides: Vec<[T; M]>,
    /// By slot: the place of a point, from the kernel's origin.
    pub points: Vec<[Pair<T>; M]>,
    /// By class: angular velocity.
    pub omegas: Vec<[T; M]>,
    /// By class: angular acceleration.
    pub alphas: Vec<[T; M]>,
    /// By slider: sliding velocity.
    pub speeds: Vec<[T; M]>,
    /// By slider: sliding acceleration.
    pub accelerations: Vec<[T; M]>,
    /// By slot: velocity of the point.
    pub point_velocities: Vec<[Pair<T>; M]>,
    /// By slot: acceleration of the point.
    pub point_accelerations: Vec<[Pair<T>; M]>,
    /// By group: its factored equations.
    pub(super) systems: Vec<System<T, M>>,
    /// By member of a loop: its vector.
    pub(super) arms: Vec<[Pair<T>; M]>,
    /// By slide of a loop's member: the unit direction of its guide in the direction of the walk.
    pub(super) rails: Vec<[Pair<T>; M]>,
    /// By placing: the vector from the point that it starts at.
    pub(super) reaches: Vec<[Pair<T>; M]>,
    /// Right sides, and solutions for them.
    pub(super) sides: Vec<[Pair<T>; M]>,
    pub(super) solution: Vec<[T; M]>,
}

/// One position.
pub type Single = Block<f64, 1>;

impl<T: Number, const M: usize> Block<T, M> {
    /// A block for `kernel`, the ground's points in their places and everything else at zero.
    #[must_use]
    pub fn new(kernel: &Kernel) -> Self {
        let pairs = |count| vec![[Pair::splat(Vector::zeros()); M]; count];
        let numbers = |count| vec![[T::splat(0.0); M]; count];
        let mut points = pairs(kernel.slots);
        for (slot, place) in &kernel.fixed {
            points[*slot] = [Pair::splat(place.coords); M];
        }
        Self {
            turns: vec![[Pair::splat(Vector::x()); M]; kernel.classes],
            slides: numbers(kernel.sliders),
            points,
            omegas: numbers(kernel.classes),
            alphas: numbers(kernel.classes),
            speeds: numbers(kernel.sliders),
            accelerations: numbers(kernel.sliders),
            point_velocities: pairs(kernel.slots),
            point_accelerations: pairs(kernel.slots),
            systems: kernel.reductions.iter().map(|r| System::new(*r)).collect(),
            arms: pairs(kernel.arms),
            rails: pairs(kernel.rails),
            reaches: pairs(kernel.placings),
            sides: pairs(kernel.loops),
            solution: numbers(2 * kernel.loops),
        }
    }

    /// The angle of a class as a rotation, in one lane.
    #[must_use]
    pub fn turn(&self, class: usize, lane: usize) -> Turn {
        let turn = self.turns[class][lane / T::LANES].lane(lane % T::LANES);
        Turn::from_cos_sin_unchecked(turn.x, turn.y)
    }

    /// The place of a slot from the kernel's origin, in one lane.
    #[must_use]
    pub fn place(&self, slot: usize, lane: usize) -> Point {
        vector(&self.points[slot], lane).into()
    }
}

/// The vector of one lane.
#[inline]
#[must_use]
pub fn vector<T: Number, const M: usize>(pairs: &[Pair<T>; M], lane: usize) -> Vector {
    pairs[lane / T::LANES].lane(lane % T::LANES)
}

/// The number of one lane.
#[inline]
#[must_use]
pub fn number<T: Number, const M: usize>(numbers: &[T; M], lane: usize) -> f64 {
    numbers[lane / T::LANES].lane(lane % T::LANES)
}
