use super::Vector;

/// N numbers that go through the same calculation side by side.
pub type Lanes<const N: usize> = [f64; N];

/// N vectors: all x, then all y.
pub type Pairs<const N: usize> = [[f64; N]; 2];

/// The vector of one lane.
#[inline(always)]
#[must_use]
pub fn lane<const N: usize>(pairs: &Pairs<N>, index: usize) -> Vector {
    Vector::new(pairs[0][index], pairs[1][index])
}

/// Writes the vector of one lane.
#[inline(always)]
pub fn set_lane<const N: usize>(pairs: &mut Pairs<N>, index: usize, vector: Vector) {
    pairs[0][index] = vector.x;
    pairs[1][index] = vector.y;
}
