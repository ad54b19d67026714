//! Writes operations one after another, carries out each at once, and draws nothing twice.

use super::constructed::{Construction, Extent};
use super::name::image_name;
use super::number::{Equation, NumberId, NumberKind, Product, Rate};
use super::operation::{Along, LineId, MeasuredAs, Operation, OperationKind, OperationRole, PlaceId, StepId};
use super::plan::{Plan, PlanPoint, PointRole};
use super::step::Action;
use crate::geometry::{Ball, UNIT_ROUNDOFF, Vector, span};
use crate::mechanism::{BodyId, GROUND, Mechanism};
use crate::motion::{BodyMotion, Motion, SlideMotion};
use crate::position::Pose;
use crate::sheet::{Order, Sheet};

/// A construction in progress, and what it is a construction of.
pub(crate) struct Writer<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub motion: &'a Motion,
    /// What has been written so far.
    pub construction: Construction,
    /// Tolerance for a point on a line and for coincident points, in units of length.
    pub near: f64,
    /// The mechanism's size.
    pub size: f64,
    /// The mechanism's largest angular velocity and acceleration.
    pub largest_rates: [f64; 2],
    /// By point: the bodies that have it.
    pub(super) holders: Vec<Vec<BodyId>>,
}

/// Where a step begins among the operations. Only when it has been [taken](Writer::take_step) do those that follow on
/// its sheet belong to it, and it to the plan: a step whose lines do not cross is left out.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub(super) struct Begun {
    sheet: Sheet,
    first: usize,
}

impl Begun {
    /// The index of its first operation.
    pub(super) fn first(self) -> usize {
        self.first
    }
}

impl<'a> Writer<'a> {
    /// A writer with the poles of the plans and the rates that the scene gives.
    pub(super) fn new(mechanism: &'a Mechanism, pose: &'a Pose, motion: &'a Motion, extent: Extent) -> Self {
        let origin = pose.points.first().copied().unwrap_or_default();
        let empty = Construction::empty(mechanism, origin, extent);
        let mut writer = Writer::continued(mechanism, pose, motion, empty);
        for &order in writer.orders() {
            writer.begin_plan(order);
        }
        writer.take_known_rates();
        writer
    }

    /// A writer that adds operations to a construction of this motion.
    pub(crate) fn continued(
        mechanism: &'a Mechanism,
        pose: &'a Pose,
        motion: &'a Motion,
        construction: Construction,
    ) -> Self {
        let size = span(pose.points.iter().copied());
        let (near, largest_rates) =
            (64.0 * UNIT_ROUNDOFF * size, Order::ALL.map(|order| largest_rate(motion, order, size)));
        Writer { mechanism, pose, motion, construction, near, size, largest_rates, holders: mechanism.holders() }
    }

    /// Draws the pole of a plan, the image of all fixed points.
    fn begin_plan(&mut self, order: Order) {
        let grounded = &self.mechanism.body(GROUND).points;
        let images: Vec<String> = grounded.iter().map(|&p| image_name(self.mechanism.point_name(p))).collect();
        let place = self.pole(order, order.pole(), Vector::zeros());
        self.show(order, order.pole(), place, PointRole::Pole);
        for image in &images {
            self.show(order, image, place, PointRole::Pole);
        }
        let step = self.begin(order);
        self.finish(step, Action::Pole { order, images });
    }

