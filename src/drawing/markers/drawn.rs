//! Markers and the small code as marks of a drawing.

use super::sheet_code::written_name;
use super::{CODE_WHITE, CODES, SheetCode, WHITE, cells, code_place, places};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Drawing, Pen};
use kurbo::{Point, Rect};
use std::collections::BTreeMap;

/// A corner of cells: column and row.
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
    let at = |[column, row]: Corner| place.origin() + side * kurbo::Vec2::new(column as f64, row as f64);
    let chains = outlines(cells).into_iter().map(|chain| chain.into_iter().map(at).collect::<Vec<Point>>());
    drawing.draw_named(id, Pen::Marker, Shape::Area(chains.collect()));
}

/// The borders of the black cells as closed chains of corners, with black on the right of each: areas run clockwise to
/// the eye, holes the other way.
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
