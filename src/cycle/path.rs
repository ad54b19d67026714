use super::CycleError;
use super::drive::{Drive, in_radians, moving, ratios, shortened, snapped, stands};
use super::position::{Position, regular_start};
use super::segment::{Node, Segment};
use super::together::Together;
use crate::geometry::{Lanes, Many, Row, span};
use crate::kernel::{Block, InputKind, Kernel, Single, vector};
use crate::mechanism::{BodyId, GROUND, Mechanism, PointId, Role, SliderId};
use crate::motion::Reach;
use crate::position::Pose;
use crate::quantity::QuantityRequest;
use crate::words::Wording;
use std::borrow::Cow;

/// Distance from a change point within which there are no results, in turns: the rounding error of accelerations is
/// about u / distance², that of groups with ties u / distance³.
pub(super) const BLANK: f64 = 1e-4;

/// An event at one value of the drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The drive's value.
    pub at: f64,
    /// How far from it the event can be: proved of limits and change points of dyads on a crank, else what another
    /// estimate differs by, with room.
    pub within: f64,
    /// What happens.
    pub what: Happening,
}

/// What can happen on a path.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Happening {
    /// Two branches meet and the drive can go no further; rates grow like 1/√distance. The links of the group that is
    /// stretched, or otherwise singular.
    Limit(String),
    /// A place runs off to infinity, as where two guides become parallel. The links of the group that runs off.
    RunsOff(String),
    /// Two branches cross: the motion goes on smoothly, but it could go on in another mode too, so rates are not
    /// determined. The links of the group.
    Change(String),
    /// The path cannot be followed through a singular position of another kind. The links of the group.
    Singular(String),
    /// A slider comes to an end of its guide and leaves it: the drive moves it no further.
    Leaves {
        /// The slider's name, as in `3/2`.
        slider: String,
        /// The position of that end.
        position: f64,
    },
    /// A link stops and turns back: an extreme position, and a dead centre if that link were the driving one.
    TurnsBack {
        /// The link's name.
        link: String,
        /// Its angle there, in degrees.
        angle: f64,
    },
    /// A slider stops on its guide and slides back: likewise.
    SlidesBack {
        /// The slider's name, as in `3/2`.
        slider: String,
        /// Its position there.
        position: f64,
    },
}

impl Event {
    /// Whether the path ends here.
    #[must_use]
    pub fn is_end(&self) -> bool {
        matches!(
            self.what,
            Happening::Limit(_) | Happening::RunsOff(_) | Happening::Singular(_) | Happening::Leaves { .. }
        )
    }

    /// The event in words; `place` is the drive's value in words, as in `angle(1) = 30°`.
    #[must_use]
    pub fn text(&self, place: &str, words: &Wording) -> String {
        let language = words.language;
        let number = |value: f64| words.number(shortened(value, 9).to_string());
        match &self.what {
            Happening::Limit(links) => language.event_limit(place, links),
            Happening::RunsOff(links) => language.event_runs_off(place, links),
            Happening::Change(links) => language.event_change(place, links),
            Happening::Singular(links) => language.event_singular(place, links),
            Happening::Leaves { slider, position } => language.event_leaves(place, slider, &number(*position)),
            Happening::TurnsBack { link, angle } => {
                language.event_turns_back(place, link, &number(snapped(*angle, 360.0)))
            }
            Happening::SlidesBack { slider, position } => language.event_slides_back(place, slider, &number(*position)),
        }
    }
}

/// The motion of a mechanism along one branch while a drive moves, as far as it has been followed.
///
/// Other drives run along in proportion to their speeds in the scene; they stand still where the moved drive's own
/// speed is zero, or in the mechanism that [`alone`](super::alone) returns.
#[derive(Clone, Debug)]
pub struct Path<'a> {
    /// The mechanism.
    pub mechanism: Cow<'a, Mechanism>,
    /// The drive that moves it.
    pub drive: Drive,
    pub(super) kernel: Kernel,
    /// The kernel without the places of points.
    pub(super) bare: Kernel,
    /// For each drive: its value at the scene's position, and its rate per unit rate of the moved drive.
    pub(super) inputs: Vec<[f64; 2]>,
    /// The moved drive's value at the scene's position.
    pub(super) origin: f64,
    /// The mechanism's size at the scene's position.
    pub(super) size: f64,
    /// In the order of the drive's value.
    pub(super) nodes: Vec<Node>,
    pub(super) segments: Vec<Segment>,
    /// The change points that it crosses.
    pub(super) changes: Vec<Event>,
    /// The events that end the path below and above, if any.
    pub(super) ends: [Option<Event>; 2],
}

