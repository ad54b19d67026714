//! Polygons, side by side.

use super::statics::{Force, Statics};
use super::{ForceOf, ForcePart, ForceStep, FoundForce, Polygon, Side, SideKind, WholeForce};
use crate::construction::number::{NumberKind, Product};
use crate::construction::operation::{Along, MeasuredAs, OperationKind, OperationRole, PlaceId};
use crate::geometry::{Ball, Pair, Vector};
use crate::mechanism::{BodyId, GROUND, JointId};
use crate::sheet::Sheet;

/// White between polygons, in parts of the largest one's size.
const APART: f64 = 0.22;
/// Width of all polygons over their height, about.
const WIDE: f64 = 1.15;

/// A polygon that is being drawn.
#[derive(Clone, Copy)]
pub(super) struct Chain {
    pub polygon: usize,
    /// Where it begins.
    pub start: PlaceId,
    /// Where its last side ends.
    pub end: PlaceId,
}

impl Statics<'_, '_> {
    /// Begins the polygon of links that are cut free together.
    pub fn chain(&mut self, links: &[BodyId]) -> Chain {
        let polygon = self.plan.polygons.len();
        self.plan.polygons.push(Polygon { links: links.to_vec(), sides: Vec::new() });
        let start = self.writer.pole(Sheet::Forces, &format!("o{}", polygon + 1), Vector::zeros());
        Chain { polygon, start, end: start }
    }

    fn add_side(&mut self, polygon: usize, of: ForceOf, ends: [PlaceId; 2], kind: SideKind) -> usize {
        let on = match of {
            ForceOf::Joint { on, .. } | ForceOf::Both { on, .. } => on,
            ForceOf::Load(index) => self.plan.loads[index].body,
        };
        let [from, to] = ends.map(|place| self.exact(place));
        let sides = &mut self.plan.polygons[polygon].sides;
        sides.push(Side { of, on, ends, from, vector: to - from, kind });
        sides.len() - 1
    }

    /// Lays a known force off.
    pub fn lay_off(&mut self, chain: &mut Chain, force: &Force) {
        let step = self.begin();
        let (from, sum) = (chain.end, vec![Product::plain(force.size).times(force.sign)]);
        chain.end = self.writer.lay_off(Sheet::Forces, from, sum, force.along);
        if let Some(exact) = force.exact {
            let places = &mut self.writer.construction.record.exact.places;
            places[chain.end.0] = places[from.0] + exact * Ball::from(1).signed(force.sign);
        }
        let side = self.add_side(chain.polygon, force.of, [from, chain.end], SideKind::Known);
        self.finish(step, ForceStep::LayOff(chain.polygon, side));
    }

