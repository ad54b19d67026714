use super::entry::Entry;

/// The verdict on a written value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The exact value rounds to it.
    Right,
    /// It differs from the exact value by no more than honest hand drawings do.
    WithinTolerance,
    /// A rate whose size is right or within the tolerance, written without a sign where no sense counts as positive: it
    /// does not tell its sense.
    SenseMissing,
    /// It differs by more.
    Off,
    /// It has no tolerance: there is no construction from which it could be read.
    Unjudged,
}

/// A value with its verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The value.
    pub entry: Entry,
    /// The verdict on it.
    pub verdict: Verdict,
    /// The value less the exact one, in the scene's units; of an angle the shorter way round.
    pub difference: f64,
    /// Largest difference that counts as within the tolerance; `None` where the value is not drawn.
    pub tolerance: Option<f64>,
    /// Whether the tolerance is only a rough estimate.
    pub is_rough: bool,
}