impl<'a> Path<'a> {
    /// The path through `pose`, not followed to either side yet.
    ///
    /// # Errors
    /// The configuration is drawn, or `pose` is singular.
    pub fn new(mechanism: &'a Mechanism, pose: &Pose, drive: Drive) -> Result<Self, CycleError> {
        Self::of(Cow::Borrowed(mechanism), pose, drive)
    }

    /// As [`Self::new`], of a mechanism that the path may own.
    pub(super) fn of(mechanism: Cow<'a, Mechanism>, pose: &Pose, drive: Drive) -> Result<Self, CycleError> {
        let kernel = moving(&mechanism)?;
        let ratios = ratios(&kernel.inputs, drive.input);
        let inputs: Vec<[f64; 2]> =
            kernel.inputs.iter().zip(ratios).map(|(i, ratio)| [stands(i, pose), ratio]).collect();
        let origin = inputs[drive.input][0];
        let at = || drive.at(origin, &Wording::default());
        let mut block = regular_start(&kernel, &mechanism, pose, at)?;
        let path = Path {
            mechanism,
            inputs,
            origin,
            size: span(block.points.iter().map(|p| vector(p, 0).into())),
            nodes: Vec::new(),
            segments: Vec::new(),
            changes: Vec::new(),
            ends: [None, None],
            drive,
            bare: kernel.without_places(),
            kernel,
        };
        if let Some((id, _)) = path.off_guide(&block) {
            return Err(CycleError::OffGuide(path.mechanism.slider_name(id)));
        }
        path.unit_rates(&mut block);
        let nodes = vec![Node::new(&path.kernel, origin, block)];
        Ok(Path { nodes, ..path })
    }

    /// How far a dyad reaches that hangs on the moved crank; `None` of other groups.
    pub(super) fn reach(&self, group: usize, pose: &Pose) -> Option<Reach> {
        let input = &self.kernel.inputs[self.drive.input];
        let reach = Reach::new(&self.mechanism, &self.mechanism.groups[group], pose)?;
        (self.drive.is_angle && reach.crank == input.body).then_some(reach)
    }

    /// The slider that is off its guide farthest in a position, and by how much.
    pub(super) fn off_guide(&self, block: &Single) -> Option<(SliderId, f64)> {
        self.mechanism.off_guide(|id| Some(block.slides[id.0][0]))
    }

    /// One turn in the drive's unit: 360° of a crank; for a slider, the mechanism's size.
    pub(super) fn unit(&self) -> f64 {
        if self.drive.is_angle { 360.0 } else { self.size }
    }

    /// Sets all drives in `block` to where they stand at these values of the moved drive.
    #[inline(always)]
    pub(super) fn set_inputs<L: Lanes, R: Row>(&self, lanes: L, block: &mut Block<R>, values: &R) {
        for (index, [start, ratio]) in self.inputs.iter().enumerate() {
            if index == self.drive.input {
                self.kernel.set_input_in(lanes, block, index, values);
                continue;
            }
            let mut own = *values;
            for value in own.as_mut() {
                *value = (*value - self.origin) * ratio + start;
            }
            self.kernel.set_input_in(lanes, block, index, &own);
        }
    }

    /// The mechanism with its drives where they stand at a value of the moved one.
    pub(super) fn mechanism_at(&self, value: f64) -> Mechanism {
        let mut mechanism = Mechanism { placing: None, ..Mechanism::clone(&self.mechanism) };
        for index in 0..self.inputs.len() {
            let own = self.value_of(index, value);
            match self.kernel.inputs[index].kind {
                InputKind::Turning { .. } => {
                    if let Role::Driver { angle, .. } = &mut mechanism.bodies[self.kernel.inputs[index].body.0].role {
                        *angle = Some(own);
                    }
                }
                InputKind::Sliding { slider } => {
                    if let Some(drive) = &mut mechanism.sliders[slider].drive {
                        drive.position = Some(own);
                    }
                }
            }
        }
        mechanism
    }

    /// Where a drive stands at a value of the moved one.
    pub(super) fn value_of(&self, input: usize, value: f64) -> f64 {
        let [start, ratio] = self.inputs[input];
        if input == self.drive.input { value } else { (value - self.origin) * ratio + start }
    }

    /// Computes all rates in `block` for a speed of the moved drive of 1° or one unit of length per unit of time.
    #[inline(always)]
    pub(super) fn unit_rates(&self, block: &mut Single) {
        for (index, [_, ratio]) in self.inputs.iter().enumerate() {
            self.kernel.set_rates(block, index, in_radians(self.kernel.inputs[index].kind, *ratio), 0.0);
        }
        self.kernel.rates(block);
    }

