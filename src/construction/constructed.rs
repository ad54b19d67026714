use super::cut::{Special, SpecialId};
use super::number::{End, NumberId, NumberKind, Rate};
use super::operation::{Along, LineId, Operation, PlaceId, StepId};
use super::run::{Disturbance, Values};
use super::step::{Action, Plan, VectorOf};
use crate::geometry::{Ball, Point};
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::sheet::{PerSheet, Sheet};
use indexmap::IndexMap;

/// Everything that is drawn for a mechanism: the special points, the plans step by step, and the manual operations
/// behind them.
#[derive(Clone, Debug)]
pub struct Construction {
    /// How far the plans go.
    pub extent: Extent,
    /// The special points, group by group; a [`SpecialId`] counts them.
    pub special: Vec<Special>,
    /// By group: how the construction's rates compare with the loop equations'; none where there is no construction.
    pub agreement: Vec<Option<Agreement>>,
    /// What is drawn on each sheet; nothing on one that was not asked for.
    pub sheets: PerSheet<Plan>,
    /// The operations of ruler, pencil and calculator, each after those whose results it uses.
    pub operations: Vec<Operation>,
    /// Origin of the places of the scheme, the mechanism's first point: coordinates that count from a far origin would
    /// lose digits.
    pub origin: Point,
    /// By number: its kind.
    pub numbers: Vec<NumberKind>,
    /// Named points: joints and special points of the scheme, points of the plans.
    pub(super) places: IndexMap<(Sheet, String), PlaceId>,
    /// By the usual name of a leg's normal part, as in `n_b3`: the plan points where the known parts of the leg's
    /// acceleration begin and end; equal where the leg has no known part.
    pub(crate) known_parts: IndexMap<String, [String; 2]>,
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
    pub(super) fn empty(mechanism: &Mechanism, origin: Point, extent: Extent) -> Self {
        Self {
            extent,
            special: Vec::new(),
            agreement: Vec::new(),
            sheets: PerSheet::from_fn(Plan::new),
            operations: Vec::new(),
            origin,
            numbers: Vec::new(),
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
        &self.special[id.0]
    }

    /// The number of a rate that is given or solved for: none of a given rate of zero.
    pub(crate) fn rate(&self, rate: Rate) -> Option<Option<NumberId>> {
        let numbers = match rate {
            Rate::Omega(link) | Rate::Alpha(link) => self.angular_rates[link.0],
            Rate::SlideVelocity(slider) | Rate::SlideAcceleration(slider) => self.slide_rates[slider.0],
        };
        numbers.map(|numbers| numbers[rate.sheet().order()])
    }

    pub(super) fn set_rate(&mut self, rate: Rate, number: NumberId) {
        let numbers = match rate {
            Rate::Omega(link) | Rate::Alpha(link) => &mut self.angular_rates[link.0],
            Rate::SlideVelocity(slider) | Rate::SlideAcceleration(slider) => &mut self.slide_rates[slider.0],
        };
        numbers.get_or_insert_default()[rate.sheet().order()] = Some(number);
    }

    /// A special point by name.
    #[must_use]
    pub fn special_point(&self, name: &str) -> Option<&Special> {
        self.special.iter().find(|s| s.name == name)
    }

    /// The plans that were asked for, in the order in which they are drawn.
    pub fn plans(&self) -> impl Iterator<Item = &Plan> {
        Sheet::PLANS.into_iter().filter_map(|sheet| self.plan_on(sheet))
    }

    /// The plan on a sheet; none on the scheme, which has no points of a plan.
    #[must_use]
    pub fn plan_on(&self, sheet: Sheet) -> Option<&Plan> {
        Some(&self.sheets[sheet]).filter(|plan| !plan.points.is_empty())
    }

    /// The groups without a construction: for each the names of its special points at infinity; empty where these are
    /// not the reason.
    pub fn without(&self) -> impl Iterator<Item = &[String]> {
        self.sheets[Sheet::Velocity].steps.iter().filter_map(|action| match action {
            Action::NoConstruction { far } => Some(far.as_slice()),
            _ => None,
        })
    }

    /// How many places, lines and numbers the operations make.
    #[must_use]
    pub(crate) fn counts(&self) -> [usize; 3] {
        self.record.counts()
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
            NumberKind::Segment(sheet, [from, to]) => sheet.segment_name(from, to),
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

    /// All steps, numbered from 1 through the sheets.
    pub fn numbered_steps(&self) -> impl Iterator<Item = NumberedStep<'_>> {
        let steps = self.sheets.iter().flat_map(|(sheet, plan)| plan.steps.iter().map(move |action| (sheet, action)));
        (1..).zip(steps).map(|(number, (sheet, action))| {
            let plan = self.plan_on(sheet);
            NumberedStep { number, sheet, plan, action }
        })
    }

    /// How many steps there are.
    #[must_use]
    pub fn step_count(&self) -> usize {
        self.sheets.iter().map(|(_, plan)| plan.steps.len()).sum()
    }

    /// The step of that number.
    #[must_use]
    pub fn numbered_step(&self, number: usize) -> Option<NumberedStep<'_>> {
        self.numbered_steps().nth(number.checked_sub(1)?)
    }

