use super::act::{Act, Deed, How, LineId, NumberId, PlaceId, Product, Reference, Sheet};
use super::body::Anchor;
use crate::geometry::{Point, UNIT_ROUNDOFF, Vector, cross, span};
use crate::mechanism::{BodyId, GROUND, Guide, Mechanism, PointId, SliderId};
use crate::motion::{Motion, Order};
use crate::plan::{Construction, PlanKind, Solution, image_name};
use crate::position::Pose;
use indexmap::IndexMap;

/// The construction of a scene by hand, act by act, in the order of the steps.
#[derive(Clone, Debug)]
pub struct Drafting {
    /// What is done.
    pub acts: Vec<Act>,
    /// From where places of the scheme count, the mechanism's first point: far from it digits would be lost.
    pub origin: Point,
    /// How many places, lines and numbers the acts make.
    pub(super) counts: [usize; 3],
    /// Points of the sheets by name: joints and special points of the scheme, points of the plans as in [`Construction`].
    pub(super) places: IndexMap<(Sheet, String), PlaceId>,
    /// What is measured and solved for, by the names of quantities.
    pub(super) numbers: IndexMap<String, NumberId>,
    /// By body, where the construction gives them: ω and α; of a given rate that is zero nothing.
    pub(super) spins: Vec<Option<[Option<NumberId>; 2]>>,
    /// By slider, likewise: velocity and acceleration along the guide.
    pub(super) slides: Vec<Option<[Option<NumberId>; 2]>>,
}

impl Drafting {
    /// A point of a sheet by its name, as in `S3` of the scheme or `n_b3` of the acceleration plan.
    #[must_use]
    pub fn place(&self, sheet: Sheet, name: &str) -> Option<PlaceId> {
        self.places.get(&(sheet, name.to_owned())).copied()
    }

    /// A number by the name of its quantity, as in `L(B,S3)`, `vplan(b,s3)`, `omega(2)`; measured ones are positive in the direction
    /// of their cut line or ray.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<NumberId> {
        self.numbers.get(name).copied()
    }

    /// The named points of the sheets, in the order in which they got their names; a place may have several names.
    pub fn named_places(&self) -> impl Iterator<Item = (Sheet, &str, PlaceId)> {
        let places = self.places.iter();
        places.map(|((sheet, name), &place)| (*sheet, name.as_str(), place))
    }
}

/// The construction of `mechanism` as acts, for the groups that have one; of the others nothing is known by hand.
///
/// Joints are plotted at their places. Lengths between two points of one link are taken from the scene, other lengths are measured, as
/// are all in a drawn configuration. A guide that runs through two points of its link is drawn through them, any other in its
/// direction. Places are counted from the mechanism's first point.
#[must_use]
pub fn drafting(solution: &Solution) -> Drafting {
    written(solution).drafting
}

/// The same, with what may still be added to it.
pub(super) fn written(solution: &Solution) -> Writer<'_> {
    let mut writer = Writer::new(solution);
    for index in 0..solution.mechanism.groups.len() {
        writer.group(index);
    }
    writer
}

/// Puts acts down one after the other, and knows what is there already.
pub(super) struct Writer<'a> {
    pub mechanism: &'a Mechanism,
    pub pose: &'a Pose,
    pub motion: &'a Motion,
    pub construction: &'a Construction,
    pub drafting: Drafting,
    /// Where the motions of bodies' points stand in the plans.
    pub moved: Vec<(Sheet, BodyId, PointId, PlaceId)>,
    /// By body: how it hangs on one whose motion is there.
    pub anchors: Vec<Option<Anchor>>,
    /// Nearer to a line or a place than this counts as being there.
    pub near: f64,
    guides: Vec<Option<LineId>>,
    joins: Vec<(PlaceId, PlaceId, LineId)>,
    lengths: Vec<(PointId, PointId, NumberId)>,
}

impl<'a> Writer<'a> {
    fn new(solution: &'a Solution) -> Self {
        let Solution { mechanism, pose, motion, construction, .. } = solution;
        let drafting = Drafting {
            acts: Vec::new(),
            origin: pose.points.first().copied().unwrap_or_default(),
            counts: [0; 3],
            places: IndexMap::new(),
            numbers: IndexMap::new(),
            spins: vec![None; mechanism.bodies.len()],
            slides: vec![None; mechanism.sliders.len()],
        };
        let mut writer = Writer {
            mechanism,
            pose,
            motion,
            construction,
            drafting,
            moved: Vec::new(),
            anchors: vec![None; mechanism.bodies.len()],
            near: 64.0 * UNIT_ROUNDOFF * span(pose.points.iter().copied()),
            guides: vec![None; mechanism.sliders.len()],
            joins: Vec::new(),
            lengths: Vec::new(),
        };
        for plan in construction.plans() {
            let sheet = Sheet::of(plan.kind);
            let pole = writer.pole(sheet, plan.kind.pole(), Vector::zeros());
            for &point in &mechanism.body(GROUND).points {
                writer.name_place(sheet, &image_name(mechanism.point_name(point)), pole);
            }
        }
        writer.take_known_rates();
        writer
    }

