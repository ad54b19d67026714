//! The panel of instant centres: the mechanism with Kennedy's lines, dashed; permanent centres as crosses, others as diamonds; far
//! ones as arrows at the edge; velocities by centres; and the circle diagram in a free place.

mod curvature;
mod diagram;

use super::canvas::Canvas;
use super::clip::{clipped_segment, holds};
use super::context::SheetContext;
use super::labels::LabelRequest;
use super::panel::Layer;
use super::scheme;
use super::shape::Shape;
use super::sheet::Pen;
use super::text::RichText;
use super::view::{Extent, ONE_PLACE, View, on_sheet, together_where, towards};
use crate::construction::{Action, Center, CenterId, CenterLine, CenterOrigin, Centers, CurvatureStep, FigureOf};
use crate::geometry::{self, Place, span};
use crate::sheet::{QuantityKind, Sheet};
use crate::words::{Medium, NumberStyle};
use kurbo::{Point, Rect, Vec2};

/// Largest size of the mechanism with centres over that without: farther ones are arrows at the edge.
const REACH: f64 = 2.2;
/// How far a line goes on beyond the last of its centres, in mm.
const BEYOND: f64 = 3.0;
/// Half the size of a centre's mark, in mm.
const MARK: f64 = 1.5;
/// Centres closer than this, in mm, share a label, with so many names at most.
const SHARED: f64 = 0.35;
const TOGETHER: usize = 4;
/// Length of an arrow towards a centre, in mm.
const ARROW: f64 = 9.0;
/// Number style of distances and velocities.
const VALUE: NumberStyle = NumberStyle::significant(4).in_full(-3, 6).on(Medium::Figure);

/// The extent of the mechanism, of the centres that are near enough to stand at their places, and of velocities.
pub(super) fn extent(context: &SheetContext<'_>) -> Extent {
    let own = Extent::of(scheme::on_paper::places(context.solution));
    let Some(centers) = context.construction().centers.as_deref() else { return own };
    let points = &context.solution.pose.points;
    let tips = centers.velocities.iter().map(|velocity| points[velocity.point.0] + velocity.arrow);
    let own = own.with_all(tips.map(|tip| Extent::of([tip])));
    let crossings = centers.tangents.iter().map(|tangent| tangent.crossing);
    let curved = centers.curvatures.iter().flat_map(|found| [found.crossing, found.center]);
    let inflected = centers.inflections.iter().flat_map(|found| [found.point, found.pole]);
    let all = places(centers).map(|(_, place)| place).chain(crossings).chain(curved).chain(inflected);
    let mut near: Vec<geometry::Point> = all.filter_map(|place| place.finite()).collect();
    let size = |place: &geometry::Point| own.with(*place).size().norm();
    near.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let most = REACH * own.size().norm();
    near.into_iter().fold(own, |extent, place| {
        let larger = extent.with(place);
        if larger.size().norm() <= most { larger } else { extent }
    })
}

/// The places of the centres of the mechanism itself, those from the motion too, and of those without a link.
fn places(centers: &Centers) -> impl Iterator<Item = (Option<CenterId>, Place)> {
    let drawn = centers.all.iter().enumerate().map(|(index, center)| (Some(CenterId(index)), center.place));
    drawn.chain(centers.by_rates.iter().filter_map(|(_, place)| Some((None, (*place)?))))
}

/// Draws the panel.
pub(super) fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(centers) = context.construction().centers.as_deref() else { return };
    let named = |point| {
        let of_velocities = centers.velocities.iter().map(|velocity| velocity.point);
        of_velocities.chain(centers.curvatures.iter().map(|found| found.point)).any(|named| named == point)
    };
    scheme::draw_bare(canvas, view, context, named);
    let panel = CentersOnPaper { view, context, centers, steps: CenterSteps::of(context, centers) };
    panel.lines(canvas);
    panel.marks(canvas, |_| true);
    panel.far(canvas);
    panel.guides(canvas);
    panel.curvatures(canvas);
    panel.inflections(canvas);
    panel.velocities(canvas);
    diagram::draw(&panel, canvas);
    canvas.step = 0;
}