    /// The number of a step.
    #[must_use]
    pub fn step_number(&self, StepId { sheet, index }: StepId) -> usize {
        let earlier = self.sheets.iter().filter(|(other, _)| *other < sheet);
        earlier.map(|(_, plan)| plan.steps.len()).sum::<usize>() + index + 1
    }

    /// A step by its sheet and index.
    #[must_use]
    pub fn step(&self, StepId { sheet, index }: StepId) -> Option<&Action> {
        self.sheets[sheet].steps.get(index)
    }

    /// For each quantity, by name, the first step that yields it.
    #[must_use]
    pub(crate) fn steps_of_quantities(&self) -> IndexMap<String, StepId> {
        let mut steps = IndexMap::new();
        for step in self.numbered_steps() {
            let index = step.number - self.step_number(StepId { sheet: step.sheet, index: 0 });
            for name in step.names() {
                steps.entry(name).or_insert(StepId { sheet: step.sheet, index });
            }
        }
        steps
    }

    /// Carries out all operations with `disturbances`, which are sorted by operation; without any the values are those
    /// of the plans.
    #[must_use]
    pub fn run(&self, scales: PerSheet<f64>, disturbances: &[Disturbance]) -> Values {
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
    /// The sheet on which it is drawn.
    pub sheet: Sheet,
    /// The plan to which it belongs; none for the scheme.
    pub plan: Option<&'a Plan>,
    /// What is done.
    pub action: &'a Action,
}

impl NumberedStep<'_> {
    /// Names of the quantities that the step yields.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let sheet = self.sheet;
        match self.action {
            Action::MeasureLength { from, to, .. } | Action::Measure { from, to, .. } => {
                vec![sheet.segment_name(from, to)]
            }
            Action::LayOff(arrow) => vec![sheet.segment_name(&arrow.from, &arrow.to)],
            Action::Cross { point, .. } | Action::Divide { point, .. } | Action::Coincide { point, .. } => {
                vec![sheet.segment_name(sheet.pole(), point)]
            }
            Action::Solve { unknowns, .. } => unknowns.iter().map(|u| u.0.clone()).collect(),
            Action::Pole { .. } | Action::SpecialPoint { .. } | Action::Ray(_) | Action::NoConstruction { .. } => {
                Vec::new()
            }
        }
    }
}

/// The results of the operations written so far, by what they are results of.
#[derive(Clone, Debug, Default)]
pub(super) struct Record {
    /// The results, with bounds of their rounding errors.
    pub exact: Values<Ball>,
    /// By place, by line and by number: the index of the operation that makes it.
    pub makers: [Vec<usize>; 3],
    /// By place: its names, as indices of [`Construction::places`](super::Construction).
    pub names: Vec<Vec<usize>>,
    /// The guides on the scheme.
    pub guides: IndexMap<SliderId, LineId>,
    /// The lines through two places, from the first towards the second.
    pub joins: IndexMap<[PlaceId; 2], LineId>,
    /// The distances of joints.
    pub lengths: IndexMap<[PointId; 2], NumberId>,
    /// By place: the lines drawn through it in a direction.
    pub rays: IndexMap<PlaceId, Vec<(Along, LineId)>>,
    /// By plan, body and point: the place of that motion in the plan.
    pub motions: IndexMap<(Sheet, BodyId, PointId), PlaceId>,
    /// By plan and body: the point whose motion was there first, and its place.
    pub first_motions: IndexMap<(Sheet, BodyId), (PointId, PlaceId)>,
    /// The vectors laid off between images of points, by their ends.
    pub laid_off: IndexMap<PlaceId, LaidOff>,
    /// The joint by which the motion of a body follows from a known one.
    pub anchors: IndexMap<BodyId, Anchor>,
}

/// A vector laid off in a plan.
#[derive(Clone, Debug)]
pub(super) struct LaidOff {
    pub start: PlaceId,
    pub end: PlaceId,
    pub of: VectorOf,
}

/// The joint by which the motion of a body follows from that of a neighbour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    /// The joint.
    pub joint: JointId,
    /// The neighbour, whose motion is known.
    pub from: BodyId,
}

impl Record {
    /// How many places, lines and numbers the operations make.
    pub fn counts(&self) -> [usize; 3] {
        self.makers.each_ref().map(Vec::len)
    }

    /// Notes the place of the motion of a body's point in a plan; an earlier one stays.
    pub fn note_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId, place: PlaceId) {
        self.motions.entry((sheet, body, point)).or_insert(place);
        self.first_motions.entry((sheet, body)).or_insert((point, place));
    }
}
