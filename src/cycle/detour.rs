use super::Path;

/// Narrowest part that is told, in turns.
const NARROW: f64 = 0.01;

/// A part of a range that a drive reaches the other way round: beyond a limit position, but a whole turn away between the
/// limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detour {
    /// The values of the drive on the path.
    pub part: [f64; 2],
    /// The same positions by the values that were asked for, a whole turn away.
    pub asked: [f64; 2],
    /// The least and the greatest value that hold this part and what was reached at once.
    pub both: [f64; 2],
}

impl Path<'_> {
    /// What of a range beyond a limit position the drive reaches the other way round; the wider part where there are
    /// two. `None` where there is nothing of that kind, and where other drives run along, which stand elsewhere a turn
    /// further on.
    #[must_use]
    pub fn other_way_round(&self, range: [f64; 2]) -> Option<Detour> {
        let runs_along = |(index, [_, ratio]): (usize, &[f64; 2])| index != self.drive.input && *ratio != 0.0;
        if !self.drive.turns || self.inputs.iter().enumerate().any(runs_along) {
            return None;
        }
        let mut whole = self.clone();
        whole.once().ok()?;
        whole.end(false).and(whole.end(true))?;
        let turn = self.unit();
        let [low, high] = [range[0].min(range[1]), range[0].max(range[1])];
        let reached = [low.max(self.low()), high.min(self.high())];
        let above = [reached[1].max(low + turn), whole.high().min(reached[0] + turn)];
        let below = [whole.low().max(reached[1] - turn), reached[0].min(high - turn)];
        let width = |part: [f64; 2]| part[1] - part[0];
        let (part, turns) = if width(above) >= width(below) { (above, -1.0) } else { (below, 1.0) };
        (width(part) > NARROW * turn).then(|| Detour {
            part,
            asked: part.map(|v| v + turns * turn),
            both: [part[0].min(reached[0]), part[1].max(reached[1])],
        })
    }
}
