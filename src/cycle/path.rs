use super::event::dead_positions;
use super::segment::{Node, Segment};
use super::start::{stands, start};
use super::trace::{Traced, trace};
use super::{CycleError, Event, Happening, Position, Walker};
use crate::geometry::{Number, span};
use crate::kernel::{Block, InputKind, Kernel, vector};
use crate::mechanism::{Mechanism, Role, SliderId};
use crate::position::Pose;

/// The widest range that is followed, in turns to each side.
const MOST_TURNS: f64 = 100.0;

/// How far the branch is followed the other way first, in turns: enough for the longest leap.
const RUN_UP: f64 = 0.01;

/// A drive that is moved through a range; its value is in degrees, or in lengths along the guide.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Its name: that of the driven link, or of the slider on a moving link, as in `3/2`.
    pub name: String,
    pub(super) input: usize,
    pub(super) turns: bool,
}

impl Drive {
    /// The drive of that name, one of [`Mechanism::drive_names`]; without a name the first of them.
    ///
    /// # Errors
    /// There is no such drive, or no drive at all.
    pub fn new(mechanism: &Mechanism, name: Option<&str>) -> Result<Self, CycleError> {
        let kernel = Kernel::new(mechanism).ok_or(CycleError::Drawn)?;
        let names = mechanism.drive_names();
        let input = match name {
            None if names.is_empty() => return Err(CycleError::NoDrive),
            None => 0,
            Some(name) => names.iter().position(|n| n == name).ok_or_else(|| {
                let known = names.join(", ");
                CycleError::NoSuchDrive {
                    name: name.to_owned(),
                    known,
                }
            })?,
        };
        Ok(Drive {
            name: names[input].clone(),
            input,
            turns: matches!(kernel.inputs[input].kind, InputKind::Turning { .. }),
        })
    }

    /// Its value in words, as in `angle(1) = 30°`.
    #[must_use]
    pub fn at(&self, value: f64) -> String {
        format!("{} = {}", self.quantity(), self.amount(value))
    }

    /// A value with its unit, as in `30°`.
    #[must_use]
    pub fn amount(&self, value: f64) -> String {
        // Places are known to about 1e-12 of a turn.
        let rounded = (value * 1e10).round() / 1e10 + 0.0;
        let shown = if rounded.is_finite() { rounded } else { value };
        format!("{shown}{}", if self.turns { "°" } else { "" })
    }

    /// The name of its value as a quantity, as in `angle(1)` or `position(4)`.
    #[must_use]
    pub fn quantity(&self) -> String {
        let head = if self.turns { "angle" } else { "position" };
        format!("{head}({})", self.name)
    }

    /// Whether its value is an angle in degrees; else it is a length.
    #[must_use]
    pub fn is_angle(&self) -> bool {
        self.turns
    }
}

/// `mechanism` with every drive but the one of this name standing still where it is.
#[must_use]
pub fn alone(mechanism: &Mechanism, drive: &str) -> Mechanism {
    let mut alone = mechanism.clone();
    for body in alone.bodies.iter_mut().filter(|b| b.name != drive) {
        if let Role::Driver { omega, alpha, .. } = &mut body.role {
            (*omega, *alpha) = (0.0, 0.0);
        }
    }
    for (id, slider) in alone.sliders.iter_mut().enumerate() {
        if let Some(push) = &mut slider.drive
            && mechanism.push_name(SliderId(id)) != drive
        {
            (push.speed, push.acceleration) = (0.0, 0.0);
        }
    }
    alone
}

/// The motion of a mechanism along one branch while a drive moves, as far as it has been followed.
///
/// Other drives run along, each in proportion to its speed in the scene; [`alone`] makes them stand.
#[derive(Clone, Debug)]
pub struct Path<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// The drive that moves it.
    pub drive: Drive,
    pub(super) kernel: Kernel,
    /// By input: its value at the first node found, and its units for each unit of the moved drive.
    pub(super) inputs: Vec<[f64; 2]>,
    origin: f64,
    size: f64,
    /// In the order of the drive's value.
    pub(super) nodes: Vec<Node>,
    pub(super) segments: Vec<Segment>,
    /// Change positions on the way.
    pub(super) changes: Vec<Event>,
    /// What ends the path below and above, where something does.
    ends: [Option<Event>; 2],
}

