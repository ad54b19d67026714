//! The panel of the speed diagram: the train with its line of centres upright, the velocities along it beside that, and below these the
//! parallels that cut angular velocities off a base (`fan`). `scales` says where all that is.

mod fan;
mod scales;

pub(super) use scales::SpeedScales;

use super::canvas::Canvas;
use super::context::SheetContext;
use super::labels::LabelRequest;
use super::layout::{LEAST, ROW};
use super::scale_bar::{ScaleBars, Scaled};
use super::scheme::{hatch_line, hatch_rim, tangents};
use super::shape::Shape;
use super::sheet::Pen;
use super::text::RichText;
use super::view::{Extent, ONE_PLACE, View, together_where};
use crate::construction::{Action, Construction, SpeedDiagram, SpeedStep, SpotName, display, image_name};
use crate::geometry;
use crate::mechanism::GROUND;
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};
use scales::Layout;
use std::f64::consts::PI;

/// White below the heading for the scales of velocities and angular velocities, in mm.
pub(super) const ABOVE: f64 = 2.0 * ROW - 1.0;
/// Half the length of a stroke on the base, and at a pitch point, in mm.
const TICK: f64 = 1.2;
/// Half the length of the line of what slides, in mm.
const SLIDING: f64 = 5.0;
/// Places closer than this, in mm, share a label.
const SHARED: f64 = 0.35;

/// The extent of the diagram; none of a scene without wheels that mesh.
pub(super) fn extent(context: &SheetContext<'_>) -> Option<Extent> {
    let diagram = context.construction().speeds.as_ref()?;
    let layout = Layout::of(diagram, context.surface.speeds)?;
    let circles = diagram.circles.iter().flat_map(|circle| {
        [-1.0, 1.0].map(|side| geometry::Point::new(side * circle.radius, circle.center + side * circle.radius))
    });
    let tips = (0..diagram.spots.len()).map(|spot| layout.tip(spot));
    let cuts = diagram.lines.iter().filter(|line| !line.slides).map(|line| layout.cut(line));
    let own = [layout.pole, layout.base].map(|height| geometry::Point::new(layout.zero, height));
    Some(Extent::of(circles.chain(tips).chain(cuts).chain(own)))
}

/// Room below the content for the names on the base, in mm, besides this white around it and what wheels that reach below the base leave beside
/// them.
pub(super) fn below(context: &SheetContext<'_>, white: f64) -> f64 {
    let diagram = context.construction().speeds.as_ref();
    let layout = diagram.and_then(|diagram| Layout::of(diagram, context.surface.speeds));
    layout.map_or(0.0, |layout| (fan::BELOW - white - LEAST * layout.below_base()).max(0.0))
}

/// The scales that a diagram keeps in some positions of its mechanism.
pub(super) fn scales_in<'a>(constructions: impl Iterator<Item = &'a Construction>) -> Option<SpeedScales> {
    SpeedScales::of(constructions.filter_map(|construction| construction.speeds.as_ref()))
}

