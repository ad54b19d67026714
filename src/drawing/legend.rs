use super::canvas::CAPTION;
use super::layout::{Layout, MARGIN, Placed};
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{PlacedText, RichText};
use crate::construction::Construction;
use crate::quantity::Kind;
use crate::scene::{Panel, Units};
use crate::words::{Medium, NumberStyle, Wording};
use kurbo::{Point, Rect};

/// White inside the legend's frame, left and right.
pub(super) const PAD: f64 = 4.0;
/// Height of a row of scales.
const ROW: f64 = 7.2;
/// Height of a line of words.
const LINE: f64 = 6.0;
/// Above and below the rows of scales, and below the words.
const EDGE: f64 = 2.2;
/// Length of the bar beside a scale.
const BAR: f64 = 10.0;
/// How scales are written.
pub(super) const SCALE: NumberStyle = NumberStyle::decimals(6).trimmed().in_full(-4, 6);
/// How it is written how far two routes differ.
const BOUND: NumberStyle = NumberStyle::bound().on(Medium::Figure);

/// Room for the scales of some panels in so many columns, in mm.
pub(super) fn height(panels: usize, columns: usize) -> f64 {
    ROW * panels.max(1).div_ceil(columns) as f64 + EDGE
}

/// A scale, and a bar of a round value.
pub(super) struct Entry {
    symbol: RichText,
    value: RichText,
    bar: RichText,
}

impl Entry {
    /// The scale of that symbol: `mu` units a millimetre.
    pub(super) fn new(symbol: &str, unit: &str, mu: f64, words: &Wording) -> Self {
        let per_mm = if unit.contains('/') { format!("({unit})/mm") } else { format!("{unit}/mm") };
        let value = words.write(mu, SCALE);
        let bar = words.write(BAR * mu, SCALE);
        Self {
            symbol: RichText::math(symbol),
            value: RichText::plain(&format!("= {value} {per_mm}")),
            bar: RichText::plain(&format!("{bar} {unit}")),
        }
    }

    fn of(placed: &Placed, words: &Wording, units: Units) -> Self {
        let (symbol, kind) = match placed.panel {
            Panel::Scheme => ("μ_l", Kind::Length),
            Panel::Velocity => ("μ_v", Kind::Velocity),
            Panel::Acceleration => ("μ_a", Kind::Acceleration),
        };
        Self::new(symbol, &kind.unit(units), placed.mu, words)
    }

    pub(super) fn width(&self) -> f64 {
        self.places()[2]
    }

    /// Where bar and its value begin, from the entry's own begin, and where it ends.
    fn places(&self) -> [f64; 3] {
        let bar = self.symbol.width(CAPTION) + 1.2 + self.value.width(CAPTION) + 3.0;
        let value = bar + BAR + 1.4;
        [bar, value, value + self.bar.width(CAPTION)]
    }

    /// Draws it from the left end of its baseline.
    pub(super) fn draw(&self, drawing: &mut Drawing, from: Point) {
        let mut put = |text: &RichText, x: f64| {
            let text = PlacedText::new(text.clone(), CAPTION, Point::new(from.x + x, from.y));
            drawing.draw(Pen::Caption, Shape::Text(text));
        };
        let [bar, value, _] = self.places();
        put(&self.symbol, 0.0);
        put(&self.value, self.symbol.width(CAPTION) + 1.2);
        put(&self.bar, value);
        let y = from.y - 1.3;
        let ends = [bar, bar + BAR].map(|x| Point::new(from.x + x, y));
        drawing.draw(Pen::Ground, Shape::Line(ends[0], ends[1]));
        for end in ends {
            let tick = Shape::Line(Point::new(end.x, y - 0.9), Point::new(end.x, y + 0.9));
            drawing.draw(Pen::Ground, tick);
        }
    }
}

/// Whether the scales find room in the layout's columns.
pub(super) fn fits(layout: &Layout, words: &Wording, units: Units) -> bool {
    let column = layout.legend.width() / layout.columns as f64;
    let entries = layout.panels.iter().map(|p| Entry::of(p, words, units));
    let mut widths = entries.map(|entry| entry.width());
    widths.all(|width| width <= column - PAD)
}

/// The box with the scales.
pub(super) fn draw(drawing: &mut Drawing, layout: &Layout, words: &Wording, units: Units) {
    let area = layout.legend;
    drawing.draw(Pen::Frame, Shape::Polygon(corners(area)));
    let column = area.width() / layout.columns as f64;
    for (index, placed) in layout.panels.iter().enumerate() {
        let (row, place) = (index / layout.columns, index % layout.columns);
        let x = area.x0 + PAD + column * place as f64;
        let y = area.y0 + 0.5 * EDGE + 5.0 + ROW * row as f64;
        Entry::of(placed, words, units).draw(drawing, Point::new(x, y));
    }
}

/// How the construction and the loop equations agree, in lines for a sheet of that width.
pub(super) fn agreement(words: &Wording, construction: &Construction, page: f64) -> Vec<RichText> {
    lines(&comparison(words, construction), page)
}

/// A sentence in lines for a sheet of that width.
pub(super) fn lines(sentence: &str, page: f64) -> Vec<RichText> {
    RichText::lines(sentence, CAPTION, words_width([page, 0.0]))
}

/// How wide lines of words below the scales may be.
pub(super) fn words_width([width, _]: [f64; 2]) -> f64 {
    width - 2.0 * (MARGIN + PAD)
}

/// Room for so many lines below the scales, in mm.
pub(super) fn height_of_lines(lines: usize) -> f64 {
    LINE * lines as f64 + EDGE
}

/// Writes lines below the scales.
pub(super) fn draw_lines(drawing: &mut Drawing, layout: &Layout, lines: Vec<RichText>) {
    let mut area = layout.legend;
    area.y0 += layout.scales;
    draw_lines_in(drawing, area, 0, lines);
}

/// Writes lines from the upper edge of an area, below as many others.
pub(super) fn draw_lines_in(drawing: &mut Drawing, area: Rect, before: usize, lines: Vec<RichText>) {
    for (index, line) in lines.into_iter().enumerate() {
        let text = PlacedText::new(line, CAPTION, baseline(area, before + index));
        drawing.draw(Pen::Caption, Shape::Text(text));
    }
}

/// Where a line of an area begins.
pub(super) fn baseline(area: Rect, line: usize) -> Point {
    Point::new(area.x0 + PAD, area.y0 + 4.6 + LINE * line as f64)
}

/// How the construction and the loop equations agree, in words.
fn comparison(words: &Wording, construction: &Construction) -> String {
    let language = words.language;
    let known = construction.agreement.iter().flatten();
    let worst = known.max_by(|a, b| a.difference.total_cmp(&b.difference));
    match worst {
        Some(worst) if construction.agreement.iter().all(Option::is_some) => {
            let [difference, allowed] = [worst.difference, worst.allowed].map(|x| words.write(x, BOUND));
            language.agreement(&difference, &allowed)
        }
        _ => {
            let mut special = construction.special.iter().flatten();
            let far = special.any(|s| s.place.finite().is_none());
            let why = if far { language.one_route_far() } else { language.one_route() };
            why.to_owned()
        }
    }
}

pub(super) fn corners(r: Rect) -> Vec<Point> {
    vec![Point::new(r.x0, r.y0), Point::new(r.x1, r.y0), Point::new(r.x1, r.y1), Point::new(r.x0, r.y1)]
}
