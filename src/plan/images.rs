use super::driven::{self, SlideMeasure};
use super::name::{coincident_name, image_name};
use super::step::{Action, Arrow, Part, Plan, PlanPoint, PointRole, Step};
use super::words;
use crate::geometry::Vector;
use crate::mechanism::{Carried, Group, JointKind, Leg, Mechanism, SliderId};
use crate::motion::Motion;
use crate::position::Pose;
use crate::words::Wording;

/// Adds to the velocity plan the images of a group's inner joints, from the images of its outer ones.
///
/// With the rates known every point of a carrying link follows from its outer joint; at a prismatic joint
/// the point of the guide's body under the slider comes first, then the sliding velocity.
pub(super) fn images(
    words: &Wording,
    mechanism: &Mechanism,
    pose: &Pose,
    motion: &Motion,
    group: &Group,
    plan: &mut Plan,
) {
    let mut board = Images { words, mechanism, pose, motion, plan };
    let legs = group.special.iter().flat_map(|s| s.legs);
    let mut carried: Vec<(Leg, Carried)> = Vec::new();
    for leg in legs {
        if let Some(second) = leg.carried.filter(|_| !carried.iter().any(|(l, _)| *l == leg)) {
            carried.push((leg, second));
        }
    }
    // Pins first, so that a slider's point has its image before the point under it is joined to it.
    carried.sort_by_key(|(_, second)| mechanism.is_prismatic(second.inner));
    for (leg, second) in &carried {
        board.leg(leg, second);
    }
}

struct Images<'a> {
    words: &'a Wording,
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    plan: &'a mut Plan,
}

impl Images<'_> {
    fn leg(&mut self, leg: &Leg, second: &Carried) {
        let outer = self.mechanism.joint_point(leg.outer);
        let outer_name = self.mechanism.point_name(outer);
        let mut from = image_name(outer_name);
        if let JointKind::Prismatic(slider) = self.mechanism.joint(leg.outer).kind {
            let (under, image) = self.slide(slider);
            let guide_on_carrier = self.mechanism.slide_sign(slider, second.carrier) > 0.0;
            from = if guide_on_carrier { under } else { image };
        }
        let from = self.driven(leg, from);
        // The link of a compound one that holds the inner joint.
        let holder = self.mechanism.side(second.inner, second.carrier);
        let carrier = &self.mechanism.body(holder).name;
        match self.mechanism.joint(second.inner).kind {
            JointKind::Revolute(point) => {
                let name = self.mechanism.point_name(point);
                let place = self.pose.point(point);
                let velocity = self.motion.body(holder).velocity_at(place);
                let words = words::image(self.words, carrier, outer_name, name);
                self.lay_off(&from, image_name(name), velocity, Part::Relative, words);
            }
            JointKind::Prismatic(id) => {
                let slider = self.mechanism.slider(id);
                let at = self.mechanism.point_name(slider.at);
                let under = coincident_name(at, &self.mechanism.body(slider.on).name);
                let own = if slider.on == holder { under } else { at.to_owned() };
                let place = self.pose.point(slider.at);
                let velocity = self.motion.body(holder).velocity_at(place);
                let words = words::image(self.words, carrier, outer_name, &own);
                self.lay_off(&from, image_name(&own), velocity, Part::Relative, words);
                self.slide(id);
            }
        }
    }

    /// What driven sliders within the carrying link add from the plan point `from` on; the point reached.
    fn driven(&mut self, leg: &Leg, from: String) -> String {
        let way = leg.carrier_slides(self.mechanism);
        let slides = SlideMeasure::on_way(self.mechanism, self.pose, self.motion, &way);
        let parts = driven::parts(self.mechanism, self.plan.kind, &from, &slides);
        driven::lay_off(self.words, self.mechanism, self.plan, PointRole::Slid, from, parts)
    }

    /// The sliding velocity at a slider, from the image of the guide's point to that of the slider's; returns both names.
    fn slide(&mut self, id: SliderId) -> (String, String) {
        let slider = self.mechanism.slider(id);
        let at = self.mechanism.point_name(slider.at);
        let place = self.pose.point(slider.at);
        let image = image_name(at);
        let under = coincident_name(at, &self.mechanism.body(slider.on).name);
        let under_image = image_name(&under);
        let on = self.motion.body(slider.on).velocity_at(place);
        let own = self.motion.body(slider.link).velocity_at(place);
        let role = PointRole::Image;
        for (name, vector) in [(&under_image, on), (&image, own)] {
            let point = PlanPoint { vector, role };
            self.plan.points.entry(name.clone()).or_insert(point);
        }
        let words = words::sliding(self.words, &self.mechanism.slider_name(id), &under, at);
        self.lay_off(&under_image, image.clone(), own, Part::Sliding, words);
        (under_image, image)
    }

    fn lay_off(&mut self, from: &str, to: String, vector: Vector, part: Part, (equation, caption): (String, String)) {
        // A dyad's joint has its image already, where the rays cross.
        if self.plan.points.contains_key(&to) && part == Part::Relative {
            return;
        }
        let point = PlanPoint { vector, role: PointRole::Image };
        self.plan.points.entry(to.clone()).or_insert(point);
        let arrow = Arrow { from: from.to_owned(), to, part };
        self.plan.steps.push(Step { action: Action::LayOff(arrow), equation: equation.into(), caption });
    }
}
