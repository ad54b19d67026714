//! What a work sheet has besides the panels: a table of the lengths that a person measures on it, in the order of the construction,
//! and a ruler that shows whether it was printed at 100 %.

use super::canvas::CAPTION;
use super::layout::{Aside, Placed};
use super::plan_panel::is_hidden;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::table::{Cells, Table};
use super::text::{PlacedText, RichText};
use super::view::Extent;
use super::words::{HUNDREDTHS, VALUE};
use crate::construction::{Action, Plan, PlanKind};
use crate::quantity::Kind;
use crate::scene::{Panel, Units};
use crate::words::Wording;
use kurbo::{Point, Rect, Vec2};

/// Length of the ruler.
const RULER: f64 = 50.0;
/// Room for the ruler with its numbers and words.
const RULER_ROOM: [f64; 2] = [64.0, 18.6];
/// Rows that this takes.
const RULER_ROWS: usize = 3;

/// A table of measured lengths and a ruler, not yet placed.
pub(super) struct Worksheet {
    pub(super) table: Table<CELLS>,
    pub(super) rows: Vec<Row>,
    pub(super) ruler: &'static str,
    /// Whether millimetres and values are left to be filled in.
    pub(super) is_blank: bool,
}

/// Name, millimetres, scale, value, unit.
pub(super) const CELLS: usize = 5;

/// A measured length; on a blank sheet any quantity.
pub(super) struct Row {
    /// The step that measures it.
    pub(super) step: u16,
    pub(super) panel: Panel,
    pub(super) value: f64,
    pub(super) name: RichText,
    pub(super) scale: &'static str,
    pub(super) written: RichText,
    pub(super) unit: RichText,
}

impl Worksheet {
    /// The table for the panels of a figure on a page of this size.
    pub(super) fn new(scheme: &Scheme<'_>, units: Units, extents: &[(Panel, Extent)], page: [f64; 2]) -> Self {
        let language = scheme.words.language;
        let rows: Vec<Row> =
            rows(scheme, units).filter(|row| extents.iter().any(|(panel, _)| *panel == row.panel)).collect();
        let mut table = table(language.segment(), language.value(), rows.len());
        let figure = scheme.figure;
        // No panel is larger than the page, so its scale is at least this one.
        let least = |panel: Panel| {
            let given = figure.mu(panel);
            let extent = extents.iter().find(|(p, _)| *p == panel);
            let size = extent.map_or(nalgebra::zero(), |(_, extent)| extent.size());
            given.unwrap_or((size.x / page[0]).max(size.y / page[1]))
        };
        for row in &rows {
            let most = millimetres(&scheme.words, row.value, least(row.panel));
            table.widen([&row.name, &most, &symbol(row.scale), &row.written, &row.unit]);
        }
        Self { table, rows, ruler: language.ruler(), is_blank: false }
    }

    /// The parts of a room that it may take.
    pub(super) fn asides(&self, room: Rect) -> Vec<Aside> {
        self.table.asides(room)
    }

    /// Draws the table in its area, beside these panels.
    pub(super) fn draw(&self, drawing: &mut Drawing, area: Rect, panels: &[Placed], words: &Wording) {
        let cells = self.rows.iter().zip(1..).map(|(row, number)| {
            let mu = panels.iter().find(|p| p.panel == row.panel).map(|p| p.mu);
            let mm = match (self.is_blank, mu) {
                (true, _) => RichText::plain(""),
                (false, None) => RichText::plain("–"),
                (false, Some(mu)) => millimetres(words, row.value, mu),
            };
            // What has no scale has no millimetres.
            let boxes = [false, !row.scale.is_empty(), false, true, false];
            let kind = if self.is_blank { "box" } else { "measured" };
            Cells {
                texts: [row.name.clone(), mm, symbol(row.scale), row.written.clone(), row.unit.clone()],
                id: Some(format!("{kind}-{number}")),
                since: row.step,
                stands_out: false,
                boxes: boxes.map(|is_box| is_box && self.is_blank),
            }
        });
        let cells: Vec<Cells<CELLS>> = cells.collect();
        let foot = self.table.draw(drawing, area, &cells);
        ruler(drawing, foot + Vec2::new(2.0, -RULER_ROOM[1]), self.ruler);
    }
}

