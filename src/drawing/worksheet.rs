//! Additions of a work sheet to the panels: a table of the lengths that are measured, in the order of the construction, or
//! with boxes to be filled in; the table of a key; a ruler by which the size of a print is checked.

use super::context::SheetContext;
use super::layout::{Aside, Item, Layout};
use super::lines::{Lines, PAD};
use super::panel::Panel;
use super::remarks::{HUNDREDTHS, VALUE};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::table::{Cells, Heading, Table};
use super::text::{CAPTION, RichText};
use super::values::is_hidden;
use crate::construction::{Action, NumberedStep, Plan};
use crate::quantity::QuantityRequest;
use crate::sheet::Sheet;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::{Point, Rect, Vec2};

/// Length of the ruler, in mm of paper.
const RULER: f64 = 50.0;
/// Width and height of the ruler with its numbers, and words above it, in mm.
const RULER_ROOM: [f64; 2] = [64.0, 18.6];
/// Rows of the table that the ruler is as high as.
const RULER_ROWS: usize = 3;

/// The table of a work sheet or of a key, with the ruler below its last column.
pub(super) struct Worksheet {
    pub table: Table,
    /// By row: the measured length and the sheet on which it is, none for what is no length on paper. There are no rows
    /// where millimetres do not follow the layout's scales.
    lengths: Vec<Option<(f64, Sheet)>>,
    words: Wording,
    /// A unit of the layout, in mm of paper.
    unit: f64,
    place: TablePlace,
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

/// Index of the cell of millimetres in a row.
const MILLIMETRES: usize = 1;
/// Index of the cell of values in a row.
const VALUES: usize = 3;
/// Widths of the boxes for millimetres and values, in mm.
const BOXES: [f64; 2] = [15.0, 21.0];
/// Style of what a hand may be off by.
const ALLOWED: NumberStyle = NumberStyle::significant(2).trimmed().in_full(-5, 12).on(Medium::Figure);

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

impl Worksheet {
    /// The table of the lengths measured in the panels of a figure.
    pub(super) fn new(context: &SheetContext<'_>, panels: &[Panel<'_>], place: TablePlace) -> Self {
        let (words, page) = (context.words, context.surface.page.size_mm());
        let mut lengths = Vec::new();
        let mut rows = Vec::new();
        for (NumberedStep { number, sheet, plan, .. }, [from, to], value) in measured(context) {
            let Some(panel) = panels.iter().find(|panel| panel.needs.sheet == sheet) else {
                continue;
            };
            lengths.push(Some((value, sheet)));
            let name = format!("{} {}", context.told(from, plan), context.told(to, plan));
            let mm = millimetres(&words, value, least(panel, page));
            let unit = sheet.facts().drawn.unit(context.solution.scene.units);
            let texts = row(&name, &mm, sheet.facts().scale_symbol, &words.write(value, VALUE), &unit);
            rows.push(Cells { since: number as u16, ..Cells::new(texts, format!("measured-{}", lengths.len())) });
        }
        for value in context.values.iter() {
            let panel = panels.iter().find(|panel| panel.needs.sheet.facts().drawn == value.kind);
            lengths.push(panel.map(|panel| (value.number, panel.needs.sheet)));
            let scale = panel.map_or("", |panel| panel.needs.sheet.facts().scale_symbol);
            let mm = panel.map(|panel| millimetres(&words, value.number, least(panel, page)));
            let texts = row(&value.symbol, &mm.unwrap_or_default(), scale, &value.written, &value.unit);
            rows.push(Cells { since: value.since, ..Cells::new(texts, value.name.clone()) });
        }
        let head = head(words.language.segment(), words.language.value());
        Self { lengths, ..Self::of(context, Table::new(head, rows), place) }
    }