impl<'a> Path<'a> {
    /// The path through `pose`, not followed anywhere yet.
    ///
    /// # Errors
    /// The configuration is drawn, or singular where it stands.
    pub fn new(mechanism: &'a Mechanism, pose: &Pose, drive: Drive) -> Result<Self, CycleError> {
        let kernel = Kernel::new(mechanism).ok_or(CycleError::Drawn)?;
        let own = |input: usize| {
            let input = &kernel.inputs[input];
            match input.kind {
                InputKind::Turning { .. } => input.rate.to_degrees(),
                InputKind::Sliding { .. } => input.rate,
            }
        };
        let moved = own(drive.input);
        let ratio = |input: usize| {
            if input == drive.input {
                1.0
            } else if moved == 0.0 {
                0.0
            } else {
                own(input) / moved
            }
        };
        let inputs: Vec<[f64; 2]> = (0..kernel.inputs.len())
            .map(|i| [stands(&kernel.inputs[i], pose), ratio(i)])
            .collect();
        let origin = inputs[drive.input][0];
        let mut block = start(&kernel, mechanism, pose);
        let closed = kernel.assemble(&mut block, 0.0).closed;
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
            kernel,
        };
        let determinants = path.kernel.determinants(&block);
        let dull = |group: &usize| determinants[*group][1] < 1e-18;
        if let Some(group) = (0..mechanism.groups.len()).find(|g| !closed || dull(g)) {
            return Err(CycleError::Singular {
                links: mechanism.groups[group].link_names(mechanism),
                at: path.drive.at(origin),
            });
        }
        path.unit_rates(&mut block);
        let nodes = vec![Node::new(&path, origin, block)];
        Ok(Path { nodes, ..path })
    }

    /// What counts as one turn of the drive: a full one of a crank; for a slider, the mechanism's size.
    pub(super) fn unit(&self) -> f64 {
        if self.drive.turns { 360.0 } else { self.size }
    }

    /// The mechanism's size where the path begins.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    /// Sets all drives for these values of the moved one.
    #[inline(always)]
    pub(super) fn set_inputs<T: Number, const M: usize>(
        &self,
        block: &mut Block<T, M>,
        values: &[T; M],
    ) {
        for (index, [start, ratio]) in self.inputs.iter().enumerate() {
            let own = if index == self.drive.input {
                *values
            } else {
                values.map(|value| (value - T::splat(self.origin)) * *ratio + T::splat(*start))
            };
            self.kernel.set_input(block, index, &own);
        }
    }

    /// All rates for the moved drive running by one degree, or one unit of length, a unit of time.
    #[inline(always)]
    pub(super) fn unit_rates<T: Number, const M: usize>(&self, block: &mut Block<T, M>) {
        for (index, [_, ratio]) in self.inputs.iter().enumerate() {
            let rate = match self.kernel.inputs[index].kind {
                InputKind::Turning { .. } => ratio.to_radians(),
                InputKind::Sliding { .. } => *ratio,
            };
            self.kernel.set_rates(block, index, rate, 0.0);
        }
        self.kernel.rates(block);
    }

    /// All rates for the drives running as the scene says.
    #[inline(always)]
    pub(super) fn scene_rates<T: Number, const M: usize>(&self, block: &mut Block<T, M>) {
        for (index, input) in self.kernel.inputs.iter().enumerate() {
            self.kernel
                .set_rates(block, index, input.rate, input.second);
        }
        self.kernel.rates(block);
    }

    /// Follows the branch over the range from one value of the drive to another, as far as it can be reached; with
    /// neither end given, once around or from limit to limit. Returns the range that is meant.
    ///
    /// # Errors
    /// No part of the range can be reached, or it is wider than a hundred turns.
    pub fn cover(&mut self, from: Option<f64>, to: Option<f64>) -> Result<[f64; 2], CycleError> {
        let turn = self.unit();
        let range = match (from, to) {
            (Some(from), Some(to)) => [from, to],
            (Some(from), None) if self.drive.turns => [from, from + turn],
            (None, Some(to)) => [self.origin, to],
            (None, None) if self.drive.turns => {
                self.follow_to(self.origin + turn);
                if self.end(true).is_none() {
                    [self.origin, self.origin + turn]
                } else {
                    self.follow_to(self.origin - turn);
                    [self.low(), self.high()]
                }
            }
            _ => {
                let hint = "its ends with --from and --to; a slider has no full turn";
                let text = format!(
                    "the range of {} is not given\n  try: {hint}",
                    self.drive.quantity()
                );
                return Err(CycleError::Range(text));
            }
        };
        let far = |value: f64| (value - self.origin).abs() > MOST_TURNS * turn;
        if range.iter().any(|v| !v.is_finite() || far(*v)) {
            let [low, high] = [
                self.origin - MOST_TURNS * turn,
                self.origin + MOST_TURNS * turn,
            ];
            let [low, high] = [low, high].map(|v| self.drive.amount(v));
            let hint = format!("values between {low} and {high}");
            let text = format!("the range reaches further than a hundred turns\n  try: {hint}");
            return Err(CycleError::Range(text));
        }
        range.iter().for_each(|v| self.follow_to(*v));
        let (low, high) = (range[0].min(range[1]), range[0].max(range[1]));
        if low > self.high() || high < self.low() {
            let above = low > self.high();
            let end = self.end(above).map(|e| e.text(&self.drive.at(e.at)));
            let [from, to] = range.map(|v| self.drive.amount(v));
            let [low, high] = [self.low(), self.high()].map(|v| self.drive.amount(v));
            let stop = end.unwrap_or_default();
            return Err(CycleError::OutOfReach {
                from,
                to,
                stop,
                low,
                high,
            });
        }
        Ok(range)
    }

    /// Follows the branch until the drive's value is reached or something ends it, which [`Self::end`] then tells.
    pub fn follow_to(&mut self, value: f64) {
        if self.nodes.len() == 1 && value.is_finite() {
            // A change position right ahead is leapt over with a run-up; one right behind is left for later, when there are nodes before it.
            let bare = self.clone();
            self.extend(self.origin + RUN_UP.copysign(self.origin - value) * self.unit());
            let singular = |end: &Event| matches!(end.what, Happening::Singular { .. });
            if !self.changes.is_empty() || self.ends.iter().flatten().any(singular) {
                *self = bare;
            }
        }
        self.extend(value);
    }

    /// Follows the branch beyond the nodes that there are.
    fn extend(&mut self, value: f64) {
        let up = value > self.high();
        if !up && value >= self.low() || self.ends[usize::from(up)].is_some() {
            return;
        }
        let mut nodes = std::mem::take(&mut self.nodes);
        if !up {
            nodes.reverse();
        }
        let Traced {
            nodes,
            changes,
            end,
        } = trace(self, nodes, value);
        self.nodes = nodes;
        if !up {
            self.nodes.reverse();
        }
        self.changes.extend(changes);
        self.ends[usize::from(up)] = end;
        let segments = self.nodes.windows(2).map(|w| {
            let mut segment = Segment::new(&self.kernel, &w[0], &w[1]);
            let mut changes = self.changes.iter();
            if changes.any(|c| segment.holds(&[c.at])) {
                segment.sure = 0.0;
            }
            segment
        });
        self.segments = segments.collect();
    }

    /// The drive's value in the scene.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.origin
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

    /// How many positions the path is built on.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// All that happens between the path's ends and at them, in the order of the drive's value.
    #[must_use]
    pub fn events(&self) -> Vec<Event> {
        let mut events = dead_positions(self);
        events.extend(
            self.changes
                .iter()
                .chain(self.ends.iter().flatten())
                .cloned(),
        );
        events.sort_by(|a, b| a.at.total_cmp(&b.at));
        events
    }

    /// What ends the path above, or below.
    #[must_use]
    pub fn end(&self, above: bool) -> Option<&Event> {
        self.ends[usize::from(above)].as_ref()
    }

    /// The drive's value at the limit position that ends the path above, or below, if one does.
    pub(super) fn limit(&self, above: bool) -> Option<f64> {
        let end = self.end(above)?;
        matches!(end.what, Happening::Limit { .. }).then_some(end.at)
    }

    /// A walker, one position at a time.
    #[must_use]
    pub fn walker(&self) -> Walker<'_> {
        Walker::new(self)
    }

    /// A walker for many positions at a time.
    #[must_use]
    pub fn walker_of<T: Number, const M: usize>(&self) -> Walker<'_, T, M> {
        Walker::new(self)
    }

    /// One position of a block.
    pub(super) fn position<'b, T: Number, const M: usize>(
        &'b self,
        block: &'b Block<T, M>,
        lane: usize,
    ) -> Position<'b, T, M> {
        Position {
            mechanism: self.mechanism,
            kernel: &self.kernel,
            block,
            lane,
        }
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
