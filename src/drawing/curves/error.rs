/// Number of curves in one panel that every style distinguishes.
pub(super) const MOST_CURVES: usize = 12;

/// Reasons why curves do not fit on a sheet.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CurvesError {
    /// More panels than the sheet holds.
    #[error(
        "{wanted} kinds of quantities need {wanted} panels, and the sheet has room for {room}\n  \
         try: fewer quantities at a time, or another `page` in the scene's figure, as \"a4-portrait\""
    )]
    Panels {
        /// Number of panels needed.
        wanted: usize,
        /// Number of panels that the sheet holds.
        room: usize,
    },
    /// More curves in a panel than can be distinguished.
    #[error(
        "{wanted} curves in one panel are more than can be told apart, which is {MOST_CURVES}\n  \
         try: fewer quantities at a time"
    )]
    Crowd {
        /// Number of curves in the panel.
        wanted: usize,
    },
}
