//! The motion of a body's point, laid off in a plan: from the pole where the scene gives it, else from a point that is there.

use super::act::{PlaceId, Product, Reference, Sheet};
use super::writer::Writer;
use crate::geometry::unit;
use crate::mechanism::{BodyId, DrivenSlide, JointId, JointKind, PointId, Role, SliderId};
use crate::plan::{coriolis_name, image_name, point_on, slide_name};

/// How a body hangs on one whose motion is there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// The joint.
    pub joint: JointId,
    /// The body on its other side.
    pub from: BodyId,
}

impl Writer<'_> {
    /// The rates that the scene gives: of bodies and of driven sliders.
    pub(super) fn take_known_rates(&mut self) {
        let mechanism = self.mechanism;
        for body in (0..mechanism.bodies.len()).map(BodyId) {
            let root = mechanism.body(mechanism.root(body));
            let rates = match root.role {
                Role::Ground => [0.0, 0.0],
                Role::Driver { omega, alpha, .. } | Role::Moving { omega, alpha, .. } => [omega, alpha],
                Role::Pushed { .. } | Role::Carrier { .. } | Role::Stub | Role::Member => continue,
            };
            let name = &mechanism.body(body).name;
            let omega = self.take(Sheet::Velocity, &format!("omega({name})"), rates[0]);
            let alpha = self.take(Sheet::Acceleration, &format!("alpha({name})"), rates[1]);
            self.drafting.spins[body.0] = Some([omega, alpha]);
        }
        for id in (0..mechanism.sliders.len()).map(SliderId) {
            if let Some(drive) = mechanism.slider(id).drive {
                let name = mechanism.slider_name(id);
                let speed = self.take(Sheet::Velocity, &format!("v_r({name})"), drive.speed);
                let makes = format!("a_r({name})");
                let second = self.take(Sheet::Acceleration, &makes, drive.acceleration);
                self.drafting.slides[id.0] = Some([speed, second]);
            }
        }
    }

    /// The end of the vector of the body's point at `point` in a plan; `None` where the construction does not give it.
    pub(super) fn motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        if let Some(place) = self.moved_point(sheet, body, point) {
            return Some(place);
        }
        let place = if self.mechanism.is_known(body) {
            self.known_motion(sheet, body, point)?
        } else {
            self.found_motion(sheet, body, point)?
        };
        self.moved.push((sheet, body, point, place));
        Some(place)
    }

    pub(super) fn moved_point(&self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        let mut moved = self.moved.iter();
        let found = moved.find(|m| (m.0, m.1, m.2) == (sheet, body, point));
        found.map(|m| m.3)
    }

    fn known_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        let (mechanism, pole) = (self.mechanism, self.pole_of(sheet)?);
        match mechanism.body(body).role {
            Role::Ground => Some(pole),
            Role::Driver { pivot, .. } => self.turn(sheet, body, (pivot, pole), point),
            Role::Pushed { .. } => {
                let root = mechanism.root(body);
                let start = self.motion(sheet, root, point)?;
                let name = image_name(&point_on(mechanism, root, point));
                self.name_place(sheet, &name, start);
                let way = mechanism.way(root, body);
                let (_, end) = self.named_slides(sheet, name, start, &way)?;
                Some(end)
            }
            // Given as a vector.
            _ => {
                let (motion, at) = (self.motion.body(body), self.pose.point(point));
                let vector = match sheet {
                    Sheet::Acceleration => motion.acceleration_at(at),
                    _ => motion.velocity_at(at),
                };
                let makes = format!("given vector of {}", mechanism.point_name(point));
                let size = self.take(sheet, &makes, vector.norm());
                let sum = size.map(|size| Product::new(1.0, &[size]));
                let along = Reference::Given(unit(vector).unwrap_or_default());
                let sum = sum.into_iter().collect();
                Some(self.lay_off(sheet, &makes, pole, sum, (along, 0)))
            }
        }
    }

    /// From another point of the body that is in the plan, from the body on which it hangs, or from a link of its compound.
    fn found_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId) -> Option<PlaceId> {
        self.drafting.spins[body.0]?;
        let mechanism = self.mechanism;
        let own = |m: &&(Sheet, BodyId, PointId, PlaceId)| (m.0, m.1) == (sheet, body);
        if let Some(&(.., from, place)) = self.moved.iter().find(own) {
            return self.turn(sheet, body, (from, place), point);
        }
        if let Some(Anchor { joint, from }) = self.anchors[body.0] {
            let at = mechanism.joint_point(joint);
            let mut place = self.motion(sheet, from, at)?;
            if let JointKind::Prismatic(slider) = mechanism.joint(joint).kind {
                let guide_first = mechanism.slider(slider).on == from;
                let slide = DrivenSlide { slider, from, to: body, sign: if guide_first { 1.0 } else { -1.0 } };
                place = self.slides(sheet, place, &[slide])?;
            }
            self.moved.push((sheet, body, at, place));
            return self.turn(sheet, body, (at, place), point);
        }
        // Driven sliders join it to a link that hangs on something.
        let root = mechanism.root(body);
        let mut others = mechanism.compound(root).into_iter();
        let is_there = |b: &BodyId| {
            let moved = || self.moved.iter().any(|m| (m.0, m.1) == (sheet, *b));
            self.anchors[b.0].is_some() || moved()
        };
        let other = others.find(|b| *b != body && is_there(b))?;
        let start = self.motion(sheet, other, point)?;
        self.slides(sheet, start, &mechanism.way(other, body))
    }

    /// What the rotation of a body adds from one of its points to another.
    fn turn(&mut self, sheet: Sheet, body: BodyId, (from, place): (PointId, PlaceId), to: PointId) -> Option<PlaceId> {
        let [omega, alpha] = self.drafting.spins[body.0]?;
        let at_rest = omega.is_none() && alpha.is_none();
        // Two pins may have one place.
        if from == to || at_rest || self.pose.arm(from, to).norm() == 0.0 {
            return Some(place);
        }
        let line = Reference::Line(self.join(from, to));
        let length = self.length(from, to);
        let name = |p: PointId| self.mechanism.point_name(p);
        let makes = format!("{}{}", name(to), name(from));
        let turned = |rate| vec![Product::new(1.0, &[rate, length])];
        if sheet == Sheet::Velocity {
            let sum = omega.map(turned).unwrap_or_default();
            return Some(self.lay_off(sheet, &format!("v_{makes}"), place, sum, (line, 1)));
        }
        let normal = omega.map(|omega| vec![Product::new(-1.0, &[omega, omega, length])]);
        let makes_normal = format!("a^n_{makes}");
        let sum = normal.unwrap_or_default();
        let place = self.lay_off(sheet, &makes_normal, place, sum, (line, 0));
        let sum = alpha.map(turned).unwrap_or_default();
        Some(self.lay_off(sheet, &format!("a^t_{makes}"), place, sum, (line, 1)))
    }

    /// What sliders add, one after the other.
    pub(super) fn slides(&mut self, sheet: Sheet, mut place: PlaceId, way: &[DrivenSlide]) -> Option<PlaceId> {
        for slide in way {
            place = self.sliding(sheet, place, slide)?;
            if sheet == Sheet::Acceleration {
                place = self.coriolis(place, slide)?;
            }
        }
        Some(place)
    }

    /// What driven sliders add from a plan point on, its ends named as in the plans; the name and the place reached.
    pub(super) fn named_slides(
        &mut self,
        sheet: Sheet,
        start: String,
        mut place: PlaceId,
        way: &[DrivenSlide],
    ) -> Option<(String, PlaceId)> {
        let (mut name, mut entered) = (start.clone(), String::new());
        for slide in way {
            entered.push_str(&self.mechanism.body(slide.to).name);
            let sliding = slide_name(&start, &entered);
            let end = match self.drafting.place(sheet, &sliding) {
                Some(end) => end,
                None => self.sliding(sheet, place, slide)?,
            };
            (name, place) = self.end(sheet, (name, place), (sliding, end));
            if sheet == Sheet::Acceleration {
                let coriolis = coriolis_name(&start, &entered);
                let end = match self.drafting.place(sheet, &coriolis) {
                    Some(end) => end,
                    None => self.coriolis(place, slide)?,
                };
                (name, place) = self.end(sheet, (name, place), (coriolis, end));
            }
        }
        Some((name, place))
    }

    /// The end of a vector, with its name; where nothing was laid off there is no new name.
    fn end(&mut self, sheet: Sheet, before: (String, PlaceId), (name, end): (String, PlaceId)) -> (String, PlaceId) {
        if end == before.1 {
            return before;
        }
        self.name_place(sheet, &name, end);
        (name, end)
    }

    /// A slider's sliding velocity or acceleration, laid off.
    pub(super) fn sliding(&mut self, sheet: Sheet, place: PlaceId, slide: &DrivenSlide) -> Option<PlaceId> {
        let [velocity, acceleration] = self.drafting.slides[slide.slider.0]?;
        let (letter, rate) = match sheet {
            Sheet::Acceleration => ("a", acceleration),
            _ => ("v", velocity),
        };
        let line = Reference::Line(self.guide(slide.slider));
        let makes = format!("{letter}_r({})", self.mechanism.slider_name(slide.slider));
        let sum = rate.map(|rate| vec![Product::new(slide.sign, &[rate])]);
        Some(self.lay_off(sheet, &makes, place, sum.unwrap_or_default(), (line, 0)))
    }

    /// A slider's Coriolis acceleration, laid off.
    pub(super) fn coriolis(&mut self, place: PlaceId, slide: &DrivenSlide) -> Option<PlaceId> {
        let [velocity, _] = self.drafting.slides[slide.slider.0]?;
        let [omega, _] = self.drafting.spins[slide.to.0]?;
        let line = Reference::Line(self.guide(slide.slider));
        let makes = format!("a_c({})", self.mechanism.slider_name(slide.slider));
        let both = omega.zip(velocity);
        let sum = both.map(|(omega, rate)| vec![Product::new(2.0 * slide.sign, &[omega, rate])]);
        let sheet = Sheet::Acceleration;
        Some(self.lay_off(sheet, &makes, place, sum.unwrap_or_default(), (line, 1)))
    }
}
