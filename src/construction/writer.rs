//! Writes operations one after another, carries out each at once, and keeps an index of what has been drawn.

use super::body::Anchor;
use super::construct::{Construction, Extent};
use super::images::LaidOff;
use super::name::image_name;
use super::operation::{
    Along, End, LineId, MeasuredAs, NumberId, NumberKind, Operation, OperationKind, Part, PlaceId, Product, Rate,
    StepId,
};
use super::run::Values;
use super::step::{Action, Plan, PlanPoint, PointRole, Step};
use crate::geometry::{Ball, Number, Pair, UNIT_ROUNDOFF, Vector, cross, span};
use crate::mechanism::{BodyId, GROUND, Guide, Mechanism, PointId, SliderId};
use crate::motion::Motion;
use crate::position::Pose;
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// Number of roundings in a guide's unit direction, computed from the scene's direction.
const GUIDE_ROUNDINGS: f64 = 4.0;

/// A construction in progress.
pub(crate) struct Writer<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub motion: &'a Motion,
    /// The operations and steps written so far.
    pub construction: Construction,
    /// The results of the operations, with bounds of their rounding errors.
    pub(super) exact: Values<Ball>,
    /// Places in the plans of the motions of bodies' points.
    pub(super) motions: IndexMap<(Sheet, BodyId, PointId), PlaceId>,
    /// By plan and body: the point whose motion was there first, and its place.
    pub(super) first_motions: IndexMap<(Sheet, BodyId), (PointId, PlaceId)>,
    /// The vectors laid off between images of points, by their ends.
    pub(super) laid_off: IndexMap<PlaceId, LaidOff>,
    /// By place: its names on the sheets.
    pub(super) names: Vec<Vec<(Sheet, String)>>,
    /// By body: the joint by which its motion follows from a known one.
    pub(super) anchors: Vec<Option<Anchor>>,
    /// Tolerance for a point on a line and for coincident points, in units of length.
    pub near: f64,
    /// The current step, to which operations belong.
    pub step: Option<StepId>,
    /// False while rates are taken from the computed motion: operations then are not done by hand.
    pub(super) by_hand: bool,
    guides: Vec<Option<LineId>>,
    joins: IndexMap<[PlaceId; 2], LineId>,
    lengths: IndexMap<[PointId; 2], NumberId>,
    /// By place: the lines drawn through it in a direction.
    rays: IndexMap<PlaceId, Vec<(Along, LineId)>>,
    /// By place: the operation that makes it.
    makers: Vec<usize>,
    /// By point: the bodies that have it.
    holders: Vec<Vec<BodyId>>,
    /// Results that depend on rates taken from the computed motion, which ruler and pencil do not find: by place, by
    /// line, by number.
    not_by_hand: [Vec<bool>; 3],
}

impl<'a> Writer<'a> {
    /// A writer with the poles of the plans and the rates that the scene gives.
    pub(super) fn new(mechanism: &'a Mechanism, pose: &'a Pose, motion: &'a Motion, extent: Extent) -> Self {
        let origin = pose.points.first().copied().unwrap_or_default();
        let mut writer = Writer {
            mechanism,
            pose,
            motion,
            construction: Construction::empty(mechanism, motion.order, origin, extent),
            exact: Values::default(),
            motions: IndexMap::new(),
            first_motions: IndexMap::new(),
            laid_off: IndexMap::new(),
            names: Vec::new(),
            anchors: vec![None; mechanism.bodies.len()],
            near: 64.0 * UNIT_ROUNDOFF * span(pose.points.iter().copied()),
            step: None,
            by_hand: true,
            guides: vec![None; mechanism.sliders.len()],
            joins: IndexMap::new(),
            lengths: IndexMap::new(),
            rays: IndexMap::new(),
            makers: Vec::new(),
            holders: mechanism.holders(),
            not_by_hand: Default::default(),
        };
        for &sheet in writer.plans() {
            writer.begin_plan(sheet);
        }
        writer.take_known_rates();
        writer
    }

