//! Signs by which a photograph of a printed sheet is read: eight square markers along its edges, which tell where on
//! the paper a pixel is, and a small code, which tells which sheet it is.
//!
//! All lengths are millimetres of paper, y down. A sheet for a projector (`16x9`) has no markers.

mod drawn;
mod sheet_code;

pub(in crate::drawing) use drawn::Signs;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A code turned by a right angle clockwise.
    fn turned(code: u16) -> u16 {
        let bit = |row: usize, column: usize| code >> (15 - (4 * row + column)) & 1;
        (0..16).fold(0, |turned, place| turned << 1 | bit(3 - place % 4, place / 4))
    }

    fn turns(code: u16) -> [u16; 4] {
        let mut turns = [code; 4];
        for k in 1..4 {
            turns[k] = turned(turns[k - 1]);
        }
        assert_eq!(turned(turns[3]), code);
        turns
    }

    #[test]
    fn codes_differ_however_they_are_turned() {
        for (i, code) in CODES.into_iter().enumerate() {
            for (j, other) in CODES.into_iter().enumerate() {
                for (quarter, turned) in turns(other).into_iter().enumerate() {
                    let differing = (code ^ turned).count_ones();
                    let is_same = i == j && quarter == 0;
                    assert!(is_same || differing >= 6, "{code:#06x} and {other:#06x}, turned {quarter} times");
                }
            }
        }
    }

    #[test]
    fn cells_are_ring_and_code() {
        let drawn: Vec<String> =
            cells(0x01c7).iter().map(|row| row.iter().map(|black| if *black { '#' } else { '.' }).collect()).collect();
        assert_eq!(drawn, ["######", "#....#", "#...##", "###..#", "#.####", "######"]);
    }

    #[test]
    fn places_on_a4() {
        let places = places([297.0, 210.0]).map(|place| [place.x0, place.y0, place.x1, place.y1]);
        assert_eq!(places[0], [6.5, 6.5, 14.5, 14.5]);
        assert_eq!(places[1], [144.5, 6.5, 152.5, 14.5]);
        assert_eq!(places[3], [282.5, 101.0, 290.5, 109.0]);
        assert_eq!(places[4], [282.5, 195.5, 290.5, 203.5]);
        assert_eq!(places[7], [6.5, 101.0, 14.5, 109.0]);
        assert_eq!(code_place([297.0, 210.0]), Rect::new(263.5, 176.5, 279.5, 192.5));
        assert_eq!(code_place([297.0, 420.0]), Rect::new(259.5, 382.5, 279.5, 402.5));
    }
}
