//! The box below the panels: their scales, and the sentences under these.

use super::context::{SheetContext, Surface};
use super::dims::Dims;
use super::layout::{Item, Layout};
use super::lines::{EDGE, Lines, PAD};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{CAPTION, RichText};
use crate::cycle::Times;
use crate::scene::{PageSize, Units};
use crate::sheet::Sheet;
use crate::text::Untrusted;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::Point;

/// Height of a row of scales, in mm.
const ROW: f64 = 7.2;
/// Length of the bar beside a scale, in mm of paper.
const BAR: f64 = 10.0;
/// Least white between scales in one row, in mm.
const LEAST_GAP: f64 = 6.0;
/// Most white between scales in one row, in mm.
const MOST_GAP: f64 = 24.0;
/// Number style of scales.
pub(super) const SCALE: NumberStyle = NumberStyle::decimals(6).trimmed().in_full(-4, 6);
/// Number style of values in tables and words.
pub(super) const VALUE: NumberStyle = NumberStyle::significant(5).in_full(-4, 7).on(Medium::Figure);
/// Number style of lengths on paper and angles.
pub(super) const HUNDREDTHS: NumberStyle = NumberStyle::decimals(2).on(Medium::Figure);
/// Number style of the steps between ticks.
const STEP: NumberStyle = NumberStyle::significant(3).trimmed().in_full(-3, 6).on(Medium::Figure);
/// Number style of the difference between construction and loop equations.
const BOUND: NumberStyle = NumberStyle::bound().on(Medium::Figure);

/// Height of the scales of some panels in so many columns, in mm.
pub(super) fn height(panels: usize, columns: usize) -> f64 {
    ROW * panels.max(1).div_ceil(columns) as f64 + EDGE
}

/// A scale, and a bar of a round value.
pub(super) struct Entry {
    symbol: RichText,
    value: RichText,
    bar: RichText,
    /// Length of the bar, in units of the layout.
    length: f64,
}

impl Entry {
    pub(super) fn width(&self) -> f64 {
        self.places()[2]
    }

    /// Distances from the entry's start, in mm: of its bar, of the bar's value, of its end.
    fn places(&self) -> [f64; 3] {
        let bar = self.symbol.width(CAPTION) + 1.2 + self.value.width(CAPTION) + 3.0;
        let value = bar + self.length + 1.4;
        [bar, value, value + self.bar.width(CAPTION)]
    }

    /// Draws it from the left end `from` of its baseline.
    pub(super) fn draw(&self, drawing: &mut Drawing, from: Point) {
        let mut put = |text: &RichText, x: f64| {
            drawing.caption(text.clone(), Point::new(from.x + x, from.y));
        };
        let [bar, value, _] = self.places();
        put(&self.symbol, 0.0);
        put(&self.value, self.symbol.width(CAPTION) + 1.2);
        put(&self.bar, value);
        let y = from.y - 1.3;
        let ends = [bar, bar + self.length].map(|x| Point::new(from.x + x, y));
        drawing.draw(Pen::Ground, Shape::Line(ends[0], ends[1]));
        for end in ends {
            let tick = Shape::Line(Point::new(end.x, y - 0.9), Point::new(end.x, y + 0.9));
            drawing.draw(Pen::Ground, tick);
        }
    }
}

fn fit_columns(widths: &[f64], layout: &Layout) -> bool {
    let column = layout.legend.width() / layout.columns as f64;
    widths.iter().all(|width| *width <= column - PAD)
}

/// White between scales that share a row whatever their widths, in mm.
fn gap(widths: &[f64], layout: &Layout) -> f64 {
    let free = layout.legend.width() - 2.0 * PAD - widths.iter().sum::<f64>();
    (free / widths.len().saturating_sub(1).max(1) as f64).min(MOST_GAP)
}

/// The box with the scales of the panels, and room for words below them.
#[derive(Clone, Copy)]
pub(super) struct Legend {
    pub words: Wording,
    pub units: Units,
    pub dims: Dims,
}

impl Legend {
    pub(super) fn of(context: &SheetContext<'_>) -> Legend {
        Legend { words: context.words, units: context.solution.scene.units, dims: context.surface.dims }
    }

    /// The scale of a sheet: `mu` units a millimetre.
    pub(super) fn entry(&self, sheet: Sheet, mu: f64) -> Entry {
        let unit = sheet.facts().drawn.unit(self.units);
        let per_mm = if unit.contains('/') { format!("({unit})/mm") } else { format!("{unit}/mm") };
        let [value, bar] = [mu, BAR * mu].map(|value| self.words.write(value, SCALE));
        Entry {
            symbol: RichText::math(sheet.facts().scale_symbol),
            value: RichText::plain(&format!("= {value} {per_mm}")),
            bar: RichText::plain(&format!("{bar} {unit}")),
            length: BAR / self.dims.unit,
        }
    }

