//! The parallels through the pole, and what they cut off the base, with its names and numbers in one row.

use super::{DiagramOnPaper, TICK};
use crate::accuracy::{Bounds, bounds};
use crate::construction::{PitchCircle, Solution};
use crate::drawing::canvas::Canvas;
use crate::drawing::context::SheetContext;
use crate::drawing::labels::LabelRequest;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::drawing::text::{Anchor, BESIDE, LABEL, PlacedText, RichText};
use crate::drawing::values::VALUE;
use crate::mechanism::BodyId;
use kurbo::{Point, Vec2};
use std::cell::OnceCell;

/// Radius of the pole, in mm.
const POLE: f64 = 1.1;
/// How far the base goes beyond its marks, in mm.
const BEYOND: f64 = 3.0;
/// From the ends of the marks to the upper edge of the names, and from their baseline to that of the numbers, in mm.
const DROP: f64 = 2.4;
const LINE: f64 = 4.9;
/// Height of a name above its baseline, in mm.
const HEIGHT: f64 = 2.6;
/// What marks, names and numbers take below the base, in mm.
pub(super) const BELOW: f64 = TICK + DROP + HEIGHT + LINE + 1.3;
/// A name less than that beside its mark needs no line to it, in mm.
const BELOW_MARK: f64 = 0.8;

/// What stands at a mark of the base.
struct Named {
    /// The mark.
    at: Point,
    /// The first of its lines.
    line: usize,
    symbol: RichText,
    number: RichText,
    step: u16,
}

impl Named {
    fn width(&self) -> f64 {
        self.symbol.ink_box(LABEL).width().max(self.number.ink_box(LABEL).width())
    }
}

/// Which links turn equally: their numbers say so, and not how close their marks are on paper.
struct Alike<'a> {
    solution: &'a Solution,
    bounds: OnceCell<Bounds<'a>>,
}

/// Angular velocities that differ by more than this part of the larger one differ by more than any error of theirs.
const APART: f64 = 1e-6;

impl<'a> Alike<'a> {
    fn of(context: &'a SheetContext<'_>) -> Alike<'a> {
        Alike { solution: context.solution, bounds: OnceCell::new() }
    }

    /// Whether the angular velocities of two links are equal within the errors of both.
    fn turn(&self, first: BodyId, second: BodyId) -> bool {
        let Solution { scene, mechanism, pose, motion, .. } = self.solution;
        let [one, other] = [first, second].map(|link| motion.body(link).omega);
        if one == other || (one - other).abs() > APART * one.abs().max(other.abs()) {
            return one == other;
        }
        let bounds = self.bounds.get_or_init(|| bounds(scene, mechanism, pose, motion));
        (one - other).abs() <= [first, second].map(|link| bounds.angular_rates(link)[0]).iter().sum()
    }
}