    /// A table with boxes for the quantities to be found. Only lengths on paper have a scale.
    pub(super) fn blank(context: &SheetContext<'_>, asked: &[QuantityRequest], place: TablePlace) -> Self {
        let language = context.words.language;
        let blank = |(asked, number): (&QuantityRequest, usize)| {
            let is_length = asked.is_distance();
            let scale = if is_length { asked.sheet().facts().scale_symbol } else { "" };
            let texts = row(&context.quantity(asked), "", scale, "", &asked.kind().unit(context.solution.scene.units));
            let boxes: &'static [usize] = if is_length { &[MILLIMETRES, VALUES] } else { &[VALUES] };
            Cells { boxes, ..Cells::new(texts, format!("box-{number}")) }
        };
        let head = head(language.column_quantity(), language.value());
        let mut table = Table::new(head, asked.iter().zip(1..).map(blank).collect());
        [table.head[MILLIMETRES].width, table.head[VALUES].width] = BOXES;
        Self::of(context, table, place)
    }

    /// The table of a key beside panels. Millimetres of a panel without a scale are those at its largest.
    pub(super) fn key(context: &SheetContext<'_>, panels: &[Panel<'_>], rows: &[KeyRow<'_>]) -> Self {
        let (words, page) = (context.words, context.surface.page.size_mm());
        let cells = rows.iter().zip(1..).map(|(KeyRow { asked, value, allowed }, number)| {
            let is_its = |panel: &&Panel<'_>| {
                let sheet = panel.needs.sheet;
                sheet == asked.sheet() && sheet.facts().drawn == asked.kind() && asked.is_length_on_sheet()
            };
            let panel = panels.iter().find(is_its);
            let mm = panel.map(|panel| words.write(value / least(panel, page), HUNDREDTHS));
            let scale = panel.map_or("", |panel| panel.needs.sheet.facts().scale_symbol);
            let unit = asked.kind().unit(context.solution.scene.units);
            let name = context.quantity(asked);
            let mut texts = row(&name, &mm.unwrap_or_default(), scale, &words.write(*value, VALUE), &unit);
            let allowed = allowed.map(|allowed| format!("± {}", words.write(allowed, ALLOWED)));
            texts.insert(VALUES + 1, RichText::plain(&allowed.unwrap_or_default()));
            Cells::new(texts, format!("key-{number}"))
        });
        let mut head = head(words.language.column_quantity(), words.language.value());
        head.insert(VALUES + 1, Heading::new(RichText::plain("±"), "allowed", false));
        Self::of(context, Table::new(head, cells.collect()), TablePlace::Anywhere)
    }

    /// A table with room for the ruler.
    fn of(context: &SheetContext<'_>, table: Table, place: TablePlace) -> Self {
        let table = Table { foot: (RULER_ROOM, RULER_ROWS), ..table };
        Self { table, lengths: Vec::new(), words: context.words, unit: context.surface.dims.unit, place }
    }

    /// The table with millimetres at a layout's scales.
    fn at_scales(&self, layout: &Layout) -> Table {
        let mut table = self.table.clone();
        for (row, length) in table.rows.iter_mut().zip(&self.lengths) {
            if let Some((value, mu)) = length.and_then(|(value, sheet)| Some((value, layout.mu_of(sheet)?))) {
                row.texts[MILLIMETRES] = RichText::plain(&millimetres(&self.words, value, mu));
            }
        }
        table
    }

    /// The table at these scales, without room for a ruler.
    pub(super) fn filled(&self, layout: &Layout) -> Table {
        Table { foot: ([0.0; 2], 0), ..self.at_scales(layout) }
    }
}

impl Item for Worksheet {
    fn asides(&self, room: Rect) -> Vec<Aside> {
        match self.place {
            TablePlace::Beside => self.table.asides_at_full_size(room),
            _ => self.table.asides(room),
        }
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, aside: Option<Rect>) {
        let Some(area) = aside else { return };
        let foot = self.at_scales(layout).draw_in(drawing, area);
        // The ruler stands in the foot with its words above it.
        let from = foot + Vec2::new(2.0, -RULER_ROOM[1]);
        drawing.caption(RichText::plain(self.words.language.ruler()), from + Vec2::new(0.0, 4.2));
        ruler(drawing, from + Vec2::new(0.0, 7.4), self.unit);
    }
}

/// The texts of a row.
fn row(name: &str, mm: &str, scale: &str, value: &str, unit: &str) -> Vec<RichText> {
    let [mm, value, unit] = [mm, value, unit].map(RichText::plain);
    vec![RichText::math(name), mm, RichText::math(scale), value, unit]
}

