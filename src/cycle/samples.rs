use super::reading::Reading;

/// Largest distance of a curve from the straight line between two samples, in parts of the window's height.
const TOLERANCE: f64 = 5e-5;

/// Smallest distance of two samples, in parts of the range.
const CLOSEST: f64 = 1e-7;

/// Difference of two samples at the smallest distance that counts as a jump, in parts of the window's height.
const JUMP: f64 = 0.01;

/// Most further samples for each sample of the grid; smooth curves take fewer than ten.
const MOST: usize = 50;

/// A value of the drive, and that of a quantity (or the place of a point) there, if it has one.
pub(super) type Sample<V = f64> = (f64, Option<V>);

/// Least and greatest of some numbers; `[∞, −∞]` of none.
pub(super) fn hull(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.fold(none, |[low, high], y| [low.min(y), high.max(y)])
}

/// Samples at these values of the drive; angles run on without jumps of whole turns.
pub(super) fn samples(reading: &mut Reading, grid: &[f64]) -> Vec<Sample> {
    let mut last = None;
    let at = |x: &f64| {
        let value = reading.at(*x, last);
        last = value.or(last);
        (*x, value)
    };
    grid.iter().map(at).collect()
}

/// The curve in pieces without a gap or jump, sampled between the samples of `grid` so densely that straight lines look
/// like it.
///
/// Outside `window` the curve is sampled only as far as to show where it leaves.
pub(super) fn pieces(reading: &mut Reading, grid: &[Sample], window: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let (Some(first), Some(last)) = (grid.first(), grid.last()) else {
        return Vec::new();
    };
    let mut graph = Graph { reading, window };
    let mut sampler = Sampler::new(&mut graph, [first.0, last.0], MOST * grid.len());
    grid.iter().for_each(|sample| sampler.go_on(*sample));
    sampler.pieces().into_iter().map(|piece| piece.into_iter().map(<[f64; 2]>::from).collect()).collect()
}

/// The local extreme next to the sample of that index; `None` if a neighbour of the sample lies further out.
pub(super) fn peak(reading: &mut Reading, samples: &[Sample], index: usize, sign: f64) -> Option<[f64; 2]> {
    let (x, y) = samples[index];
    let y = y?;
    let last = samples.len() - 1;
    let (left, right) = (index.saturating_sub(1), (index + 1).min(last));
    let further = |i: usize, or_equal: bool| {
        let other = samples[i].1.map(|other| sign * (other - y));
        i != index && other.is_some_and(|d| d > 0.0 || or_equal && d == 0.0)
    };
    // Of equal neighbours the first counts.
    if further(left, true) || further(right, false) {
        return None;
    }
    let between = reading.peak([samples[left].0, samples[right].0], sign, y);
    Some(between.filter(|p| sign * (p[1] - y) > 0.0).unwrap_or([x, y]))
}

/// A curve over the drive that can be read anywhere.
pub(super) trait CurveReader {
    /// What a point of the curve is besides the drive's value.
    type Value: Copy;

    /// The value at one of the drive, of an angle the one closest to `near`; `None` where it has none.
    fn at(&mut self, drive: f64, near: Option<Self::Value>) -> Option<Self::Value>;

    /// Whether two samples at the smallest distance hang together; else the curve jumps between them.
    fn is_joined(&self, a: Self::Value, b: Self::Value) -> bool;

    /// Whether the curve looks straight between two samples, with this one in the middle.
    fn is_straight(&self, a: Self::Value, middle: Self::Value, b: Self::Value) -> bool;
}

/// A quantity, as it looks in a window.
struct Graph<'r, 'a> {
    reading: &'r mut Reading<'a>,
    window: [f64; 2],
}

impl CurveReader for Graph<'_, '_> {
    type Value = f64;

    fn at(&mut self, drive: f64, near: Option<f64>) -> Option<f64> {
        self.reading.at(drive, near)
    }

    fn is_joined(&self, a: f64, b: f64) -> bool {
        let [low, high] = self.window;
        (a - b).abs() <= JUMP * (high - low)
    }

    fn is_straight(&self, a: f64, middle: f64, b: f64) -> bool {
        let [low, high] = self.window;
        let outside = [a, b, middle].iter().all(|v| *v > high) || [a, b, middle].iter().all(|v| *v < low);
        outside || (middle - 0.5 * (a + b)).abs() <= TOLERANCE * (high - low)
    }
}

/// Samples a curve as densely as it is curved, in pieces without a gap or jump.
pub(super) struct Sampler<'c, C: CurveReader> {
    pub curve: &'c mut C,
    /// Smallest distance of two samples.
    closest: f64,
    /// Number of samples that may still be taken between those of the grid.
    left: usize,
    last: Option<Sample<C::Value>>,
    pieces: Vec<Vec<(f64, C::Value)>>,
}

impl<'c, C: CurveReader> Sampler<'c, C> {
    /// For a range of the drive, with so many samples at most besides those of the grid.
    pub fn new(curve: &'c mut C, [first, last]: [f64; 2], most: usize) -> Self {
        Sampler { curve, closest: CLOSEST * (last - first), left: most, last: None, pieces: vec![Vec::new()] }
    }

    /// Adds the next sample of the grid, and as many before it as the curve needs.
    pub fn go_on(&mut self, next: Sample<C::Value>) {
        match self.last.replace(next) {
            Some(last) => self.between(last, next),
            None => self.push(next),
        }
    }

    /// The pieces of more than one sample.
    pub fn pieces(mut self) -> Vec<Vec<(f64, C::Value)>> {
        self.pieces.retain(|piece| piece.len() > 1);
        self.pieces
    }

    fn push(&mut self, (x, y): Sample<C::Value>) {
        if let (Some(y), Some(piece)) = (y, self.pieces.last_mut()) {
            piece.push((x, y));
        }
    }

    /// Adds the samples after `a` up to `b`, and `b` itself.
    fn between(&mut self, a: Sample<C::Value>, b: Sample<C::Value>) {
        let whole = a.1.zip(b.1);
        if b.0 - a.0 <= self.closest || self.left == 0 {
            if !whole.is_some_and(|(a, b)| self.curve.is_joined(a, b)) {
                self.pieces.push(Vec::new());
            }
            return self.push(b);
        }
        self.left -= 1;
        let x = 0.5 * (a.0 + b.0);
        let middle = (x, self.curve.at(x, a.1.or(b.1)));
        if middle.1.is_none() && whole.is_none() {
            self.pieces.push(Vec::new());
            return self.push(b);
        }
        if whole.zip(middle.1).is_some_and(|((a, b), y)| self.curve.is_straight(a, y, b)) {
            self.push(middle);
            self.push(b);
        } else {
            self.between(a, middle);
            self.between(middle, b);
        }
    }
}