impl DiagramOnPaper<'_> {
    /// The parallels through the pole, and what they cut off the base.
    pub(super) fn fan(&self, canvas: &mut Canvas<'_>) {
        canvas.step = self.steps.pole;
        let pole = self.at(self.layout.zero, self.layout.pole);
        let foot = self.at(self.layout.zero, self.layout.base);
        let turning =
            || self.diagram.lines.iter().zip(&self.steps.rays).enumerate().filter(|(_, (line, _))| !line.slides);
        let cuts: Vec<Point> = turning().map(|(_, (line, _))| self.view.at(self.layout.cut(line))).collect();
        let (low, high) = cuts.iter().fold((foot.x, foot.x), |(low, high), cut| (low.min(cut.x), high.max(cut.x)));
        let base = [Point::new(low - BEYOND, foot.y), Point::new(high + BEYOND, foot.y)];
        canvas.draw(Pen::Frame, Shape::Line(base[0], base[1]));
        canvas.draw(Pen::Frame, Shape::Line(pole, foot));
        canvas.draw(Pen::Pole, Shape::Circle { center: pole, radius: POLE });
        canvas.ask("pole", LabelRequest::new(RichText::math("o"), pole, POLE + 0.5, None, 2));
        let alike = Alike::of(self.context);
        let mut marks: Vec<(Point, Vec<(usize, u16)>)> = Vec::new();
        for ((index, (line, &step)), cut) in turning().zip(cuts) {
            canvas.step = step;
            let name = &self.context.mechanism().body(line.link).name;
            canvas.draw_named(&format!("ray-{name}"), Pen::Ray, Shape::Line(pole, cut)).number =
                self.context.number(line.link);
            let stroke = Vec2::new(0.0, TICK);
            canvas.draw(Pen::Frame, Shape::Line(cut - stroke, cut + stroke));
            let same = marks.iter_mut().find(|(_, lines)| alike.turn(self.diagram.lines[lines[0].0].link, line.link));
            match same {
                Some((_, lines)) => lines.push((index, step)),
                None => marks.push((cut, vec![(index, step)])),
            }
        }
        let mut named: Vec<Named> = marks.into_iter().map(|(at, lines)| self.named(at, &lines)).collect();
        named.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
        self.names(canvas, &named);
    }

    fn named(&self, at: Point, lines: &[(usize, u16)]) -> Named {
        let of = |index: usize| &self.diagram.lines[index];
        let symbols: Vec<String> =
            lines.iter().map(|(line, _)| self.context.teller().speed_symbol(of(*line).link)).collect();
        let line = lines[0].0;
        Named {
            at,
            line,
            symbol: RichText::math(&symbols.join(" = ")),
            number: RichText::plain(&self.context.words.write(self.diagram.rate(of(line)), VALUE)),
            step: lines.iter().map(|(_, step)| *step).max().unwrap_or_default(),
        }
    }

    /// The names and numbers in a row below the base, each as near to its mark as the others let it.
    fn names(&self, canvas: &mut Canvas<'_>, named: &[Named]) {
        let room = canvas.room();
        let sizes: Vec<[f64; 2]> = named.iter().map(|own| [own.at.x, own.width()]).collect();
        let Some(places) = spread(&sizes, [room.x0, room.x1]) else {
            for own in named {
                canvas.step = own.step;
                let request = LabelRequest::new(own.symbol.clone(), own.at, TICK + 0.5, Some(Vec2::new(0.0, 1.0)), 3);
                canvas.ask(&format!("rate-{}", own.line), request);
            }
            return;
        };
        self.unit(canvas, named, &places);
        for (own, x) in named.iter().zip(places) {
            canvas.step = own.step;
            let foot = own.at.y + TICK;
            if (x - own.at.x).abs() > BELOW_MARK {
                canvas.draw(Pen::Leader, Shape::Line(Point::new(own.at.x, foot), Point::new(x, foot + DROP - 0.4)));
            }
            let baseline = foot + DROP + HEIGHT;
            for (id, text, y) in [("rate", &own.symbol, baseline), ("value", &own.number, baseline + LINE)] {
                let ink = text.ink_box(LABEL);
                let left = x - 0.5 * ink.width() - ink.x0;
                let placed = PlacedText::new(text.clone(), LABEL, Point::new(left, y)).anchored(Anchor::Middle);
                canvas.draw_named(&format!("label-{id}-{}", own.line), Pen::Label, Shape::Text(placed));
            }
        }
    }

    /// The unit of the numbers before the first of them, or after the last.
    fn unit(&self, canvas: &mut Canvas<'_>, named: &[Named], places: &[f64]) {
        let ([first, .., last] | [first @ last], [low, .., high] | [low @ high]) = (named, places) else { return };
        let unit = RichText::plain(&self.diagram.kind().unit(self.context.solution.scene.units));
        let ink = unit.ink_box(LABEL);
        let before = low - 0.5 * first.width() - LABEL - ink.x1;
        let after = high + 0.5 * last.width() + BESIDE - ink.x0;
        let y = first.at.y + TICK + DROP + HEIGHT + LINE;
        let room = canvas.room();
        let is_clear = |left: &f64| {
            let ink = ink + Vec2::new(*left, y);
            let is_off = |circle: &PitchCircle| {
                let center = self.at(0.0, circle.center);
                let nearest = Point::new(center.x.clamp(ink.x0, ink.x1), center.y.clamp(ink.y0, ink.y1));
                (nearest - center).hypot() > circle.radius / self.view.mu() + BELOW_MARK
            };
            ink.x0 >= room.x0 && ink.x1 <= room.x1 && self.diagram.circles.iter().all(is_off)
        };
        if let Some(left) = [before, after].into_iter().find(is_clear) {
            canvas.step = self.steps.pole;
            let placed = PlacedText::new(unit, LABEL, Point::new(left, y));
            canvas.draw_named("label-unit", Pen::Label, Shape::Text(placed));
        }
    }
}

/// The middles of some things in a row, each as near to where it belongs as the others let it; they have a place and a width, and are sorted by
/// place. Isotonic regression: the sum of the squares of the shifts is least. `None` where the room is too small.
fn spread(wanted: &[[f64; 2]], [from, to]: [f64; 2]) -> Option<Vec<f64>> {
    // From the middle of the first to that of each when they stand as close as may be.
    let mut packed = vec![0.0; wanted.len()];
    for index in 1..wanted.len() {
        packed[index] = packed[index - 1] + 0.5 * (wanted[index - 1][1] + wanted[index][1]) + BESIDE;
    }
    let ([first, .., last] | [first @ last]) = wanted else { return Some(Vec::new()) };
    let low = from + 0.5 * first[1];
    let high = to - 0.5 * last[1] - packed[wanted.len() - 1];
    if low > high {
        return None;
    }
    // Things that stand close together: the sum of where the first would be, and how many they are.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for ([place, _], packed) in wanted.iter().zip(&packed) {
        let mut group = (place - packed, 1);
        while let Some(&(sum, count)) = groups.last() {
            if sum / count as f64 <= group.0 / group.1 as f64 {
                break;
            }
            groups.pop();
            group = (group.0 + sum, group.1 + count);
        }
        groups.push(group);
    }
    let starts = groups.iter().flat_map(|(sum, count)| std::iter::repeat_n(sum / *count as f64, *count));
    Some(starts.zip(&packed).map(|(start, packed)| start.clamp(low, high) + packed).collect())
}