    /// The sheets of the plans that are drawn.
    pub(super) fn plans(&self) -> &'static [Sheet] {
        match self.motion.order {
            Order::Velocity => &[Sheet::Velocity],
            Order::Acceleration => &[Sheet::Velocity, Sheet::Acceleration],
        }
    }

    fn act(&mut self, sheet: Sheet, makes: &str, deed: Deed) {
        let makes = makes.to_owned();
        self.drafting.acts.push(Act { sheet, makes, deed });
    }

    fn new_place(&mut self) -> PlaceId {
        self.drafting.counts[0] += 1;
        PlaceId(self.drafting.counts[0] - 1)
    }

    fn new_line(&mut self) -> LineId {
        self.drafting.counts[1] += 1;
        LineId(self.drafting.counts[1] - 1)
    }

    pub(super) fn new_number(&mut self) -> NumberId {
        self.drafting.counts[2] += 1;
        NumberId(self.drafting.counts[2] - 1)
    }

    /// A place may have several names; the first place of a name stays.
    pub(super) fn name_place(&mut self, sheet: Sheet, name: &str, place: PlaceId) {
        let key = (sheet, name.to_owned());
        self.drafting.places.entry(key).or_insert(place);
    }

    pub(super) fn name_number(&mut self, name: &str, number: NumberId) {
        let name = name.to_owned();
        self.drafting.numbers.entry(name).or_insert(number);
    }

    pub(super) fn pole(&mut self, sheet: Sheet, name: &str, at: Vector) -> PlaceId {
        let place = self.new_place();
        self.act(sheet, name, Deed::Pole { place, at });
        self.name_place(sheet, name, place);
        place
    }

    /// The pole of a plan.
    pub(super) fn pole_of(&self, sheet: Sheet) -> Option<PlaceId> {
        let mut places = self.drafting.places.iter();
        let found = places.find(|((of, _), _)| *of == sheet);
        found.map(|(_, &place)| place)
    }

    /// A joint on the scheme.
    pub(super) fn plot(&mut self, point: PointId) -> PlaceId {
        let name = self.mechanism.point_name(point);
        self.plot_at(name, self.pose.point(point))
    }

    pub(super) fn plot_at(&mut self, name: &str, at: Point) -> PlaceId {
        if let Some(place) = self.drafting.place(Sheet::Scheme, name) {
            return place;
        }
        let place = self.new_place();
        let at = at - self.drafting.origin;
        self.act(Sheet::Scheme, name, Deed::Plot { place, at });
        self.name_place(Sheet::Scheme, name, place);
        place
    }

    /// The line through two joints, from the first towards the second.
    pub(super) fn join(&mut self, from: PointId, towards: PointId) -> LineId {
        let (from, towards) = (self.plot(from), self.plot(towards));
        self.join_places(from, towards)
    }

    pub(super) fn join_places(&mut self, from: PlaceId, towards: PlaceId) -> LineId {
        let mut joins = self.joins.iter();
        if let Some((.., line)) = joins.find(|j| (j.0, j.1) == (from, towards)) {
            return *line;
        }
        let line = self.new_line();
        self.joins.push((from, towards, line));
        let deed = Deed::Join { line, from, towards };
        self.act(Sheet::Scheme, "line through two joints", deed);
        line
    }

    pub(super) fn draw(
        &mut self,
        sheet: Sheet,
        makes: &str,
        through: PlaceId,
        (reference, quarter_turns): (Reference, u8),
    ) -> LineId {
        let line = self.new_line();
        let deed = Deed::Draw { line, through, reference, quarter_turns };
        self.act(sheet, makes, deed);
        line
    }

    pub(super) fn cross(&mut self, sheet: Sheet, name: &str, lines: [LineId; 2]) -> PlaceId {
        let place = self.new_place();
        self.act(sheet, name, Deed::Cross { place, lines });
        self.name_place(sheet, name, place);
        place
    }

    pub(super) fn measure(&mut self, sheet: Sheet, name: &str, [from, to]: [PlaceId; 2], how: How) -> NumberId {
        let number = self.new_number();
        let deed = Deed::Measure { number, from, to, how };
        self.act(sheet, name, deed);
        number
    }

    /// A number of the scene; none for zero.
    pub(super) fn take(&mut self, sheet: Sheet, name: &str, value: f64) -> Option<NumberId> {
        if value == 0.0 {
            return None;
        }
        let number = self.new_number();
        self.act(sheet, name, Deed::Take { number, value });
        Some(number)
    }

    pub(super) fn compute(&mut self, sheet: Sheet, makes: &str, sum: Vec<Product>) -> NumberId {
        let number = self.new_number();
        self.act(sheet, makes, Deed::Compute { number, sum });
        number
    }

    pub(super) fn solve(&mut self, sheet: Sheet, makes: &str, deed: Deed) {
        self.act(sheet, makes, deed);
    }

    /// The end of a vector whose size is a sum of products, laid off from a place; that place itself where nothing is summed.
    pub(super) fn lay_off(
        &mut self,
        sheet: Sheet,
        makes: &str,
        from: PlaceId,
        sum: Vec<Product>,
        (reference, quarter_turns): (Reference, u8),
    ) -> PlaceId {
        if sum.is_empty() {
            return from;
        }
        let size = self.compute(sheet, &format!("size of the vector to {makes}"), sum);
        let place = self.new_place();
        let deed = Deed::LayOff { place, from, size, reference, quarter_turns };
        self.act(sheet, makes, deed);
        place
    }

    /// The distance of two joints: taken from the scene where it is one of a link, else measured.
    pub(super) fn length(&mut self, a: PointId, b: PointId) -> NumberId {
        let known = |l: &&(PointId, PointId, NumberId)| [(a, b), (b, a)].contains(&(l.0, l.1));
        if let Some((.., number)) = self.lengths.iter().find(known) {
            return *number;
        }
        let mut bodies = self.mechanism.bodies.iter();
        let given = bodies.any(|body| body.local_of(a).and(body.local_of(b)).is_some());
        let name = |p| self.mechanism.point_name(p);
        let name = format!("L({},{})", name(a), name(b));
        let number = if given {
            let number = self.new_number();
            let value = self.pose.arm(a, b).norm();
            self.act(Sheet::Scheme, &name, Deed::Take { number, value });
            number
        } else {
            let line = self.join(a, b);
            let ends = [self.plot(a), self.plot(b)];
            let number = self.measure(Sheet::Scheme, &name, ends, How::Along(line));
            self.name_number(&name, number);
            number
        };
        self.lengths.push((a, b, number));
        number
    }

    /// A slider's guide on the scheme.
    pub(super) fn guide(&mut self, id: SliderId) -> LineId {
        if let Some(line) = self.guides[id.0] {
            return line;
        }
        let line = match self.points_of_guide(id) {
            Some([from, towards]) => self.join(from, towards),
            None => {
                let at = self.plot(self.mechanism.slider(id).at);
                let makes = format!("guide of {}", self.mechanism.slider_name(id));
                let direction = Reference::Given(self.pose.guide(id));
                self.draw(Sheet::Scheme, &makes, at, (direction, 0))
            }
        };
        self.guides[id.0] = Some(line);
        line
    }

    /// The two points of the guide's body farthest from each other between which it runs, in its direction.
    fn points_of_guide(&self, id: SliderId) -> Option<[PointId; 2]> {
        let slider = self.mechanism.slider(id);
        let (u, at) = (self.pose.guide(id), self.pose.point(slider.at));
        let along = |p: PointId| (self.pose.point(p) - at).dot(&u);
        let candidates = match slider.guide {
            Guide::DrawnBetween(p, q) => vec![p, q],
            Guide::Drawn(_) => Vec::new(),
            Guide::Local { .. } => {
                let points = self.mechanism.body(slider.on).points.iter().copied();
                let on_it = |p: &PointId| cross(self.pose.point(*p) - at, u).abs() <= self.near;
                points.filter(on_it).collect()
            }
        };
        let by_place = |a: &&PointId, b: &&PointId| along(**a).total_cmp(&along(**b));
        let first = *candidates.iter().min_by(by_place)?;
        let last = *candidates.iter().max_by(by_place)?;
        (along(last) - along(first) > self.near).then_some([first, last])
    }
}

impl Sheet {
    /// The sheet of a plan.
    #[must_use]
    pub fn of(kind: PlanKind) -> Sheet {
        match kind {
            PlanKind::Velocity => Sheet::Velocity,
            PlanKind::Acceleration => Sheet::Acceleration,
        }
    }
}
