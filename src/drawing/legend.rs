use super::canvas::CAPTION;
use super::layout::Placed;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::text::{PlacedText, RichText};
use crate::plan::Construction;
use crate::scene::{Panel, Units};
use crate::words::{Language, Wording};
use kurbo::{Point, Rect};

/// The box with the scales, each with a bar of a round value.
pub(super) fn draw(
    drawing: &mut Drawing,
    area: Rect,
    words: &Wording,
    units: Units,
    panels: &[Placed],
) {
    drawing.draw(Pen::Frame, Shape::Polygon(corners(area)));
    let column = area.width() / 3.0;
    let (length, time) = (units.length.as_str(), units.time.as_str());
    for (index, placed) in panels.iter().enumerate() {
        let (name, unit) = match placed.panel {
            Panel::Scheme => ("μ_l", length.to_owned()),
            Panel::Velocity => ("μ_v", format!("{length}/{time}")),
            Panel::Acceleration => ("μ_a", format!("{length}/{time}²")),
        };
        let x = area.x0 + 4.0 + column * index as f64;
        let per_mm = if unit.contains('/') {
            format!("({unit})/mm")
        } else {
            format!("{unit}/mm")
        };
        let baseline = area.y0 + 5.6;
        let symbol = PlacedText::new(
            RichText::math(name),
            CAPTION * 1.15,
            Point::new(x, baseline),
        );
        let after = x + symbol.text.width(symbol.size) + 1.2;
        drawing.draw(Pen::Caption, Shape::Text(symbol));
        let value = format!("= {} {per_mm}", short(words, placed.mu));
        let value = PlacedText::new(
            RichText::plain(&value),
            CAPTION,
            Point::new(after, baseline),
        );
        let bar_from = after + value.text.width(CAPTION) + 4.0;
        drawing.draw(Pen::Caption, Shape::Text(value));
        // A bar of ten millimetres of paper.
        let y = baseline - 1.0;
        let (a, b) = (Point::new(bar_from, y), Point::new(bar_from + 10.0, y));
        drawing.draw(Pen::Ground, Shape::Line(a, b));
        for end in [a, b] {
            let tick = Shape::Line(Point::new(end.x, y - 0.9), Point::new(end.x, y + 0.9));
            drawing.draw(Pen::Ground, tick);
        }
        let bar = format!("{} {unit}", short(words, 10.0 * placed.mu));
        let bar = PlacedText::new(
            RichText::plain(&bar),
            0.9 * CAPTION,
            Point::new(b.x + 1.4, baseline),
        );
        drawing.draw(Pen::Caption, Shape::Text(bar));
    }
}

/// Below the scales: how the construction and the loop equations agree.
pub(super) fn agreement(
    drawing: &mut Drawing,
    area: Rect,
    words: &Wording,
    construction: &Construction,
) {
    let text = PlacedText::new(
        RichText::plain(&comparison(words.language, construction)),
        0.95 * CAPTION,
        Point::new(area.x0 + 4.0, area.y0 + 12.6),
    );
    drawing.draw(Pen::Caption, Shape::Text(text));
}

/// How the construction and the loop equations agree, in words.
fn comparison(language: &Language, construction: &Construction) -> String {
    let known = construction.agreement.iter().flatten();
    let worst = known.max_by(|a, b| a.difference.total_cmp(&b.difference));
    match worst {
        Some(worst) if construction.agreement.iter().all(Option::is_some) => {
            (language.agreement)(&power(worst.difference), &power(worst.allowed))
        }
        _ => {
            let mut special = construction.special.iter().flatten();
            let far = special.any(|s| s.place.finite().is_none());
            let why = if far {
                language.one_route_far
            } else {
                language.one_route
            };
            why.to_owned()
        }
    }
}

/// A small number as a digit and a power of ten, rounded up.
fn power(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let mut exponent = libm::floor(libm::log10(x)) as i32;
    let mut digit = (x / libm::pow(10.0, f64::from(exponent))).ceil();
    if digit >= 10.0 {
        (digit, exponent) = (1.0, exponent + 1);
    }
    format!("{digit}·10^{{{}}}", exponent.to_string().replace('-', "−"))
}

/// A scale value without superfluous digits.
pub(super) fn short(words: &Wording, x: f64) -> String {
    if x != 0.0 && !(1e-4..1e6).contains(&x.abs()) {
        return words.number(format!("{x:e}"));
    }
    let text = format!("{x:.6}");
    words.number(text.trim_end_matches('0').trim_end_matches('.').to_owned())
}

pub(super) fn corners(r: Rect) -> Vec<Point> {
    vec![
        Point::new(r.x0, r.y0),
        Point::new(r.x1, r.y0),
        Point::new(r.x1, r.y1),
        Point::new(r.x0, r.y1),
    ]
}
