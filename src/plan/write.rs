use super::cut::{CutLine, LegKind, Special, special_points};
use super::driven::{self, SlideMeasure, SlidePart};
use super::equation::Equation;
use super::equations::{Agreement, Construct, LegMeasure, construct};
use super::images::images;
use super::name::{image_name, point_on};
use super::step::{Action, Arrow, Part, Plan, PlanKind, PlanPoint, PointRole, Ray, Relation, Step};
use super::words::{self, written};
use crate::geometry::Vector;
use crate::mechanism::{BodyId, GROUND, Group, LoopEquations, Mechanism, PointId, Role, SliderId};
use crate::motion::{Motion, Order};
use crate::position::Pose;
use crate::words::Wording;
use indexmap::IndexMap;

/// Everything that is drawn on the board for a mechanism: special points, then the plans, step by step.
#[derive(Clone, Debug)]
pub struct Construction {
    /// By group: its special points.
    pub special: Vec<Vec<Special>>,
    /// By group: how the construction's rates compare with the loop equations'; none where a special point lies at infinity.
    pub agreement: Vec<Option<Agreement>>,
    /// Steps on the mechanism itself.
    pub scheme: Vec<Step>,
    /// The velocity plan.
    pub velocity: Plan,
    /// The acceleration plan, if accelerations were asked for.
    pub acceleration: Option<Plan>,
    /// What the reader should know, as text.
    pub warnings: Vec<String>,
}

impl Construction {
    /// A special point by name.
    #[must_use]
    pub fn special_point(&self, name: &str) -> Option<&Special> {
        self.special.iter().flatten().find(|s| s.name == name)
    }

    /// The plans that there are.
    pub fn plans(&self) -> impl Iterator<Item = &Plan> {
        std::iter::once(&self.velocity).chain(&self.acceleration)
    }
}

/// The graphical construction for every group of `mechanism`, as steps for both plans from one pole each; said in English and written as
/// the source paper does.
#[must_use]
pub fn construction(mechanism: &Mechanism, pose: &Pose, motion: &Motion) -> Construction {
    construction_in(mechanism, pose, motion, &Wording::default())
}

/// The same in another wording, as in [`Wording::of`] a scene's figure. Points of plans and quantities keep their names.
#[must_use]
pub fn construction_in(mechanism: &Mechanism, pose: &Pose, motion: &Motion, words: &Wording) -> Construction {
    let mut writer = Writer {
        words,
        mechanism,
        pose,
        motion,
        scheme: Vec::new(),
        velocity: Writer::plan(PlanKind::Velocity),
        acceleration: (motion.order == Order::Acceleration).then(|| Writer::plan(PlanKind::Acceleration)),
        warnings: Vec::new(),
    };
    writer.poles();
    let mut special = Vec::new();
    let mut agreement = Vec::new();
    for group in &mechanism.groups {
        let points = special_points(mechanism, pose, group);
        let construct = construct(mechanism, group, pose, motion, &points);
        writer.group(group, &points, construct.as_ref());
        agreement.push(construct.map(|c| c.agreement));
        special.push(points);
    }
    Construction {
        special,
        agreement,
        scheme: writer.scheme,
        velocity: writer.velocity,
        acceleration: writer.acceleration,
        warnings: writer.warnings,
    }
}

struct Writer<'a> {
    words: &'a Wording,
    mechanism: &'a Mechanism,
    pose: &'a Pose,
    motion: &'a Motion,
    scheme: Vec<Step>,
    velocity: Plan,
    acceleration: Option<Plan>,
    warnings: Vec<String>,
}

fn step(action: Action, equation: impl Into<Equation>, caption: String) -> Step {
    Step { action, equation: equation.into(), caption }
}

