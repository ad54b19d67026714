//! Pitch circles of wheels that mesh: a stroke where two touch, and the hatching of those that are fixed. Teeth are not drawn, as in textbooks of
//! mechanisms.

use super::on_paper::{SchemeOnPaper, circles};
use crate::construction::{SpotName, display, image_name};
use crate::drawing::canvas::Canvas;
use crate::drawing::shape::Shape;
use crate::drawing::sheet::Pen;
use crate::geometry;
use crate::mechanism::{GROUND, Joint, JointId, Pitch, Rack};
use crate::sheet::Sheet;
use kurbo::{Point, Vec2};
use std::f64::consts::{PI, TAU};

/// Half the length of the stroke where two pitch circles touch, in mm.
const TOUCH: f64 = 1.6;

/// Length of a stroke of a fixed wheel's hatching, and the distance of two on its rim, in mm.
const HATCH: f64 = 1.6;
const APART: f64 = 1.4;

/// Strokes of a fixed wheel's hatching on either side of its middle.
const STROKES: i32 = 6;

impl SchemeOnPaper<'_> {
    /// Draws the circles larger than that of a pin, each once, with what belongs to them.
    pub(super) fn wheels(&self, canvas: &mut Canvas<'_>) {
        let mut drawn: Vec<(Point, f64)> = Vec::new();
        for (center, radius) in circles(self.mechanism, self.pose) {
            let (center, rim) = (self.pose.point(center), geometry::Vector::new(radius, 0.0));
            let (center, rim) = (self.view.at(center), self.view.at(center + rim));
            let radius = (rim - center).hypot();
            let is_drawn = drawn.iter().any(|(other, own)| (*other - center).hypot() + (own - radius).abs() < 0.05);
            if radius <= self.dims().joint || is_drawn {
                continue;
            }
            drawn.push((center, radius));
            // Two half circles: unlike a full circle they leave the inside free for a label.
            for start in [0.0, PI] {
                canvas.draw(Pen::Guide, Shape::Arc { center, radius, start, sweep: PI });
            }
        }
        for (index, joint) in self.mechanism.joints.iter().enumerate() {
            if let Some(pitch) = joint.pitch {
                self.mesh(canvas, joint, pitch);
                self.pitch_point(canvas, JointId(index), pitch);
            }
            if let Some(rack) = joint.rack {
                self.rack(canvas, joint, rack);
                self.pitch_point_of_rack(canvas, JointId(index), rack);
            }
            if let Some(belt) = joint.belt {
                self.belt(canvas, belt);
            }
        }
    }

    /// The name of the point where a wheel touches its rack, where the speed diagram has it.
    fn pitch_point_of_rack(&self, canvas: &mut Canvas<'_>, joint: JointId, rack: Rack) {
        let Some(diagram) = &self.context.construction().speeds else { return };
        let Some(spot) = diagram.spots.iter().find(|spot| spot.at == SpotName::Pitch(joint)) else { return };
        let to_rack = geometry::quarter_turn(self.pose.guide(rack.slider)) * (-rack.side * rack.radius);
        let touch = self.view.at(self.pose.point(rack.center) + to_rack);
        canvas.label(&spot.name, &display(&spot.name), touch, TOUCH, None, 1);
    }

    /// The name of the point where two wheels touch, where a plan has its image.
    fn pitch_point(&self, canvas: &mut Canvas<'_>, joint: JointId, pitch: Pitch) {
        let construction = self.context.construction();
        let name = construction.pitch_name(joint);
        if construction.place(Sheet::Velocity, &image_name(name)).is_none() {
            return;
        }
        let places = pitch.centers.map(|center| self.pose.point(center));
        let touch = self.view.at(places[0] + (places[1] - places[0]) * pitch.share::<f64>());
        canvas.label(name, &display(name), touch, TOUCH, None, 1);
    }

    /// The stroke where two wheels touch, and the hatching of the one that is fixed.
    fn mesh(&self, canvas: &mut Canvas<'_>, joint: &Joint, pitch: Pitch) {
        let places = pitch.centers.map(|center| self.pose.point(center));
        let touch = self.view.at(places[0] + (places[1] - places[0]) * pitch.share::<f64>());
        let centers = places.map(|place| self.view.at(place));
        let way = centers[1] - centers[0];
        if way.hypot() <= f64::EPSILON {
            return;
        }
        let along = way / way.hypot();
        let tangent = Vec2::new(-along.y, along.x) * TOUCH;
        canvas.draw(Pen::Guide, Shape::Line(touch - tangent, touch + tangent));
        for (index, _) in joint.bodies.iter().enumerate().filter(|(_, body)| **body == GROUND) {
            hatch_rim(canvas, [centers[index], touch], pitch.teeth[index] < 0);
        }
    }
}

/// The hatching of a fixed wheel beside where another touches it. The teeth of a ring point inwards: it is hatched outside, any other wheel inside.
pub(in crate::drawing) fn hatch_rim(canvas: &mut Canvas<'_>, [center, touch]: [Point; 2], is_ring: bool) {
    let radius = (touch - center).hypot();
    let outwards = if is_ring { HATCH } else { -HATCH };
    let middle = (touch - center).atan2();
    let step = (APART / radius).min(TAU / f64::from(4 * STROKES));
    for stroke in -STROKES..=STROKES {
        let (from, to) = (middle + f64::from(stroke) * step, middle + (f64::from(stroke) + 0.7) * step);
        let at = |angle: f64, radius: f64| center + Vec2::new(libm::cos(angle), libm::sin(angle)) * radius;
        canvas.draw(Pen::Hatch, Shape::Line(at(from, radius), at(to, radius + outwards)));
    }
}
