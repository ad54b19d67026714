use super::arrow::{Arrow, Ray, VectorOf};
use super::cut::{Special, SpecialId};
use super::kennedy::{Center, CenterId, Centers};
use super::lever::Lever;
use super::name::image_name;
use super::number::{End, NumberId, NumberKind, Rate};
use super::operation::{Along, LineId, Operation, PlaceId, StepId};
use super::plan::Plan;
use super::polygon::ForcePlan;
use super::run::{Disturbance, Values};
use super::speeds::SpeedDiagram;
use super::step::{Action, NumberedStep};
use super::train::pitch_points;
use crate::geometry::{Ball, Point};
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::scene::TurnedName;
use crate::sheet::{Order, PerSheet, Sheet};
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
    /// The steps by which each sheet is drawn, in order; none on one that was not asked for.
    pub steps: PerSheet<Vec<Action>>,
    /// The plans; one that was not asked for has no points.
    pub plans: [Plan; 2],
    /// The instant centres that the figure asks for, and how they are found.
    pub centers: Option<Box<Centers>>,
    /// The force plan, where the figure asks for it.
    pub forces: Option<Box<ForcePlan>>,
    /// The levers of the drives, where the figure asks for them.
    pub levers: Vec<Lever>,
    /// The speed diagram, where the figure asks for it and there is a train.
    pub speeds: Option<SpeedDiagram>,
    /// The sheets that a hand draws, whose quantities forms ask for: the mechanism and its plans; where the figure has the centres, these and the plans
    /// that it shows.
    pub by_hand: Vec<Sheet>,
    /// How the velocity plan is turned by 90°, where it is.
    pub turned: Option<TurnedName>,
    /// The operations of ruler, pencil and calculator, each after those whose results it uses.
    pub operations: Vec<Operation>,
    /// Origin of the places of the scheme, the mechanism's first point: coordinates that count from a far origin would
    /// lose digits.
    pub origin: Point,
    /// The names of the points where wheels touch.
    pub(super) pitch_points: IndexMap<JointId, String>,
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
            steps: PerSheet::default(),
            plans: Order::ALL.map(Plan::new),
            centers: None,
            forces: None,
            levers: Vec::new(),
            speeds: None,
            by_hand: Sheet::USUAL.to_vec(),
            turned: None,
            operations: Vec::new(),
            origin,
            pitch_points: pitch_points(mechanism).collect(),
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
            Rate::Angular(_, link) => self.angular_rates[link.0],
            Rate::Slide(_, slider) => self.slide_rates[slider.0],
        };
        numbers.map(|numbers| numbers[rate.order()])
    }

    pub(super) fn set_rate(&mut self, rate: Rate, number: NumberId) {
        let numbers = match rate {
            Rate::Angular(_, link) => &mut self.angular_rates[link.0],
            Rate::Slide(_, slider) => &mut self.slide_rates[slider.0],
        };
        numbers.get_or_insert_default()[rate.order()] = Some(number);
    }

    /// A special point by name.
    #[must_use]
    pub fn special_point(&self, name: &str) -> Option<&Special> {
        self.special.iter().find(|s| s.name == name)
    }

    /// The plans that were asked for, in the order in which they are drawn.
    pub fn plans(&self) -> impl Iterator<Item = &Plan> {
        self.plans.iter().filter(|plan| !plan.points.is_empty())
    }

    /// The plan of velocities or of accelerations, if it was asked for.
    #[must_use]
    pub fn plan(&self, order: Order) -> Option<&Plan> {
        self.plans().find(|plan| plan.order == order)
    }

    /// The plan on a sheet, if it shows one that was asked for.
    #[must_use]
    pub fn plan_on(&self, sheet: Sheet) -> Option<&Plan> {
        self.plan(sheet.order()?)
    }

    /// The vectors that the steps of a plan lay off, in order.
    pub fn arrows(&self, sheet: impl Into<Sheet>) -> impl Iterator<Item = &Arrow> {
        self.steps[sheet.into()].iter().filter_map(|action| match action {
            Action::LayOff(arrow) => Some(arrow),
            _ => None,
        })
    }

    /// The rays that the steps of a plan draw, in order.
    pub fn rays(&self, order: Order) -> impl Iterator<Item = &Ray> {
        self.steps[order.sheet()].iter().filter_map(|action| match action {
            Action::Ray(ray) => Some(ray),
            _ => None,
        })
    }

    /// The groups without a construction: for each the names of its special points at infinity; empty where these are
    /// not the reason.
    pub fn without(&self) -> impl Iterator<Item = &[String]> {
        self.steps[Sheet::Velocity].iter().filter_map(|action| match action {
            Action::NoConstruction(far) => Some(far.as_slice()),
            _ => None,
        })
    }

    /// How many places, lines and numbers the operations make.
    pub(crate) fn counts(&self) -> [usize; 3] {
        self.record.counts()
    }

    /// The name of a plan point that may be called as if every leg had a normal part: `n_b3` also is the end of a
    /// Coriolis acceleration alone, or the start of a leg without a known part. Other names stay.
    #[must_use]
    pub fn plan_name<'a>(&'a self, sheet: impl Into<Sheet>, name: &'a str) -> &'a str {
        let has_parts = sheet.into() == Sheet::Acceleration;
        let end = self.known_parts.get(name).filter(|_| has_parts);
        end.map_or(name, |[_, end]| end)
    }

    /// A point of a sheet by its name, as in `S3` of the scheme or `n_b3` of the acceleration plan.
    #[must_use]
    pub fn place(&self, sheet: impl Into<Sheet>, name: &str) -> Option<PlaceId> {
        self.places.get(&(sheet.into(), name.to_owned())).copied()
    }

    /// The step that makes a place; `None` for one that is there from the start.
    pub(crate) fn step_of_place(&self, place: PlaceId) -> Option<StepId> {
        let mut operations = self.operations.iter();
        operations.find(|operation| operation.kind.place() == Some(place)).and_then(|operation| operation.step)
    }

    /// The named points of the sheets, in the order in which they got their names; a place may have several names.
    pub(crate) fn named_places(&self) -> impl Iterator<Item = (Sheet, &str, PlaceId)> {
        self.places.iter().map(|((sheet, name), &place)| (*sheet, name.as_str(), place))
    }

    /// The quantity name of a number, as in `L(B,S3)`, `vplan(b,s3)`, `omega(2)`; empty for the size of a vector.
    pub(crate) fn number_name(&self, mechanism: &Mechanism, number: NumberId) -> String {
        match &self.numbers[number.0] {
            NumberKind::Length(ends) => {
                let [a, b] = ends.map(|end| self.end_name(mechanism, end));
                format!("L({a},{b})")
            }
            NumberKind::Segment(order, [from, to]) => order.sheet().segment_name(from, to),
            NumberKind::Rate(rate) => rate.name(mechanism),
            NumberKind::SpeedByCenters(point) => format!("v({}).size", mechanism.point_name(*point)),
            NumberKind::RateByCenters(link) => Rate::Angular(Order::Velocity, *link).name(mechanism),
            NumberKind::Reading(name) => name.clone(),
            NumberKind::Force | NumberKind::Moment => self.name_of_force(mechanism, number).unwrap_or_default(),
            NumberKind::Size | NumberKind::Arm => String::new(),
        }
    }

    /// The name of a force or a moment that the force plan or a lever finds.
    fn name_of_force(&self, mechanism: &Mechanism, number: NumberId) -> Option<String> {
        let on_lever = self.levers.iter().find_map(|lever| lever.number_name(number));
        on_lever.or_else(|| self.forces.as_ref()?.number_name(mechanism, number))
    }

    /// The name of the joint or special point at an end of a length.
    pub(crate) fn end_name<'n>(&'n self, mechanism: &'n Mechanism, end: End) -> &'n str {
        match end {
            End::Joint(point) => mechanism.point_name(point),
            End::Special(id) => &self.special(id).name,
            End::Pitch(joint) => self.pitch_name(joint),
            End::Center(id) => self.center(id).map_or("", |center| &center.name),
        }
    }

    /// The name of the pitch point of a mesh, as `P23`; empty of other joints.
    #[must_use]
    pub fn pitch_name(&self, joint: JointId) -> &str {
        self.pitch_points.get(&joint).map_or("", String::as_str)
    }

    /// Whether that is the name of a pitch point.
    pub(super) fn is_pitch_point(&self, name: &str) -> bool {
        self.pitch_points.values().any(|own| own == name)
    }

    /// Whether that is the image of a pitch point.
    pub(crate) fn is_pitch_image(&self, name: &str) -> bool {
        self.pitch_points.values().any(|own| image_name(own) == name)
    }

    /// The distance of two joints, where an operation uses it.
    pub(crate) fn length_of(&self, [a, b]: [PointId; 2]) -> Option<NumberId> {
        let lengths = &self.record.lengths;
        lengths.get(&[a, b]).or_else(|| lengths.get(&[b, a])).copied()
    }

    /// An instant centre.
    #[must_use]
    pub fn center(&self, id: CenterId) -> Option<&Center> {
        self.centers.as_ref()?.all.get(id.0)
    }

    /// All steps, numbered from 1 through the sheets.
    pub fn numbered_steps(&self) -> impl Iterator<Item = NumberedStep<'_>> {
        let steps = self.steps.iter().flat_map(|(sheet, actions)| actions.iter().map(move |action| (sheet, action)));
        (1..).zip(steps).map(|(number, (sheet, action))| {
            let plan = self.plan_on(sheet);
            NumberedStep {
                number,
                sheet,
                plan,
                centers: self.centers.as_deref(),
                forces: self.forces.as_deref(),
                levers: &self.levers,
                action,
            }
        })
    }

    /// The steps on the sheets that a hand draws.
    pub fn steps_by_hand(&self) -> impl Iterator<Item = NumberedStep<'_>> {
        // The steps on the scheme lead to the plans.
        let is_drawn = |sheet| self.by_hand.contains(&sheet) && (sheet != Sheet::Scheme || self.draws_plans());
        self.numbered_steps().filter(move |step| is_drawn(step.sheet))
    }

    /// Whether a hand draws a plan.
    #[must_use]
    pub fn draws_plans(&self) -> bool {
        self.by_hand.iter().any(|sheet| sheet.order().is_some())
    }

    /// How many steps there are.
    #[must_use]
    pub fn step_count(&self) -> usize {
        self.steps.iter().map(|(_, actions)| actions.len()).sum()
    }

    /// The step of that number.
    #[must_use]
    pub fn numbered_step(&self, number: usize) -> Option<NumberedStep<'_>> {
        let mut index = number.checked_sub(1)?;
        for (sheet, actions) in self.steps.iter() {
            match actions.get(index) {
                Some(action) => {
                    let (plan, centers) = (self.plan_on(sheet), self.centers.as_deref());
                    return Some(NumberedStep {
                        number,
                        sheet,
                        plan,
                        centers,
                        forces: self.forces.as_deref(),
                        levers: &self.levers,
                        action,
                    });
                }
                None => index -= actions.len(),
            }
        }
        None
    }

    /// The number of a step.
    #[must_use]
    pub fn step_number(&self, StepId { sheet, index }: StepId) -> usize {
        let earlier = self.steps.iter().filter(|(other, _)| *other < sheet);
        earlier.map(|(_, actions)| actions.len()).sum::<usize>() + index + 1
    }

    /// A step by its sheet and index.
    #[must_use]
    pub fn step(&self, StepId { sheet, index }: StepId) -> Option<&Action> {
        self.steps[sheet].get(index)
    }

    /// For each quantity, by name, the first step by hand that yields it.
    pub(crate) fn steps_of_quantities(&self) -> IndexMap<String, StepId> {
        let mut steps = IndexMap::new();
        for step in self.steps_by_hand() {
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

/// The results of the operations written so far, by what they are results of.
#[derive(Clone, Debug, Default)]
pub(super) struct Record {
    /// The results, with bounds of their rounding errors.
    pub exact: Values<Ball>,
    /// By place, by line and by number: the index of the operation that makes it.
    pub makers: [Vec<usize>; 3],
    /// By place: its names, as indices of [`Construction::places`](super::Construction).
    pub names: Vec<Vec<usize>>,
    /// The guides, by the sheet on which they are drawn.
    pub guides: IndexMap<(Sheet, SliderId), LineId>,
    /// The lines through two places, from the first towards the second.
    pub joins: IndexMap<[PlaceId; 2], LineId>,
    /// The distances of joints.
    pub lengths: IndexMap<[PointId; 2], NumberId>,
    /// By mesh and centre: the pitch radii.
    pub radii: IndexMap<(JointId, PointId), NumberId>,
    /// By place: the lines drawn through it in a direction.
    pub rays: IndexMap<PlaceId, Vec<(Along, LineId)>>,
    /// By plan, body and point: the place of that motion in the plan.
    pub motions: IndexMap<(Order, BodyId, PointId), PlaceId>,
    /// By plan and body: the point whose motion was there first, and its place.
    pub first_motions: IndexMap<(Order, BodyId), (PointId, PlaceId)>,
    /// By its end, each vector laid off between images of points: where it begins, and its meaning.
    pub laid_off: IndexMap<PlaceId, (PlaceId, VectorOf)>,
    /// The joint by which the motion of a body follows from that of a neighbour, and the neighbour.
    pub anchors: IndexMap<BodyId, (JointId, BodyId)>,
}

impl Record {
    /// How many places, lines and numbers the operations make.
    pub fn counts(&self) -> [usize; 3] {
        self.makers.each_ref().map(Vec::len)
    }

    /// Notes the place of the motion of a body's point in a plan; an earlier one stays.
    pub fn note_motion(&mut self, order: Order, body: BodyId, point: PointId, place: PlaceId) {
        self.motions.entry((order, body, point)).or_insert(place);
        self.first_motions.entry((order, body)).or_insert((point, place));
    }
}
