//! The sheet in a photograph: which it is, and where its places are in the picture.

use super::camera::{Fitted, fitted};
use super::code;
use super::markers::{self, Marker, Seen};
use super::picture::{Paper, Picture};
use super::says;
use super::strokes::{Stroke, strokes};
use crate::drawing::markers::{SheetCode, code_place};
use crate::geometry::Point;
use crate::message::Message;
use std::fmt;

/// Largest residual of the markers' corners, in mm: a camera over an evenly bent sheet leaves 0.02 to 0.05 mm.
const UNEVEN: f64 = 0.18;
/// Spread of edges, as a standard deviation in mm, from which blur moves them by as much.
const BLURRED: f64 = 0.2;
/// Width of an edge, in standard deviations of its spread, if it rises evenly.
const WIDTH: f64 = 3.5;
/// What a place errs in each direction by what no camera explains, in mm: always, and as a part of the residual.
const ALWAYS: f64 = 0.02;
const PART: f64 = 0.8;
/// Largest height of a bend, in mm.
const BENT: f64 = 20.0;
/// Edge of a sheet on which nobody draws, with the markers in it, in mm.
const MARGIN: f64 = 16.0;
/// Distance of places at which pencil lines are looked for, in mm: a line is one or two of them wide.
const STEP: f64 = 0.2;
/// Standard deviations in the widest direction within which 95 % of places in the plane lie.
const CIRCLE: f64 = 2.45;

/// A sheet found in a photograph.
#[derive(Clone, Debug)]
pub struct PhotoSheet {
    /// What its code says.
    pub code: SheetCode,
    /// How many of its eight markers were found.
    pub markers: usize,
    /// Whether the picture shows no other sheet beside it.
    pub is_alone: bool,
    fitted: Fitted,
}

/// Reads the sheet in a photograph. Its code says which it is; where that is too blurred to be read by itself, it is compared with the codes that are
/// `expected`, which are asked for only then.
///
/// # Errors
/// There is none that can be measured on.
pub fn read(picture: &Picture, expected: impl FnOnce() -> Vec<SheetCode>) -> Result<PhotoSheet, Refusal> {
    let found = markers::markers(picture);
    let together = markers::sheets(&found);
    let mut fitted: Vec<(Seen, Fitted)> =
        together.into_iter().filter_map(|seen| Some((seen.clone(), fitted(picture, &seen)?))).collect();
    fitted.sort_by(|a, b| a.1.residual.total_cmp(&b.1.residual));
    let Some((seen, best)) = fitted.first() else {
        return Err(few(picture, &found));
    };
    even(best)?;
    let (page, place) = (seen.page, code_place(seen.page.size_mm()));
    let pixel = |u, v| best.camera.pixel(Point::new(place.x0 + place.width() * u, place.y0 + place.height() * v));
    let of_page = || expected().into_iter().filter(|code| code.page == page).collect();
    let is_inside = picture.holds(pixel(0.0, 0.0)) && picture.holds(pixel(1.0, 1.0));
    let no_code = if is_inside { Refusal::NoCode } else { Refusal::CutOff };
    let code = code::code(picture, pixel, of_page).ok_or(no_code)?;
    // Folded a sheet may look like one of another size.
    let own = fitted.into_iter().find(|(seen, _)| seen.page == code.page);
    let (seen, fitted) = own.ok_or(Refusal::OtherPage)?;
    even(&fitted)?;
    let others: Vec<Marker> = found.iter().filter(|marker| !seen.has(marker)).copied().collect();
    let is_alone = markers::most_together(&others) < markers::LEAST || markers::sheets(&others).is_empty();
    Ok(PhotoSheet { code, markers: seen.markers.len(), is_alone, fitted })
}

/// Why no sheet is found from these markers.
fn few(picture: &Picture, found: &[Marker]) -> Refusal {
    let count = markers::most_together(found).min(markers::LEAST - 1);
    // Mirrored some markers look like others: whether all stand on a sheet tells.
    if !markers::sheets(&markers::markers(&picture.mirrored())).is_empty() {
        Refusal::Mirrored
    } else if markers::ends_early(found, picture) {
        Refusal::CutOff
    } else {
        Refusal::FewMarkers(count)
    }
}

