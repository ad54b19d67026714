use super::name::{coriolis_name, slide_name};
use super::step::{Action, Arrow, Part, Plan, PlanKind, PlanPoint, PointRole, Step};
use super::words::{self, Added};
use crate::geometry::{Vector, quarter_turn};
use crate::mechanism::{DrivenSlide, Mechanism};
use crate::motion::Motion;
use crate::position::Pose;
use crate::words::Wording;

/// What a driven slider adds to the motion of a point, from the body before it to the body behind it: known vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideMeasure {
    /// The slider, and which way.
    pub slide: DrivenSlide,
    /// Its sliding velocity v_r.
    pub velocity: Vector,
    /// Its sliding acceleration a_r.
    pub acceleration: Vector,
    /// Its Coriolis acceleration 2 ω ẑ × v_r.
    pub coriolis: Vector,
}

impl SlideMeasure {
    /// What `slide` adds where its bodies turn with `omega`; nothing for a slider without a drive.
    #[must_use]
    pub fn new(mechanism: &Mechanism, pose: &Pose, slide: &DrivenSlide, omega: f64) -> Self {
        let u = pose.guide(slide.slider) * slide.sign;
        let drive = mechanism.slider(slide.slider).drive;
        let (speed, acceleration) = drive.map_or((0.0, 0.0), |d| (d.speed, d.acceleration));
        Self {
            slide: *slide,
            velocity: u * speed,
            acceleration: u * acceleration,
            coriolis: quarter_turn(u) * (2.0 * omega * speed),
        }
    }

    /// What driven sliders add on the way from one body to another of a compound link whose motion is known.
    pub(super) fn on_way(mechanism: &Mechanism, pose: &Pose, motion: &Motion, way: &[DrivenSlide]) -> Vec<Self> {
        let way = way.iter();
        way.map(|slide| Self::new(mechanism, pose, slide, motion.body(slide.to).omega)).collect()
    }
}

/// A known vector that a driven slider adds to a plan.
pub(super) struct SlidePart {
    /// The plan point where it ends.
    pub to: String,
    vector: Vector,
    part: Part,
    added: Added,
    slide: DrivenSlide,
}

/// The vectors that driven sliders add to a plan from the point `start` on; those that vanish are left out.
pub(super) fn parts(mechanism: &Mechanism, kind: PlanKind, start: &str, slides: &[SlideMeasure]) -> Vec<SlidePart> {
    let mut parts = Vec::new();
    let mut entered = String::new();
    for measure in slides {
        let slide = measure.slide;
        entered.push_str(&mechanism.body(slide.to).name);
        let to = slide_name(start, &entered);
        match kind {
            PlanKind::Velocity => parts.push(SlidePart {
                to,
                vector: measure.velocity,
                part: Part::Sliding,
                added: Added::SlidingVelocity,
                slide,
            }),
            PlanKind::Acceleration => {
                parts.push(SlidePart {
                    to,
                    vector: measure.acceleration,
                    part: Part::Sliding,
                    added: Added::SlidingAcceleration,
                    slide,
                });
                parts.push(SlidePart {
                    to: coriolis_name(start, &entered),
                    vector: measure.coriolis,
                    part: Part::Coriolis,
                    added: Added::Coriolis,
                    slide,
                });
            }
        }
    }
    parts.retain(|part| part.vector != Vector::zeros());
    parts
}

/// Lays them off one after the other from the plan point `from`, but for those that are there; the point where the last one ends.
pub(super) fn lay_off(
    words: &Wording,
    mechanism: &Mechanism,
    plan: &mut Plan,
    role: PointRole,
    from: String,
    parts: Vec<SlidePart>,
) -> String {
    let mut here = from;
    for part in parts {
        if !plan.points.contains_key(&part.to) {
            let vector = plan.points[&here].vector + part.vector;
            plan.points.insert(part.to.clone(), PlanPoint { vector, role });
            let ends = [here.as_str(), part.to.as_str()];
            let (equation, caption) = words::driven(words, mechanism, &part.slide, part.added, ends);
            plan.steps.push(Step {
                caption,
                equation: equation.into(),
                action: Action::LayOff(Arrow { from: here, to: part.to.clone(), part: part.part }),
            });
        }
        here = part.to;
    }
    here
}
