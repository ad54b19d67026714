//! A solved scene, and the construction of all its groups, one after another.

use super::constructed::{Construction, Extent};
use super::cut::{Special, SpecialId, special_points};
use super::kennedy::{MOST_LINKS, missing_of_centers};
use super::leg::DrawnSpecial;
use super::lever::levers;
use super::markup::{no_construction, plain_text};
use super::polygon::force_plan;
use super::sentence::Teller;
use super::step::Action;
use super::writer::Writer;
use crate::centers::LinkPair;
use crate::forces::{AtPose, Forces, forces, warnings_of_forces};
use crate::mechanism::says::off_guide;
use crate::mechanism::{AngularRate, BodyId, GROUND, Group, LoopEquations, Mechanism, PointId};
use crate::message::Message;
use crate::motion::{Motion, MotionError, motion};
use crate::position::Pose;
use crate::scene::{CentersShown, ConstructionShown, Figure, Loads, Scene};
use crate::sheet::{Order, Sheet};
use crate::words::{Language, Wording};

/// A solved scene: the mechanism in one position with its motion and its plans. Input of figures, results, steps and
/// checks.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The scene as read.
    pub scene: Scene,
    /// Its bodies, joints and groups.
    pub mechanism: Mechanism,
    /// Places of all points and directions of all guides.
    pub pose: Pose,
    /// Velocities and accelerations.
    pub motion: Motion,
    /// The plans of that motion.
    pub construction: Construction,
    /// The same with the velocity plan turned, where the figure asks for it: see [`Solution::shown_construction`].
    pub turned: Option<Box<Construction>>,
}

impl Solution {
    /// Motion and plans of a mechanism at a pose.
    pub fn new(scene: Scene, mechanism: Mechanism, pose: Pose, order: Order) -> Result<Self, MotionError> {
        let motion = motion(&mechanism, &pose, order)?;
        let extent = match scene.figure.construction {
            ConstructionShown::Paper => Extent::Rates,
            ConstructionShown::Whole | ConstructionShown::Hidden => Extent::Points,
        };
        let construction = asked_construction(&scene, (&mechanism, &pose, &motion), extent);
        // A work sheet is drawn on.
        let turned = scene.figure.turned.filter(|_| !scene.figure.worksheet);
        let turned = turned.map(|sense| Box::new(construction.turned(sense)));
        Ok(Self { scene, mechanism, pose, motion, construction, turned })
    }

    /// The solution of the mechanism in another position.
    ///
    /// # Errors
    /// [`MotionError`] in a singular position.
    pub fn moved(&self, pose: Pose) -> Result<Self, MotionError> {
        Self::new(self.scene.clone(), self.mechanism.clone(), pose, self.motion.order)
    }

    /// What joints carry and drives need, found anew; `None` for a scene without loads, and where a number leaves the range of f64.
    #[must_use]
    pub fn forces(&self) -> Option<Forces> {
        self.mechanism.loads.as_ref()?;
        forces(&self.mechanism, &AtPose::new(&self.mechanism, &self.pose))
    }

    /// The construction as figures and steps show it: with the velocity plan turned, where the figure asks for it. What a hand draws or
    /// measures on, and what a result says, is [`Self::construction`].
    #[must_use]
    pub fn shown_construction(&self) -> &Construction {
        self.turned.as_deref().unwrap_or(&self.construction)
    }

    /// Language and notation of the figure.
    #[must_use]
    pub fn wording(&self) -> Wording {
        Wording::of(&self.scene.figure)
    }

    /// The warnings of all stages, in English, in the order in which they were found.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        // Warnings are in English whatever the language of the figure.
        self.warnings_in(Wording::default().language)
    }

    /// What is said of sliders beyond an end of their guides.
    pub(crate) fn off_guides(&self) -> impl Iterator<Item = Message> {
        let Solution { mechanism, pose, .. } = self;
        mechanism.slider_ids().filter_map(|id| {
            let ([low, high], at) = (mechanism.slider(id).travel?, pose.slides[id.0]?);
            let is_off = mechanism.slider(id).beyond(at).is_some();
            is_off.then(|| off_guide(mechanism.slider_name(id), format!("{at:.4}"), low, high))
        })
    }

    /// The same in another language.
    pub fn warnings_in(&self, language: &'static Language) -> impl Iterator<Item = String> {
        let found = [&self.mechanism.warnings, &self.pose.warnings, &self.motion.warnings];
        let words = Wording { language, ..Wording::default() };
        let without = self.construction.without().map(move |far| plain_text(&no_construction(&words, far)));
        let own = Wording { language, ..self.wording() };
        let may_warn = |loads: &Loads| !loads.friction.is_empty() || !loads.springs.is_empty();
        let forces = self.mechanism.loads.as_ref().filter(|loads| may_warn(&loads.0));
        let forces =
            forces.and_then(|_| warnings_of_forces(&self.mechanism, &AtPose::new(&self.mechanism, &self.pose)));
        let forces = forces.into_iter().map(|warning| language.says(&warning));
        let centers = self.construction.centers.as_deref();
        let centers = centers.map(|centers| missing_of_centers(centers, &self.mechanism, &own)).unwrap_or_default();
        let centers = centers.into_iter().map(|sentence| plain_text(&sentence));
        let off = self.off_guides().map(|message| language.says(&message));
        let found = found.into_iter().flatten().map(|warning| language.says(warning)).chain(off);
        let is_asked = self.scene.figure.shown_panels().contains(&Sheet::Speeds);
        let speeds = Teller::new(self, &own).missing_of_speeds(is_asked).into_iter();
        let speeds = speeds.map(|sentence| plain_text(&sentence));
        found.chain(without).chain(centers).chain(speeds).chain(forces)
    }
}