    /// The orders of motion whose plans are drawn.
    pub(super) fn orders(&self) -> &'static [Order] {
        self.motion.order.and_lower()
    }

    /// The plan of velocities or of accelerations.
    pub(super) fn plan(&mut self, order: Order) -> &mut Plan {
        &mut self.construction.plans[order]
    }

    /// Whether a plan shows a point of that name.
    pub(super) fn shows(&self, order: Order, name: &str) -> bool {
        self.construction.plans[order].points.contains_key(name)
    }

    /// Begins a step on a sheet.
    pub(super) fn begin(&self, sheet: impl Into<Sheet>) -> Begun {
        Begun { sheet: sheet.into(), first: self.construction.operations.len() }
    }

    /// Adds a step that has done this to its sheet; its operations, up to that index, belong to it, unless several steps
    /// may use them.
    pub(super) fn take_step(&mut self, Begun { sheet, first }: Begun, end: usize, action: Action) -> StepId {
        let index = self.construction.steps[sheet].len();
        let id = StepId { sheet, index };
        if let (Some(order), Some(image)) = (sheet.order(), action.image()) {
            self.plan(order).makers.entry(image.to_owned()).or_insert(index);
        }
        self.construction.steps[sheet].push(action);
        for operation in &mut self.construction.operations[first..end] {
            if operation.sheet == sheet && operation.step.is_none() && !operation.kind.is_shared() {
                operation.step = Some(id);
            }
        }
        id
    }

    /// Ends a step that has done this.
    pub(super) fn finish(&mut self, begun: Begun, action: Action) -> StepId {
        self.take_step(begun, self.construction.operations.len(), action)
    }

    /// Assigns the operation that made a place to a step, if it belongs to none.
    pub(super) fn claim(&mut self, step: StepId, place: PlaceId) {
        let maker = self.construction.record.makers[0][place.0];
        self.construction.operations[maker].step.get_or_insert(step);
    }

    /// Adds a point to a plan; an existing point of that name stays.
    pub(super) fn show(&mut self, order: Order, name: &str, place: PlaceId, role: PointRole) {
        self.name_place(order, name, place);
        let point = PlanPoint { vector: self.construction.record.exact.places[place.0].rounded(), role };
        let plan = self.plan(order);
        if !plan.points.contains_key(name) {
            plan.largest = plan.largest.max(point.vector.norm());
            plan.points.insert(name.to_owned(), point);
        }
    }

    /// Adds an operation and carries it out.
    pub(super) fn push(&mut self, sheet: impl Into<Sheet>, role: OperationRole, kind: OperationKind) {
        self.push_by(true, sheet, role, kind);
    }

    /// Adds an operation and carries it out. `by_hand` says whether a hand can do it with what it uses; if that is not
    /// found by hand, neither is this.
    fn push_by(&mut self, by_hand: bool, sheet: impl Into<Sheet>, role: OperationRole, kind: OperationKind) {
        let Construction { operations, record, .. } = &mut self.construction;
        let [of_places, of_lines, of_numbers] = &record.makers;
        let (places, lines) = kind.places_and_lines_read();
        let mut by_hand = by_hand
            && places.iter().all(|place| operations[of_places[place.0]].by_hand)
            && lines.iter().all(|line| operations[of_lines[line.0]].by_hand);
        kind.each_number_read(|number| by_hand &= operations[of_numbers[number.0]].by_hand);
        let index = operations.len();
        record.makers[0].extend(kind.place().map(|_| index));
        record.makers[1].extend(kind.line().map(|_| index));
        record.makers[2].extend(kind.numbers().iter().map(|_| index));
        record.exact.resize(record.counts());
        record.exact.run(&kind, [0.0; 2], 1.0);
        operations.push(Operation { sheet: sheet.into(), step: None, role, kind, by_hand });
    }

    /// Whether a number can be found with ruler and pencil.
    pub(crate) fn is_by_hand(&self, number: NumberId) -> bool {
        self.construction.operations[self.construction.record.makers[2][number.0]].by_hand
    }

    /// Whether a place can be found with ruler and pencil.
    pub(crate) fn is_place_by_hand(&self, place: PlaceId) -> bool {
        self.construction.operations[self.construction.record.makers[0][place.0]].by_hand
    }

    /// The place that the next operation makes.
    pub(super) fn next_place(&self) -> PlaceId {
        PlaceId(self.construction.record.makers[0].len())
    }

    /// The line that the next operation makes.
    fn next_line(&self) -> LineId {
        LineId(self.construction.record.makers[1].len())
    }

    pub(super) fn new_number(&mut self, kind: NumberKind) -> NumberId {
        self.construction.numbers.push(kind);
        NumberId(self.construction.numbers.len() - 1)
    }

    /// Names a place. A place may have several names; a name keeps its first place.
    pub(super) fn name_place(&mut self, sheet: impl Into<Sheet>, name: &str, place: PlaceId) {
        let Construction { places, record, .. } = &mut self.construction;
        let key = (sheet.into(), name.to_owned());
        if !places.contains_key(&key) {
            record.names.resize(record.names.len().max(place.0 + 1), Vec::new());
            record.names[place.0].push(places.len());
            places.insert(key, place);
        }
    }

    /// The name of the plan point at a place.
    pub(super) fn shown_name(&self, order: Order, place: PlaceId) -> Option<String> {
        let names = self.construction.record.names.get(place.0)?.iter();
        let mut names = names.filter_map(|&index| Some(self.construction.places.get_index(index)?.0));
        names.find(|(on, name)| *on == order.sheet() && self.shows(order, name)).map(|(_, name)| name.clone())
    }

    pub(crate) fn pole(&mut self, sheet: impl Into<Sheet>, name: &str, at: Vector) -> PlaceId {
        let sheet = sheet.into();
        let place = self.next_place();
        self.push(sheet, OperationRole::Pole, OperationKind::Pole { place, at });
        self.name_place(sheet, name, place);
        place
    }

    /// The pole of a plan.
    pub(crate) fn pole_of(&self, order: Order) -> Option<PlaceId> {
        self.construction.place(order, order.pole())
    }

    /// The line through two places of a sheet.
    pub(crate) fn join_places(&mut self, sheet: Sheet, role: OperationRole, [from, towards]: [PlaceId; 2]) -> LineId {
        if let Some(line) = self.construction.record.joins.get(&[from, towards]) {
            return *line;
        }
        let line = self.next_line();
        self.construction.record.joins.insert([from, towards], line);
        self.push(sheet, role, OperationKind::Join { line, from, towards });
        line
    }

    pub(crate) fn draw(
        &mut self,
        sheet: impl Into<Sheet>,
        role: OperationRole,
        through: PlaceId,
        along: Along,
    ) -> LineId {
        let line = self.next_line();
        self.construction.record.rays.entry(through).or_default().push((along, line));
        self.push(sheet, role, OperationKind::Draw { line, through, along });
        line
    }

    /// The line that is drawn already through a place in a direction.
    pub(super) fn drawn(&self, through: PlaceId, along: Along) -> Option<LineId> {
        let lines = self.construction.record.rays.get(&through)?;
        lines.iter().find(|(other, _)| *other == along).map(|(_, line)| *line)
    }

    /// The crossing of two lines; `None` for parallel lines. `by_hand` says whether it is drawn at all.
    pub(super) fn cross(
        &mut self,
        by_hand: bool,
        sheet: impl Into<Sheet>,
        role: OperationRole,
        lines: [LineId; 2],
    ) -> Option<PlaceId> {
        let place = self.next_place();
        self.push_by(by_hand, sheet, role, OperationKind::Cross { place, lines });
        let at = self.construction.record.exact.places[place.0];
        (at.x.is_known() && at.y.is_known()).then_some(place)
    }

    /// The point that divides the line between two plan points as the third of `like` divides that of the other two.
    pub(super) fn divide(&mut self, order: Order, ends: [PlaceId; 2], like: [PlaceId; 3]) -> PlaceId {
        let place = self.next_place();
        self.push(order, OperationRole::Image, OperationKind::Divide { place, ends, like });
        place
    }

    pub(crate) fn measure(
        &mut self,
        sheet: impl Into<Sheet>,
        kind: NumberKind,
        [from, to]: [PlaceId; 2],
        how: MeasuredAs,
    ) -> NumberId {
        let number = self.new_number(kind);
        self.push(sheet, OperationRole::Number, OperationKind::Measure { number, from, to, how });
        number
    }

    /// Reads the direction of a line.
    pub(crate) fn read_direction(&mut self, sheet: Sheet, kind: NumberKind, along: Along) -> NumberId {
        let number = self.new_number(kind);
        self.push(sheet, OperationRole::Number, OperationKind::ReadDirection { number, along });
        number
    }

    /// Takes a number of the scene, or with `by_hand` false one of the computed motion; none for zero.
    pub(super) fn take(
        &mut self,
        by_hand: bool,
        sheet: impl Into<Sheet>,
        kind: NumberKind,
        value: f64,
    ) -> Option<NumberId> {
        if value == 0.0 {
            return None;
        }
        let number = self.new_number(kind);
        self.push_by(by_hand, sheet, OperationRole::Number, OperationKind::Take { number, value });
        Some(number)
    }

    pub(crate) fn compute(&mut self, sheet: impl Into<Sheet>, kind: NumberKind, sum: Vec<Product>) -> NumberId {
        let number = self.new_number(kind);
        self.push(sheet, OperationRole::Number, OperationKind::Compute { number, sum });
        number
    }

    /// Takes a rate from the computed motion, with the bound of its error.
    pub(super) fn take_computed(&mut self, rate: Rate, value: f64, error: f64) -> NumberId {
        let number = self.new_number(NumberKind::Rate(rate));
        self.push_by(false, rate.order(), OperationRole::Number, OperationKind::Take { number, value });
        self.construction.record.exact.numbers[number.0] = Ball::within(value, error);
        number
    }

    /// Solves linear equations for rates; `None` where they are singular.
    pub(crate) fn solve(
        &mut self,
        sheet: impl Into<Sheet>,
        kinds: Vec<NumberKind>,
        equations: Vec<Equation>,
    ) -> Option<Vec<NumberId>> {
        let unknowns: Vec<NumberId> = kinds.into_iter().map(|kind| self.new_number(kind)).collect();
        self.push(sheet, OperationRole::Rates, OperationKind::Solve { unknowns: unknowns.clone(), equations });
        unknowns.iter().all(|&number| self.construction.record.exact.numbers[number.0].is_known()).then_some(unknowns)
    }

    /// Lays off a vector whose size is a sum of products; returns its end, which is `from` for an empty sum.
    pub(crate) fn lay_off(
        &mut self,
        sheet: impl Into<Sheet>,
        from: PlaceId,
        sum: Vec<Product>,
        along: Along,
    ) -> PlaceId {
        if sum.is_empty() {
            return from;
        }
        let sheet = sheet.into();
        let size = self.compute(sheet, NumberKind::Size, sum);
        let place = self.next_place();
        self.push(sheet, OperationRole::Vector, OperationKind::LayOff { place, from, size, along });
        place
    }
}

/// The mechanism's largest angular velocity or acceleration; it also counts other velocities and accelerations, over the
/// mechanism's size, and ω². A group that stands still has no measure of its own.
fn largest_rate(motion: &Motion, order: Order, size: f64) -> f64 {
    let of_body = |body: &BodyMotion| match order {
        Order::Velocity => body.omega.abs().max(body.velocity.norm() / size),
        Order::Acceleration => body.alpha.abs().max(body.omega * body.omega).max(body.acceleration.norm() / size),
    };
    let of_slide = |slide: &SlideMotion| [slide.velocity, slide.acceleration][order].abs() / size;
    let Motion { bodies, slides, .. } = motion;
    // `max` ignores NaN, as of a mechanism without size.
    bodies.iter().map(of_body).chain(slides.iter().map(of_slide)).fold(0.0, f64::max)
}
