//! The panel of levers: the velocity plan turned by 90° clockwise, as its links lie; forces at their images with their arms about the pole.

use super::canvas::Canvas;
use super::clip::clipped_segment;
use super::context::SheetContext;
use super::labels::LabelRequest;
use super::scheme::on_paper::outline;
use super::shape::Shape;
use super::sheet::Pen;
use super::text::RichText;
use super::view::{Extent, ONE_PLACE, View, on_sheet, together_where, towards};
use crate::construction::{Action, Construction, Lever, LeverForce, LeverStep, image_name};
use crate::geometry::{self, Vector};
use crate::sheet::{Order, Sheet};
use kurbo::{Point, Vec2};

/// Length of a force's arrow, in mm: forces have no scale here.
const LENGTH: f64 = 10.0;
/// Largest size of a lever with the feet of its arms over that without.
const REACH: f64 = 1.5;
/// So many arms at most are seen at once.
const ARMS: usize = 8;
/// Radius of the pole.
const POLE: f64 = 1.1;
/// Places closer than this, in mm, share a label.
const SHARED: f64 = 0.35;

/// The extent of all images.
pub(super) fn extent(construction: &Construction) -> Option<Extent> {
    let levers = &construction.levers;
    let place = |at: Vector| geometry::Point::from(at);
    let images = levers.iter().flat_map(|lever| lever.links.iter().flat_map(|(_, images)| images));
    let forces = levers.iter().flat_map(|lever| &lever.forces).map(|force| place(force.at));
    let places = images.map(|(_, at)| place(*at)).chain(levers.iter().map(|lever| place(lever.pole))).chain(forces);
    let own = Extent::of(places);
    // Arms that are seen at once reach to their feet, unless these would make the lever small.
    let feet = levers.iter().filter(|lever| lever.forces.len() <= ARMS).flat_map(|lever| &lever.forces);
    let whole = feet.map(|force| place(force.foot)).fold(own, |extent, foot| {
        let larger = extent.with(foot);
        if larger.size().norm() <= REACH * own.size().norm() { larger } else { extent }
    });
    (!levers.is_empty()).then_some(whole)
}

/// Draws the panel.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    for (index, lever) in context.construction().levers.iter().enumerate() {
        let (mut turned, mut arms) = (0, vec![0; lever.forces.len()]);
        for step in context.construction().numbered_steps().filter(|step| step.sheet == Sheet::Lever) {
            match *step.action {
                Action::Lever(LeverStep::Turn(own)) if own == index => turned = step.number as u16,
                Action::Lever(LeverStep::Arm(own, force)) if own == index => arms[force] = step.number as u16,
                _ => {}
            }
        }
        let panel = LeverOnPaper::new(view, context, index);
        canvas.step = turned;
        panel.images(canvas);
        panel.couples(canvas);
        for (number, force) in panel.forces() {
            canvas.step = arms[number];
            if !panel.is_crowded {
                panel.arm(canvas, number, force);
            }
            panel.force(canvas, number, force);
        }
        canvas.step = turned;
        panel.points(canvas);
    }
    canvas.step = 0;
}

/// Draws the arms of crowded levers, each in its step alone.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let levers = 0..context.construction().levers.len();
    let panels: Vec<LeverOnPaper<'_>> = levers.map(|index| LeverOnPaper::new(view, context, index)).collect();
    for step in context.construction().numbered_steps() {
        let Action::Lever(LeverStep::Arm(index, number)) = *step.action else { continue };
        let panel = &panels[index];
        let force = panel.lever.forces[number];
        if panel.is_crowded && panel.shown[number] {
            canvas.step = step.number as u16;
            let before = canvas.drawing.marks.len();
            panel.arm(canvas, number, &force);
            canvas.drawing.marks[before..].iter_mut().for_each(|mark| mark.passing = true);
        }
    }
    canvas.step = 0;
}

struct LeverOnPaper<'a> {
    view: &'a View,
    context: &'a SheetContext<'a>,
    lever: &'a Lever,
    index: usize,
    /// By force: whether it is seen. One that acts in the pole has no moment.
    shown: Vec<bool>,
    /// Whether there are too many arms to be seen at once.
    is_crowded: bool,
}

impl<'a> LeverOnPaper<'a> {
    fn new(view: &'a View, context: &'a SheetContext<'_>, index: usize) -> Self {
        let lever = &context.construction().levers[index];
        let is_in_pole = |force: &LeverForce| (view.at(force.at.into()) - view.at(lever.pole.into())).hypot() <= SHARED;
        let least = lever.least_shown();
        let shown = lever.forces.iter().map(|force| force.size > least && !is_in_pole(force));
        let shown: Vec<bool> = shown.collect();
        let is_crowded = shown.iter().filter(|is_shown| **is_shown).count() > ARMS;
        LeverOnPaper { view, context, lever, index, shown, is_crowded }
    }

    fn at(&self, at: Vector) -> Point {
        self.view.at(at.into())
    }

    /// The forces that are seen, by their indices.
    fn forces(&self) -> impl Iterator<Item = (usize, &LeverForce)> {
        self.lever.forces.iter().enumerate().filter(|(number, _)| self.shown[*number])
    }