    /// The scales of a layout, and their widths in mm.
    fn entries(&self, layout: &Layout) -> (Vec<Entry>, Vec<f64>) {
        let entries: Vec<Entry> =
            layout.panels.iter().map(|placed| self.entry(placed.needs.sheet, placed.mu)).collect();
        let widths = entries.iter().map(Entry::width).collect();
        (entries, widths)
    }

    /// Whether the scales fit into the layout's columns, or all into one row.
    pub(super) fn fits(&self, layout: &Layout) -> bool {
        let (_, widths) = self.entries(layout);
        fit_columns(&widths, layout) || (layout.columns >= widths.len() && gap(&widths, layout) >= LEAST_GAP)
    }
}

impl Item for Legend {
    fn draw(&self, drawing: &mut Drawing, layout: &Layout) {
        let area = layout.legend;
        drawing.draw(Pen::Frame, Shape::rectangle(area));
        let column = area.width() / layout.columns as f64;
        let (entries, widths) = self.entries(layout);
        let (in_columns, gap) = (fit_columns(&widths, layout), gap(&widths, layout));
        for (index, entry) in entries.iter().enumerate() {
            let (row, place) = (index / layout.columns, index % layout.columns);
            let before: f64 = widths[..index].iter().map(|width| width + gap).sum();
            let x = area.x0 + PAD + if in_columns || row > 0 { column * place as f64 } else { before };
            let y = area.y0 + 0.5 * EDGE + 5.0 + ROW * row as f64;
            entry.draw(drawing, Point::new(x, y));
        }
    }
}

/// The sentences on paths, if there are any, and on how the construction agrees with the loop equations. Beside values
/// and on a projector only what is not as it should be is said. They are there in all steps or only in `step`; `beside` mm of
/// the width are kept free.
pub(super) fn agreement(context: &SheetContext<'_>, step: Option<u16>, beside: f64) -> Lines {
    let (sentence, agrees) = routes(context);
    let Surface { page, dims, .. } = context.surface;
    let is_projected = page.size == PageSize::Wide || dims.unit > 1.0;
    let is_said = !agrees || (context.values.is_empty() && !is_projected);
    let sentence = is_said.then_some(sentence);
    Lines {
        step,
        ..Lines::of(sentence_on_paths(context).iter().chain(&sentence), context.surface.dims.width_below() - beside)
    }
}

/// The sentence on the agreement of the construction with the loop equations, and whether they agree.
fn routes(context: &SheetContext<'_>) -> (String, bool) {
    let (language, construction) = (context.words.language, context.construction());
    let known = construction.agreement.iter().flatten();
    let worst = known.max_by(|a, b| a.difference.total_cmp(&b.difference));
    match worst {
        Some(worst) if construction.agreement.iter().all(Option::is_some) => {
            let [difference, allowed] = [worst.difference, worst.allowed].map(|x| context.words.write(x, BOUND));
            (language.agreement(&difference, &allowed), true)
        }
        _ => {
            let far = construction.special.iter().any(|special| special.place.finite().is_none());
            let why = if far { language.one_route_far() } else { language.one_route() };
            (why.to_owned(), false)
        }
    }
}

/// The sentence on the paths and their ticks, in markup.
pub(super) fn sentence_on_paths(context: &SheetContext<'_>) -> Option<String> {
    let Times { drive, step, time, .. } = context.traces.times.as_ref()?;
    let shown = |name: &str| context.shown(name, None);
    let points: Vec<String> = context.traces.paths.iter().map(|path| shown(&path.name)).collect();
    let (language, units) = (context.words.language, context.solution.scene.units);
    let number = |value: f64| context.words.write(value, STEP);
    let step = match drive.is_angle {
        true => format!("{}°", number(*step)),
        false => format!("{} {}", number(*step), units.length.as_str()),
    };
    let drive = context.figure().labels.get(&drive.name).map_or_else(|| drive.name.clone(), Untrusted::for_setting);
    let points = points.join(", ");
    let mut sentence = match time {
        Some(time) => {
            let time = format!("{} {}", number(*time), units.time.as_str());
            language.paths_in_time(&points, &step, &drive, &time)
        }
        None => language.paths(&points, &step, &drive),
    };
    if context.traces.paths.iter().any(|path| !path.beyond.is_empty()) {
        sentence = format!("{sentence} {}", language.paths_beyond());
    }
    Some(sentence)
}
