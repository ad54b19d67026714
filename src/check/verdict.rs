use super::entry::Entry;

/// How a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The exact value rounds to it.
    Right,
    /// As near as an honest hand drawing comes.
    WithinTolerance,
    /// Farther off.
    Off,
    /// There is no construction from which it could be read, so no tolerance.
    Unjudged,
}

/// A value with its verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The value.
    pub entry: Entry,
    /// How it is.
    pub verdict: Verdict,
    /// The value less the exact one, in the scene's units; of an angle the shorter way round.
    pub difference: f64,
    /// Up to which difference it counts as drawn within the tolerance; none where it is not drawn.
    pub tolerance: Option<f64>,
    /// Whether the tolerance is only a rough one.
    pub is_rough: bool,
}
