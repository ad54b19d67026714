//! What changes from one picture to the next.

/// The smallest box that holds all that changes; of a picture like the one before it, one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Change {
    pub left: usize,
    pub top: usize,
    pub width: usize,
    pub height: usize,
}

impl Change {
    /// The change from `before`, another picture of the same width; all of it without one.
    pub(super) fn of<T: PartialEq>(before: Option<&[T]>, now: &[T], width: usize) -> Change {
        let whole = Change { left: 0, top: 0, width, height: now.len() / width };
        let Some(before) = before else { return whole };
        let rows = || before.chunks_exact(width).zip(now.chunks_exact(width)).enumerate();
        let (mut changed, mut bounds) = (rows().filter(|(_, (a, b))| a != b), None);
        for (row, (a, b)) in changed.by_ref() {
            let differs = |at: &usize| a[*at] != b[*at];
            let first = (0..width).find(differs).unwrap_or_default();
            let last = (0..width).rev().find(differs).unwrap_or_default();
            let [left, top, right, _] = bounds.unwrap_or([first, row, last, row]);
            bounds = Some([left.min(first), top, right.max(last), row]);
        }
        let [left, top, right, bottom] = bounds.unwrap_or_default();
        Change { left, top, width: right + 1 - left, height: bottom + 1 - top }
    }

    /// What is written of the pixels in it: `kept` for those that are as before.
    pub(super) fn written<T: Copy + PartialEq, U: Copy>(
        self,
        before: Option<&[T]>,
        now: &[T],
        width: usize,
        kept: U,
        as_written: impl Fn(T) -> U,
    ) -> Vec<U> {
        let rows = self.top..self.top + self.height;
        let places = rows.flat_map(|row| (row * width + self.left)..(row * width + self.left + self.width));
        let written = places.map(|at| match before {
            Some(before) if before[at] == now[at] => kept,
            _ => as_written(now[at]),
        });
        written.collect()
    }
}
