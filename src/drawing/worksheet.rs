//! Additions of a work sheet to the panels: a table of the lengths that are measured, in the order of the construction, or
//! with boxes to be filled in; the table of a key; a ruler by which the size of a print is checked.

use super::context::SheetContext;
use super::dims::Dims;
use super::layout::{Aside, Item, Layout, cut_off};
use super::legend::{HUNDREDTHS, VALUE, symbol};
use super::lines::{Lines, PAD};
use super::panel::Panel;
use super::plan::sight::is_hidden;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::table::{Cells, Table};
use super::text::{CAPTION, RichText};
use crate::construction::{Action, Plan};
use crate::quantity::{QuantityKind, QuantityRequest, What};
use crate::sheet::Sheet;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::{Point, Rect, Vec2};

/// Length of the ruler, in mm of paper.
const RULER: f64 = 50.0;
/// Width and height of the ruler with its numbers, and words above it, in mm.
const RULER_ROOM: [f64; 2] = [64.0, 18.6];
/// Rows of the table that the ruler is as high as.
const RULER_ROWS: usize = 3;
pub(super) struct Worksheet {
    pub table: Table<CELLS>,
    /// By row: the measured length, in units of its kind; empty on a sheet to be filled in.
    pub lengths: Vec<Option<(f64, QuantityKind)>>,
    pub words: Wording,
    pub dims: Dims,
    pub place: TablePlace,
}

/// Where a work sheet's table stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TablePlace {
    /// Beside or below the panels, which make room for it.
    Anywhere,
    /// Beside or below the panels, where all its rows fit at their usual size.
    Beside,
    /// On a further sheet.
    Apart,
}

/// Widths of the boxes for millimetres and values, in mm.
const BOXES: [f64; 2] = [15.0, 21.0];

/// Number of cells: name, millimetres, scale, value, unit.
const CELLS: usize = 5;
/// Index of the cell of millimetres.
const MILLIMETRES: usize = 1;

impl Worksheet {
    /// The table of the lengths measured in the panels of a figure.
    pub(super) fn new(context: &SheetContext<'_>, panels: &[Panel<'_>]) -> Self {
        let (words, page) = (context.words, context.surface.page.size_mm());
        let mut lengths = Vec::new();
        let mut rows = Vec::new();
        for (step, plan, [from, to], value) in measured(context) {
            let kind = plan.map_or(Sheet::Scheme, |plan| plan.sheet).drawn();
            let Some(panel) = panels.iter().find(|panel| panel.needs.kind == kind) else {
                continue;
            };
            let least = least(panel, page);
            let name = format!("{} {}", context.shown(from, plan), context.shown(to, plan));
            lengths.push(Some((value, kind)));
            let texts = [
                RichText::math(&name),
                millimetres(&words, value, least),
                RichText::math(symbol(kind)),
                RichText::plain(&words.write(value, VALUE)),
                RichText::plain(&kind.unit(context.scene().units)),
            ];
            rows.push(Cells { since: step, ..Cells::new(texts, format!("measured-{}", lengths.len())) });
        }
        for value in context.values.iter() {
            let is_drawn =
                matches!(value.kind, QuantityKind::Length | QuantityKind::Velocity | QuantityKind::Acceleration);
            let panel = panels.iter().find(|panel| panel.needs.kind == value.kind).filter(|_| is_drawn);
            let least = panel.map(|panel| least(panel, page));
            lengths.push(least.map(|_| (value.number, value.kind)));
            let [number, unit] = [&value.written, &value.unit].map(|text| RichText::plain(text));
            let scale = least.map_or("", |_| symbol(value.kind));
            let mm = least.map_or_else(|| RichText::plain(""), |least| millimetres(&words, value.number, least));
            let texts = [RichText::math(&value.symbol), mm, RichText::math(scale), number, unit];
            rows.push(Cells { since: value.since, ..Cells::new(texts, value.name.clone()) });
        }
        let table = table(words.language.segment(), words.language.value(), rows);
        Self { table, lengths, words, dims: context.surface.dims, place: TablePlace::Anywhere }
    }

    /// A table with boxes for the quantities to be found.
    pub(super) fn blank(context: &SheetContext<'_>, asked: &[QuantityRequest]) -> Self {
        let language = context.words.language;
        let rows = asked.iter().zip(1..).map(|(asked, number)| blank_row(context, asked, number)).collect();
        let mut table = table(language.exercise_quantity(), language.value(), rows);
        [table.widths[1], table.widths[3]] = BOXES;
        Self {
            table,
            lengths: Vec::new(),
            words: context.words,
            dims: context.surface.dims,
            place: TablePlace::Anywhere,
        }
    }

    /// The table with millimetres at a layout's scales.
    fn at_scales(&self, layout: &Layout) -> Table<CELLS> {
        let mut table = self.table.clone();
        for (row, length) in table.rows.iter_mut().zip(&self.lengths) {
            if let Some((value, mu)) = length.and_then(|(value, kind)| Some((value, layout.mu_of(kind)?))) {
                row.texts[MILLIMETRES] = millimetres(&self.words, value, mu);
            }
        }
        table
    }

    /// The table at these scales, without room for a ruler.
    pub(super) fn filled(&self, layout: &Layout) -> Table<CELLS> {
        Table { foot: ([0.0; 2], 0), ..self.at_scales(layout) }
    }
}

