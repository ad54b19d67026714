//! What a work sheet has besides the panels: a table of the lengths that a person measures on it, in the order of the construction,
//! and a ruler that shows whether it was printed at 100 %.

use super::canvas::CAPTION;
use super::item::Item;
use super::layout::{Aside, Layout};
use super::legend::symbol;
use super::panel::Panel;
use super::plan_panel::{self, is_hidden};
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::table::{Cells, Table};
use super::text::{PlacedText, RichText};
use super::words::{HUNDREDTHS, VALUE};
use crate::construction::{Action, Plan};
use crate::quantity::Kind;
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
    pub(super) words: Wording,
    /// Whether millimetres and values are left to be filled in.
    pub(super) is_blank: bool,
}

/// Name, millimetres, scale, value, unit.
pub(super) const CELLS: usize = 5;

/// A measured length; on a blank sheet any quantity.
pub(super) struct Row {
    /// The step that measures it.
    pub(super) step: u16,
    pub(super) value: f64,
    pub(super) name: RichText,
    /// The kind of quantity in whose scale it has a length on paper.
    pub(super) scale: Option<Kind>,
    pub(super) written: RichText,
    pub(super) unit: RichText,
}

impl Worksheet {
    /// The table for the panels of a figure.
    pub(super) fn new(scheme: &Scheme<'_>, panels: &[Panel<'_>]) -> Self {
        let (words, page) = (scheme.words, scheme.figure.page.size_mm());
        let needs = |row: &Row| panels.iter().map(|panel| panel.needs).find(|needs| Some(needs.kind) == row.scale);
        let rows: Vec<Row> = rows(scheme).filter(|row| needs(row).is_some()).collect();
        let mut table = table(words.language.segment(), words.language.value(), rows.len());
        for row in &rows {
            // No panel is larger than the page, so its scale is at least this one.
            let least = needs(row).map_or(0.0, |needs| {
                let size = needs.extent.size();
                needs.mu.unwrap_or((size.x / page[0]).max(size.y / page[1]))
            });
            let most = millimetres(&words, row.value, least);
            table.widen([&row.name, &most, &row.symbol(), &row.written, &row.unit]);
        }
        Self { table, rows, words, is_blank: false }
    }
}

impl Item for Worksheet {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        self.table.asides(room)
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let Some(area) = layout.aside else { return };
        let cells = self.rows.iter().zip(1..).map(|(row, number)| {
            let mu = row.scale.and_then(|kind| layout.mu(kind));
            let mm = match (self.is_blank, mu) {
                (true, _) => RichText::plain(""),
                (false, None) => RichText::plain("–"),
                (false, Some(mu)) => millimetres(&self.words, row.value, mu),
            };
            let boxes = [false, row.scale.is_some(), false, true, false];
            let kind = if self.is_blank { "box" } else { "measured" };
            Cells {
                texts: [row.name.clone(), mm, row.symbol(), row.written.clone(), row.unit.clone()],
                id: Some(format!("{kind}-{number}")),
                since: row.step,
                stands_out: false,
                boxes: boxes.map(|is_box| is_box && self.is_blank),
            }
        });
        let cells: Vec<Cells<CELLS>> = cells.collect();
        let foot = self.table.draw(drawing, area, &cells);
        ruler(drawing, foot + Vec2::new(2.0, -RULER_ROOM[1]), self.words.language.ruler());
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

impl Row {
    /// The symbol of its scale.
    pub(super) fn symbol(&self) -> RichText {
        RichText::math(self.scale.map_or("", symbol))
    }
}

/// A value in millimetres of paper at a scale.
fn millimetres(words: &Wording, value: f64, mu: f64) -> RichText {
    let mm = if mu > 0.0 { value / mu } else { 0.0 };
    RichText::plain(&words.write(mm, HUNDREDTHS))
}

/// What is measured, and visible, in the order of the construction.
fn rows<'a>(scheme: &'a Scheme<'_>) -> impl Iterator<Item = Row> + 'a {
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
        let kind = plan_panel::kind(plan.map(|plan| plan.kind));
        let name = |name: &str| scheme.shown(name, plan);
        let written = scheme.words.write(value, VALUE);
        Some(Row {
            step,
            value,
            name: RichText::math(&format!("{} {}", name(from), name(to))),
            scale: Some(kind),
            written: RichText::plain(&written),
            unit: RichText::plain(&kind.unit(scheme.scene.units)),
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
