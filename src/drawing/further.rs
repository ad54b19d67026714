//! Further sheets of a figure, with the table that has no room on its own.

use super::compose::draw_title;
use super::layout::{MARGIN, TITLE};
use super::lines;
use super::shape::{Shape, corners};
use super::sheet::{Drawing, Pen};
use super::table::Table;
use super::text::RichText;
use kurbo::Rect;

/// White between words and the table below them, in mm.
const GAP: f64 = 4.0;
/// White above words in their frame, in mm.
const TOP: f64 = 1.4;

/// Sheets with the figure's title, the lines of words for a sheet of their size, and the table, as many as its rows
/// need; none without words and rows. Portrait unless the rows are too wide.
pub(super) fn further_sheets<const N: usize>(
    figure: &Drawing,
    unit: f64,
    words: impl Fn([f64; 2]) -> Vec<RichText>,
    mut table: Table<N>,
) -> Vec<Drawing> {
    let [across, down] = [figure.width, figure.height].map(|side| side / unit);
    let narrow = across.min(down);
    let [width, height] = match table.column() <= narrow - 2.0 * MARGIN {
        true => [narrow, across.max(down)],
        false => [across, down],
    };
    let area = Rect::new(MARGIN, MARGIN + TITLE, width - MARGIN, height - MARGIN);
    let mut words = words([width, height]);
    let mut sheets = Vec::new();
    while !(table.rows.is_empty() && words.is_empty()) {
        let mut drawing = Drawing::new(width, height);
        (drawing.style, drawing.language) = (figure.style.clone(), figure.language);
        drawing.title.clone_from(&figure.title);
        draw_title(&mut drawing, [MARGIN, width - MARGIN]);
        let mut left = area;
        if !words.is_empty() {
            let room = Rect { y1: left.y0 + TOP + lines::height(words.len()), ..left };
            drawing.draw(Pen::Frame, Shape::Polygon(corners(room)));
            lines::draw(&mut drawing, Rect { y0: room.y0 + TOP, ..room }, 0, &std::mem::take(&mut words));
            left.y0 = room.y1 + GAP;
        }
        if !table.rows.is_empty() {
            let later = table.rows.split_off(table.capacity(left).clamp(1, table.rows.len()));
            table.draw_in(&mut drawing, table.needed(left));
            table.rows = later;
        }
        sheets.push(drawing.enlarged(unit));
    }
    sheets
}