    /// Draws the pole of a plan, the image of all fixed points.
    fn begin_plan(&mut self, sheet: Sheet) {
        let grounded = &self.mechanism.body(GROUND).points;
        let images: Vec<String> = grounded.iter().map(|&p| image_name(self.mechanism.point_name(p))).collect();
        let pole = self.plan(sheet).kind.pole();
        let place = self.pole(sheet, pole, Vector::zeros());
        self.show(sheet, pole, place, PointRole::Pole);
        for image in &images {
            self.show(sheet, image, place, PointRole::Pole);
        }
        self.begin(sheet, Action::Pole { images });
        self.step = None;
    }

    /// The plans that are drawn.
    pub(super) fn plans(&self) -> &'static [Sheet] {
        self.motion.order.plans_up_to()
    }

    /// The plan of a sheet; never called for the scheme.
    pub(super) fn plan(&mut self, sheet: Sheet) -> &mut Plan {
        match (sheet, &mut self.construction.acceleration) {
            (Sheet::Acceleration, Some(plan)) => plan,
            _ => &mut self.construction.velocity,
        }
    }

    /// Begins a step, to which the operations that follow belong.
    pub(super) fn begin(&mut self, sheet: Sheet, action: Action) {
        let steps = match sheet {
            Sheet::Scheme => &mut self.construction.scheme,
            _ => &mut self.plan(sheet).steps,
        };
        let index = steps.len();
        steps.push(Step { action });
        self.step = Some(StepId { sheet, index });
    }

    /// Assigns the operation that made a place to the current step, if it belongs to none.
    pub(super) fn claim(&mut self, place: PlaceId) {
        let step = self.step;
        let made = self.makers.get(place.0).and_then(|&index| self.construction.operations.get_mut(index));
        if let Some(operation) = made.filter(|operation| operation.step.is_none()) {
            operation.step = step;
        }
    }

    /// Sets the value of the last step, a measurement.
    pub(super) fn set_measured(&mut self, sheet: Sheet, measured: f64) {
        if let Some(Action::Measure { value, .. }) = self.plan(sheet).steps.last_mut().map(|step| &mut step.action) {
            *value = measured;
        }
    }

    /// Sets the direction of the last step, a ray, to that of its line.
    pub(super) fn set_direction(&mut self, sheet: Sheet, line: LineId) {
        let along = self.exact.exact_direction(line).rounded();
        if let Some(Action::Ray(ray)) = self.plan(sheet).steps.last_mut().map(|step| &mut step.action) {
            ray.direction = along;
        }
    }

    /// Notes the place of the motion of a body's point in a plan.
    pub(super) fn note_motion(&mut self, sheet: Sheet, body: BodyId, point: PointId, place: PlaceId) {
        self.motions.entry((sheet, body, point)).or_insert(place);
        self.first_motions.entry((sheet, body)).or_insert((point, place));
    }

    /// Adds a point to a plan; an existing point of that name stays.
    pub(super) fn show(&mut self, sheet: Sheet, name: &str, place: PlaceId, role: PointRole) {
        self.name_place(sheet, name, place);
        let point = PlanPoint { vector: self.exact.exact_place(place).rounded(), role };
        let plan = self.plan(sheet);
        if !plan.points.contains_key(name) {
            plan.largest = plan.largest.max(point.vector.norm());
            plan.points.insert(name.to_owned(), point);
        }
    }

    /// Adds an operation and carries it out.
    fn push(&mut self, sheet: Sheet, part: Part, kind: OperationKind) {
        let (places, lines) = kind.places_and_lines_read();
        let mut by_hand = self.by_hand;
        by_hand &= !places.iter().any(|p| self.not_by_hand[0][p.0]) && !lines.iter().any(|l| self.not_by_hand[1][l.0]);
        kind.each_number_read(|n| by_hand &= !self.not_by_hand[2][n.0]);
        let counts = self.construction.counts;
        for (not_by_hand, count) in self.not_by_hand.iter_mut().zip(counts) {
            not_by_hand.resize(count, false);
        }
        let not_by_hand = !by_hand;
        if let Some(place) = kind.place() {
            self.not_by_hand[0][place.0] = not_by_hand;
            self.makers.resize(counts[0], 0);
            self.makers[place.0] = self.construction.operations.len();
        }
        if let Some(line) = kind.line() {
            self.not_by_hand[1][line.0] = not_by_hand;
        }
        for number in kind.numbers() {
            self.not_by_hand[2][number.0] = not_by_hand;
        }
        self.exact.resize(counts);
        self.exact.run(&kind, [0.0; 2], 1.0);
        // Given numbers, sums and joining lines may be used by several steps: they belong to none.
        let belongs_to_step = matches!(
            kind,
            OperationKind::Draw { .. }
                | OperationKind::Cross { .. }
                | OperationKind::Divide { .. }
                | OperationKind::LayOff { .. }
                | OperationKind::Measure { .. }
                | OperationKind::Solve { .. }
        );
        let step = self.step.filter(|step| belongs_to_step && step.sheet == sheet);
        self.construction.operations.push(Operation { sheet, step, part, kind, by_hand });
    }

    /// Whether a number cannot be found with ruler and pencil.
    pub(crate) fn is_not_by_hand(&self, number: NumberId) -> bool {
        self.not_by_hand[2][number.0]
    }

    /// Whether a place cannot be found with ruler and pencil.
    pub(crate) fn is_place_not_by_hand(&self, place: PlaceId) -> bool {
        self.not_by_hand[0][place.0]
    }

    fn new_place(&mut self) -> PlaceId {
        self.construction.counts[0] += 1;
        PlaceId(self.construction.counts[0] - 1)
    }

    fn new_line(&mut self) -> LineId {
        self.construction.counts[1] += 1;
        LineId(self.construction.counts[1] - 1)
    }

    fn new_number(&mut self, kind: NumberKind) -> NumberId {
        self.construction.counts[2] += 1;
        self.construction.numbers.push(kind);
        NumberId(self.construction.counts[2] - 1)
    }

    /// Names a place. A place may have several names; a name keeps its first place.
    pub(super) fn name_place(&mut self, sheet: Sheet, name: &str, place: PlaceId) {
        let key = (sheet, name.to_owned());
        if !self.construction.places.contains_key(&key) {
            self.names.resize(self.names.len().max(place.0 + 1), Vec::new());
            self.names[place.0].push(key.clone());
            self.construction.places.insert(key, place);
        }
    }

    pub(crate) fn pole(&mut self, sheet: Sheet, name: &str, at: Vector) -> PlaceId {
        let place = self.new_place();
        self.push(sheet, Part::Pole, OperationKind::Pole { place, at });
        self.name_place(sheet, name, place);
        place
    }

    /// The pole of a plan.
    pub(crate) fn pole_of(&self, sheet: Sheet) -> Option<PlaceId> {
        self.construction.operations.iter().find_map(|operation| match operation.kind {
            OperationKind::Pole { place, .. } if operation.sheet == sheet => Some(place),
            _ => None,
        })
    }

    /// A joint on the scheme.
    pub(crate) fn plot(&mut self, point: PointId) -> PlaceId {
        let name = self.mechanism.point_name(point);
        if let Some(place) = self.construction.place(Sheet::Scheme, name) {
            return place;
        }
        let place = self.new_place();
        let at = self.pose.point(point) - self.construction.origin;
        // Joints are plotted by hand in any case.
        let by_hand = core::mem::replace(&mut self.by_hand, true);
        self.push(Sheet::Scheme, Part::Joint(point), OperationKind::Plot { place, at });
        self.by_hand = by_hand;
        self.exact.set_place(place, Pair::between(self.construction.origin, self.pose.point(point)));
        self.name_place(Sheet::Scheme, name, place);
        place
    }

    /// The line through two joints, from the first towards the second.
    pub(crate) fn join(&mut self, from: PointId, towards: PointId) -> LineId {
        let (from, towards) = (self.plot(from), self.plot(towards));
        self.join_places(from, towards, Part::Line)
    }

    /// The line through two places.
    pub(crate) fn join_places(&mut self, from: PlaceId, towards: PlaceId, part: Part) -> LineId {
        if let Some(line) = self.joins.get(&[from, towards]) {
            return *line;
        }
        let line = self.new_line();
        self.joins.insert([from, towards], line);
        self.push(Sheet::Scheme, part, OperationKind::Join { line, from, towards });
        line
    }

    pub(super) fn draw(&mut self, sheet: Sheet, part: Part, through: PlaceId, along: Along) -> LineId {
        let line = self.new_line();
        self.rays.entry(through).or_default().push((along, line));
        self.push(sheet, part, OperationKind::Draw { line, through, along });
        line
    }

    /// The line that is drawn already through a place in a direction.
    pub(super) fn drawn(&self, through: PlaceId, along: Along) -> Option<LineId> {
        let lines = self.rays.get(&through)?;
        lines.iter().find(|(other, _)| *other == along).map(|(_, line)| *line)
    }

    /// The crossing of two lines; `None` for parallel lines.
    pub(super) fn cross(&mut self, sheet: Sheet, part: Part, lines: [LineId; 2]) -> Option<PlaceId> {
        let place = self.new_place();
        self.push(sheet, part, OperationKind::Cross { place, lines });
        let at = self.exact.exact_place(place);
        (is_known(at.x) && is_known(at.y)).then_some(place)
    }

    /// The point that divides the line between two plan points as the third of `like` divides that of the other two.
    pub(super) fn divide(&mut self, sheet: Sheet, ends: [PlaceId; 2], like: [PlaceId; 3]) -> PlaceId {
        let place = self.new_place();
        self.push(sheet, Part::Image, OperationKind::Divide { place, ends, like });
        place
    }

    pub(crate) fn measure(
        &mut self,
        sheet: Sheet,
        kind: NumberKind,
        [from, to]: [PlaceId; 2],
        how: MeasuredAs,
    ) -> NumberId {
        let number = self.new_number(kind);
        self.push(sheet, Part::Number, OperationKind::Measure { number, from, to, how });
        number
    }

    /// Takes a number of the scene; none for zero.
    pub(super) fn take(&mut self, sheet: Sheet, kind: NumberKind, value: f64) -> Option<NumberId> {
        if value == 0.0 {
            return None;
        }
        let number = self.new_number(kind);
        self.push(sheet, Part::Number, OperationKind::Take { number, value });
        Some(number)
    }

    pub(crate) fn compute(&mut self, sheet: Sheet, kind: NumberKind, sum: Vec<Product>) -> NumberId {
        let number = self.new_number(kind);
        self.push(sheet, Part::Number, OperationKind::Compute { number, sum });
        number
    }

    /// Takes a rate from the computed motion, with the bound of its error.
    pub(super) fn take_computed(&mut self, sheet: Sheet, rate: Rate, value: f64, error: f64) -> NumberId {
        let number = self.new_number(NumberKind::Rate(rate));
        let by_hand = core::mem::replace(&mut self.by_hand, false);
        self.push(sheet, Part::Number, OperationKind::Take { number, value });
        self.by_hand = by_hand;
        self.exact.set_number(number, Ball::from(value).widened(error));
        number
    }

    /// Solves linear equations for rates; `None` where they are singular.
    pub(super) fn solve(
        &mut self,
        sheet: Sheet,
        rates: &[Rate],
        equations: Vec<super::operation::Equation>,
    ) -> Option<Vec<NumberId>> {
        let unknowns: Vec<NumberId> = rates.iter().map(|&rate| self.new_number(NumberKind::Rate(rate))).collect();
        self.push(sheet, Part::Rates, OperationKind::Solve { unknowns: unknowns.clone(), equations });
        unknowns.iter().all(|&number| is_known(self.exact.exact_number(number))).then_some(unknowns)
    }

    /// Lays off a vector whose size is a sum of products; returns its end, which is `from` for an empty sum.
    pub(crate) fn lay_off(&mut self, sheet: Sheet, from: PlaceId, sum: Vec<Product>, along: Along) -> PlaceId {
        if sum.is_empty() {
            return from;
        }
        let size = self.compute(sheet, NumberKind::Size, sum);
        let place = self.new_place();
        self.push(sheet, Part::Vector, OperationKind::LayOff { place, from, size, along });
        place
    }

    /// The distance of two joints: given where both belong to one body, else measured.
    pub(super) fn length(&mut self, a: PointId, b: PointId) -> NumberId {
        if let Some(number) = self.lengths.get(&[a, b]).or_else(|| self.lengths.get(&[b, a])) {
            return *number;
        }
        let bodies = self.holders[a.0].iter().map(|&body| self.mechanism.body(body));
        let given = bodies.into_iter().any(|body| body.local_of(a).and(body.local_of(b)).is_some());
        let kind = NumberKind::Length([End::Joint(a), End::Joint(b)]);
        let number = if given {
            let value = self.pose.arm(a, b).norm();
            let number = self.new_number(kind);
            self.push(Sheet::Scheme, Part::Number, OperationKind::Take { number, value });
            let arm = Pair::between(self.pose.point(a), self.pose.point(b));
            self.exact.set_number(number, arm.dot(arm).sqrt());
            number
        } else {
            let line = self.join(a, b);
            let ends = [self.plot(a), self.plot(b)];
            self.measure(Sheet::Scheme, kind, ends, MeasuredAs::Along(line))
        };
        self.lengths.insert([a, b], number);
        number
    }

    /// A slider's guide on the scheme.
    pub(crate) fn guide(&mut self, id: SliderId) -> LineId {
        if let Some(line) = self.guides[id.0] {
            return line;
        }
        let direction = self.pose.guide(id);
        let line = match self.points_of_guide(id) {
            Some(ends) => {
                let [from, towards] = ends.map(|point| self.plot(point));
                self.join_places(from, towards, Part::Guide(id))
            }
            None => {
                let at = self.plot(self.mechanism.slider(id).at);
                self.draw(Sheet::Scheme, Part::Guide(id), at, Along::given(direction))
            }
        };
        // The scene gives the direction itself; a join of rounded joints would be less exact.
        let error = GUIDE_ROUNDINGS * UNIT_ROUNDOFF + 0.5 * (direction.norm_squared() - 1.0).abs();
        let Pair { x, y } = Pair::<Ball>::from(direction);
        self.exact.set_direction(line, Pair { x: x.widened(error), y: y.widened(error) });
        self.guides[id.0] = Some(line);
        line
    }

    /// The two points of the guide on its body that are farthest apart, in the guide's direction; `None` without two
    /// distinct points.
    fn points_of_guide(&self, id: SliderId) -> Option<[PointId; 2]> {
        let slider = self.mechanism.slider(id);
        let (u, at) = (self.pose.guide(id), self.pose.point(slider.at));
        let along = |p: PointId| (self.pose.point(p) - at).dot(&u);
        let candidates = match slider.guide {
            Guide::DrawnBetween(p, q) => vec![p, q],
            Guide::Drawn(_) => Vec::new(),
            Guide::Local { .. } => {
                let on_it = |p: &PointId| cross(self.pose.point(*p) - at, u).abs() <= self.near;
                self.mechanism.body(slider.on).points.iter().copied().filter(on_it).collect()
            }
        };
        let by_place = |a: &&PointId, b: &&PointId| along(**a).total_cmp(&along(**b));
        let first = *candidates.iter().min_by(by_place)?;
        let last = *candidates.iter().max_by(by_place)?;
        (along(last) - along(first) > self.near).then_some([first, last])
    }
}

/// Whether a number and the bound of its error are finite.
fn is_known(number: Ball) -> bool {
    number.high.is_finite() && number.error().is_finite()
}
