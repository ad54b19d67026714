//! Signs by which a photograph of a printed sheet is read: eight square markers along its edges, which tell where on
//! the paper a pixel is, and a small code, which tells which sheet it is.
//!
//! All lengths are millimetres of paper, y down. A sheet for a projector (`16x9`) has no markers.

pub(super) mod sheet_code;

pub use sheet_code::{PlacedPanel, SheetCode, pages};

use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use kurbo::{Point, Rect, Size, Vec2};
use sheet_code::written_name;
use std::collections::BTreeMap;

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

/// A corner of cells: column and row.
#[doc(hidden)] // for tests
pub type Corner = [usize; 2];

/// Draws the markers and the code of a sheet on its drawing, whose lengths are mm of paper.
pub(in crate::drawing) fn draw_markers(drawing: &mut Drawing, code: SheetCode) {
    let page = [drawing.width, drawing.height];
    for ((place, code), number) in places(page).into_iter().zip(CODES).zip(1..) {
        draw_cells(drawing, &format!("marker-{number}"), place, WHITE, &cells(code).map(|row| row.to_vec()));
    }
    let code = SheetCode { name: written_name(&code.name), ..code };
    if let Some(modules) = code.modules() {
        draw_cells(drawing, "code", code_place(page), CODE_WHITE, &modules);
        drawing.code = Some(code);
    }
}

/// Draws the black ones of cells in rows, as one area without seams, and white under and around them: a style may be for dark paper.
fn draw_cells(drawing: &mut Drawing, id: &str, place: Rect, white: f64, cells: &[Vec<bool>]) {
    drawing.draw_named(format!("{id}-white"), Pen::MarkerWhite, Shape::rectangle(place.inflate(white, white)));
    let side = place.width() / cells.len() as f64;
    let at = |[column, row]: Corner| place.origin() + side * Vec2::new(column as f64, row as f64);
    let chains = outlines(cells).into_iter().map(|chain| chain.into_iter().map(at).collect::<Vec<Point>>());
    drawing.draw_named(id, Pen::Marker, Shape::Area(chains.collect()));
}

/// The borders of the black cells as closed chains of corners, with black on the right of each: areas run clockwise to
/// the eye, holes the other way.
#[doc(hidden)] // for tests
pub fn outlines(cells: &[Vec<bool>]) -> Vec<Vec<Corner>> {
    let black = |column: usize, row: usize| cells.get(row).and_then(|row| row.get(column)) == Some(&true);
    // Sides of cells with white on the other side, by their starts.
    let mut sides: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
    for (row, line) in cells.iter().enumerate() {
        for (column, _) in line.iter().enumerate().filter(|(_, black)| **black) {
            let [left, top, right, bottom] = [column, row, column + 1, row + 1];
            let borders = [
                ([left, top], [right, top], row > 0 && black(column, row - 1)),
                ([right, top], [right, bottom], black(right, row)),
                ([right, bottom], [left, bottom], black(column, bottom)),
                ([left, bottom], [left, top], column > 0 && black(column - 1, row)),
            ];
            for (from, to, _) in borders.into_iter().filter(|(.., covered)| !covered) {
                sides.entry(from).or_default().push(to);
            }
        }
    }
    let mut chains = Vec::new();
    while let Some((&start, _)) = sides.first_key_value() {
        let mut chain = vec![start];
        let mut here = start;
        while let Some(ends) = sides.get_mut(&here) {
            let next = ends.pop().expect("a corner without sides is taken away");
            if ends.is_empty() {
                sides.remove(&here);
            }
            if next == start {
                break;
            }
            chain.push(next);
            here = next;
        }
        chains.push(without_middles(&chain));
    }
    chains
}

/// A closed chain without the corners at which it goes straight on.
fn without_middles(chain: &[Corner]) -> Vec<Corner> {
    let count = chain.len();
    let turns = |index: &usize| {
        let [before, here, after] = [index + count - 1, *index, index + 1].map(|index| chain[index % count]);
        !(0..2).any(|axis| before[axis] == here[axis] && here[axis] == after[axis])
    };
    (0..count).filter(turns).map(|index| chain[index]).collect()
}
