use super::cut::{Special, SpecialId};
use super::number::{End, NumberId, NumberKind, Rate};
use super::operation::{Operation, PlaceId, StepId};
use super::plan::Plan;
use super::record::Record;
use super::run::{Disturbance, Values};
use super::step::{Action, Step};
use crate::geometry::Point;
use crate::mechanism::Mechanism;
use crate::sheet::{PerSheet, Sheet};
use indexmap::IndexMap;

/// Everything that is drawn for a mechanism: the special points, the plans step by step, and the manual operations
/// behind them.
#[derive(Clone, Debug)]
pub struct Construction {
    /// How far the plans go.
    pub extent: Extent,
    /// By group: its special points.
    pub special: Vec<Vec<Special>>,
    /// By group: how the construction's rates compare with the loop equations'; none where there is no construction.
    pub agreement: Vec<Option<Agreement>>,
    /// Steps on the scheme.
    pub scheme: Vec<Step>,
    /// The velocity plan.
    pub velocity: Plan,
    /// The acceleration plan, if accelerations were asked for.
    pub acceleration: Option<Plan>,
    /// The operations of ruler, pencil and calculator, each after those whose results it uses.
    pub operations: Vec<Operation>,
    /// Origin of the places of the scheme, the mechanism's first point: coordinates that count from a far origin would
    /// lose digits.
    pub origin: Point,
    /// By number: its kind.
    pub numbers: Vec<NumberKind>,
    /// By group: how many special points those before it have.
    pub(super) special_before: Vec<usize>,
    /// By plan point: the index of the first step of its plan that makes it.
    pub(super) made_by: IndexMap<(Sheet, String), usize>,
    /// Named points: joints and special points of the scheme, points of the plans.
    pub(super) places: IndexMap<(Sheet, String), PlaceId>,
    /// By the usual name of a leg's normal part, as in `n_b3`: the plan points where the known parts of the leg's
    /// acceleration begin and end.
    pub(super) known_parts: IndexMap<String, [String; 2]>,
    /// By body: the numbers of ω and α; none for a given rate of zero.
    pub(crate) angular_rates: Vec<Option<[Option<NumberId>; 2]>>,
    /// By slider: the numbers of velocity and acceleration along the guide; none for a given rate of zero.
    pub(crate) slide_rates: Vec<Option<[Option<NumberId>; 2]>>,
    /// Names of rates of links that turn with another link, as a block with its lever: the same rate of that link, which
    /// has more points.
    pub(crate) same_rates: IndexMap<String, String>,
    /// What the operations have found, by which more can be added. Not for operations that have been removed or moved.
    pub(super) record: Record,
}

/// How far the plans go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// To the rates of all links, and in the velocity plan to the joints, as in the source paper (Quintero et al.,
    /// 2011).
    Rates,
    /// To every point of every link.
    Points,
}

/// Comparison of the rates from the construction with those from the loop equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The largest difference of an angular or slide rate, velocity or acceleration, relative to the mechanism's largest
    /// rate of its kind.
    pub difference: f64,
    /// The largest difference that rounding, the condition and the sines of the crossings allow, relative in the same
    /// way.
    pub allowed: f64,
}

impl Construction {
    pub(super) fn empty(mechanism: &Mechanism, order: Sheet, origin: Point, extent: Extent) -> Self {
        let plan = |kind| Plan { kind, points: IndexMap::new(), steps: Vec::new(), largest: 0.0 };
        Self {
            extent,
            special: Vec::new(),
            agreement: Vec::new(),
            scheme: Vec::new(),
            velocity: plan(Sheet::Velocity),
            acceleration: (order == Sheet::Acceleration).then(|| plan(Sheet::Acceleration)),
            operations: Vec::new(),
            origin,
            numbers: Vec::new(),
            special_before: Vec::new(),
            made_by: IndexMap::new(),
            places: IndexMap::new(),
            known_parts: IndexMap::new(),
            angular_rates: vec![None; mechanism.bodies.len()],
            slide_rates: vec![None; mechanism.sliders.len()],
            same_rates: IndexMap::new(),
            record: Record::default(),
        }
    }

    /// A special point.
    #[must_use]
    pub fn special(&self, id: SpecialId) -> &Special {
        let group = self.group_of(id).expect("a step names a special point that there is");
        &self.special[group][id.0 - self.special_before[group]]
    }

    /// The group to which a special point belongs.
    pub(super) fn group_of(&self, id: SpecialId) -> Option<usize> {
        // Of groups without special points the last begins where the next one does.
        let group = self.special_before.partition_point(|&before| before <= id.0).checked_sub(1)?;
        (id.0 - self.special_before[group] < self.special[group].len()).then_some(group)
    }