impl Writer<'_> {
    fn plan(kind: PlanKind) -> Plan {
        Plan { kind, points: IndexMap::new(), steps: Vec::new() }
    }

    fn plans(&mut self) -> impl Iterator<Item = &mut Plan> {
        std::iter::once(&mut self.velocity).chain(&mut self.acceleration)
    }

    /// The poles, with the images of the points at rest.
    fn poles(&mut self) {
        let grounded = self.mechanism.bodies[0].points.iter();
        let images: Vec<String> = grounded.map(|&p| image_name(self.mechanism.point_name(p))).collect();
        let words = self.words;
        for plan in self.plans() {
            let pole = PlanPoint { vector: Vector::zeros(), role: PointRole::Pole };
            let name = plan.kind.pole();
            plan.points.insert(name.to_owned(), pole);
            for image in &images {
                plan.points.insert(image.clone(), pole);
            }
            let caption = words::pole(words, plan.kind, &images);
            plan.steps.push(step(Action::Pole { images: images.clone() }, String::new(), caption));
        }
    }

    fn group(&mut self, group: &Group, special: &[Special], construct: Option<&Construct>) {
        for point in special {
            self.special_point(point);
        }
        let starts = self.starts(special);
        for &(base, point) in &starts {
            self.known_vector(base, point);
        }
        let Some(construct) = construct else {
            self.without_construction(special);
            images(self.words, self.mechanism, self.pose, self.motion, group, &mut self.velocity);
            return;
        };
        for (index, point) in special.iter().enumerate() {
            self.velocity_of(point, construct, index);
        }
        self.solve(group, special, construct, Order::Velocity);
        images(self.words, self.mechanism, self.pose, self.motion, group, &mut self.velocity);
        if self.acceleration.is_some() {
            for (index, point) in special.iter().enumerate() {
                self.acceleration_of(point, construct, index);
            }
            self.solve(group, special, construct, Order::Acceleration);
        }
    }

    /// Where the rays start: outer pins, or inner pins on sliding carriers as points of the known body.
    fn starts(&self, special: &[Special]) -> Vec<(BodyId, PointId)> {
        let mut starts = Vec::new();
        for cut in special.iter().flat_map(|s| &s.cuts) {
            if let Some(point) = cut.start() {
                let entry = (cut.leg.base, point);
                if !starts.contains(&entry) {
                    starts.push(entry);
                }
            }
        }
        starts
    }

    /// The name in the plans of the point from which a leg starts: `b`, or `c_iB` for the known body's point under C.
    fn start_name(&self, base: BodyId, point: PointId) -> String {
        image_name(&point_on(self.mechanism, base, point))
    }

    /// What driven sliders add on the way of a leg.
    fn slide_parts(&self, kind: PlanKind, cut: &CutLine, leg: &LegMeasure) -> Vec<SlidePart> {
        let start = cut.start().map(|p| self.start_name(cut.leg.base, p));
        driven::parts(self.mechanism, kind, &start.unwrap_or_default(), &leg.slides)
    }

    fn special_point(&mut self, point: &Special) {
        if !point.is_assur {
            return;
        }
        let names = [0, 1].map(|i| point.cuts[i].name(self.words, self.mechanism, &point.name));
        let action =
            Action::SpecialPoint { point: point.name.clone(), cuts: names.clone(), sine: point.crossing.sine() };
        let link = &self.mechanism.body(point.link).name;
        let caption = words::special_point(self.words, &point.name, link, &names, &point.place);
        self.scheme.push(step(action, String::new(), caption));
        let Some(place) = point.place.finite() else {
            return;
        };
        for cut in &point.cuts {
            if let Some(end) = measured_end(cut) {
                let value = (place - self.pose.point(end)).norm();
                let from = self.mechanism.point_name(end).to_owned();
                let equation = words::length(&from, &point.name);
                let caption = words::measure_length(self.words, &from, &point.name);
                let action = Action::MeasureLength { from, to: point.name.clone(), value };
                self.scheme.push(step(action, equation, caption));
            }
        }
    }

    /// Lays off the known vector of a start in both plans.
    fn known_vector(&mut self, base: BodyId, point: PointId) {
        if let Role::Pushed { from, .. } = self.mechanism.body(base).role
            && from != GROUND
            && self.mechanism.is_known(base)
        {
            self.pushed_vector(base, point);
            return;
        }
        let name = self.start_name(base, point);
        let body = *self.motion.body(base);
        let at = self.pose.point(point);
        let vectors = [body.velocity_at(at), body.acceleration_at(at)];
        let role = &self.mechanism.body(base).role;
        if *role == Role::Ground {
            // At rest: its image is the pole, under a name of its own where it lies beneath a slider.
            for plan in self.plans() {
                let pole = plan.points[plan.kind.pole()];
                plan.points.entry(name.clone()).or_insert(pole);
            }
            return;
        }
        let captions = [PlanKind::Velocity, PlanKind::Acceleration]
            .map(|kind| words::known(self.words, self.mechanism, base, point, kind));
        for ((plan, vector), (equation, caption)) in self.plans().zip(vectors).zip(captions) {
            let role = PointRole::Known;
            plan.points.insert(name.clone(), PlanPoint { vector, role });
            let arrow = Arrow { from: plan.kind.pole().to_owned(), to: name.clone(), part: Part::Whole };
            plan.steps.push(step(Action::LayOff(arrow), equation, caption));
        }
    }

    /// Lays off the vector of a body that drives push from one of known motion: that one's own point first, then what the driven
    /// sliders add.
    fn pushed_vector(&mut self, base: BodyId, point: PointId) {
        let (words, mechanism, pose, motion) = (self.words, self.mechanism, self.pose, self.motion);
        let root = mechanism.root(base);
        self.known_vector(root, point);
        let (start, name) = (self.start_name(root, point), self.start_name(base, point));
        let slides = SlideMeasure::on_way(mechanism, pose, motion, &mechanism.way(root, base));
        for plan in self.plans() {
            let mut parts = driven::parts(mechanism, plan.kind, &start, &slides);
            match parts.last_mut() {
                Some(last) => last.to = name.clone(),
                None => {
                    let here = plan.points[&start];
                    plan.points.insert(name.clone(), here);
                }
            }
            driven::lay_off(words, mechanism, plan, PointRole::Known, start.clone(), parts);
        }
    }

    fn ray(&self, cut: &CutLine, point: &Special, through: String) -> Step {
        let image = image_name(&point.name);
        let (relation, line) = match cut.kind {
            LegKind::Pin { .. } | LegKind::Pins { .. } => {
                (Relation::Perpendicular, cut.name(self.words, self.mechanism, &point.name))
            }
            LegKind::PinThenSlider { inner: slider, .. }
            | LegKind::Slider { outer: slider, .. }
            | LegKind::SliderThenPin { outer: slider, .. } => {
                (Relation::Parallel, self.words.language.guide_of(&self.mechanism.slider_name(slider)))
            }
            LegKind::Sliders => (Relation::Parallel, cut.name(self.words, self.mechanism, &point.name)),
        };
        let direction = cut.line.direction().unwrap_or_else(Vector::x);
        let caption = words::ray(self.words, &through, relation, &line, &image);
        let ray = Ray { through, to: image, direction: crate::geometry::quarter_turn(direction), relation, line };
        step(Action::Ray(ray), String::new(), caption)
    }

    fn velocity_of(&mut self, point: &Special, construct: &Construct, index: usize) {
        let image = image_name(&point.name);
        let mut through = Vec::new();
        for (cut, leg) in point.cuts.iter().zip(&construct.legs[index]) {
            let Some(start) = cut.start() else { return };
            let name = self.start_name(cut.leg.base, start);
            let parts = self.slide_parts(PlanKind::Velocity, cut, leg);
            let name = driven::lay_off(self.words, self.mechanism, &mut self.velocity, PointRole::Slid, name, parts);
            let mut ray = self.ray(cut, point, name.clone());
            let from = point_on(self.mechanism, cut.leg.base, start);
            ray.equation = words::relative_velocity(self.words, self.mechanism, &cut.slides, &point.name, &from);
            self.velocity.steps.push(ray);
            through.push(name);
        }
        let vector = construct.velocities[index];
        let role = role(point);
        let plan = &mut self.velocity;
        plan.points.insert(image.clone(), PlanPoint { vector, role });
        plan.steps.push(cross_step(self.words, point, &image, &through));
        for (name, leg) in through.into_iter().zip(&construct.legs[index]) {
            plan.steps.push(measure_step(self.words, PlanKind::Velocity, name, &image, leg.velocity));
        }
    }

    fn acceleration_of(&mut self, point: &Special, construct: &Construct, index: usize) {
        let image = image_name(&point.name);
        let Some(mut plan) = self.acceleration.take() else {
            return;
        };
        let mut through = Vec::new();
        let legs = point.cuts.iter().zip(&construct.legs[index]);
        for ((cut, leg), normal) in legs.zip(point.normal_names(self.mechanism)) {
            let Some(start) = cut.start() else { continue };
            let from = self.start_name(cut.leg.base, start);
            let parts = self.slide_parts(plan.kind, cut, leg);
            let from = driven::lay_off(self.words, self.mechanism, &mut plan, PointRole::Slid, from, parts);
            let (equation, caption) = words::normal(self.words, self.mechanism, self.pose, cut, point, &from, &normal);
            let arrow = Arrow { from, to: normal.clone(), part: Part::Normal };
            plan.steps.push(step(Action::LayOff(arrow), equation, caption));
            let (vector, role) = (leg.acceleration_start + leg.normal, PointRole::Normal);
            plan.points.insert(normal.clone(), PlanPoint { vector, role });
            let mut ray = self.ray(cut, point, normal.clone());
            let start = point_on(self.mechanism, cut.leg.base, start);
            ray.equation = words::relative_acceleration(self.words, self.mechanism, cut, &point.name, &start);
            plan.steps.push(ray);
            through.push((normal, leg.acceleration));
        }
        let vector = construct.accelerations[index];
        let role = role(point);
        plan.points.insert(image.clone(), PlanPoint { vector, role });
        let names: Vec<String> = through.iter().map(|t| t.0.clone()).collect();
        plan.steps.push(cross_step(self.words, point, &image, &names));
        for (name, segment) in through {
            plan.steps.push(measure_step(self.words, PlanKind::Acceleration, name, &image, segment));
        }
        self.acceleration = Some(plan);
    }

    /// The four equations and what they give.
    fn solve(&mut self, group: &Group, special: &[Special], construct: &Construct, order: Order) {
        let kind = match order {
            Order::Velocity => PlanKind::Velocity,
            Order::Acceleration => PlanKind::Acceleration,
        };
        let mut equations = Vec::new();
        for (point, legs) in special.iter().zip(&construct.legs) {
            let normals = point.normal_names(self.mechanism);
            for ((cut, leg), normal) in point.cuts.iter().zip(legs).zip(normals) {
                let Some(start) = cut.start() else { continue };
                let (from, signed) = match order {
                    Order::Velocity => {
                        let parts = self.slide_parts(kind, cut, leg);
                        let last = parts.into_iter().next_back().map(|part| part.to);
                        let start = || self.start_name(cut.leg.base, start);
                        (last.unwrap_or_else(start), leg.velocity)
                    }
                    Order::Acceleration => (normal, leg.acceleration),
                };
                let what = (kind, signed);
                equations.push(words::leg_equation(self.words, self.mechanism, self.pose, cut, point, &from, what));
            }
        }
        let unknowns = self.unknowns(group, order);
        let caption = words::solve(self.words, &unknowns);
        let action = Action::Solve { equations, unknowns };
        let solved = step(action, String::new(), caption);
        match order {
            Order::Velocity => self.velocity.steps.push(solved),
            Order::Acceleration => {
                if let Some(plan) = &mut self.acceleration {
                    plan.steps.push(solved);
                }
            }
        }
    }

    /// Names and values of the rates that the equations give.
    fn unknowns(&self, group: &Group, order: Order) -> Vec<(String, f64)> {
        let equations = LoopEquations::new(self.mechanism, group);
        let second = order == Order::Acceleration;
        let mut unknowns = Vec::new();
        for &link in &group.bodies {
            if equations.spin_unknown(link).is_some() {
                let (body, name) = (self.motion.body(link), &self.mechanism.body(link).name);
                unknowns.push(if second {
                    (format!("alpha({name})"), body.alpha)
                } else {
                    (format!("omega({name})"), body.omega)
                });
            }
        }
        for slider in (0..self.mechanism.sliders.len()).map(SliderId) {
            if equations.slide_unknown(slider).is_some() {
                let (slide, name) = (self.motion.slide(slider), self.mechanism.slider_name(slider));
                unknowns.push(if second {
                    (format!("a_r({name})"), slide.acceleration)
                } else {
                    (format!("v_r({name})"), slide.velocity)
                });
            }
        }
        unknowns
    }

    /// Says why there is no construction.
    fn without_construction(&mut self, special: &[Special]) {
        let far: Vec<String> =
            special.iter().filter(|s| s.place.finite().is_none()).map(|s| written(&s.name)).collect();
        // Warnings are messages, which are in English whatever the figure says.
        let warning = words::no_construction(&Wording::default(), &far);
        self.warnings.push(words::plain_text(&warning));
        let caption = words::no_construction(self.words, &far);
        for plan in self.plans() {
            plan.steps.push(step(Action::Note, String::new(), caption.clone()));
        }
    }
}

fn role(point: &Special) -> PointRole {
    if point.is_assur { PointRole::Special } else { PointRole::Image }
}

/// The joint of a leg from which the length to the special point enters an equation.
fn measured_end(cut: &CutLine) -> Option<PointId> {
    match cut.kind {
        LegKind::Pins { inner, .. } | LegKind::SliderThenPin { inner, .. } => Some(inner),
        LegKind::Pin { outer } | LegKind::PinThenSlider { outer, .. } => Some(outer),
        LegKind::Slider { .. } | LegKind::Sliders => None,
    }
}

fn cross_step(words: &Wording, point: &Special, image: &str, from: &[String]) -> Step {
    let from = [0, 1].map(|i| from.get(i).cloned().unwrap_or_default());
    let caption = words::cross(words, image);
    let action = Action::Cross { point: image.to_owned(), from, sine: point.crossing.sine() };
    step(action, String::new(), caption)
}

fn measure_step(words: &Wording, kind: PlanKind, from: String, to: &str, signed: f64) -> Step {
    let equation = words::measured(kind, &from, to);
    let caption = words::measure(words, &from, to);
    let action = Action::Measure { from, to: to.to_owned(), value: signed.abs() };
    step(action, equation, caption)
}
