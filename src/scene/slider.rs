//! Sliders of a scene: links on straight guides, pins in slots.

use super::link::At;

/// A link, or a lone pin, that slides along a straight guide of another link or of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// The sliding link; `None` where a pin rides in the slot.
    pub link: Option<String>,
    /// The point of `link` that slides; `None` where a pin rides in the slot.
    pub at: Option<String>,
    /// The pin that rides in the slot, a point of another link or of the frame; `None` where a link slides.
    pub pin: Option<String>,
    /// What carries the guide.
    pub on: On,
    /// A place on the guide: a point of `on`; or coordinates, in the fixed frame for a guide on the ground, in the own
    /// frame of `on` (its shape) otherwise. `None`: the first point of `along`, else of `on`, which is there in the
    /// lengths form; in the drawn form a guide given by its direction passes through the sliding point.
    pub through: Option<At>,
    /// The direction of the guide.
    pub along: Along,
    /// Angle from the guide to the slider's axis, in degrees; zero unless given, always zero in the drawn form.
    pub turned_deg: f64,
    /// The drive that pushes the slider, if any. One that the file gives in the sliding link stands here too.
    pub drive: Option<SliderDrive>,
}

/// What carries a guide.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum On {
    /// The frame.
    Ground,
    /// The link of this name.
    Link(String),
}

/// The direction of a guide.
#[derive(Debug, Clone, PartialEq)]
pub enum Along {
    /// From the first to the second of two points of the guide's carrier.
    Points(String, String),
    /// An angle in degrees: from +x on the ground, from the axis of the carrier otherwise. Zero unless given.
    Degrees(f64),
    /// A direction, not zero: in the fixed frame on the ground and in the drawn form, in the carrier's own otherwise.
    Direction([f64; 2]),
}

/// A drive that pushes a slider along its guide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderDrive {
    /// Distance along the guide from `through`, in units of length; always `None` in the drawn form.
    pub position: Option<f64>,
    /// Speed along the guide, in length per time.
    pub speed: f64,
    /// Acceleration along the guide, in length per time squared; zero unless given.
    pub acceleration: f64,
}