    /// How many special points there are.
    pub(super) fn special_count(&self) -> usize {
        self.special_before.last().copied().unwrap_or(0) + self.special.last().map_or(0, Vec::len)
    }

    /// Adds the special points of the next group.
    pub(super) fn add_special(&mut self, special: Vec<Special>) {
        self.special_before.push(self.special_count());
        self.special.push(special);
    }

    /// The number of a rate that is given or solved for: none of a given rate of zero.
    pub(crate) fn rate(&self, rate: Rate) -> Option<Option<NumberId>> {
        let numbers = match rate {
            Rate::Omega(link) | Rate::Alpha(link) => self.angular_rates[link.0],
            Rate::SlideVelocity(slider) | Rate::SlideAcceleration(slider) => self.slide_rates[slider.0],
        };
        numbers.map(|numbers| numbers[rate.order()])
    }

    pub(super) fn set_rate(&mut self, rate: Rate, number: NumberId) {
        let numbers = match rate {
            Rate::Omega(link) | Rate::Alpha(link) => &mut self.angular_rates[link.0],
            Rate::SlideVelocity(slider) | Rate::SlideAcceleration(slider) => &mut self.slide_rates[slider.0],
        };
        numbers.get_or_insert_default()[rate.order()] = Some(number);
    }

    /// Notes which steps make the plans' points.
    pub(super) fn note_makers(&mut self) {
        let mut made_by = IndexMap::new();
        for plan in self.plans() {
            for (index, step) in plan.steps.iter().enumerate() {
                if let Some(name) = step.action.image() {
                    made_by.entry((plan.kind, name.to_owned())).or_insert(index);
                }
            }
        }
        self.made_by = made_by;
    }

    /// A special point by name.
    #[must_use]
    pub fn special_point(&self, name: &str) -> Option<&Special> {
        self.special.iter().flatten().find(|s| s.name == name)
    }

    /// The velocity plan and, if it was asked for, the acceleration plan.
    pub fn plans(&self) -> impl Iterator<Item = &Plan> {
        std::iter::once(&self.velocity).chain(&self.acceleration)
    }

    /// The plan on a sheet; none of the scheme.
    #[must_use]
    pub fn plan_on(&self, sheet: Sheet) -> Option<&Plan> {
        self.plans().find(|plan| plan.kind == sheet)
    }

    /// The groups without a construction: for each the names of its special points at infinity; empty where these are
    /// not the reason.
    pub fn without(&self) -> impl Iterator<Item = &[String]> {
        self.velocity.steps.iter().filter_map(|step| match &step.action {
            Action::NoConstruction { far } => Some(far.as_slice()),
            _ => None,
        })
    }

    /// How many places, lines and numbers the operations make.
    #[must_use]
    pub(crate) fn counts(&self) -> [usize; 3] {
        self.record.counts()
    }

    /// The plan points where the known parts of a leg's acceleration begin and end, by the usual name `n_b3` of that end:
    /// equal where the leg has no known part.
    #[must_use]
    pub(crate) fn known_parts(&self, normal_name: &str) -> Option<&[String; 2]> {
        self.known_parts.get(normal_name)
    }

    /// The name of a plan point that may be called as if every leg had a normal part: `n_b3` also is the end of a
    /// Coriolis acceleration alone, or the start of a leg without a known part. Other names stay.
    #[must_use]
    pub fn plan_name<'a>(&'a self, sheet: Sheet, name: &'a str) -> &'a str {
        let end = self.known_parts.get(name).filter(|_| sheet == Sheet::Acceleration);
        end.map_or(name, |[_, end]| end)
    }

    /// A point of a sheet by its name, as in `S3` of the scheme or `n_b3` of the acceleration plan.
    #[must_use]
    pub fn place(&self, sheet: Sheet, name: &str) -> Option<PlaceId> {
        self.places.get(&(sheet, name.to_owned())).copied()
    }

    /// The named points of the sheets, in the order in which they got their names; a place may have several names.
    pub(crate) fn named_places(&self) -> impl Iterator<Item = (Sheet, &str, PlaceId)> {
        self.places.iter().map(|((sheet, name), &place)| (*sheet, name.as_str(), place))
    }

    /// The quantity name of a number, as in `L(B,S3)`, `vplan(b,s3)`, `omega(2)`; empty for the size of a vector.
    #[must_use]
    pub(crate) fn number_name(&self, mechanism: &Mechanism, number: NumberId) -> String {
        match &self.numbers[number.0] {
            NumberKind::Length(ends) => {
                let [a, b] = ends.map(|end| self.end_name(mechanism, end));
                format!("L({a},{b})")
            }
            NumberKind::Segment(sheet, [from, to]) => {
                self.plan_on(*sheet).map_or_else(String::new, |plan| plan.kind.segment_name(from, to))
            }
            NumberKind::Rate(rate) => rate.name(mechanism),
            NumberKind::Reading(name) => name.clone(),
            NumberKind::Size => String::new(),
        }
    }