/// The row of a quantity to be found. Only lengths on paper have a scale.
fn blank_row(context: &SheetContext<'_>, asked: &QuantityRequest, number: usize) -> Cells<CELLS> {
    let name = context.quantity(asked);
    let is_length = matches!(asked.what(), What::Segment { .. } | What::Length(..));
    let scale = if is_length { symbol(asked.kind()) } else { "" };
    let texts = [
        RichText::math(&name),
        RichText::plain(""),
        RichText::math(scale),
        RichText::plain(""),
        RichText::plain(&asked.kind().unit(context.scene().units)),
    ];
    Cells { boxes: [false, is_length, false, true, false], ..Cells::new(texts, format!("box-{number}")) }
}

impl Item for Worksheet {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        let mut asides = self.table.asides(room);
        if self.place == TablePlace::Beside {
            asides.retain(|aside| cut_off(room, *aside).1.is_some_and(|area| self.table.fits(area)));
        }
        asides
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let Some(area) = layout.aside else { return };
        let foot = self.at_scales(layout).draw_in(drawing, area);
        draw_ruler_at_foot(drawing, foot, &self.words, &self.dims);
    }
}

/// Draws the ruler with its words in the foot of a table, from the foot's lower left corner.
fn draw_ruler_at_foot(drawing: &mut Drawing, foot: Point, words: &Wording, dims: &Dims) {
    let from = foot + Vec2::new(2.0, -RULER_ROOM[1]);
    drawing.caption(RichText::plain(words.language.ruler()), from + Vec2::new(0.0, 4.2));
    ruler(drawing, from + Vec2::new(0.0, 7.4), dims.unit);
}

/// The least scale of a panel: it is no larger than the page, so millimetres at this scale are the widest.
fn least(panel: &Panel<'_>, page: [f64; 2]) -> f64 {
    let size = panel.needs.extent.size();
    panel.needs.mu.unwrap_or((size.x / page[0]).max(size.y / page[1]))
}

/// A table with these headings over names and values, and room for the ruler.
fn table(name: &str, value: &str, rows: Vec<Cells<CELLS>>) -> Table<CELLS> {
    let head = [name, "mm", "μ", value, ""].map(RichText::plain);
    let names = ["name", "mm", "scale", "value", "unit"];
    Table { foot: (RULER_ROOM, RULER_ROWS), ..Table::new(head, [false, true, false, true, false], names, rows) }
}

/// A value in millimetres of paper at a scale; a dash where no paper is long enough.
fn millimetres(words: &Wording, value: f64, mu: f64) -> RichText {
    let mm = if mu > 0.0 { words.on_paper(value, mu, HUNDREDTHS) } else { Some(words.write(0.0, HUNDREDTHS)) };
    RichText::plain(mm.as_deref().unwrap_or("–"))
}

