use kinegon::photo::Refusal;
use kinegon::words::Language;
use kinegon::{Sheet, check};
use serde::{Deserialize, Serialize};

/// What is read from a photograph: one of both.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PhotoRead {
    /// The sheet in it.
    pub photo: Option<Photo>,
    /// Why none is read.
    pub refused: Option<PhotoRefused>,
}

/// Why no sheet is read from a photograph.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PhotoRefused {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub hint: String,
}

impl PhotoRefused {
    /// It in the words of a language.
    pub fn of(why: &Refusal, language: &Language) -> PhotoRefused {
        PhotoRefused { message: language.says(&why.message()), hint: language.says(&why.hint()) }
    }
}

/// A sheet in a photograph. Places in the picture are in pixels from its upper left corner, y down, after `turn`.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Photo {
    /// The exercise or scene that the sheet is of, as its code has it.
    pub name: String,
    /// The sheet's number.
    pub number: u16,
    /// Whether it is a sheet of this scene.
    pub is_own: bool,
    /// By how many quarters the picture is turned clockwise, so that the sheet stands upright.
    pub turn: u8,
    /// Pixels per mm in the sheet's middle.
    pub per_mm: f64,
    /// How far the sheet's middle is above or below its edges, in mm.
    pub bend: f64,
    /// What makes it of less use, and what to do; none where nothing does.
    pub warning: Option<String>,
    /// Radius within which places on the sheet are known with 95 %, at the plans' points, in mm.
    pub band: f64,
    /// The plans on it; none of another scene's sheet.
    pub plans: Vec<PhotoPlan>,
}

/// The right plan over a photograph.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PhotoPlan {
    /// Of which plan.
    pub plan: Sheet,
    /// The sheet's scale, in units per mm.
    pub mu: f64,
    /// Its points in the order of the construction, the pole first.
    pub points: Vec<PhotoPoint>,
    /// Its vectors and rays: places along each in the picture.
    pub lines: Vec<Vec<[f64; 2]>>,
}

/// A point of the right plan in the picture.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PhotoPoint {
    /// The name under which its place stands in the form file.
    pub name: String,
    /// As the sheet writes it, in HTML.
    pub label: String,
    /// Where it should be in the picture.
    pub at: [f64; 2],
}

/// A point that pencil lines show: a proposal, as lines may mislead.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Proposed {
    /// Of which plan.
    pub plan: Sheet,
    /// Its name in the form file.
    pub name: String,
    /// Where it seems to be.
    pub place: Tapped,
}

/// A place that was tapped, or is proposed.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Tapped {
    /// In mm of paper from the printed origin, x right, y up.
    pub at: [f64; 2],
    /// In the picture.
    pub pixel: [f64; 2],
    /// Whether pencil lines cross there.
    pub is_snapped: bool,
    /// Radius that holds the place with 95 %, in mm.
    pub band: f64,
    /// The same in pixels.
    pub band_pixels: f64,
}

/// A point of a student's plan.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "MarkedPoint"))]
pub struct PlacedPoint {
    /// Of which plan.
    pub plan: Sheet,
    /// Its name in the form file.
    pub name: String,
    /// In mm of paper from the printed origin, x right, y up.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm; none where a hand has put it.
    pub band: Option<f64>,
}

/// How a point of a student's plan stands.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct PointVerdict {
    /// Of which plan.
    pub plan: Sheet,
    /// Its name in the form file.
    pub name: String,
    /// Where it is in the picture.
    pub pixel: [f64; 2],
    /// Radius that holds it with 95 %, in pixels.
    pub band_pixels: f64,
    /// How far it is from the right place, in mm.
    pub off: f64,
    /// What its place tells; `open`: the picture cannot tell.
    pub verdict: check::PointVerdict,
}