/// Refuses what lies too unevenly, and what is too blurred to know.
fn even(fitted: &Fitted) -> Result<(), Refusal> {
    let bend = fitted.camera.bend_height();
    match (fitted.residual > UNEVEN, fitted.blur > BLURRED) {
        (true, true) => Err(Refusal::Blurred(WIDTH * fitted.blur)),
        (true, false) => Err(Refusal::NotEven(fitted.residual)),
        _ if bend > BENT => Err(Refusal::Bent(bend)),
        _ => Ok(()),
    }
}

impl PhotoSheet {
    /// Where a place on the sheet is in the picture.
    #[must_use]
    pub fn pixel(&self, paper: [f64; 2]) -> [f64; 2] {
        self.fitted.camera.pixel(Point::from(paper)).into()
    }

    /// Where a place in the picture is on the sheet's plane; `None` where it is not.
    #[must_use]
    pub fn paper(&self, pixel: [f64; 2]) -> Option<[f64; 2]> {
        self.fitted.camera.paper(Point::from(pixel)).map(Into::into)
    }

    /// Radius round a place on the sheet within which what is seen there lies with 95 %, in mm: from the covariance of the camera and the scatter of the markers.
    #[must_use]
    pub fn band(&self, paper: [f64; 2]) -> f64 {
        let covariance = self.fitted.covariance(Point::from(paper));
        let widest = covariance.map_or(f64::INFINITY, |covariance| covariance.symmetric_eigenvalues().max());
        let further = ALWAYS.powi(2) + (PART * self.fitted.residual).powi(2);
        CIRCLE * (widest.max(0.0) + further).sqrt()
    }

    /// Root of the mean square of the distances of the markers' corners from where they should be, in mm.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.fitted.residual
    }

    /// How wide edges on the sheet are in the picture, in mm.
    #[must_use]
    pub fn edge_width(&self) -> f64 {
        WIDTH * self.fitted.blur
    }

    /// How far the sheet's middle is above or below its edges, in mm.
    #[must_use]
    pub fn bend(&self) -> f64 {
        self.fitted.camera.bend_height()
    }

    /// The straight pencil lines on the sheet, in `picture`; its edges with the markers are left out.
    #[must_use]
    pub fn strokes(&self, picture: &Picture) -> Vec<Stroke> {
        let [width, height] = self.code.page.size_mm();
        strokes(&self.straightened(picture, [[MARGIN; 2], [width - MARGIN, height - MARGIN]], STEP))
    }

    /// How dark the paper is between two corners, in mm, at places `step` mm apart.
    #[must_use]
    pub fn straightened(&self, picture: &Picture, corners: [[f64; 2]; 2], step: f64) -> Paper {
        Paper::new(picture, |paper| self.fitted.camera.pixel(paper), corners, step)
    }
}

/// Why no sheet is read from a picture, and what to do.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// No sheet is there, or too little of it: how many different markers were found.
    FewMarkers(usize),
    /// The picture ends before the sheet does: markers are outside.
    CutOff,
    /// The picture is mirrored.
    Mirrored,
    /// The markers are not where any camera would see those of a flat or evenly bent sheet: root of the mean square of
    /// their distances from there, in mm.
    NotEven(f64),
    /// The picture is so blurred that the markers are not where any camera would see them: width of edges, in mm.
    Blurred(f64),
    /// The sheet is rolled too much: height of the bend, in mm.
    Bent(f64),
    /// The small code cannot be read.
    NoCode,
    /// The code is of a sheet of another size.
    OtherPage,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    /// What is wrong.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Refusal::FewMarkers(0) => says::no_sheet(),
            Refusal::FewMarkers(1) => says::one_marker(),
            Refusal::FewMarkers(count) => says::few_markers(*count),
            Refusal::CutOff => says::cut_off(),
            Refusal::Mirrored => says::mirrored(),
            Refusal::NotEven(mm) => says::not_even(format!("{mm:.1}")),
            Refusal::Blurred(mm) => says::blurred(format!("{mm:.1}")),
            Refusal::Bent(mm) => says::bent(format!("{mm:.0}")),
            Refusal::NoCode => says::no_code(),
            Refusal::OtherPage => says::other_page(),
        }
    }

    /// What to do.
    #[must_use]
    pub fn hint(&self) -> Message {
        match self {
            Refusal::FewMarkers(_) => says::whole_sheet(),
            Refusal::CutOff => says::step_back(),
            Refusal::Mirrored => says::unmirror(),
            Refusal::NotEven(_) | Refusal::Bent(_) => says::flatten(),
            Refusal::Blurred(_) => says::nearer(),
            Refusal::NoCode => says::light_on_code(),
            Refusal::OtherPage => says::one_whole_sheet(),
        }
    }
}