/// The layer with the lines and the centres that they lead to, on paper that has the mechanism already.
pub(super) fn lines_alone<'a>(context: &'a SheetContext<'a>) -> Layer<'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| {
        let Some(centers) = context.construction().centers.as_deref() else { return };
        let panel = CentersOnPaper { view, context, centers, steps: CenterSteps::of(context, centers) };
        panel.lines(canvas);
        panel.marks(canvas, |center| !center.is_permanent());
        panel.far(canvas);
        panel.velocities(canvas);
        canvas.step = 0;
    })
}

/// Draws the hints of the steps: the distances from which an angular velocity follows.
pub(super) fn hints(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>) {
    let Some(centers) = context.construction().centers.as_deref() else { return };
    for step in context.construction().numbered_steps().filter(|step| step.sheet == Sheet::Centers) {
        if let Action::CenterLine { line, .. } = step.action {
            let [from, to] = line.through.map(|id| centers.get(id).place.finite().map(|place| view.at(place)));
            if let (Some(from), Some(to)) = (from, to) {
                canvas.hint(step.number as u16, from, to);
            }
        }
    }
}

/// The steps with which marks appear.
struct CenterSteps {
    /// By centre.
    centers: Vec<u16>,
    /// By centre: of its two lines.
    lines: Vec<[u16; 2]>,
    by_rates: u16,
    /// By velocity.
    velocities: Vec<u16>,
    /// By pole tangent: of the collineation axis and of the tangent.
    tangents: Vec<[u16; 2]>,
    /// By centre of curvature: of the axis and of the centre.
    curvatures: Vec<[u16; 2]>,
    /// By inflection pole: of the point on the ray and of the pole.
    inflections: Vec<[u16; 2]>,
}

impl CenterSteps {
    fn of(context: &SheetContext<'_>, centers: &Centers) -> CenterSteps {
        let count = centers.all.len();
        let mut steps = CenterSteps {
            centers: vec![0; count],
            lines: vec![[0; 2]; count],
            by_rates: 0,
            velocities: vec![0; centers.velocities.len()],
            tangents: vec![[0; 2]; centers.tangents.len()],
            curvatures: vec![[0; 2]; centers.curvatures.len()],
            inflections: vec![[0; 2]; centers.inflections.len()],
        };
        for step in context.construction().numbered_steps().filter(|step| step.sheet == Sheet::Centers) {
            let number = step.number as u16;
            match step.action {
                Action::PermanentCenters => {
                    let permanent = centers.all.iter().zip(&mut steps.centers);
                    permanent.filter(|(center, _)| center.is_permanent()).for_each(|(_, step)| *step = number);
                }
                Action::CenterLine { center, line, .. } => {
                    let lines = centers.all.get(center.0).map(Center::lines).unwrap_or_default();
                    if let Some(side) = lines.iter().position(|own| own == line) {
                        steps.lines[center.0][side] = number;
                    }
                }
                Action::Center(center) => steps.centers[center.0] = number,
                Action::CentersByRates(_) => steps.by_rates = number,
                Action::VelocityByCenters(index) => steps.velocities[*index] = number,
                Action::Curvature { index, step } => match step {
                    CurvatureStep::Axis => steps.tangents[*index][0] = number,
                    CurvatureStep::Tangent => steps.tangents[*index][1] = number,
                    CurvatureStep::OwnAxis => steps.curvatures[*index][0] = number,
                    CurvatureStep::Center => steps.curvatures[*index][1] = number,
                    CurvatureStep::InflectionPoint => steps.inflections[*index][0] = number,
                    CurvatureStep::InflectionPole => steps.inflections[*index][1] = number,
                },
                _ => {}
            }
        }
        steps
    }
}

/// The centres as they stand on a sheet.
struct CentersOnPaper<'a> {
    view: &'a View,
    context: &'a SheetContext<'a>,
    centers: &'a Centers,
    steps: CenterSteps,
}

