/// How many curves in one panel every style tells apart.
pub(super) const MOST_CURVES: usize = 12;

/// Why curves do not fit on a sheet.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CurvesError {
    /// More panels than the sheet has room for.
    #[error(
        "{wanted} kinds of quantities need {wanted} panels, and the sheet has room for {room}\n  \
         try: fewer quantities at a time, or another `page` in the scene's figure, as \"a4-portrait\""
    )]
    Panels {
        /// How many there should be.
        wanted: usize,
        /// How many there can be.
        room: usize,
    },
    /// More curves in a panel than can be told apart.
    #[error(
        "{wanted} curves in one panel are more than can be told apart, which is {MOST_CURVES}\n  \
         try: fewer quantities at a time"
    )]
    Crowd {
        /// How many there should be.
        wanted: usize,
    },
}
