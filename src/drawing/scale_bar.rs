//! The scale of a panel: on paper the units that a millimetre stands for, with a bar; elsewhere a bar alone, for nobody
//! lays a ruler on a screen.

use super::context::SheetContext;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{CAPTION, RichText};
use super::view::{Series, next_of};
use crate::scene::Units;
use crate::sheet::Sheet;
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::{Point, Rect};

/// Length of the bar beside a scale, in mm of paper.
const BAR: f64 = 10.0;
/// Least and most length of a bar alone, in units of the layout.
const ALONE: [f64; 2] = [6.0, 24.0];
/// White between the parts of a scale, in mm.
const GAPS: [f64; 3] = [1.2, 3.0, 1.4];
/// Half the height of the bar's ends, in mm.
const TICK: f64 = 0.9;
/// Number style of scales.
pub(super) const SCALE: NumberStyle = NumberStyle::decimals(6).trimmed().in_full(-4, 6);
/// The same on a sheet.
const ON_SHEET: NumberStyle = SCALE.on(Medium::Figure);

/// What scales are written with.
#[derive(Clone, Copy)]
pub(super) struct ScaleBars {
    pub words: Wording,
    pub units: Units,
    /// A unit of the layout, in mm of paper.
    pub unit: f64,
    pub series: Series,
}

/// What a scale is of.
pub(super) struct Scaled<'a> {
    pub symbol: &'a str,
    pub unit: String,
}

/// A scale, and a bar of a round value.
pub(super) struct ScaleBar {
    /// Symbol and value; none where the bar stands alone.
    value: Option<[RichText; 2]>,
    /// What the bar stands for, and its length in units of the layout; none where it has no room.
    bar: Option<(RichText, f64)>,
}

impl ScaleBars {
    pub(super) fn of(context: &SheetContext<'_>) -> ScaleBars {
        let surface = context.surface;
        let units = context.solution.scene.units;
        ScaleBars { words: context.words, units, unit: surface.dims.unit, series: surface.series }
    }

    /// The scale of a sheet: `mu` units a millimetre.
    pub(super) fn bar(&self, sheet: Sheet, mu: f64) -> ScaleBar {
        self.whole(&self.of_sheet(sheet), mu)
    }

