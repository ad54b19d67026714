//! Images of a group's joints, once its rates are known.

use super::name::{coincident_name, image_name};
use super::plan::PointRole;
use super::step::{Action, Arrow, RelativePart, VectorOf};
use super::writer::Writer;
use crate::mechanism::{Carried, Group, Leg, SliderId};
use crate::sheet::Sheet;

impl Writer<'_> {
    /// Adds the velocity plan's steps from the images of a group's outer joints to those of its inner ones.
    ///
    /// With known rates every point of a carrying link follows from its outer joint. At a prismatic joint the point of
    /// the guide's body under the slider comes first, then the sliding velocity.
    pub(super) fn image_steps(&mut self, group: &Group) {
        let mut carried: Vec<(Leg, Carried)> = Vec::new();
        for leg in group.special.iter().flat_map(|s| s.legs) {
            if let Some(second) = leg.carried.filter(|_| !carried.iter().any(|(known, _)| *known == leg)) {
                carried.push((leg, second));
            }
        }
        // Pins first: the image of a slider's point is there before the step of its sliding velocity.
        carried.sort_by_key(|(_, second)| self.mechanism.joint(second.inner).pin.is_none());
        for (leg, second) in &carried {
            self.image_step_of_leg(leg, second);
        }
    }

    fn image_step_of_leg(&mut self, leg: &Leg, second: &Carried) {
        let (mechanism, sheet) = (self.mechanism, Sheet::Velocity);
        let outer = mechanism.joint_point(leg.outer);
        // The links of the carrying compound link at the outer and at the inner joint.
        let [outer_link, inner_link] = [leg.outer, second.inner].map(|joint| mechanism.side(joint, second.carrier));
        let mut from = image_name(mechanism.point_name(outer));
        if let Some(slider) = mechanism.joint(leg.outer).slider {
            let [guide_image, slider_image] = self.sliding_velocity_step(slider);
            from = if mechanism.slide_sign(slider, second.carrier) > 0.0 { guide_image } else { slider_image };
        }
        let slides = leg.carrier_slides(mechanism);
        if !slides.is_empty() {
            let start = (from, self.motion(sheet, outer_link, outer));
            let (name, place) = self.driven_slides(sheet, start, &slides, PointRole::Slid, None);
            self.construction.record.note_motion(sheet, inner_link, outer, place);
            from = name;
        }
        let inner = mechanism.joint_point(second.inner);
        let name = mechanism.point_name(inner);
        let slider = mechanism.joint(second.inner).slider;
        let end = match slider.is_some_and(|id| mechanism.slider(id).on == inner_link) {
            true => coincident_name(name, &mechanism.body(inner_link).name),
            false => name.to_owned(),
        };
        let to = image_name(&end);
        // A dyad's inner joint has its image already, the crossing of its rays.
        if !self.shows(sheet, &to) {
            let of = VectorOf::Relative {
                link: inner_link,
                from: mechanism.point_name(outer).to_owned(),
                to: end,
                part: RelativePart::Velocity,
            };
            let step = self.begin(sheet);
            let place = self.motion(sheet, inner_link, inner);
            self.show(sheet, &to, place, PointRole::Image);
            let step = self.finish(step, Action::LayOff(Arrow { from, to, of }));
            self.claim(step, place);
        }
        if let Some(slider) = slider {
            self.sliding_velocity_step(slider);
        }
    }

    /// Adds the step of a sliding velocity, from the image of the guide's point to that of the slider's; returns both
    /// names.
    fn sliding_velocity_step(&mut self, id: SliderId) -> [String; 2] {
        let (mechanism, sheet) = (self.mechanism, Sheet::Velocity);
        let slider = mechanism.slider(id);
        let at = mechanism.point_name(slider.at);
        let under = coincident_name(at, &mechanism.body(slider.on).name);
        let names = [image_name(&under), image_name(at)];
        let of = VectorOf::Sliding(id, under);
        let step = self.begin(sheet);
        let image = self.motion(sheet, slider.link, slider.at);
        let guide_image = self.motion(sheet, slider.on, slider.at);
        self.show(sheet, &names[0], guide_image, PointRole::Image);
        self.show(sheet, &names[1], image, PointRole::Image);
        let [from, to] = names.clone();
        let step = self.finish(step, Action::LayOff(Arrow { from, to, of }));
        self.claim(step, image);
        names
    }

    /// Constructs the images of the group's joints by relative motions: first of pins, then of sliders.
    pub(super) fn relative_images(&mut self, sheet: Sheet, group: &Group) {
        let mechanism = self.mechanism;
        for joint in mechanism.joints_of(group) {
            if let Some(point) = mechanism.joint(joint).pin {
                let bodies = mechanism.joint(joint).bodies;
                let body = bodies.into_iter().find(|&body| self.place_of_motion(sheet, body, point).is_some());
                let anchored = || bodies.into_iter().find(|&body| self.construction.record.anchors.contains_key(&body));
                if let Some(body) = body.or_else(anchored) {
                    self.relative_image(sheet, body, point);
                    let place = self.motion(sheet, body, point);
                    for other in bodies {
                        if self.place_of_motion(sheet, other, point).is_none() {
                            self.construction.record.note_motion(sheet, other, point, place);
                        }
                    }
                }
            }
        }
        for joint in mechanism.joints_of(group) {
            let Some(slider) = mechanism.joint(joint).slider else { continue };
            let ends = mechanism.slider(slider);
            for body in [ends.on, ends.link] {
                self.relative_image(sheet, body, ends.at);
            }
        }
    }

    /// Names the images of the group's joints: first of pins, each by the motion of its carrying link, then of sliders.
    pub(super) fn images(&mut self, sheet: Sheet, group: &Group) {
        let mechanism = self.mechanism;
        for (special, leg) in group.special.iter().flat_map(|s| s.legs.map(|leg| (s, leg))) {
            let Some(Carried { carrier, inner }) = leg.carried else { continue };
            if let Some(point) = mechanism.joint(inner).pin {
                let place = self.motion(sheet, mechanism.side(inner, carrier), point);
                self.name_place(sheet, &image_name(mechanism.point_name(point)), place);
                let other = mechanism.side(inner, mechanism.lead(special.link));
                if self.place_of_motion(sheet, other, point).is_none() {
                    self.construction.record.note_motion(sheet, other, point, place);
                }
            }
        }
        for joint in mechanism.joints_of(group) {
            let Some(slider) = mechanism.joint(joint).slider else { continue };
            let ends = mechanism.slider(slider);
            let at = mechanism.point_name(ends.at);
            let under = coincident_name(at, &mechanism.body(ends.on).name);
            for (body, name) in [(ends.link, at), (ends.on, under.as_str())] {
                let place = self.motion(sheet, body, ends.at);
                self.name_place(sheet, &image_name(name), place);
            }
        }
    }
}