/// A table with such a heading over its names and its values.
pub(super) fn table(name: &str, value: &str, rows: usize) -> Table<CELLS> {
    let head = [name, "mm", "μ", value, ""].map(RichText::plain);
    Table {
        widths: head.each_ref().map(|text| text.width(CAPTION)),
        head,
        ending: [false, true, false, true, false],
        names: ["name", "mm", "scale", "value", "unit"],
        rows,
        foot: (RULER_ROOM, RULER_ROWS),
    }
}

pub(super) fn symbol(scale: &str) -> RichText {
    RichText::math(scale)
}

/// A value in millimetres of paper at a scale.
fn millimetres(words: &Wording, value: f64, mu: f64) -> RichText {
    let mm = if mu > 0.0 { value / mu } else { 0.0 };
    RichText::plain(&words.write(mm, HUNDREDTHS))
}

/// What is measured, and visible, in the order of the construction.
fn rows<'a>(scheme: &'a Scheme<'_>, units: Units) -> impl Iterator<Item = Row> + 'a {
    let figure = scheme.figure;
    let hidden = move |plan: Option<&Plan>, name: &str| match plan {
        Some(plan) => is_hidden(figure, plan, name),
        None => !figure.special_points && scheme.construction.special_point(name).is_some(),
    };
    let row = move |(step, plan, action): (u16, Option<&'a Plan>, &'a Action)| {
        let (from, to, value) = match action {
            Action::MeasureLength { from, to, value } | Action::Measure { from, to, value } => (from, to, *value),
            _ => return None,
        };
        if hidden(plan, from) || hidden(plan, to) {
            return None;
        }
        let (panel, kind, scale) = match plan.map(|plan| plan.kind) {
            None => (Panel::Scheme, Kind::Length, "μ_l"),
            Some(own @ PlanKind::Velocity) => (Panel::Velocity, Kind::Velocity, own.scale_name()),
            Some(own) => (Panel::Acceleration, Kind::Acceleration, own.scale_name()),
        };
        let name = |name: &str| scheme.shown(name, plan);
        let written = scheme.words.write(value, VALUE);
        Some(Row {
            step,
            panel,
            value,
            name: RichText::math(&format!("{} {}", name(from), name(to))),
            scale,
            written: RichText::plain(&written),
            unit: RichText::plain(&kind.unit(units)),
        })
    };
    let steps = scheme.construction.numbered_steps();
    steps.filter_map(move |step| row((step.number as u16, step.plan, &step.step.action)))
}

/// A ruler with a stroke for each millimetre, below the words.
fn ruler(drawing: &mut Drawing, from: Point, words: &str) {
    let text = PlacedText::new(RichText::plain(words), CAPTION, from + Vec2::new(0.0, 4.2));
    drawing.draw(Pen::Caption, Shape::Text(text));
    let at = |mm: f64| Point::new(from.x + mm, from.y + 7.4);
    let line = Shape::Line(at(0.0), at(RULER));
    drawing.draw_named("ruler", Pen::Ground, line);
    for mm in 0..=RULER as u32 {
        let long = match mm {
            _ if mm % 10 == 0 => 3.6,
            _ if mm % 5 == 0 => 2.6,
            _ => 1.7,
        };
        let top = at(f64::from(mm));
        let stroke = Shape::Line(top, top + Vec2::new(0.0, long));
        drawing.draw_named(format!("ruler-{mm}"), Pen::Ground, stroke);
        if mm % 10 == 0 {
            let number = RichText::plain(&mm.to_string());
            let x = top.x - 0.5 * number.width(CAPTION);
            let unit = if f64::from(mm) == RULER { " mm" } else { "" };
            let text = RichText::plain(&format!("{mm}{unit}"));
            let place = Point::new(x, top.y + 3.6 + 4.4);
            drawing.draw(Pen::Caption, Shape::Text(PlacedText::new(text, CAPTION, place)));
        }
    }
}