    /// The name of the joint or special point at an end of a length.
    #[must_use]
    pub(crate) fn end_name<'n>(&'n self, mechanism: &'n Mechanism, end: End) -> &'n str {
        match end {
            End::Joint(point) => mechanism.point_name(point),
            End::Special(id) => &self.special(id).name,
        }
    }

    /// All steps, numbered from 1 through the scheme, the velocity plan and the acceleration plan.
    pub fn numbered_steps(&self) -> impl Iterator<Item = NumberedStep<'_>> {
        let scheme = self.scheme.iter().map(|step| (None, step));
        let plans = self.plans().flat_map(|plan| plan.steps.iter().map(move |step| (Some(plan), step)));
        (1..).zip(scheme.chain(plans)).map(|(number, (plan, step))| NumberedStep { number, plan, step })
    }

    /// How many steps there are.
    #[must_use]
    pub fn step_count(&self) -> usize {
        self.scheme.len() + self.plans().map(|plan| plan.steps.len()).sum::<usize>()
    }

    /// The step of that number.
    #[must_use]
    pub fn numbered_step(&self, number: usize) -> Option<NumberedStep<'_>> {
        let mut index = number.checked_sub(1)?;
        let of = |step, plan| Some(NumberedStep { number, plan, step });
        if let Some(step) = self.scheme.get(index) {
            return of(step, None);
        }
        index -= self.scheme.len();
        for plan in self.plans() {
            if let Some(step) = plan.steps.get(index) {
                return of(step, Some(plan));
            }
            index -= plan.steps.len();
        }
        None
    }

    /// The number of a step.
    #[must_use]
    pub fn step_number(&self, StepId { sheet, index }: StepId) -> usize {
        let before = match sheet {
            Sheet::Scheme => 0,
            _ => {
                let earlier = self.plans().filter(|plan| plan.kind < sheet);
                self.scheme.len() + earlier.map(|plan| plan.steps.len()).sum::<usize>()
            }
        };
        before + index + 1
    }

    /// A step by its sheet and index.
    #[must_use]
    pub fn step(&self, StepId { sheet, index }: StepId) -> Option<&Step> {
        match sheet {
            Sheet::Scheme => self.scheme.get(index),
            _ => self.plan_on(sheet)?.steps.get(index),
        }
    }

    /// For each quantity, by name, the first step that yields it.
    #[must_use]
    pub(crate) fn steps_of_quantities(&self) -> IndexMap<String, StepId> {
        let mut steps = IndexMap::new();
        for step in self.numbered_steps() {
            let sheet = step.sheet();
            let index = step.number - self.step_number(StepId { sheet, index: 0 });
            for name in step.names() {
                steps.entry(name).or_insert(StepId { sheet, index });
            }
        }
        steps
    }

    /// Carries out all operations with `disturbances`, which are sorted by operation; without any the values are those
    /// of the plans.
    #[must_use]
    pub fn run(&self, scales: PerSheet<f64>, disturbances: &[Disturbance<'_>]) -> Values {
        let mut values = Values::default();
        values.resize(self.counts());
        values.carry_out(&self.operations, 0, scales, disturbances);
        values
    }
}

/// A step of the construction with its number.
#[derive(Clone, Copy, Debug)]
pub struct NumberedStep<'a> {
    /// Number of the step, from 1 through all sheets.
    pub number: usize,
    /// The plan to which it belongs; none for the scheme.
    pub plan: Option<&'a Plan>,
    /// What is done.
    pub step: &'a Step,
}

impl NumberedStep<'_> {
    /// The sheet on which it is drawn.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        self.plan.map_or(Sheet::Scheme, |plan| plan.kind)
    }

    /// Names of the quantities that the step yields.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let segment = |from: &str, to: &str| self.plan.map(|p| p.kind.segment_name(from, to)).into_iter().collect();
        match &self.step.action {
            Action::MeasureLength { from, to, .. } => vec![format!("L({from},{to})")],
            Action::LayOff(arrow) => segment(&arrow.from, &arrow.to),
            Action::Cross { point, .. } => segment(self.plan.map_or("", |p| p.kind.pole()), point),
            Action::Divide { point, .. } | Action::Coincide { point, .. } => {
                segment(self.plan.map_or("", |p| p.kind.pole()), point)
            }
            Action::Measure { from, to, .. } => segment(from, to),
            Action::Solve { unknowns, .. } => unknowns.iter().map(|u| u.0.clone()).collect(),
            Action::Pole { .. } | Action::SpecialPoint { .. } | Action::Ray(_) | Action::NoConstruction { .. } => {
                Vec::new()
            }
        }
    }
}
