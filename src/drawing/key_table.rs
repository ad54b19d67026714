//! The table of a key: every quantity of the form with its value, and by how much a careful hand may be off.

use super::context::SheetContext;
use super::dims::Dims;
use super::layout::{Aside, Item, Layout};
use super::legend::{HUNDREDTHS, VALUE, symbol};
use super::panel::Panel;
use super::sheet::Drawing;
use super::table::{Cells, Table};
use super::text::RichText;
use super::worksheet::{RULER_ROOM, RULER_ROWS, draw_ruler_at_foot, least};
use crate::quantity::QuantityRequest;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::Rect;

/// A quantity of the form with its exact value.
#[derive(Clone, Copy, Debug)]
pub struct KeyRow<'a> {
    /// The quantity.
    pub asked: &'a QuantityRequest,
    /// Its value in the scene's units.
    pub value: f64,
    /// By how much the value of a careful hand may differ; none for what is given.
    pub allowed: Option<f64>,
}

/// Name, millimetres, scale, value, what a hand may be off by, unit.
const CELLS: usize = 6;
/// Style of what a hand may be off by.
const ALLOWED: NumberStyle = NumberStyle::significant(2).trimmed().in_full(-5, 12).on(Medium::Figure);

/// The table with a ruler below it.
pub(super) struct KeyTable {
    table: Table<CELLS>,
    words: Wording,
    dims: Dims,
}

impl KeyTable {
    /// The table of these rows beside panels. Millimetres of a panel without a scale are those at its largest.
    pub(super) fn new(context: &SheetContext<'_>, panels: &[Panel<'_>], rows: &[KeyRow<'_>]) -> KeyTable {
        let (words, page) = (context.words, context.surface.page.size_mm());
        let cells = rows.iter().zip(1..).map(|(row, number)| {
            let kind = row.asked.kind();
            let panel = panels.iter().find(|panel| panel.needs.kind == kind && row.asked.is_length_on_sheet());
            let mm = panel.map(|panel| words.write(row.value / least(panel, page), HUNDREDTHS));
            let allowed = row.allowed.map(|allowed| format!("± {}", words.write(allowed, ALLOWED)));
            Cells {
                texts: [
                    RichText::math(&context.quantity(row.asked)),
                    RichText::plain(&mm.unwrap_or_default()),
                    RichText::math(if panel.is_some() { symbol(kind) } else { "" }),
                    RichText::plain(&words.write(row.value, VALUE)),
                    RichText::plain(&allowed.unwrap_or_default()),
                    RichText::plain(&kind.unit(context.scene().units)),
                ],
                id: Some(format!("key-{number}")),
                since: 0,
                stands_out: false,
                boxes: [false; CELLS],
            }
        });
        let head = [words.language.exercise_quantity(), "mm", "μ", words.language.value(), "±", ""];
        let right_aligned = [false, true, false, true, false, false];
        let names = ["name", "mm", "scale", "value", "allowed", "unit"];
        let table = Table::new(head.map(RichText::plain), right_aligned, names, cells.collect());
        KeyTable { table: Table { foot: (RULER_ROOM, RULER_ROWS), ..table }, words, dims: context.surface.dims }
    }
}

impl Item for KeyTable {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        self.table.asides(room)
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let Some(area) = layout.aside else { return };
        let foot = self.table.draw_in(drawing, area);
        draw_ruler_at_foot(drawing, foot, &self.words, &self.dims);
    }
}