/// The construction of both plans from one pole each, for every group of `mechanism`.
///
/// Joints are plotted at their places. Lengths between two points of one link are taken from the scene, other lengths
/// are measured, as are all in a drawn configuration. A guide that runs through two points of its link is drawn through
/// them, any other in its direction. For a group without a construction, and for bodies whose motion follows from it,
/// rates and vectors are taken from `motion`.
#[must_use]
pub fn construct(mechanism: &Mechanism, pose: &Pose, motion: &Motion, extent: Extent) -> Construction {
    let mut writer = Writer::new(mechanism, pose, motion, extent);
    for group in &mechanism.groups {
        writer.group(group);
        if extent == Extent::Points {
            group.bodies.iter().for_each(|&body| writer.further_images(body));
        }
    }
    if extent == Extent::Points {
        mechanism.body_ids().filter(|&body| mechanism.is_known(body)).for_each(|body| writer.further_images(body));
    }
    writer.construction
}

/// The construction with all that a figure asks for beside the plans.
pub(crate) fn asked_construction(
    scene: &Scene,
    (mechanism, pose, motion): (&Mechanism, &Pose, &Motion),
    extent: Extent,
) -> Construction {
    let figure = &scene.figure;
    let mut construction = construct(mechanism, pose, motion, extent);
    if figure.shown_panels().contains(&Sheet::Centers) {
        construction = with_centers(figure, (mechanism, pose, motion), construction);
    }
    construction = with_forces(figure, (mechanism, pose, motion), construction);
    if figure.shown_panels().contains(&Sheet::Speeds) {
        let mut writer = Writer::continued(mechanism, pose, motion, construction);
        writer.speeds(scene);
        construction = writer.construction;
    }
    construction
}

/// A construction with the instant centres and the velocities by centres that a figure asks for.
fn with_centers(
    figure: &Figure,
    (mechanism, pose, motion): (&Mechanism, &Pose, &Motion),
    construction: Construction,
) -> Construction {
    /// Most links, with the frame, of which all centres are drawn unless the figure says otherwise: six centres, two by lines.
    const FEW: usize = 4;
    let all = LinkPair::all(mechanism);
    let wanted = match &figure.centers {
        // Of more links no lines are sought.
        CentersShown::All if mechanism.links().count() < MOST_LINKS => all,
        CentersShown::Usual if mechanism.links().count() < FEW => all,
        CentersShown::All | CentersShown::Usual => {
            all.into_iter().filter(|pair| pair.other(GROUND).is_some()).collect()
        }
        CentersShown::Named(names) => names.iter().filter_map(|name| LinkPair::named(name, mechanism)).collect(),
    };
    let points = |names: &[String]| -> Vec<PointId> { names.iter().filter_map(|name| mechanism.point(name)).collect() };
    let mut writer = Writer::continued(mechanism, pose, motion, construction);
    let inflected: Vec<BodyId> = figure.inflection.iter().filter_map(|link| mechanism.link(link)).collect();
    writer.centers(&wanted, &points(&figure.velocities), &points(&figure.curvature), &inflected);
    writer.construction.by_hand = drawn_by_hand(figure);
    writer.construction
}

/// The sheets that a hand draws for a figure with centres or forces, and those that these need.
fn drawn_by_hand(figure: &Figure) -> Vec<Sheet> {
    // On a scheme beside the centres nothing is drawn.
    let drawn: Vec<Sheet> = figure.shown_panels().into_iter().filter(|sheet| *sheet != Sheet::Scheme).collect();
    let needed = |sheet: &Sheet| drawn.iter().any(|drawn| drawn.with_those_needed().contains(sheet));
    Sheet::ALL.into_iter().filter(needed).collect()
}

