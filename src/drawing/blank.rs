//! The table of a work sheet with boxes to be filled in.

use super::canvas::CAPTION;
use super::legend;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::RichText;
use super::worksheet::{GUTTER, Row, Worksheet, symbol};
use crate::plan::{Asked, PlanKind, Spot, What};
use crate::scene::{Panel, Units};
use kurbo::{Point, Rect};

/// Widths of the boxes for millimetres and values.
const BOXES: [f64; 2] = [15.0, 21.0];
/// How far a box reaches above and below the line of letters.
const BOX: [f64; 2] = [4.1, 1.3];

impl Worksheet {
    /// A table with boxes for what is to be found.
    pub(super) fn blank(scheme: &Scheme<'_>, units: Units, asked: &[Asked]) -> Self {
        let language = scheme.words.language;
        let rows: Vec<Row> = asked
            .iter()
            .map(|asked| blank_row(scheme, units, asked))
            .collect();
        let plain = RichText::plain;
        let head = [
            plain(language.exercise.quantity),
            plain("mm"),
            plain("μ"),
            plain(language.value),
            plain(""),
        ];
        let mut widths = head.each_ref().map(|text| text.width(CAPTION));
        for row in &rows {
            let own = [&row.name, &symbol(row.scale), &row.unit].map(|text| text.width(CAPTION));
            for (cell, own) in [0, 2, 4].into_iter().zip(own) {
                widths[cell] = widths[cell].max(own);
            }
        }
        [widths[1], widths[3]] = BOXES;
        Self {
            rows,
            head,
            ruler: language.ruler,
            widths,
            is_blank: true,
        }
    }

    /// The empty boxes of a row: for the value, and for millimetres where it has a scale.
    pub(super) fn boxes(
        &self,
        drawing: &mut Drawing,
        from: Point,
        small: f64,
        (index, row): (usize, &Row),
    ) {
        for (cell, name) in [(1, "mm"), (3, "value")] {
            if cell == 1 && row.scale.is_empty() {
                continue;
            }
            let before: f64 = self.widths[..cell].iter().sum();
            let x = from.x + (before + GUTTER * cell as f64) * small;
            let [above, below] = BOX.map(|y| y * small);
            let area = Rect::new(
                x,
                from.y - above,
                x + self.widths[cell] * small,
                from.y + below,
            );
            let name = format!("box-{index}-{name}");
            drawing.draw_named(name, Pen::Frame, Shape::Polygon(legend::corners(area)));
        }
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
        _ => asked.symbol(scheme.mechanism, scheme.words.notation, &|name| {
            scheme.shown(name, None)
        }),
    };
    let (panel, scale) = match (asked.what(), plan) {
        (_, Some(plan)) if plan.kind == PlanKind::Velocity => {
            (Panel::Velocity, plan.kind.scale_name())
        }
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
