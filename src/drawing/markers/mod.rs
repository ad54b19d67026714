//! Signs by which a photograph of a printed sheet is read: eight square markers along its edges, which tell where on
//! the paper a pixel is, and a small code, which tells which sheet it is.
//!
//! All lengths are millimetres of paper, y down. A sheet for a projector (`16x9`) has no markers.

#[doc(hidden)] // for tests
pub mod drawn;
mod sheet_code;

pub(in crate::drawing) use drawn::draw_markers;
pub use sheet_code::{PlacedPanel, SheetCode};

use kurbo::{Point, Rect, Size};

/// Side of a marker.
pub const SIDE: f64 = 8.0;
/// Distance of markers from the sheet's edges: printers leave about 4 mm white.
pub const EDGE: f64 = 6.5;
/// Cells along a side of a marker: an outer ring that is black, and [`INNER`] by [`INNER`] cells of its code.
pub const CELLS: usize = 6;
/// Cells along a side of a marker's code.
pub const INNER: usize = 4;
/// White around a marker.
pub const WHITE: f64 = 1.5;
/// White around the small code.
pub const CODE_WHITE: f64 = 1.6;

/// The codes of the markers: clockwise from the upper left corner, so that corners and middles of edges alternate.
///
/// The cells of a code row by row from the upper left one, the highest of 16 bits first; 1 is black. Any two of them
/// differ in six cells or more however either is turned, and so does each from itself when turned.
pub const CODES: [u16; 8] = [0x003f, 0x01c7, 0x01f8, 0x064b, 0x0695, 0x0726, 0x0b1a, 0x0b75];

/// Distance of the small code from the right and lower edge of the sheet.
const CODE_EDGE: f64 = 17.5;

/// The places of the markers on a page of this width and height, in the order of [`CODES`]: upper left, upper middle,
/// upper right, right middle, lower right, lower middle, lower left, left middle.
///
/// All stand upright.
#[must_use]
pub fn places([width, height]: [f64; 2]) -> [Rect; 8] {
    let [left, top] = [EDGE; 2];
    let [right, bottom] = [width, height].map(|side| side - EDGE - SIDE);
    let [across, down] = [width, height].map(|side| 0.5 * (side - SIDE));
    [
        (left, top),
        (across, top),
        (right, top),
        (right, down),
        (right, bottom),
        (across, bottom),
        (left, bottom),
        (left, down),
    ]
    .map(|corner| Rect::from_origin_size(Point::from(corner), Size::new(SIDE, SIDE)))
}

/// The place of the small code on a page of this width and height: the square of its modules, without the white around.
#[must_use]
pub fn code_place([width, height]: [f64; 2]) -> Rect {
    // A3 is the only page with a side of more than 400 mm.
    let side = if width.max(height) > 400.0 { 20.0 } else { 16.0 };
    let corner = Point::new(width - CODE_EDGE, height - CODE_EDGE);
    Rect::new(corner.x - side, corner.y - side, corner.x, corner.y)
}

/// The cells of a marker by rows from above, each from the left; true is black.
#[must_use]
pub fn cells(code: u16) -> [[bool; CELLS]; CELLS] {
    let mut cells = [[true; CELLS]; CELLS];
    for (row, line) in cells[1..=INNER].iter_mut().enumerate() {
        for (column, cell) in line[1..=INNER].iter_mut().enumerate() {
            *cell = code >> (15 - (INNER * row + column)) & 1 == 1;
        }
    }
    cells
}