/// A construction with the force plan and the levers that a figure asks for; without loads, and in a singular position, there are none.
fn with_forces(
    figure: &Figure,
    (mechanism, pose, motion): (&Mechanism, &Pose, &Motion),
    construction: Construction,
) -> Construction {
    let panels = figure.shown_panels();
    if !panels.iter().any(|panel| matches!(panel, Sheet::Forces | Sheet::Lever)) || mechanism.loads.is_none() {
        return construction;
    }
    let Some(computed) = forces(mechanism, &AtPose::new(mechanism, pose)) else { return construction };
    let mut writer = Writer::continued(mechanism, pose, motion, construction);
    force_plan(&mut writer, &computed, panels.contains(&Sheet::Forces));
    if panels.contains(&Sheet::Lever) {
        writer.construction.levers = levers(&mut writer, &computed);
    }
    writer.construction.by_hand = drawn_by_hand(figure);
    writer.construction
}

/// The force polygons of a position, whatever a figure shows; `None` where there are no forces.
pub(crate) fn force_polygons(mechanism: &Mechanism, pose: &Pose, motion: &Motion) -> Option<Construction> {
    let computed = forces(mechanism, &AtPose::new(mechanism, pose))?;
    let drawn = construct(mechanism, pose, motion, Extent::Rates);
    let mut writer = Writer::continued(mechanism, pose, motion, drawn);
    force_plan(&mut writer, &computed, true);
    Some(writer.construction)
}

impl Writer<'_> {
    /// Constructs the next group: each of its special points by two rays, then the rates from measured segments.
    /// Without such a construction the rates come from the motion.
    fn group(&mut self, group: &Group) {
        let first = self.construction.special.len();
        let special = special_points(self.mechanism, self.pose, self.construction.agreement.len());
        let equations = LoopEquations::new(self.mechanism, group);
        for &link in &group.bodies {
            if let AngularRate::Known(body) = equations.angular_rate_of(link) {
                self.construction.angular_rates[link.0] = self.construction.angular_rates[body.0];
            }
        }
        let has_crossing =
            |s: &Special| s.place.finite().is_some() && s.cuts.iter().all(|c| c.line.direction().is_some());
        let equation_count = 2 * special.len() + equations.angular.len();
        let has_rays = equation_count == equations.unknowns && special.iter().all(has_crossing);
        let ids = (first..).map(SpecialId);
        let drawn: Vec<Option<DrawnSpecial<'_>>> =
            special.iter().zip(ids).map(|(special, id)| self.special_point(special, id, has_rays)).collect();
        let mut starts: Vec<(BodyId, PointId)> = Vec::new();
        let cuts = special.iter().flat_map(|s| &s.cuts);
        let legs = cuts.filter_map(|cut| cut.start().map(|point| (cut.leg.base, point)));
        let hanging = group.hanging(self.mechanism).into_iter();
        for (base, point) in legs.chain(hanging.map(|(joint, base, _)| (base, self.mechanism.joint_point(joint)))) {
            // A wheel may hang on an arm whose motion is yet to be found.
            if !starts.contains(&(base, point)) && !group.bodies.contains(&base) {
                starts.push((base, point));
                self.orders().iter().for_each(|&order| self.known_vector(order, base, point));
            }
        }
        let drawn: Option<Vec<DrawnSpecial<'_>>> = drawn.into_iter().collect();
        let constructed = drawn.filter(|_| has_rays).and_then(|drawn| self.rates(group, &equations, &drawn));
        if constructed.is_none() {
            self.without_construction(group, &equations, &special);
        }
        let agreement = constructed.map(|()| self.agreement(group, &equations));
        self.construction.agreement.push(agreement);
        self.construction.special.extend(special);
    }

    /// Constructs both plans; `None` where rays are parallel or the equations have no solution.
    fn rates(&mut self, group: &Group, equations: &LoopEquations, drawn: &[DrawnSpecial<'_>]) -> Option<()> {
        let is_train = self.is_train(group, equations);
        if is_train {
            self.train(group, equations)?;
        }
        for &order in self.orders().iter().filter(|_| !is_train) {
            self.rays(order, group, equations, drawn)?;
            if order == Order::Velocity {
                self.note_anchors(group);
            }
            if order == Order::Velocity || self.construction.extent == Extent::Rates {
                self.images(order, group);
            }
        }
        if !is_train {
            self.image_steps(group);
        }
        if self.construction.extent == Extent::Points && self.motion.order == Order::Acceleration {
            self.relative_images(Order::Acceleration, group);
        }
        Some(())
    }

    /// Notes that the group has no construction, and takes its rates from the motion.
    fn without_construction(&mut self, group: &Group, equations: &LoopEquations, special: &[Special]) {
        let far = special.iter().filter(|s| s.place.finite().is_none()).map(|s| s.name.clone());
        let far: Vec<String> = far.collect();
        for &order in self.orders() {
            let step = self.begin(order);
            self.finish(step, Action::NoConstruction(far.clone()));
        }
        self.take_computed_rates(group, equations);
        self.note_anchors(group);
        for &order in self.orders() {
            self.relative_images(order, group);
        }
    }
}