/// The least scale of a panel: it is no larger than the page, so millimetres at this scale are the widest.
fn least(panel: &Panel<'_>, page: [f64; 2]) -> f64 {
    let size = panel.needs.extent.size();
    panel.needs.mu.unwrap_or((size.x / page[0]).max(size.y / page[1]))
}

/// The headings of rows, with these over names and values.
fn head(name: &str, value: &str) -> Vec<Heading> {
    let all =
        [(name, "name", false), ("mm", "mm", true), ("μ", "scale", false), (value, "value", true), ("", "unit", false)];
    all.map(|(text, id, is_number)| Heading::new(RichText::plain(text), id, is_number)).to_vec()
}

/// A value in millimetres of paper at a scale; a dash where no paper is long enough.
fn millimetres(words: &Wording, value: f64, mu: f64) -> String {
    let mm = if mu > 0.0 { words.on_paper(value, mu, HUNDREDTHS) } else { Some(words.write(0.0, HUNDREDTHS)) };
    mm.unwrap_or_else(|| "–".to_owned())
}

/// The measurements between visible points, in the order of the construction: step, plan, ends, value.
fn measured<'a>(context: &'a SheetContext<'_>) -> impl Iterator<Item = (NumberedStep<'a>, [&'a str; 2], f64)> {
    let is_hidden = |plan: Option<&Plan>, name: &str| match plan {
        Some(plan) => is_hidden(context.figure(), plan, name),
        None => !context.figure().special_points && context.construction().special_point(name).is_some(),
    };
    context.construction().numbered_steps().filter_map(move |step| match &step.action {
        Action::Measure { from, to, value } => {
            let hidden = is_hidden(step.plan, from) || is_hidden(step.plan, to);
            (!hidden).then_some((step, [from.as_str(), to.as_str()], *value))
        }
        _ => None,
    })
}

/// Lines that a ruler is as high as.
const LINES_BESIDE: usize = 2;
/// White before the ruler's words and between them and the ruler, in mm.
const BEFORE: f64 = 3.0;
/// Room after the ruler for its last number with the unit, in mm.
const AFTER: f64 = 12.0;

/// Height of the ruler with its numbers, in mm.
const HEIGHT: f64 = 11.0;

/// A ruler at the right end of the area below the scales, for a sheet without the table; words before it.
pub(super) struct Ruler {
    words: RichText,
    unit: f64,
    /// Height of the lines of words above it, in mm.
    lines: f64,
}

impl Ruler {
    pub(super) fn new(context: &SheetContext<'_>) -> Self {
        Self { words: RichText::plain(context.words.language.ruler()), unit: context.surface.dims.unit, lines: 0.0 }
    }

    /// A ruler beside lines of words, or below them where it has no room beside.
    pub(super) fn with_lines(context: &SheetContext<'_>, lines: &Lines) -> Self {
        let ruler = Ruler::new(context);
        let width = |line: &RichText| line.width(CAPTION) + PAD;
        let widest = lines.lines.iter().take(LINES_BESIDE).map(width).fold(0.0, f64::max);
        let is_beside = widest + ruler.width() <= context.surface.dims.width_below();
        Self { lines: if is_beside { 0.0 } else { lines.height() }, ..ruler }
    }

    /// A ruler beside words that make room for it, given the width that is kept free, or below them where that is lower:
    /// on a narrow sheet words beside it would be a column.
    pub(super) fn with_words(context: &SheetContext<'_>, said: impl Fn(f64) -> Lines) -> (Ruler, Lines) {
        let ruler = Ruler::new(context);
        let (beside, above) = (said(ruler.width()), said(0.0));
        match beside.height() <= above.height() + HEIGHT {
            true => (ruler, beside),
            false => (Ruler { lines: above.height(), ..ruler }, above),
        }
    }

    /// Width of the area that is kept free, in mm.
    pub(super) fn width(&self) -> f64 {
        self.words.width(CAPTION) + 2.0 * BEFORE + RULER / self.unit + AFTER
    }
}

impl Item for Ruler {
    fn height(&self) -> f64 {
        self.lines + HEIGHT
    }

    fn draw(&self, drawing: &mut Drawing, layout: &Layout, _: Option<Rect>) {
        let area = layout.below;
        let from = Point::new(area.x1 - self.width() + BEFORE, area.y0 + self.lines + 4.6);
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
