//! The table of a work sheet with boxes to be filled in.

use super::plan_panel;
use super::scheme::Scheme;
use super::text::RichText;
use super::worksheet::{Row, Worksheet, table};
use crate::quantity::{Asked, Spot, What};

/// Widths of the boxes for millimetres and values.
const BOXES: [f64; 2] = [15.0, 21.0];

impl Worksheet {
    /// A table with boxes for what is to be found.
    pub(super) fn blank(scheme: &Scheme<'_>, asked: &[Asked]) -> Self {
        let language = scheme.words.language;
        let rows: Vec<Row> = asked.iter().map(|asked| blank_row(scheme, asked)).collect();
        let mut table = table(language.exercise_quantity(), language.value(), rows.len());
        let none = RichText::plain("");
        for row in &rows {
            table.widen([&row.name, &none, &row.symbol(), &none, &row.unit]);
        }
        [table.widths[1], table.widths[3]] = BOXES;
        Self { table, rows, words: scheme.words, is_blank: true }
    }
}

/// The row of a quantity that is to be found. What has no length on paper has no scale.
fn blank_row(scheme: &Scheme<'_>, asked: &Asked) -> Row {
    let plan = match asked.what() {
        What::Segment { kind, .. } => {
            let mut plans = scheme.construction.plans();
            plans.find(|plan| plan.kind == *kind)
        }
        _ => None,
    };
    let name = match asked.what() {
        What::Segment { from, to, .. } => {
            format!("{} {}", scheme.shown(from, plan), scheme.shown(to, plan))
        }
        What::Length(from, to) => {
            let shown = |spot: &Spot| scheme.shown(spot.name(), None);
            format!("{} {}", shown(from), shown(to))
        }
        _ => asked.symbol(scheme.mechanism, scheme.words.notation, &|name| scheme.shown(name, None)),
    };
    let scale = match (asked.what(), plan.map(|plan| plan.kind)) {
        (What::Length(..), kind) | (_, kind @ Some(_)) => Some(plan_panel::kind(kind)),
        _ => None,
    };
    Row {
        step: 0,
        value: 0.0,
        name: RichText::math(&name),
        scale,
        written: RichText::plain(""),
        unit: RichText::plain(&asked.kind().unit(scheme.scene.units)),
    }
}
