use super::reading::Reading;

/// The part of the window's height by which a straight line between samples may miss the curve.
const TOLERANCE: f64 = 5e-5;

/// The part of the range below which two samples are not taken further apart.
const CLOSEST: f64 = 1e-7;

/// The part of the window's height that counts as a jump between two samples so close.
const JUMP: f64 = 0.01;

/// How many samples each of the grid may bring about; smooth curves take fewer than ten.
const MOST: usize = 50;

/// A value of the drive and the quantity's there, if it has one.
pub(super) type Sample = (f64, Option<f64>);

/// Least and greatest of some numbers; without any, `[∞, −∞]`.
pub(super) fn hull(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.fold(none, |[low, high], y| [low.min(y), high.max(y)])
}

/// Samples at these values of the drive; angles go on without jumps of whole turns.
pub(super) fn samples(reading: &mut Reading, grid: &[f64]) -> Vec<Sample> {
    let mut last = None;
    let at = |x: &f64| {
        let value = reading.at(*x, last);
        last = value.or(last);
        (*x, value)
    };
    grid.iter().map(at).collect()
}

/// The curve in pieces without a gap or jump, sampled between `grid` so densely that straight lines between the samples look like it.
///
/// What lies outside `window` is sampled only as far as to show where the curve leaves it.
pub(super) fn pieces(reading: &mut Reading, grid: &[Sample], window: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let (Some(first), Some(last)) = (grid.first(), grid.last()) else {
        return Vec::new();
    };
    let mut refined = Refined {
        reading,
        window,
        closest: CLOSEST * (last.0 - first.0),
        left: MOST * grid.len(),
        pieces: vec![Vec::new()],
    };
    refined.push(*first);
    for pair in grid.windows(2) {
        refined.between(pair[0], pair[1]);
    }
    refined.pieces.retain(|piece| piece.len() > 1);
    refined.pieces
}

struct Refined<'r, 'a> {
    reading: &'r mut Reading<'a>,
    window: [f64; 2],
    closest: f64,
    /// How many samples may still be taken.
    left: usize,
    pieces: Vec<Vec<[f64; 2]>>,
}

impl Refined<'_, '_> {
    fn push(&mut self, (x, y): Sample) {
        if let (Some(y), Some(piece)) = (y, self.pieces.last_mut()) {
            piece.push([x, y]);
        }
    }

    /// Adds all samples after `a` up to and with `b`.
    fn between(&mut self, a: Sample, b: Sample) {
        let height = self.window[1] - self.window[0];
        let whole = a.1.zip(b.1);
        if b.0 - a.0 <= self.closest || self.left == 0 {
            if !whole.is_some_and(|(a, b)| (a - b).abs() <= JUMP * height) {
                self.pieces.push(Vec::new());
            }
            return self.push(b);
        }
        self.left -= 1;
        let x = 0.5 * (a.0 + b.0);
        let y = self.reading.at(x, a.1.or(b.1));
        if y.is_none() && whole.is_none() {
            self.pieces.push(Vec::new());
            return self.push(b);
        }
        let middle = (x, y);
        let smooth = whole.zip(y).is_some_and(|((a, b), y)| {
            let [low, high] = self.window;
            let outside = [a, b, y].iter().all(|v| *v > high) || [a, b, y].iter().all(|v| *v < low);
            outside || (y - 0.5 * (a + b)).abs() <= TOLERANCE * height
        });
        if smooth {
            self.push(middle);
            self.push(b);
        } else {
            self.between(a, middle);
            self.between(middle, b);
        }
    }
}