    fn images(&self, canvas: &mut Canvas<'_>) {
        for (link, images) in &self.lever.links {
            // From the pole where the link has a point at rest: images of two points are a line, of more an area.
            let places = images.iter().map(|(_, at)| geometry::Point::from(*at)).collect();
            let corners: Vec<Point> = outline(places).into_iter().map(|place| self.view.at(place)).collect();
            let shape = match corners.as_slice() {
                [a, b] if (*b - *a).hypot() > SHARED => Shape::Line(*a, *b),
                [_, _, _, ..] => Shape::Polygon(corners),
                _ => continue,
            };
            canvas.draw(Pen::Image, shape).number = self.context.number(*link);
        }
    }

    /// A line between the two forces of each couple, where there is no image of the link.
    fn couples(&self, canvas: &mut Canvas<'_>) {
        let forces: Vec<(usize, &LeverForce)> = self.forces().filter(|(_, force)| force.is_of_couple).collect();
        let images = self.lever.links.iter().flat_map(|(_, images)| images).map(|(_, at)| self.at(*at));
        let images: Vec<Point> = images.collect();
        for pair in forces.windows(2) {
            let [(number, from), (_, to)] = [pair[0], pair[1]];
            let ends = [from.at, to.at].map(|at| self.at(at));
            let is_image = |end: &Point| images.iter().any(|image| (*image - *end).hypot() < SHARED);
            if from.load == to.load && !ends.iter().all(is_image) {
                let name = format!("couple-{}-{}", self.index + 1, number + 1);
                canvas.draw_below(&name, Pen::Construction, Shape::Line(ends[0], ends[1]));
            }
        }
    }

    /// The images of points with their names as in the velocity plan, and the pole.
    fn points(&self, canvas: &mut Canvas<'_>) {
        let pole = self.at(self.lever.pole);
        canvas.draw(Pen::Pole, Shape::Circle { center: pole, radius: POLE });
        let mechanism = self.context.mechanism();
        type Image = (String, Vector);
        let own = self.lever.pole;
        let mut named: Vec<(Point, Image)> =
            vec![(pole, (self.context.words.notation.pole(Order::Velocity).to_owned(), own))];
        for (point, at) in self.lever.links.iter().flat_map(|(_, images)| images) {
            let (place, at, name) = (*at, self.at(*at), image_name(mechanism.point_name(*point)));
            if (at - pole).hypot() > SHARED && !named.iter().any(|(_, (other, _))| *other == name) {
                canvas.draw(Pen::ImagePoint, Shape::Circle { center: at, radius: canvas.dims.dot });
                named.push((at, (name, place)));
            }
        }
        let largest = named.iter().map(|(_, (_, place))| (*place - own).norm()).fold(0.0, f64::max);
        let is_one = |(_, a): &Image, (_, b): &Image| (*a - *b).norm() <= ONE_PLACE * largest;
        for (at, names) in together_where(named.into_iter(), SHARED, is_one) {
            let shown: Vec<String> = names.iter().map(|(name, _)| self.context.shown(name, None)).collect();
            let request = LabelRequest::new(RichText::math(&shown.join(", ")), at, 1.2, None, 3);
            canvas.ask(&format!("{}-{}", self.index + 1, names[0].0), request);
        }
    }

    /// The line of action of a force, and its arm.
    fn arm(&self, canvas: &mut Canvas<'_>, number: usize, force: &LeverForce) {
        let [at, foot, pole] = [force.at, force.foot, self.lever.pole].map(|place| self.at(place));
        let room = canvas.room();
        let id = format!("{}-{}", self.index + 1, number + 1);
        if let Some((a, b)) = clipped_segment(room, at, foot) {
            canvas.draw_below(&format!("action-{id}"), Pen::Ray, Shape::Line(a, b));
        }
        if let Some((a, b)) = clipped_segment(room, pole, foot).filter(|_| (foot - pole).hypot() > SHARED) {
            canvas.draw_below(&format!("arm-{id}"), Pen::Construction, Shape::Line(a, b));
        }
    }

    /// A force at its image.
    fn force(&self, canvas: &mut Canvas<'_>, number: usize, force: &LeverForce) {
        let at = self.at(force.at);
        let along = on_sheet(force.along) * LENGTH;
        let ways = [[at, at + along], [at - along, at]];
        let room = canvas.room();
        let cost = |[from, to]: &[Point; 2]| {
            let free = [0.3, 0.5, 0.7].iter().filter(|share| canvas.is_free(from.lerp(*to, **share), 0.8)).count();
            (!(room.contains(*from) && room.contains(*to)), 3 - free)
        };
        let Some([from, to]) = ways.into_iter().min_by_key(cost) else { return };
        let name = format!("force-{}-{}", self.index + 1, number + 1);
        canvas.draw_named(&name, Pen::Acceleration, canvas.arrow(from, to));
        let free = if from == at { to } else { from };
        let symbol = RichText::math(&self.context.teller().lever_symbol(force));
        canvas.ask(&name, LabelRequest::new(symbol, free, 0.8, Some(towards(at, free, Vec2::ZERO)), 2));
    }
}