impl CentersOnPaper<'_> {
    /// The symbol of a centre.
    fn symbol(&self, center: &Center) -> String {
        self.context.center_symbol(center.pair, center.figure)
    }

    /// The symbol of a centre, with that of the special point that it is: `P_{20} = S_{2}`.
    fn named(&self, center: &Center) -> String {
        let own = self.symbol(center);
        self.special_at(center).map_or_else(|| own.clone(), |special| format!("{own} = {special}"))
    }

    /// Where a centre stands on the panel; none of one that is at infinity or off the panel.
    fn shown(&self, canvas: &Canvas<'_>, place: Place) -> Option<Point> {
        let at = self.view.at(place.finite()?);
        holds(canvas.room().inset(-MARK), at).then_some(at)
    }

    /// A place of a line on the sheet, and its direction there.
    fn course(&self, line: &CenterLine) -> Option<(Point, Vec2)> {
        let [first, second] = line.through.map(|id| self.centers.get(id).place);
        match (first, second) {
            (Place::At(a), Place::At(b)) => Some((self.view.at(a), on_sheet(geometry::unit(b - a)?))),
            (Place::At(at), Place::AtInfinity(along)) | (Place::AtInfinity(along), Place::At(at)) => {
                Some((self.view.at(at), on_sheet(along).normalize()))
            }
            (Place::AtInfinity(_), Place::AtInfinity(_)) => None,
        }
    }

    /// The lines, each over its three centres and a little more; towards one off the panel to its edge.
    fn lines(&self, canvas: &mut Canvas<'_>) {
        if !self.context.figure().construction.has_lines() {
            return;
        }
        for (index, center) in self.centers.all.iter().enumerate() {
            for (side, line) in center.lines().iter().enumerate() {
                let Some((at, along)) = self.course(line) else { continue };
                let reach = 2.0 * (canvas.frame.width() + canvas.frame.height() + (at - canvas.frame.center()).hypot());
                let on_line = line.through.iter().map(|id| self.centers.get(*id).place).chain([center.place]);
                let (mut low, mut high) = (-BEYOND, BEYOND);
                for place in on_line {
                    match place {
                        Place::At(place) => {
                            let t = (self.view.at(place) - at).dot(along).clamp(-reach, reach);
                            (low, high) = (low.min(t - BEYOND), high.max(t + BEYOND));
                        }
                        // The line of a finite place and a direction needs its end on the crossing alone.
                        Place::AtInfinity(_) if center.place.finite().is_some() => {}
                        Place::AtInfinity(_) => (low, high) = (-reach, reach),
                    }
                }
                if let Some((a, b)) = clipped_segment(canvas.room(), at + along * low, at + along * high) {
                    canvas.step = self.steps.lines[index][side];
                    let name = format!("line-{}-{}", center.name, side + 1);
                    canvas.draw_named(&name, Pen::Construction, Shape::Line(a, b));
                }
            }
        }
    }

    /// The marks and names of the centres on the panel; those in one place share a label.
    fn marks(&self, canvas: &mut Canvas<'_>, is_marked: fn(&Center) -> bool) {
        type Named = (String, String, u16, geometry::Point);
        let mut all: Vec<(Point, Named)> = Vec::new();
        for (index, center) in self.centers.all.iter().enumerate().filter(|(_, center)| is_marked(center)) {
            let Some(at) = self.shown(canvas, center.place) else { continue };
            canvas.step = self.steps.centers[index];
            mark(canvas, &center.name, at, center.is_permanent());
            let place = center.place.finite().unwrap_or_default();
            all.push((at, (center.name.clone(), self.named(center), canvas.step, place)));
        }
        for (pair, place) in &self.centers.by_rates {
            let Some(at) = place.and_then(|place| self.shown(canvas, place)) else { continue };
            canvas.step = self.steps.by_rates;
            let name = pair.name(self.context.mechanism());
            mark(canvas, &name, at, false);
            let (symbol, place) =
                (self.context.center_symbol(*pair, FigureOf::Mechanism), place.and_then(|place| place.finite()));
            all.push((at, (name, symbol, canvas.step, place.unwrap_or_default())));
        }
        let middle = self.view.at(self.context.facts.middle);
        let size = span(self.context.solution.pose.points.iter().copied());
        let is_one = |(.., a): &Named, (.., b): &Named| (*a - *b).norm() <= ONE_PLACE * size.max(a.coords.norm());
        for (at, here) in together_where(all.into_iter(), SHARED, is_one) {
            for names in here.chunks(TOGETHER) {
                let away = at - middle;
                let text = |until: u16| {
                    let there = names.iter().filter(|(.., since, _)| *since <= until);
                    RichText::math(&there.map(|(_, symbol, ..)| symbol.as_str()).collect::<Vec<_>>().join(", "))
                };
                let mut steps: Vec<u16> = names.iter().map(|(.., since, _)| *since).collect();
                steps.sort_unstable();
                steps.dedup();
                canvas.step = steps.pop().unwrap_or_default();
                let prefer = (away.hypot() > 5.0).then(|| away.normalize());
                let request = LabelRequest::new(text(canvas.step), at, MARK + 0.8, prefer, 3);
                canvas.ask(&names[0].0, request).before = steps.into_iter().map(|step| (step, text(step))).collect();
            }
        }
    }

    /// The special point of a link of class III or IV that is this centre, by its name.
    fn special_at(&self, center: &Center) -> Option<String> {
        let place = center.place.finite().filter(|_| center.figure == FigureOf::Mechanism && !center.is_permanent())?;
        let near = ONE_PLACE * span(self.context.solution.pose.points.iter().copied());
        let special = self.context.special().find(|special| {
            let bases = special.cuts.each_ref().map(|cut| cut.leg.base);
            let is_its = bases[0] == bases[1] && center.pair.other(special.link) == Some(bases[0]);
            is_its && special.place.finite().is_some_and(|own| (own - place).norm() <= near)
        })?;
        Some(self.context.told(&special.name, None))
    }

    /// Arrows at the edge towards the centres off the panel, with their distances.
    fn far(&self, canvas: &mut Canvas<'_>) {
        for (index, center) in self.centers.all.iter().enumerate() {
            if center.is_permanent() || self.shown(canvas, center.place).is_some() {
                continue;
            }
            let Some((line, edge, along)) = self.way_to(canvas, center) else { continue };
            canvas.step = self.steps.centers[index];
            let symbol = self.named(center);
            let start =
                line.through.iter().map(|id| self.centers.get(*id)).find(|center| center.place.finite().is_some());
            let words = match (center.place, start.and_then(|start| Some((start, start.place.finite()?)))) {
                (Place::At(place), Some((start, from))) => {
                    let unit = self.context.solution.scene.units.length.as_str();
                    let distance = format!("{} {unit}", self.context.words.write((place - from).norm(), VALUE));
                    self.context.words.language.far_away(&symbol, &distance, &self.symbol(start))
                }
                _ => self.context.words.language.at_infinity(&symbol),
            };
            let tail = edge - along * ARROW;
            self.arrow(canvas, &center.name, [tail, edge], tail, (&words, &symbol));
        }
    }

    /// The line of a far centre that runs longest from its last centre on the panel to the edge, where it leaves the panel, and its direction
    /// there. Towards infinity both ways lead.
    fn way_to<'c>(&self, canvas: &Canvas<'_>, center: &'c Center) -> Option<(&'c CenterLine, Point, Vec2)> {
        let reach = 2.0 * (canvas.frame.width() + canvas.frame.height());
        let mut best: Option<(f64, (&CenterLine, Point, Vec2))> = None;
        for line in center.lines() {
            let Some((at, along)) = self.course(line) else { continue };
            let ways = match center.place {
                Place::At(place) => vec![towards(at, self.view.at(place), along)],
                Place::AtInfinity(_) => vec![along, -along],
            };
            let on_line = || line.through.iter().filter_map(|id| self.centers.get(*id).place.finite());
            for way in ways {
                let Some((_, edge)) = clipped_segment(canvas.room().inset(-1.5), at, at + way * reach) else {
                    continue;
                };
                let last = on_line().map(|place| (self.view.at(place) - at).dot(way)).fold(0.0, f64::max);
                let free = (edge - at).dot(way) - last;
                if best.is_none_or(|(most, _)| free > most + 1e-6) {
                    best = Some((free, (line, edge, way)));
                }
            }
        }
        best.map(|(_, way)| way)
    }

    /// An arrow with words at a place, or with a symbol alone where these have no room.
    fn arrow(
        &self,
        canvas: &mut Canvas<'_>,
        name: &str,
        [tail, tip]: [Point; 2],
        at: Point,
        (words, symbol): (&str, &str),
    ) {
        canvas.draw_named(&format!("center-{name}"), Pen::Special, canvas.arrow(tail, tip));
        let request = LabelRequest::new(RichText::plain(words), at, 1.0, None, 3);
        let asked = canvas.ask(name, request);
        // Far from its arrow the distance would say nothing.
        asked.short = Some(RichText::math(symbol));
        asked.request.may_stand_apart = false;
    }

    /// Arrows at the blocks towards the permanent centres at infinity.
    fn guides(&self, canvas: &mut Canvas<'_>) {
        for (index, center) in self.centers.all.iter().enumerate() {
            let (CenterOrigin::Guide(slider), Place::AtInfinity(along)) = (&center.origin, center.place) else {
                continue;
            };
            canvas.step = self.steps.centers[index];
            let at = self.view.at(self.context.solution.pose.point(self.context.mechanism().slider(*slider).at));
            let along = on_sheet(along).normalize();
            let is_free = |along: &Vec2| {
                let tip = at + *along * (scheme::BLOCK.y + 2.0 + ARROW);
                canvas.room().contains(tip) && canvas.is_free(at + *along * (scheme::BLOCK.y + 3.0 + 0.5 * ARROW), 1.2)
            };
            let along = [along, -along].into_iter().find(is_free).unwrap_or(along);
            let tail = at + along * (scheme::BLOCK.y + 1.5);
            let tip = tail + along * ARROW;
            let symbol = self.symbol(center);
            let words = self.context.words.language.at_infinity(&symbol);
            // Next to the block there are other names.
            self.arrow(canvas, &center.name, [tail, tip], tip, (&words, &symbol));
        }
    }

    /// The velocities by centres, with the rays that they are normal to.
    fn velocities(&self, canvas: &mut Canvas<'_>) {
        let units = self.context.solution.scene.units;
        for (velocity, &step) in self.centers.velocities.iter().zip(&self.steps.velocities) {
            canvas.step = step;
            let name = self.context.mechanism().point_name(velocity.point);
            let from = self.context.solution.pose.point(velocity.point);
            let [at, tip] = [from, from + velocity.arrow].map(|place| self.view.at(place));
            if (tip - at).hypot() < 1e-3 {
                continue;
            }
            canvas.draw_named(&format!("velocity-{name}"), Pen::Velocity, canvas.arrow(at, tip));
            let value = self.context.words.write(velocity.velocity.norm(), VALUE);
            let symbol = RichText::math(&format!("v_{{{}}}", self.context.told(name, None)));
            let value = format!("= {value} {}", QuantityKind::Velocity.unit(units));
            let text = symbol.clone().followed_by(&RichText::plain(&value));
            let request = LabelRequest::new(text, at.lerp(tip, 0.75), 1.0, None, 2);
            canvas.ask(&format!("velocity-{name}"), request).short = Some(symbol);
        }
    }
}

/// A cross for a permanent centre, a diamond for another.
fn mark(canvas: &mut Canvas<'_>, name: &str, at: Point, is_permanent: bool) {
    let corner = |x: f64, y: f64| at + Vec2::new(x, y) * MARK;
    let name = format!("center-{name}");
    if is_permanent {
        for (from, to) in [(corner(-1.0, -1.0), corner(1.0, 1.0)), (corner(-1.0, 1.0), corner(1.0, -1.0))] {
            canvas.draw(Pen::Special, Shape::Line(from, to));
        }
        canvas.obstacles.add_boxes([Rect::from_center_size(at, (2.0 * MARK, 2.0 * MARK))]);
    } else {
        let corners = [corner(0.0, -1.2), corner(1.2, 0.0), corner(0.0, 1.2), corner(-1.2, 0.0)];
        canvas.draw_named(&name, Pen::Special, Shape::Polygon(corners.to_vec()));
        canvas.obstacles.add_boxes([Rect::from_center_size(at, (2.4 * MARK, 2.4 * MARK))]);
    }
}
