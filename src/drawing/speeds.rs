//! The panel of the speed diagram: the train with its line of centres upright, the velocities along it beside that, and below these the
//! parallels that cut angular velocities off a base.

use super::canvas::Canvas;
use super::context::SheetContext;
use super::labels::LabelRequest;
use super::layout::ROW;
use super::scale_bar::{ScaleBars, Scaled};
use super::scheme;
use super::shape::Shape;
use super::sheet::Pen;
use super::text::RichText;
use super::values::VALUE;
use super::view::{Extent, View, together};
use crate::construction::{Action, SpeedDiagram, SpeedLine, SpeedStep, SpotName, display, image_name};
use crate::geometry;
use crate::mechanism::GROUND;
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};
use std::f64::consts::PI;

/// White below the heading for the scales of velocities and angular velocities, in mm.
pub(super) const ABOVE: f64 = 2.0 * ROW - 1.0;
/// Largest velocity and largest angular velocity, and largest distance of the base from the pole, in parts of the height of the train.
const LARGEST: f64 = 0.6;
const LOWEST: f64 = 0.42;
/// White between the train and the velocities, and between these and the pole, in parts of that height.
const BESIDE: f64 = 0.1;
const BELOW: f64 = 0.1;
/// Radius of the pole, in mm.
const POLE: f64 = 1.1;
/// Half the length of a stroke on the base, and at a pitch point, in mm.
const TICK: f64 = 1.2;
/// Places closer than this, in mm, share a label.
const SHARED: f64 = 0.35;

/// Where things are in the panel, in units of length: the line of centres is upright at x = 0.
struct Layout<'a> {
    diagram: &'a SpeedDiagram,
    /// Where velocities begin.
    zero: f64,
    /// How long a unit of velocity is.
    velocity: f64,
    /// How long a unit of angular velocity is on the base.
    rate: f64,
    /// The height of the point through which parallels are drawn, and that of the base.
    pole: f64,
    base: f64,
}

impl<'a> Layout<'a> {
    fn of(diagram: &'a SpeedDiagram) -> Layout<'a> {
        let reach = |from: f64, to: f64| {
            diagram.circles.iter().flat_map(move |own| [own.center + from * own.radius, own.center + to * own.radius])
        };
        let high = reach(1.0, 1.0).chain(diagram.spots.iter().map(|spot| spot.height)).fold(0.0, f64::max);
        let low = reach(-1.0, -1.0).fold(0.0, f64::min);
        let height = high - low;
        let velocities = || diagram.spots.iter().map(|spot| spot.velocity);
        let fastest = velocities().map(f64::abs).fold(0.0, f64::max);
        let velocity = round_below(LARGEST * height / fastest);
        let turning = diagram.lines.iter().map(|line| diagram.rate(line).abs()).fold(0.0, f64::max);
        let per_radian = diagram.turns.unwrap_or(1.0);
        let rate = round_below((LARGEST * height / turning).min(LOWEST * height * velocity / per_radian));
        let widest = diagram.circles.iter().map(|circle| circle.radius).fold(0.0, f64::max);
        let leftmost =
            velocities().map(|own| own * velocity).chain(diagram.lines.iter().map(|line| diagram.rate(line) * rate));
        let zero = widest + BESIDE * height - leftmost.fold(0.0, f64::min);
        let pole = -BELOW * height;
        // A parallel to a line with ω is ω · velocity wide for each unit of height.
        Layout { diagram, zero, velocity, rate, pole, base: pole - rate * per_radian / velocity }
    }

    fn tip(&self, spot: usize) -> geometry::Point {
        let spot = self.diagram.spots[spot];
        geometry::Point::new(self.zero + spot.velocity * self.velocity, spot.height)
    }

    fn cut(&self, line: &SpeedLine) -> geometry::Point {
        geometry::Point::new(self.zero + self.diagram.rate(line) * self.rate, self.base)
    }
}

/// The largest of 1, 2, 5 · 10^k that is not larger; 1 where anything fits.
fn round_below(most: f64) -> f64 {
    if !(most > 0.0 && most.is_finite()) {
        return 1.0;
    }
    let decade = libm::pow(10.0, libm::floor(libm::log10(most)));
    [5.0, 2.0].into_iter().map(|part| part * decade).find(|value| *value <= most).unwrap_or(decade)
}

/// The extent of the diagram; none of a scene without wheels that mesh.
pub(super) fn extent(context: &SheetContext<'_>) -> Option<Extent> {
    let diagram = context.construction().speeds.as_ref()?;
    let layout = Layout::of(diagram);
    let circles = diagram.circles.iter().flat_map(|circle| {
        [-1.0, 1.0].map(|side| geometry::Point::new(side * circle.radius, circle.center + side * circle.radius))
    });
    let tips = (0..diagram.spots.len()).map(|spot| layout.tip(spot));
    let cuts = diagram.lines.iter().map(|line| layout.cut(line));
    let own = [layout.pole, layout.base].map(|height| geometry::Point::new(layout.zero, height));
    Some(Extent::of(circles.chain(tips).chain(cuts).chain(own)))
}

/// Draws the panel.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(diagram) = context.construction().speeds.as_ref() else { return };
    let mut steps =
        Steps { train: 0, pole: 0, lines: vec![0; diagram.lines.len()], rays: vec![0; diagram.lines.len()] };
    for step in context.construction().numbered_steps() {
        let number = step.number as u16;
        match *step.action {
            Action::Speeds(SpeedStep::Train) => steps.train = number,
            Action::Speeds(SpeedStep::Pole) => steps.pole = number,
            Action::Speeds(SpeedStep::Line(line)) => steps.lines[line] = number,
            Action::Speeds(SpeedStep::Ray(line)) => steps.rays[line] = number,
            _ => {}
        }
    }
    let panel = DiagramOnPaper { view, context, diagram, layout: Layout::of(diagram), steps };
    panel.scales(canvas);
    panel.train(canvas);
    panel.lines(canvas);
    panel.velocities(canvas);
    panel.fan(canvas);
    canvas.step = 0;
}

