//! The table of a work sheet with boxes to be filled in.

use super::scheme::Scheme;
use super::text::RichText;
use super::worksheet::{Row, Worksheet, symbol, table};
use crate::construction::PlanKind;
use crate::quantity::{Asked, Spot, What};
use crate::scene::{Panel, Units};

/// Widths of the boxes for millimetres and values.
const BOXES: [f64; 2] = [15.0, 21.0];

impl Worksheet {
    /// A table with boxes for what is to be found.
    pub(super) fn blank(scheme: &Scheme<'_>, units: Units, asked: &[Asked]) -> Self {
        let language = scheme.words.language;
        let rows: Vec<Row> = asked.iter().map(|asked| blank_row(scheme, units, asked)).collect();
        let mut table = table(language.exercise_quantity(), language.value(), rows.len());
        let none = RichText::plain("");
        for row in &rows {
            table.widen([&row.name, &none, &symbol(row.scale), &none, &row.unit]);
        }
        [table.widths[1], table.widths[3]] = BOXES;
        Self { table, rows, ruler: language.ruler(), is_blank: true }
    }
}

/// The row of a quantity that is to be found. What has no length on paper has no scale.
fn blank_row(scheme: &Scheme<'_>, units: Units, asked: &Asked) -> Row {
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
    let (panel, scale) = match (asked.what(), plan) {
        (_, Some(plan)) if plan.kind == PlanKind::Velocity => (Panel::Velocity, plan.kind.scale_name()),
        (_, Some(plan)) => (Panel::Acceleration, plan.kind.scale_name()),
        (What::Length(..), None) => (Panel::Scheme, "μ_l"),
        _ => (Panel::Scheme, ""),
    };
    Row {
        step: 0,
        panel,
        value: 0.0,
        name: RichText::math(&name),
        scale,
        written: RichText::plain(""),
        unit: RichText::plain(&asked.kind().unit(units)),
    }
}