    /// Symbol and unit of the scale of a sheet.
    fn of_sheet(&self, sheet: Sheet) -> Scaled<'static> {
        Scaled { symbol: sheet.facts().scale_symbol, unit: sheet.facts().drawn.unit(self.units) }
    }

    fn whole(&self, scaled: &Scaled<'_>, mu: f64) -> ScaleBar {
        if self.series == Series::Any {
            return self.alone(scaled, mu, ALONE[1]);
        }
        let text = format!("{} {}", self.words.write(BAR * mu, ON_SHEET), scaled.unit);
        ScaleBar { value: Some(self.value(scaled, mu)), bar: Some((RichText::plain(&text), BAR / self.unit)) }
    }

    /// The scale of a sheet in a room of that width in mm: without the bar, or with a shorter one alone.
    pub(super) fn bar_within(&self, sheet: Sheet, mu: f64, width: f64) -> ScaleBar {
        self.scaled_within(&self.of_sheet(sheet), mu, width)
    }

    /// The same of any scale.
    pub(super) fn scaled_within(&self, scaled: &Scaled<'_>, mu: f64, width: f64) -> ScaleBar {
        let whole = self.whole(scaled, mu);
        if whole.width() <= width {
            return whole;
        }
        match self.series {
            Series::Any => {
                let length = whole.bar.as_ref().map_or(0.0, |(_, length)| *length);
                self.alone(scaled, mu, (length - whole.width() + width).max(ALONE[0]))
            }
            _ => ScaleBar { value: Some(self.value(scaled, mu)), bar: None },
        }
    }

    /// A bar of a round value of at most this length, in units of the layout.
    fn alone(&self, scaled: &Scaled<'_>, mu: f64, most: f64) -> ScaleBar {
        let mu = mu * self.unit;
        let shown = next_of(&[1.0, 2.0, 5.0], 0.4 * most * mu);
        let text = RichText::plain(&format!("{} {}", self.words.write(shown, ON_SHEET), scaled.unit));
        // Of a scale that is next to nothing no value is as small as a bar is short.
        let is_bar = shown / mu <= 2.0 * most;
        ScaleBar { value: None, bar: is_bar.then_some((text, shown / mu)) }
    }

    /// Width that the narrowest scale of a sheet needs, in mm; without a scale that of any from `mu` to ten times that.
    pub(super) fn least_width(&self, sheet: Sheet, given: Option<f64>, mu: f64) -> f64 {
        // Of the scales of a decade 1.25 and 2.5 have most digits, and 1000 has one more than 800.
        let longest = self.series.longest();
        let near = [0.1 * mu, mu, 10.0 * mu].map(|mu| given.unwrap_or_else(|| next_of(&[longest], mu)));
        let width = |mu: f64| match self.narrowest(sheet, mu) {
            // A bar alone has a round value, so its length is known with the scale alone.
            ScaleBar { value: None, bar: Some((text, _)) } => ALONE[0] + GAPS[2] + text.width(CAPTION),
            bar => bar.width(),
        };
        let count = if given.is_some() { 1 } else { near.len() };
        near.into_iter().take(count).map(width).fold(0.0, f64::max)
    }

    /// The narrowest scale of a sheet: without the bar, or with a short one alone.
    pub(super) fn narrowest(&self, sheet: Sheet, mu: f64) -> ScaleBar {
        match self.series {
            Series::Any => self.alone(&self.of_sheet(sheet), mu, ALONE[0]),
            _ => ScaleBar { value: Some(self.value(&self.of_sheet(sheet), mu)), bar: None },
        }
    }

    /// Symbol and value of a scale.
    fn value(&self, scaled: &Scaled<'_>, mu: f64) -> [RichText; 2] {
        let unit = &scaled.unit;
        let per_mm = if unit.contains('/') { format!("({unit})/mm") } else { format!("{unit}/mm") };
        let value = RichText::plain(&format!("= {} {per_mm}", self.words.write(mu, ON_SHEET)));
        [RichText::math(scaled.symbol), value]
    }
}

impl ScaleBar {
    pub(super) fn width(&self) -> f64 {
        let value =
            self.value.as_ref().map(|texts| texts.iter().map(|text| text.width(CAPTION)).sum::<f64>() + GAPS[0]);
        let bar = self.bar.as_ref().map(|(text, length)| length + GAPS[2] + text.width(CAPTION));
        value.unwrap_or(0.0) + bar.unwrap_or(0.0) + if value.is_some() && bar.is_some() { GAPS[1] } else { 0.0 }
    }

    /// Draws it from the left end of its baseline, the bar with this id.
    pub(super) fn draw(&self, drawing: &mut Drawing, from: Point, id: Option<String>) -> Rect {
        let mut x = from.x;
        if let Some([symbol, value]) = &self.value {
            drawing.caption(symbol.clone(), from);
            x += symbol.width(CAPTION) + GAPS[0];
            drawing.caption(value.clone(), Point::new(x, from.y));
            x += value.width(CAPTION) + GAPS[1];
        }
        if let Some((text, length)) = &self.bar {
            let y = from.y - 1.3;
            let ends = [x, x + length].map(|x| Point::new(x, y));
            drawing.draw(Pen::Ground, Shape::Line(ends[0], ends[1])).id = id;
            for end in ends {
                drawing.draw(Pen::Ground, Shape::Line(Point::new(end.x, y - TICK), Point::new(end.x, y + TICK)));
            }
            drawing.caption(text.clone(), Point::new(x + length + GAPS[2], from.y));
        }
        Rect::new(from.x, from.y - CAPTION, from.x + self.width(), from.y + 0.3 * CAPTION)
    }
}