/// The measurements between visible points, in the order of the construction: step, plan, ends, value.
fn measured<'a>(context: &'a SheetContext<'_>) -> impl Iterator<Item = (u16, Option<&'a Plan>, [&'a str; 2], f64)> {
    let is_hidden = |plan: Option<&Plan>, name: &str| match plan {
        Some(plan) => is_hidden(context.figure(), plan, name),
        None => !context.figure().special_points && context.construction().special_point(name).is_some(),
    };
    context.construction().numbered_steps().filter_map(move |step| match &step.action {
        Action::MeasureLength { from, to, value } | Action::Measure { from, to, value } => {
            let hidden = is_hidden(step.plan, from) || is_hidden(step.plan, to);
            (!hidden).then_some((step.number as u16, step.plan, [from.as_str(), to.as_str()], *value))
        }
        _ => None,
    })
}

/// Lines that a ruler is as high as.
const LINES_BESIDE: usize = 2;

/// A ruler at the right end of the area below the scales, for a sheet without the table; words before it.
pub(super) struct Ruler {
    words: RichText,
    unit: f64,
}

/// White before the ruler's words and between them and the ruler, in mm.
const BEFORE: f64 = 3.0;
/// Room after the ruler for its last number with the unit, in mm.
const AFTER: f64 = 12.0;

impl Ruler {
    pub(super) fn new(context: &SheetContext<'_>) -> Self {
        Self { words: RichText::plain(context.words.language.ruler()), unit: context.surface.dims.unit }
    }

    /// Width of the area that is kept free, in mm.
    pub(super) fn width(&self) -> f64 {
        self.words.width(CAPTION) + 2.0 * BEFORE + RULER / self.unit + AFTER
    }
}

impl Ruler {
    /// A ruler beside lines below the scales, or below them where it has no room beside.
    pub(super) fn below(context: &SheetContext<'_>, lines: &Lines) -> Box<dyn Item> {
        let ruler = Ruler::new(context);
        let width = |line: &RichText| line.width(CAPTION) + PAD;
        let widest = lines.lines.iter().take(LINES_BESIDE).map(width).fold(0.0, f64::max);
        match widest + ruler.width() <= context.surface.dims.width_below() {
            true => Box::new(ruler),
            false => Box::new(RulerBelow { before: lines.height(), ruler }),
        }
    }
}
struct RulerBelow {
    ruler: Ruler,
    /// Height of the lines, in mm.
    before: f64,
}

impl Item for RulerBelow {
    fn height(&self) -> f64 {
        self.before + self.ruler.height()
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let mut below = Layout::of_words(layout.legend, Vec::new());
        below.scales = layout.scales + self.before;
        self.ruler.draw(drawing, &below);
    }
}

impl Item for Ruler {
    fn height(&self) -> f64 {
        11.0
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let area = layout.below();
        let from = Point::new(area.x1 - self.width() + BEFORE, area.y0 + 4.6);
        drawing.caption(self.words.clone(), from);
        ruler(drawing, from + Vec2::new(self.words.width(CAPTION) + BEFORE, -3.2), self.unit);
    }
}

/// Draws a ruler with a line for each millimetre, to the right of its upper left end.
fn ruler(drawing: &mut Drawing, from: Point, unit: f64) {
    let at = |mm: f64| Point::new(from.x + mm / unit, from.y);
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
            drawing.caption(RichText::plain(&format!("{mm}{unit}")), Point::new(x, top.y + 3.6 + 4.4));
        }
    }
}

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
const KEY_CELLS: usize = 6;
/// Style of what a hand may be off by.
const ALLOWED: NumberStyle = NumberStyle::significant(2).trimmed().in_full(-5, 12).on(Medium::Figure);

/// The table with a ruler below it.
pub(super) struct KeyTable {
    table: Table<KEY_CELLS>,
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
            let texts = [
                RichText::math(&context.quantity(row.asked)),
                RichText::plain(&mm.unwrap_or_default()),
                RichText::math(if panel.is_some() { symbol(kind) } else { "" }),
                RichText::plain(&words.write(row.value, VALUE)),
                RichText::plain(&allowed.unwrap_or_default()),
                RichText::plain(&kind.unit(context.scene().units)),
            ];
            Cells::new(texts, format!("key-{number}"))
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
