//! The scheme of the mechanism. From back to front: ghosts, areas, paths of points, cut lines, guides, the ground, links, blocks with the links
//! on their pins, joints, special points, labels.

mod drives;
mod ground;
mod links;
mod looked_up;
mod names;
mod sliders;
mod special;
mod traces;
mod values;

pub(super) use links::outline;

use self::links::Posed;
use self::looked_up::{LinkLines, LookedUp};
use super::canvas::Canvas;
use super::dims::Dims;
use super::names::Names;
use super::shape::Shape;
use super::sheet::Pen;
use super::stages::Stages;
use super::values::{Value, values};
use super::view::{Extent, View};
use crate::construction::{Action, Construction, NumberedStep, Plan, Ray, RayOf, Solution, Teller};
use crate::cycle::{OtherModes, Traces};
use crate::geometry;
use crate::mechanism::{BodyId, GROUND, Mark, Mechanism, PointId, Role};
use crate::position::Pose;
use crate::scene::{Figure, PageSize, Scene};
use crate::sheet::{Scales, Sheet};
use crate::words::Wording;
use kurbo::Point;
use std::cell::RefCell;
use std::f64::consts::PI;
use std::sync::Arc;

/// No other modes.
const NO_MODES: &OtherModes = &OtherModes { shown: Vec::new(), has_more: false, own: None };

/// The solved scene for the scheme, with names and steps.
pub(super) struct Scheme<'a> {
    pub solution: &'a Solution,
    pub scene: &'a Scene,
    pub figure: &'a Figure,
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub construction: &'a Construction,
    pub names: Names,
    pub stages: Stages,
    /// The paths and ghosts that the figure asks for.
    pub traces: Arc<Traces>,
    /// The other assembly modes to be drawn.
    pub modes: &'a OtherModes,
    /// The only step or passage that has words, from 1; none for all.
    pub only_step: Option<usize>,
    pub words: Wording,
    pub dims: Dims,
    /// The scales of the panels, in units per mm of paper: the scene's, or those chosen for all of its sheets.
    pub mu: Scales,
    /// The layer of values; empty in a figure without it.
    pub values: Vec<Value>,
    /// Whether the sheet is one that a student measures.
    pub is_for_pencil: bool,
    /// Whether the senses in which slides count as positive are drawn.
    pub shows_senses: bool,
    pub looked_up: LookedUp,
    /// The lines of the links in the last view that was asked for.
    pub link_lines: RefCell<Option<LinkLines>>,
}

impl<'a> Scheme<'a> {
    /// The scheme of a solved scene.
    pub(super) fn new(solution: &'a Solution) -> Self {
        Self::with(solution, Arc::new(Traces::of(solution)))
    }

    /// The scheme of a solved scene, with these paths and ghosts.
    pub(super) fn with(solution: &'a Solution, traces: Arc<Traces>) -> Self {
        let Solution { scene, mechanism, pose, construction, .. } = solution;
        let scheme = Self {
            solution,
            scene,
            figure: &scene.figure,
            mechanism,
            pose,
            construction,
            names: Names::new(mechanism, construction),
            stages: Stages::new(construction),
            traces,
            modes: NO_MODES,
            only_step: None,
            words: solution.wording(),
            dims: Dims::of(&scene.figure),
            mu: scene.figure.given_scales(),
            values: Vec::new(),
            is_for_pencil: false,
            shows_senses: false,
            looked_up: LookedUp::new(mechanism, pose),
            link_lines: RefCell::new(None),
        };
        Self { values: values(&scheme), ..scheme }
    }

    /// The scheme on an exercise's sheets and on the corrected drawing.
    pub(super) fn for_pencil(self) -> Self {
        Self { is_for_pencil: true, ..self }
    }

    /// The same with the positive senses of slides.
    pub(super) fn with_senses(self) -> Self {
        Self { shows_senses: true, ..self }
    }

    /// The same without the layer of values: on a student's sheet it would tell the results.
    pub(super) fn without_values(self) -> Self {
        Self { values: Vec::new(), ..self }
    }

    /// Whether the sheet is for a projector: wide, or with large letters.
    pub(super) fn is_projected(&self) -> bool {
        self.figure.page.size == PageSize::Wide || self.dims.unit > 1.0
    }