    pub fn lay_off_all<'f>(&mut self, chain: &mut Chain, forces: impl IntoIterator<Item = &'f Force>) {
        forces.into_iter().for_each(|force| self.lay_off(chain, force));
    }

    /// Lays off what is known to act on some bodies from outside.
    pub fn lay_off_loads(&mut self, chain: &mut Chain, bodies: &[BodyId]) {
        let forces = self.set(bodies).forces;
        self.lay_off_all(chain, &forces);
    }

    /// Closes a polygon by two forces of known directions: the first before its start, the second after its end. Gives both, each
    /// acting in its place on the scheme, and the corner between them; `None` where they are parallel.
    pub fn close_by_two(
        &mut self,
        chain: &Chain,
        [first, second]: [(ForceOf, PlaceId, Along); 2],
    ) -> Option<([Force; 2], PlaceId)> {
        let sides = self.plan.polygons[chain.polygon].sides.len();
        let mut lines = Vec::new();
        for (index, (through, along)) in [(1, (chain.end, second.2)), (0, (chain.start, first.2))] {
            let step = self.begin();
            lines.push(self.writer.draw(Sheet::Forces, OperationRole::Ray, through, along));
            self.finish(step, ForceStep::Direction(chain.polygon, sides + index));
        }
        let step = self.begin();
        let corner = self.writer.cross(true, Sheet::Forces, OperationRole::Image, [lines[0], lines[1]])?;
        let [after, before] =
            [(lines[0], [chain.end, corner]), (lines[1], [corner, chain.start])].map(|(line, ends)| {
                let size = self.writer.measure(Sheet::Forces, NumberKind::Force, ends, MeasuredAs::Along(line));
                (size, ends)
            });
        self.add_side(chain.polygon, first.0, before.1, SideKind::Found);
        self.add_side(chain.polygon, second.0, after.1, SideKind::Found);
        self.finish(step, ForceStep::Cross(chain.polygon, sides));
        let force = |(of, at, along): (ForceOf, PlaceId, Along), size| {
            let on = of.on().unwrap_or(GROUND);
            Force { of, on, at, along, size, sign: 1.0, exact: None }
        };
        let found = [force(first, before.0), force(second, after.0)];
        self.plan.numbers.parts.extend(found.iter().map(|force| FoundForce::from(*force)));
        Some((found, corner))
    }

    /// Closes a polygon by the whole force in a joint.
    pub fn close(&mut self, chain: &Chain, joint: JointId, on: BodyId) {
        let ends = [chain.end, chain.start];
        let step = self.begin();
        let of = Statics::part(joint, on, ForcePart::Whole);
        self.found(of, ends);
        let side = self.add_side(chain.polygon, of, ends, SideKind::Found);
        self.finish(step, ForceStep::Close(chain.polygon, side));
    }

    /// Joins two corners of a polygon by the whole force in a joint: the sum of its parts, or what closes the polygon of a part of the
    /// links.
    pub fn join(&mut self, polygon: usize, joint: JointId, on: BodyId, ends: [PlaceId; 2]) {
        let step = self.begin();
        let of = Statics::part(joint, on, ForcePart::Whole);
        self.found(of, ends);
        // A side that is there needs no diagonal.
        let is_side = |side: &&mut Side| side.ends == ends && side.on == on;
        if let Some(side) = self.plan.polygons[polygon].sides.iter_mut().find(is_side) {
            side.of = of;
            return;
        }
        let side = self.add_side(polygon, of, ends, SideKind::Diagonal);
        self.finish(step, ForceStep::Join(polygon, side));
    }

    /// Notes what a joint does to a body: from one corner of a polygon to another.
    fn found(&mut self, of: ForceOf, ends: [PlaceId; 2]) {
        let ForceOf::Joint { joint, on, .. } = of else { return };
        let [from, to] = ends.map(|place| self.writer.construction.record.exact.places[place.0]);
        if ends[0] == ends[1] || self.is_nothing(to - from) {
            self.joints.insert(joint, None);
            self.plan.joints.push((joint, on, (ends[0] != ends[1]).then_some(ends)));
            return;
        }
        let line = self.writer.join_places(Sheet::Forces, OperationRole::Line, ends);
        let size = self.writer.measure(Sheet::Forces, NumberKind::Force, ends, MeasuredAs::Size);
        let at = self.place(joint);
        let force = Force { of, on, at, along: Along::line(line), size, sign: 1.0, exact: None };
        self.plan.numbers.whole.push(WholeForce { joint, on, ends, size });
        self.joints.insert(joint, Some(force));
        self.plan.joints.push((joint, on, Some(ends)));
    }

    /// Moves the polygons apart, in rows, the first ones on top: operations from `first` on are those of this plan.
    pub fn move_apart(&mut self, first: usize) {
        let boxes: Vec<[Vector; 2]> = self.plan.polygons.iter().map(extent).collect();
        let size = |[low, high]: &[Vector; 2]| high - low;
        let largest = boxes.iter().map(|own| size(own).amax()).fold(0.0, f64::max);
        let gap = APART * largest;
        let area: f64 = boxes.iter().map(|own| (size(own).x + gap) * (size(own).y + gap)).sum();
        let widest = boxes.iter().map(|own| size(own).x).fold(0.0, f64::max);
        let width = (area * WIDE).sqrt().max(widest);
        let (mut at, mut height) = (Vector::zeros(), 0.0_f64);
        let mut moved = Vec::new();
        for own in &boxes {
            if at.x > 0.0 && at.x + size(own).x > width {
                at = Vector::new(0.0, at.y - height - gap);
                height = 0.0;
            }
            // The upper left corner.
            moved.push(Vector::new(at.x - own[0].x, at.y - own[1].y));
            at.x += size(own).x + gap;
            height = height.max(size(own).y);
        }
        self.shift(first, &moved);
    }

    fn shift(&mut self, first: usize, moved: &[Vector]) {
        let construction = &mut self.writer.construction;
        let counts = construction.record.counts();
        // The polygon of each place and line.
        let (mut places, mut lines) = (vec![None; counts[0]], vec![None; counts[1]]);
        let mut poles = 0..moved.len();
        for operation in construction.operations[first..].iter_mut().filter(|own| own.sheet == Sheet::Forces) {
            let polygon = match &mut operation.kind {
                OperationKind::Pole { at, .. } => {
                    let next = poles.next();
                    if let Some(next) = next {
                        *at += moved[next];
                    }
                    next
                }
                OperationKind::LayOff { from, .. } | OperationKind::Join { from, .. } => places[from.0],
                OperationKind::Draw { through, .. } => places[through.0],
                OperationKind::Cross { lines: [first, _], .. } => lines[first.0],
                _ => None,
            };
            let Some(polygon) = polygon else { continue };
            let by = moved[polygon];
            if let Some(place) = operation.kind.place() {
                places[place.0] = Some(polygon);
                let exact = &mut construction.record.exact.places[place.0];
                *exact = *exact + Pair::within(by, 0.0);
            }
            if let Some(line) = operation.kind.line() {
                lines[line.0] = Some(polygon);
                let exact = &mut construction.record.exact.lines[line.0].0;
                *exact = *exact + Pair::within(by, 0.0);
            }
        }
        for (polygon, by) in self.plan.polygons.iter_mut().zip(moved) {
            polygon.sides.iter_mut().for_each(|side| side.from += by);
        }
    }
}

/// The corners of the box around a polygon.
fn extent(polygon: &Polygon) -> [Vector; 2] {
    let ends = polygon.sides.iter().flat_map(|side| [side.from, side.from + side.vector]);
    let nothing = [Vector::zeros(); 2];
    ends.map(|end| [end; 2]).reduce(|[low, high], [end, _]| [low.inf(&end), high.sup(&end)]).unwrap_or(nothing)
}