/// Draws the panel.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(diagram) = context.construction().speeds.as_ref() else { return };
    let Some(layout) = Layout::of(diagram, context.surface.speeds) else { return };
    let mut steps = Steps {
        train: 0,
        pole: 0,
        lines: vec![0; diagram.lines.len()],
        belts: vec![0; diagram.belts.len()],
        rays: vec![0; diagram.lines.len()],
    };
    for step in context.construction().numbered_steps() {
        let number = step.number as u16;
        match *step.action {
            Action::Speeds(SpeedStep::Train) => steps.train = number,
            Action::Speeds(SpeedStep::Pole) => steps.pole = number,
            Action::Speeds(SpeedStep::Line(line)) => steps.lines[line] = number,
            Action::Speeds(SpeedStep::Belt { belt, .. }) => steps.belts[belt] = number,
            Action::Speeds(SpeedStep::Ray(line)) => steps.rays[line] = number,
            _ => {}
        }
    }
    let panel = DiagramOnPaper { view, context, diagram, layout, steps };
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
    belts: Vec<u16>,
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
        let velocity = bars.bar_within(Sheet::Velocity, mu / self.layout.scales.velocity, room.width());
        let symbol = if self.diagram.turns.is_some() { "μ_n" } else { "μ_ω" };
        let unit = self.diagram.kind().unit(self.context.solution.scene.units);
        let rate = bars.scaled_within(&Scaled { symbol, unit }, mu / self.layout.scales.rate, room.width());
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
                hatch_rim(canvas, [center, touch], circle.is_ring);
            }
        }
        self.racks(canvas);
        self.belts(canvas);
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
            let name = spot.name.clone();
            match spot.at {
                SpotName::Center(_) => {
                    let radius = canvas.dims.joint;
                    canvas.draw(Pen::Joint, Shape::Circle { center: place, radius });
                    let shown = RichText::math(&self.context.shown(&name, None));
                    canvas.ask(&name, LabelRequest::new(shown, place, radius + 0.5, Some(Vec2::new(-1.0, 0.0)), 3));
                }
                SpotName::Pitch(_) | SpotName::Rim(..) => {
                    let across = Vec2::new(TICK, 0.0);
                    canvas.draw(Pen::Guide, Shape::Line(place - across, place + across));
                    canvas.label(&name, &display(&name), place, TICK, Some(Vec2::new(-1.0, 0.0)), 2);
                }
            }
        }
    }

    /// The pitch lines of racks, hatched where they are fixed.
    fn racks(&self, canvas: &mut Canvas<'_>) {
        for rack in &self.diagram.racks {
            let [center, reach] = rack.wheel;
            let ends = [-reach, reach].map(|x| self.at(x, rack.height));
            let pen = if rack.link == GROUND { Pen::Guide } else { Pen::Link };
            canvas.draw(pen, Shape::Line(ends[0], ends[1])).number = self.context.number(rack.link);
            if rack.link == GROUND {
                hatch_line(canvas, ends, Vec2::new(0.0, if rack.height > center { -1.0 } else { 1.0 }));
            }
        }
    }

    /// The straight parts of belts.
    fn belts(&self, canvas: &mut Canvas<'_>) {
        for belt in &self.diagram.belts {
            let centers = belt.centers.map(|height| self.at(0.0, height));
            let radii = belt.radii.map(|radius| radius / self.view.mu());
            for [from, to] in tangents(centers, radii, belt.is_crossed) {
                canvas.draw(Pen::Guide, Shape::Line(from, to));
            }
        }
    }

    /// The line of each link through the ends of its velocities, with the link's name; that of a belt between the velocities of two rims.
    fn lines(&self, canvas: &mut Canvas<'_>) {
        for (line, &step) in self.diagram.lines.iter().zip(&self.steps.lines) {
            canvas.step = step;
            let [Some(&low), Some(&high)] = [line.spots.first(), line.spots.last()] else { continue };
            let ends = [low, high].map(|spot| self.view.at(self.layout.tip(spot)));
            let beyond = Vec2::new(0.0, if line.slides { SLIDING } else { 0.0 });
            let ends = [ends[0] + beyond, ends[1] - beyond];
            let name = &self.context.mechanism().body(line.link).name;
            canvas.draw_named(&format!("line-{name}"), Pen::Image, Shape::Line(ends[0], ends[1])).number =
                self.context.number(line.link);
        }
        for (belt, &step) in self.diagram.belts.iter().zip(&self.steps.belts) {
            canvas.step = step;
            let [from, to] = belt.rims.map(|spot| self.view.at(self.layout.tip(spot)));
            canvas.draw(Pen::Construction, Shape::Line(from, to));
        }
        // When all are drawn: names have room off all of them.
        for (line, &step) in self.diagram.lines.iter().zip(&self.steps.lines) {
            canvas.step = step;
            let [Some(&low), Some(&high)] = [line.spots.first(), line.spots.last()] else { continue };
            let ends = [low, high].map(|spot| self.view.at(self.layout.tip(spot)));
            let (place, side) = match line.slides {
                true => (ends[0] + Vec2::new(0.0, SLIDING - 0.5), Vec2::new(1.0, 0.0)),
                false => canvas.free_side(ends, across(ends)),
            };
            let name = &self.context.mechanism().body(line.link).name;
            let shown = RichText::math(&self.context.shown(name, None));
            let wanted = canvas.ask(&format!("line-{name}"), LabelRequest::new(shown, place, 0.8, Some(side), 1));
            (wanted.optional, wanted.number) = (true, self.context.number(line.link));
        }
    }

    /// The velocities, with lines from where they are on the train.
    fn velocities(&self, canvas: &mut Canvas<'_>) {
        let mut tips = Vec::new();
        for (index, spot) in self.diagram.spots.iter().enumerate() {
            let of_spot =
                self.diagram.lines.iter().zip(&self.steps.lines).filter(|(line, _)| line.spots.contains(&index));
            let of_belt = self.diagram.belts.iter().zip(&self.steps.belts);
            let of_belt = of_belt.filter(|(belt, _)| belt.rims.contains(&index)).map(|(_, step)| *step);
            canvas.step = of_spot
                .map(|(_, step)| *step)
                .chain(of_belt)
                .filter(|step| *step > 0)
                .min()
                .unwrap_or(self.steps.train);
            let from = self.at(self.layout.zero, spot.height);
            let tip = self.view.at(self.layout.tip(index));
            let reach = if tip.x < from.x { tip } else { from };
            let rack = self.diagram.racks.iter().find(|rack| rack.height == spot.height);
            let start = self.at(rack.map_or(0.0, |rack| rack.wheel[1]), spot.height);
            canvas.draw(Pen::Construction, Shape::Line(start, reach));
            let name = spot.name.clone();
            if (tip - from).hypot() > SHARED {
                canvas.draw_named(&format!("velocity-{name}"), Pen::Velocity, canvas.arrow(from, tip));
                tips.push((tip, (image_name(&name), canvas.step, index)));
            }
        }
        let place = |index: usize| Vec2::new(self.diagram.spots[index].velocity, self.diagram.spots[index].height);
        let fastest = self.diagram.spots.iter().map(|spot| spot.velocity.abs()).fold(0.0, f64::max);
        let highest = self.diagram.spots.iter().map(|spot| spot.height.abs()).fold(0.0, f64::max);
        let is_one = |(.., a): &(String, u16, usize), (.., b): &(String, u16, usize)| {
            let off = place(*a) - place(*b);
            off.x.abs() <= ONE_PLACE * fastest && off.y.abs() <= ONE_PLACE * highest
        };
        for (at, names) in together_where(tips.into_iter(), SHARED, is_one) {
            canvas.step = names.iter().map(|(_, step, _)| *step).min().unwrap_or_default();
            let shown: Vec<String> = names.iter().map(|(name, ..)| self.context.shown(name, None)).collect();
            let way = if at.x < self.at(self.layout.zero, 0.0).x { -1.0 } else { 1.0 };
            let request = LabelRequest::new(RichText::math(&shown.join(", ")), at, 0.9, Some(Vec2::new(way, 0.0)), 2);
            canvas.ask(&format!("tip-{}", names[0].0), request);
        }
    }
}

/// The direction to the right of a line, or below it.
fn across([from, to]: [Point; 2]) -> Vec2 {
    let way = to - from;
    let right = Vec2::new(way.y.abs(), if way.y * way.x > 0.0 { -way.x.abs() } else { way.x.abs() });
    if right.hypot() > 0.0 { right.normalize() } else { Vec2::new(1.0, 0.0) }
}