    /// A path of the same drives through another position, not followed to either side yet.
    pub(super) fn restarted(&self, node: Node) -> Self {
        let (segments, changes) = (Vec::new(), Vec::new());
        Path { nodes: vec![node], segments, changes, ends: [None, None], ..self.clone() }
    }

    /// Starts the path afresh at the scene's position, which gets another value of the drive.
    pub(super) fn count_from(&mut self, origin: f64) {
        let old = self.origin;
        self.nodes.retain(|node| node.value == old);
        self.nodes[0].value = origin;
        self.origin = origin;
        self.segments.clear();
        self.changes.clear();
        self.ends = [None, None];
    }

    /// Forgets what lies outside a range of the drive's value, as far as whole segments do; it is followed anew when it is
    /// asked for. So a crank may turn for ever.
    pub(super) fn forget_outside(&mut self, [low, high]: [f64; 2]) {
        let below = self.segments.partition_point(|s| s.to < low);
        let above = self.segments.partition_point(|s| s.from <= high);
        if below >= above || (below == 0 && above == self.segments.len()) {
            return;
        }
        self.ends[0].take_if(|_| below > 0);
        self.ends[1].take_if(|_| above < self.segments.len());
        self.segments = self.segments.drain(below..above).collect();
        self.nodes = self.nodes.drain(below..=above).collect();
        let (low, high) = (self.low(), self.high());
        self.changes.retain(|change| (low..=high).contains(&change.at));
    }

    /// The drive's value in the scene.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.origin
    }

    /// The scene's own position; `None` where it is singular.
    pub(super) fn start_pose(&self) -> Option<Pose> {
        Some(self.walker().position(self.origin)?.pose())
    }

    /// The lowest value of the drive that has been reached.
    #[must_use]
    pub fn low(&self) -> f64 {
        self.nodes[0].value
    }

    /// The highest value of the drive that has been reached.
    #[must_use]
    pub fn high(&self) -> f64 {
        self.nodes[self.nodes.len() - 1].value
    }

    /// Number of nodes: positions between which the path is interpolated.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The event that ends the path above, or below; `None` where it can go on.
    #[must_use]
    pub fn end(&self, above: bool) -> Option<&Event> {
        self.ends[usize::from(above)].as_ref()
    }

    /// Whether a place runs off to infinity at an end of the path.
    pub(super) fn runs_off(&self) -> bool {
        self.ends.iter().flatten().any(|end| matches!(end.what, Happening::RunsOff(_)))
    }

    /// Whether the drive's value falls at its speed in the scene.
    pub(super) fn runs_backwards(&self) -> bool {
        self.kernel.inputs[self.drive.input].rate < 0.0
    }

    /// A moving link with a point; none for a fixed point.
    pub(super) fn carrier(&self, point: PointId) -> Option<BodyId> {
        let fixed = self.mechanism.body(GROUND).points.contains(&point);
        let mut links = self.mechanism.links();
        links.find(|(_, body)| !fixed && body.points.contains(&point)).map(|(id, _)| id)
    }

    /// The drive's value at the limit position that ends the path above, or below, if one does.
    pub(super) fn limit(&self, above: bool) -> Option<f64> {
        let end = self.end(above)?;
        matches!(end.what, Happening::Limit(_)).then_some(end.at)
    }

    /// Whether an event leaves a mark on results within `range`: it lies there, or it is a change point so close to it
    /// that results are left out.
    #[must_use]
    pub fn touches(&self, event: &Event, range: [f64; 2]) -> bool {
        let near = if matches!(event.what, Happening::Change(_)) { BLANK * self.unit() } else { 0.0 };
        let [low, high] = [range[0].min(range[1]), range[0].max(range[1])];
        (low - near..=high + near).contains(&event.at)
    }

    /// One position of a block.
    pub(super) fn position<'b, R: Row>(&'b self, block: &'b Block<R>, lane: usize) -> Position<'b, R> {
        Position::new(&self.mechanism, &self.kernel, block, lane)
    }

    /// The forces among these quantities at the first positions of a block, so many.
    pub(super) fn together(&self, block: &Block<Many>, count: usize, asked: &[QuantityRequest]) -> Option<Together> {
        Together::new((&self.mechanism, &self.kernel), (block, count), asked)
    }

    /// The segment that holds a value of the drive, if it has been reached.
    pub(super) fn segment(&self, value: f64) -> Option<usize> {
        if !(self.low()..=self.high()).contains(&value) {
            return None;
        }
        let after = self.segments.partition_point(|s| s.to < value);
        (after < self.segments.len()).then_some(after)
    }
}