    /// The writer of captions in the figure's language.
    pub(super) fn teller(&self) -> Teller<'_> {
        Teller::new(self.solution, &self.words)
    }

    /// The extent of all points, of paths and ghosts, and of the special points, or of the arrows to those too far away.
    pub(super) fn extent(&self) -> Extent {
        let special = self.special().filter_map(|special| self.reached(special));
        Extent::of(self.places().chain(special).chain(self.places_of_traces()).chain(self.places_of_modes()))
    }

    /// The extent without special points.
    pub(super) fn extent_of_joints(&self) -> Extent {
        Extent::of(self.places())
    }

    fn places(&self) -> impl Iterator<Item = geometry::Point> {
        let points = self.pose.points.iter().copied();
        points.chain(self.guide_ends()).chain(self.circles().flat_map(|(center, radius)| {
            let (center, arm) = (self.pose.point(center), geometry::Vector::new(radius, radius));
            [center - arm, center + arm]
        }))
    }

    /// The marks of all joints.
    fn marks(&self) -> impl Iterator<Item = Mark> {
        self.mechanism.joints.iter().flat_map(|joint| joint.marks.iter().copied())
    }

    /// The circles of joints: centre, and radius in the scene's unit of length; zero for a pin.
    fn circles(&self) -> impl Iterator<Item = (PointId, f64)> {
        self.marks().filter_map(|mark| match mark {
            Mark::Circle { center, towards, part } => Some((center, part * self.pose.arm(center, towards).norm())),
            Mark::Block(_) => None,
        })
    }

    /// Draws the circles larger than that of a pin.
    fn wheels(&self, canvas: &mut Canvas<'_>, view: &View) {
        for (center, radius) in self.circles() {
            let (center, rim) = (self.pose.point(center), geometry::Vector::new(radius, 0.0));
            let (center, rim) = (view.at(center), view.at(center + rim));
            let radius = (rim - center).hypot();
            if radius <= self.dims.joint {
                continue;
            }
            // Two half circles: unlike a full circle they leave the inside free for a label.
            for start in [0.0, PI] {
                canvas.draw(Pen::Guide, Shape::Arc { center, radius, start, sweep: PI });
            }
        }
    }

    /// Draws the mechanism.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, view: &View) {
        self.ghosts(canvas, view);
        self.other_modes(canvas, view);
        self.link_areas(canvas, view);
        self.paths(canvas, view);
        for special in self.special() {
            canvas.set_step(self.stages.special(&special.name));
            self.cuts(canvas, view, special);
        }
        canvas.set_step(0);
        for slider in self.sliders() {
            self.guide(canvas, view, slider);
        }
        for &point in &self.mechanism.body(GROUND).points {
            self.pivot(canvas, view, point);
        }
        self.wheels(canvas, view);
        self.link_lines(canvas, view);
        self.slide_arrows(canvas, view);
        for slider in self.sliders() {
            self.block(canvas, view, slider);
        }
        for (link, body) in self.mechanism.links() {
            if body.role == Role::Unsolved {
                self.stub(canvas, view, link);
            }
        }
        self.rotation_arrows(canvas, view);
        self.values(canvas, view);
        self.joints(canvas, view);
        for special in self.special() {
            canvas.set_step(self.stages.special(&special.name));
            self.mark_special(canvas, view, special);
        }
        canvas.set_step(0);
        self.link_names(canvas, view);
    }

    /// Draws the hints of the steps: the measured length, the line to which a ray is normal, the senses of solved
    /// rates.
    pub(super) fn hints(&self, canvas: &mut Canvas<'_>, view: &View) {
        for NumberedStep { number, step, .. } in self.construction.numbered_steps() {
            let number = number as u16;
            let ends = match &step.action {
                Action::MeasureLength { from, to, .. } => {
                    let joint = self.mechanism.point(from).map(|p| self.pose.point(p));
                    joint.zip(self.construction.special_point(to).and_then(|s| s.place.finite()))
                }
                Action::Ray(ray) => self.line_of(ray),
                Action::Solve { unknowns, .. } => {
                    self.rate_arrows(canvas, view, number, unknowns);
                    None
                }
                _ => None,
            };
            if let Some((from, to)) = ends {
                canvas.hint(number, view.at(from), view.at(to));
            }
        }
    }

    /// The segment of the cut line to which a ray is normal, from its joint to the special point.
    fn line_of(&self, ray: &Ray) -> Option<(geometry::Point, geometry::Point)> {
        match ray.of {
            RayOf::Leg(special, side) => {
                let special = self.construction.special(special);
                Some((self.pose.point(special.cuts[side].start()?), special.place.finite()?))
            }
            RayOf::Arm { from, to, .. } => Some((self.pose.point(from), self.pose.point(to))),
        }
    }

    /// The markup of a point's name, on the mechanism or within a plan: the scene's own, or else that of the figure's
    /// notation.
    pub(super) fn shown(&self, name: &str, plan: Option<&Plan>) -> String {
        if let Some(renamed) = self.figure.labels.get(name) {
            return renamed.for_setting();
        }
        let written = self.names.markup(name);
        match plan {
            Some(plan) => plan.shown(name, written, self.words.notation),
            None => written,
        }
    }

    /// The plan that a panel shows; none for the scheme.
    pub(super) fn plan(&self, panel: Sheet) -> Option<&Plan> {
        match panel {
            Sheet::Scheme => None,
            Sheet::Velocity => Some(&self.construction.velocity),
            Sheet::Acceleration => self.construction.acceleration.as_ref(),
        }
    }

    /// Number of a link, by which a style picks its colour; none for the ground and for blocks without name.
    pub(super) fn number(&self, link: BodyId) -> Option<usize> {
        self.looked_up.numbers[link.0]
    }

    /// The mechanism in a position.
    fn posed<'p>(&'p self, pose: &'p Pose) -> Posed<'p> {
        Posed { mechanism: self.mechanism, pose }
    }

    fn at(&self, view: &View, point: PointId) -> Point {
        view.at(self.pose.point(point))
    }
}
