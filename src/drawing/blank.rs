//! The table of a work sheet with boxes to be filled in.

use super::legend::symbol;
use super::scheme::Scheme;
use super::table::Cells;
use super::text::RichText;
use super::worksheet::{CELLS, TablePlace, Worksheet, table};
use crate::quantity::{Asked, What};

/// Widths of the boxes for millimetres and values, in mm.
const BOXES: [f64; 2] = [15.0, 21.0];

impl Worksheet {
    /// A table with boxes for the quantities to be found.
    pub(super) fn blank(scheme: &Scheme<'_>, asked: &[Asked]) -> Self {
        let language = scheme.words.language;
        let rows = asked.iter().zip(1..).map(|(asked, number)| blank_row(scheme, asked, number)).collect();
        let mut table = table(language.exercise_quantity(), language.value(), rows);
        [table.widths[1], table.widths[3]] = BOXES;
        Self { table, lengths: Vec::new(), words: scheme.words, dims: scheme.dims, place: TablePlace::Anywhere }
    }
}

/// The row of a quantity to be found. Only lengths on paper have a scale.
fn blank_row(scheme: &Scheme<'_>, asked: &Asked, number: usize) -> Cells<CELLS> {
    let plan = match asked.what() {
        What::Segment { kind, .. } => scheme.construction.plans().find(|plan| plan.kind == *kind),
        _ => None,
    };
    let between = |from: &str, to: &str| format!("{} {}", scheme.shown(from, plan), scheme.shown(to, plan));
    let name = match asked.what() {
        What::Segment { from, to, .. } => between(from, to),
        What::Length(from, to) => between(from.name(), to.name()),
        _ => asked.symbol(scheme.mechanism, scheme.words.notation, &|name| scheme.shown(name, None)),
    };
    let is_length = plan.is_some() || matches!(asked.what(), What::Length(..));
    let scale = if is_length { symbol(asked.kind()) } else { "" };
    Cells {
        texts: [
            RichText::math(&name),
            RichText::plain(""),
            RichText::math(scale),
            RichText::plain(""),
            RichText::plain(&asked.kind().unit(scheme.scene.units)),
        ],
        id: Some(format!("box-{number}")),
        since: 0,
        stands_out: false,
        boxes: [false, is_length, false, true, false],
    }
}