/// The steps with which things appear.
struct Steps {
    train: u16,
    pole: u16,
    lines: Vec<u16>,
    rays: Vec<u16>,
}

struct DiagramOnPaper<'a> {
    view: &'a View,
    context: &'a SheetContext<'a>,
    diagram: &'a SpeedDiagram,
    layout: Layout<'a>,
    steps: Steps,
}

impl DiagramOnPaper<'_> {
    fn at(&self, x: f64, y: f64) -> Point {
        self.view.at(geometry::Point::new(x, y))
    }

    /// The scales of velocities and of angular velocities, below the heading.
    fn scales(&self, canvas: &mut Canvas<'_>) {
        canvas.step = 0;
        let mu = self.view.mu() / self.context.surface.dims.unit;
        let bars = ScaleBars::of(self.context);
        let room = canvas.room();
        let velocity = bars.bar_within(Sheet::Velocity, mu / self.layout.velocity, room.width());
        let symbol = if self.diagram.turns.is_some() { "μ_n" } else { "μ_ω" };
        let unit = self.diagram.kind().unit(self.context.solution.scene.units);
        let rate = bars.scaled_within(&Scaled { symbol, unit }, mu / self.layout.rate, room.width());
        for (index, bar) in [velocity, rate].into_iter().enumerate() {
            let from = Point::new(room.x0 + 1.3, room.y0 + 3.6 + 0.8 * ROW * index as f64);
            let ink = bar.draw(canvas.drawing, from, None);
            canvas.obstacles.add_texts([ink]);
        }
    }

    /// The pitch circles about their upright line of centres, with the names of centres and pitch points.
    fn train(&self, canvas: &mut Canvas<'_>) {
        canvas.step = self.steps.train;
        let mut drawn: Vec<(Point, f64)> = Vec::new();
        for circle in &self.diagram.circles {
            let (center, touch) = (self.at(0.0, circle.center), self.at(0.0, circle.touch));
            let radius = (touch - center).hypot();
            if drawn.iter().any(|(other, own)| (*other - center).hypot() + (own - radius).abs() < SHARED) {
                continue;
            }
            drawn.push((center, radius));
            for start in [0.0, PI] {
                canvas.draw(Pen::Guide, Shape::Arc { center, radius, start, sweep: PI });
            }
            if circle.link == GROUND {
                scheme::hatch_rim(canvas, [center, touch], circle.is_ring);
            }
        }
        let ends = [self.diagram.spots.first(), self.diagram.spots.last()];
        if let [Some(low), Some(high)] = ends {
            canvas.draw(Pen::Construction, Shape::Line(self.at(0.0, low.height), self.at(0.0, high.height)));
            canvas.draw(
                Pen::Frame,
                Shape::Line(self.at(self.layout.zero, low.height), self.at(self.layout.zero, high.height)),
            );
        }
        for spot in &self.diagram.spots {
            let place = self.at(0.0, spot.height);
            let name = self.context.teller().spot_of_speed(spot.at).to_owned();
            match spot.at {
                SpotName::Center(_) => {
                    let radius = canvas.dims.joint;
                    canvas.draw(Pen::Joint, Shape::Circle { center: place, radius });
                    let shown = RichText::math(&self.context.shown(&name, None));
                    canvas.ask(&name, LabelRequest::new(shown, place, radius + 0.5, Some(Vec2::new(-1.0, 0.0)), 3));
                }
                SpotName::Pitch(_) => {
                    let across = Vec2::new(TICK, 0.0);
                    canvas.draw(Pen::Guide, Shape::Line(place - across, place + across));
                    canvas.label(&name, &display(&name), place, TICK, Some(Vec2::new(-1.0, 0.0)), 2);
                }
            }
        }
    }

    /// The line of each link through the ends of its velocities.
    fn lines(&self, canvas: &mut Canvas<'_>) {
        for (line, &step) in self.diagram.lines.iter().zip(&self.steps.lines) {
            canvas.step = step;
            let [Some(&low), Some(&high)] = [line.spots.first(), line.spots.last()] else { continue };
            let ends = [low, high].map(|spot| self.view.at(self.layout.tip(spot)));
            let name = &self.context.mechanism().body(line.link).name;
            canvas.draw_named(&format!("line-{name}"), Pen::Image, Shape::Line(ends[0], ends[1])).number =
                self.context.number(line.link);
        }
    }

    /// The velocities, with lines from where they are on the train.
    fn velocities(&self, canvas: &mut Canvas<'_>) {
        let mut tips = Vec::new();
        for (index, spot) in self.diagram.spots.iter().enumerate() {
            let of_spot =
                self.diagram.lines.iter().zip(&self.steps.lines).filter(|(line, _)| line.spots.contains(&index));
            canvas.step = of_spot.map(|(_, step)| *step).min().unwrap_or(self.steps.train);
            let from = self.at(self.layout.zero, spot.height);
            let tip = self.view.at(self.layout.tip(index));
            let reach = if tip.x < from.x { tip } else { from };
            canvas.draw(Pen::Construction, Shape::Line(self.at(0.0, spot.height), reach));
            let name = self.context.teller().spot_of_speed(spot.at).to_owned();
            if (tip - from).hypot() > SHARED {
                canvas.draw_named(&format!("velocity-{name}"), Pen::Velocity, canvas.arrow(from, tip));
                tips.push((tip, (image_name(&name), canvas.step)));
            }
        }
        for (at, names) in together(tips.into_iter(), SHARED) {
            canvas.step = names.iter().map(|(_, step)| *step).min().unwrap_or_default();
            let shown: Vec<String> = names.iter().map(|(name, _)| self.context.shown(name, None)).collect();
            let way = if at.x < self.at(self.layout.zero, 0.0).x { -1.0 } else { 1.0 };
            let request = LabelRequest::new(RichText::math(&shown.join(", ")), at, 0.9, Some(Vec2::new(way, 0.0)), 2);
            canvas.ask(&format!("tip-{}", names[0].0), request);
        }
    }

    /// The parallels through the pole, and what they cut off the base.
    fn fan(&self, canvas: &mut Canvas<'_>) {
        canvas.step = self.steps.pole;
        let pole = self.at(self.layout.zero, self.layout.pole);
        let foot = self.at(self.layout.zero, self.layout.base);
        let cuts = || self.diagram.lines.iter().map(|line| self.view.at(self.layout.cut(line)));
        let (low, high) = cuts().fold((foot.x, foot.x), |(low, high), cut| (low.min(cut.x), high.max(cut.x)));
        canvas.draw(Pen::Frame, Shape::Line(Point::new(low - 3.0, foot.y), Point::new(high + 3.0, foot.y)));
        canvas.draw(Pen::Frame, Shape::Line(pole, foot));
        canvas.draw(Pen::Pole, Shape::Circle { center: pole, radius: POLE });
        canvas.ask("pole", LabelRequest::new(RichText::math("o"), pole, POLE + 0.5, None, 2));
        let mut named: Vec<(Point, (usize, String, u16))> = Vec::new();
        for ((index, (line, cut)), &step) in self.diagram.lines.iter().zip(cuts()).enumerate().zip(&self.steps.rays) {
            canvas.step = step;
            let name = &self.context.mechanism().body(line.link).name;
            canvas.draw_named(&format!("ray-{name}"), Pen::Ray, Shape::Line(pole, cut)).number =
                self.context.number(line.link);
            let stroke = Vec2::new(0.0, TICK);
            canvas.draw(Pen::Frame, Shape::Line(cut - stroke, cut + stroke));
            named.push((cut, (index, self.context.teller().speed_symbol(line.link), step)));
        }
        let unit = self.diagram.kind().unit(self.context.solution.scene.units);
        for (at, here) in together(named.into_iter(), SHARED) {
            canvas.step = here.iter().map(|(.., step)| *step).max().unwrap_or_default();
            let symbols: Vec<&str> = here.iter().map(|(_, symbol, _)| symbol.as_str()).collect();
            let symbol = RichText::math(&symbols.join(" = "));
            let rate = self.diagram.rate(&self.diagram.lines[here[0].0]);
            let value = format!(" = {} {unit}", self.context.words.write(rate, VALUE));
            let text = symbol.clone().followed_by(&RichText::plain(&value));
            let request = LabelRequest::new(text, at, TICK + 0.5, Some(Vec2::new(0.0, 1.0)), 3);
            canvas.ask(&format!("rate-{}", here[0].0), request).short = Some(symbol);
        }
    }
}
