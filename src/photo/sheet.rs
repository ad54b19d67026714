//! The sheet in a photograph: which it is, and where its places are in the picture.

use super::camera::Camera;
use super::code;
use super::edges;
use super::fit::{Fitted, Sight, fit};
use super::markers::{self, Seen};
use super::paper::Paper;
use super::picture::Picture;
use super::refusal::Refusal;
use super::strokes::{Stroke, strokes};
use crate::drawing::markers::{CODES, SIDE, SheetCode, code_place};
use crate::geometry::Point;
use crate::scene::Page;

/// Longer side of the picture in which markers are looked for, in pixels; their edges are found in the whole one.
const WORKING: usize = 1700;
/// Least number of markers.
const LEAST: usize = 4;
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

/// A sheet found in a photograph.
#[derive(Clone, Debug)]
pub struct PhotoSheet {
    /// What its code says.
    pub code: SheetCode,
    /// How many of its eight markers were found.
    pub markers: usize,
    fitted: Fitted,
}

/// Reads the sheet in a photograph. Its code says which it is; where it is too blurred to be read by itself, it is compared with those of the sheets
/// that are `expected`.
///
/// # Errors
/// There is none that can be measured on.
pub fn read(picture: &Picture, expected: &[SheetCode]) -> Result<PhotoSheet, Refusal> {
    let factor = picture.width().max(picture.height()).div_ceil(WORKING);
    let mut found = markers::markers(&picture.smaller(factor), factor);
    // A sheet far away has small markers.
    if factor > 1 && markers::most_together(&found) < CODES.len() {
        markers::add(&mut found, markers::markers(&picture.smaller(factor / 2), factor / 2));
    }
    let together = markers::sheets(&found, LEAST);
    let mut fitted: Vec<(Seen, Fitted)> =
        together.into_iter().filter_map(|seen| Some((seen.clone(), fitted(picture, &seen)?))).collect();
    fitted.sort_by(|a, b| a.1.residual.total_cmp(&b.1.residual));
    let Some((seen, best)) = fitted.first() else {
        return Err(Refusal::FewMarkers { markers: markers::most_together(&found).min(LEAST - 1) });
    };
    even(best)?;
    let code = code(picture, seen.page, &best.camera, expected).ok_or(Refusal::NoCode)?;
    // Folded a sheet may look like one of another size.
    let own = fitted.into_iter().find(|(seen, _)| seen.page == code.page);
    let (seen, fitted) = own.ok_or(Refusal::OtherPage)?;
    even(&fitted)?;
    Ok(PhotoSheet { code, markers: seen.markers.len(), fitted })
}

/// Refuses what lies too unevenly, and what is too blurred to know.
fn even(fitted: &Fitted) -> Result<(), Refusal> {
    let bend = fitted.camera.bend_height();
    match (fitted.residual > UNEVEN, fitted.blur > BLURRED) {
        (true, true) => Err(Refusal::Blurred { millimetres: WIDTH * fitted.blur }),
        (true, false) => Err(Refusal::NotEven { millimetres: fitted.residual }),
        _ if bend > BENT => Err(Refusal::Bent { millimetres: bend }),
        _ => Ok(()),
    }
}

/// The camera that explains the markers: from their rough corners first, then from the edges where that camera expects them.
fn fitted(picture: &Picture, seen: &Seen) -> Option<Fitted> {
    let (sheet, size) = (seen.page.size_mm(), [picture.width() as f64, picture.height() as f64]);
    let rough = fit(&sights(picture, seen, None), &seen.plane, sheet, size)?;
    let mut sights = sights(picture, seen, Some(&rough.camera));
    let mut fitted = fit(&sights, &seen.plane, sheet, size)?;
    while let Some((marker, better)) = fitted.without_worst(&sights) {
        sights.retain(|sight| sight.marker != marker);
        fitted = better;
    }
    (sights.len() >= 3 * LEAST).then_some(fitted)
}

/// The corners of the markers, looked for where a camera or else their outlines let expect them.
fn sights(picture: &Picture, seen: &Seen, camera: Option<&Camera>) -> Vec<Sight> {
    let mut sights = Vec::new();
    for marker in &seen.markers {
        let own = markers::corners(seen.page, marker.number);
        let expected = camera.map_or(marker.corners, |camera| own.map(|paper| camera.pixel(paper)));
        let middle = nalgebra::center(&own[0], &own[2]);
        for (paper, corner) in own.into_iter().zip(edges::corners(picture, &expected, SIDE)) {
            let outwards = (paper - middle) / (0.5 * SIDE);
            sights.extend(corner.map(|corner| Sight { marker: marker.number, paper, outwards, corner }));
        }
    }
    sights
}

/// What the code on a page says.
fn code(picture: &Picture, page: Page, camera: &Camera, expected: &[SheetCode]) -> Option<SheetCode> {
    let place = code_place(page.size_mm());
    let pixel = |u, v| camera.pixel(Point::new(place.x0 + place.width() * u, place.y0 + place.height() * v));
    let expected: Vec<&SheetCode> = expected.iter().filter(|code| code.page == page).collect();
    code::code(picture, pixel, &expected)
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

/// Standard deviations in the widest direction within which 95 % of places in the plane lie.
const CIRCLE: f64 = 2.45;
