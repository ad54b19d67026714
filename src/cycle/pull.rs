use super::path::BLANK;
use super::{CycleError, Drive, Event, Path, alone};
use crate::construction::Solution;
use crate::geometry::Point;
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::position::Pose;
use crate::quantity::State;
use std::borrow::Cow;

/// Length of a step, in turns of the drive or parts of the mechanism's size.
const STEP: f64 = 1.0 / 72.0;
/// The shortest of them, where a point is nearest twice in short succession.
const LEAST_STEP: f64 = STEP / 64.0;
/// How far the branch is followed ahead, in the same unit.
const AHEAD: f64 = 1.0 / 8.0;
/// Distance that is kept from a limit, in the same unit: there rates are infinite.
const OFF_THE_END: f64 = 1e-4;
/// The farthest that the drive is set at once, in the same unit.
const FARTHEST: f64 = 100.0;
/// How much of the branch to either side is kept, in the same unit.
const KEPT: f64 = 2.0;
/// A distance that leads past a change point from a place next to it, in the same unit.
pub(super) const PAST_CHANGE: f64 = 2.5 * BLANK;
/// Accuracy of the drive's value, in the same unit.
const EXACT: f64 = 1e-14;
/// Distance from a dead centre of a point within which it counts as being there, in the same unit.
const DEAD: f64 = 1e-6;
/// Most steps of Newton's method or of bisection.
const STEPS: usize = 60;

/// A mechanism that is moved by pulling its points, or by setting a drive: for a hand on the picture.
///
/// It goes along the branch of the scene's own position, with one drive; others stand still, or run along with it.
///
/// ```
/// use kinegon::cycle::Pull;
/// use kinegon::geometry::Point;
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let crank = solution.mechanism.point("B").expect("the scene has a point B");
/// let pivot = solution.pose.point(solution.mechanism.point("A").expect("and a point A"));
/// let mut pull = Pull::new(&solution, None)?;
/// let above = Point::new(pivot.x, pivot.y + 1000.0);
/// assert!((pull.to_place(crank, above).value - 90.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Pull {
    path: Path<'static>,
    value: f64,
    /// The sense in which the drive moved last: 1 or −1.
    sense: f64,
}

/// Where a pull has brought the mechanism.
#[derive(Clone, Debug)]
pub struct Pulled {
    /// The drive's value: an angle in degrees, which goes on counting from turn to turn, or a position along a guide.
    pub value: f64,
    /// The mechanism's position.
    pub pose: Pose,
    /// The event that stops the drive, if it was to go further.
    pub limit: Option<Event>,
}

/// Half the squared distance of a point from a place, derived twice by the drive's value; and whether the point stands
/// still there for a moment.
#[derive(Clone, Copy)]
struct Slope {
    first: f64,
    second: f64,
    is_dead: bool,
}

impl Slope {
    /// Whether the slope, if it goes on to bend as here, has an end before the drive has moved so far.
    fn ends_within(&self, change: f64) -> bool {
        let end = -self.first / self.second;
        end * change > 0.0 && end.abs() < change.abs()
    }
}

impl Pull {
    /// The mechanism in the scene's own position, to be moved by the drive of this name; without one by the first.
    ///
    /// # Errors
    /// There is no such drive, the configuration is drawn, or its position is singular.
    pub fn new(solution: &Solution, drive: Option<&str>) -> Result<Self, CycleError> {
        let drive = Drive::new(&solution.mechanism, drive)?;
        Self::of(alone(&solution.mechanism, &drive.name), &solution.pose, drive)
    }

    /// As [`Self::new`], but the other drives run along in proportion to their speeds in the scene, as time moves them.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn together(solution: &Solution, drive: Option<&str>) -> Result<Self, CycleError> {
        let drive = Drive::new(&solution.mechanism, drive)?;
        Self::of(solution.mechanism.clone(), &solution.pose, drive)
    }

    fn of(mechanism: Mechanism, pose: &Pose, drive: Drive) -> Result<Self, CycleError> {
        let path = Path::of(Cow::Owned(mechanism), pose, drive)?;
        Ok(Self { value: path.start(), sense: 1.0, path })
    }

    /// The mechanism in the scene's own position, to be moved by the first drive that moves a point; by the first of all if none does.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_point(solution: &Solution, point: PointId) -> Result<Self, CycleError> {
        for name in solution.mechanism.drive_names() {
            let mut pull = Self::new(solution, Some(&name))?;
            if pull.moves(point) {
                return Ok(pull);
            }
        }
        Self::new(solution, None)
    }

    /// The drive that moves the mechanism.
    #[must_use]
    pub fn drive(&self) -> &Drive {
        &self.path.drive
    }

    /// The drive's value in the scene's own position.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.path.start()
    }

    /// The drive's present value.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The present value of any drive of the mechanism.
    #[must_use]
    pub fn value_of(&self, drive: &Drive) -> f64 {
        self.path.value_of(drive.input, self.value)
    }

    /// The mechanism with its drive where it stands.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism {
        self.path.mechanism_at(self.value)
    }

    /// Whether the drive moves a point.
    pub fn moves(&mut self, point: PointId) -> bool {
        let Some(body) = self.path.carrier(point) else { return false };
        self.follow(self.value + AHEAD * self.path.unit());
        self.follow(self.value - AHEAD * self.path.unit());
        let mut walker = self.path.walker();
        let speed = walker.unit_motion(self.value).map(|block| {
            let position = self.path.position(block, 0);
            position.motion_at(body, position.place(point)).map(|rate| rate.norm())
        });
        let Some([first, second]) = speed else { return true };
        let unit = self.path.unit();
        first * unit + second * unit * unit > 1e-9 * self.path.size
    }

    /// Moves the drive the way on which a point comes nearer to a place, until it comes no nearer: so a crank follows
    /// the pointer round and round. At a dead centre of the point the drive goes on in its sense. Without a drive that
    /// moves the point nothing moves.
    pub fn to_place(&mut self, point: PointId, place: Point) -> Pulled {
        let is_place = place.x.is_finite() && place.y.is_finite();
        match self.path.carrier(point).filter(|_| is_place && self.moves(point)) {
            Some(body) => self.go(|path, value| slope(path, value, body, point, place)),
            None => self.stay(),
        }
    }

    /// Moves the drive to a value, or as far towards it as it goes.
    pub fn to_value(&mut self, value: f64) -> Pulled {
        if !value.is_finite() {
            return self.stay();
        }
        let most = FARTHEST * self.path.unit();
        let wanted = value.clamp(self.value - most, self.value + most);
        let sense = (wanted - self.value).signum();
        self.follow(wanted);
        let (to, limit) = self.held(wanted, sense);
        self.arrive(to, limit)
    }

    /// The events that stop the drive below and above, if it is stopped: within a turn, or ten sizes of the mechanism.
    pub fn ends(&mut self) -> [Option<Event>; 2] {
        let far = self.path.far();
        [false, true].map(|above| {
            self.path.follow_to(self.value + if above { far } else { -far });
            self.path.end(above).cloned()
        })
    }

    /// Goes down a slope to its end.
    fn go(&mut self, slope: impl Fn(&Path<'_>, f64) -> Option<Slope>) -> Pulled {
        let unit = self.path.unit();
        let far = self.path.far();
        self.follow(self.value + STEP * unit);
        self.follow(self.value - STEP * unit);
        let start = slope(&self.path, self.value);
        let Some((mut before, sense)) = start.and_then(|here| Some((here, self.downhill(&here)?))) else {
            return self.stay();
        };
        let (mut from, mut step) = (self.value, STEP * unit);
        while (from - self.value).abs() < far {
            let next = from + sense * step;
            self.follow(next + sense * STEP * unit);
            let (mut to, limit) = self.held(next, sense);
            let mut here = slope(&self.path, to);
            if here.is_none() && limit.is_none() {
                // Next to a change point.
                to += PAST_CHANGE * unit * sense;
                here = slope(&self.path, to);
            }
            match here {
                Some(here) if here.first * sense >= 0.0 => {
                    let lowest = lowest(&self.path, [from, to], slope);
                    return self.arrive(lowest, None);
                }
                // The end of the slope and the beginning of the next one may both be in between.
                Some(here)
                    if step > LEAST_STEP * unit && (before.ends_within(to - from) || here.ends_within(from - to)) =>
                {
                    step *= 0.5;
                }
                Some(here) if limit.is_none() => (from, before, step) = (to, here, STEP * unit),
                Some(_) => return self.arrive(to, limit),
                None => return self.arrive(from, limit),
            }
        }
        self.arrive(from, None)
    }

    /// The sense in which a slope goes down: 1 or −1; none at its end.
    fn downhill(&self, here: &Slope) -> Option<f64> {
        if here.is_dead {
            return (here.second < 0.0).then_some(self.sense);
        }
        (here.first != 0.0).then(|| -here.first.signum())
    }

    /// A value, or the one next to the limit before it with the event there.
    fn held(&self, value: f64, sense: f64) -> (f64, Option<Event>) {
        let above = sense > 0.0;
        let Some(end) = self.path.end(above) else { return (value, None) };
        let off = OFF_THE_END * self.path.unit();
        // A scene may stand nearer to its limit.
        let edge = match above {
            true => (end.at - off).min(self.path.high()).max(self.value),
            false => (end.at + off).max(self.path.low()).min(self.value),
        };
        if (value - edge) * sense > 0.0 { (edge, Some(end.clone())) } else { (value, None) }
    }

    /// Follows the branch until a value and somewhat further, if it has not been followed so far.
    fn follow(&mut self, value: f64) {
        let ahead = AHEAD * self.path.unit();
        if value > self.path.high() {
            self.path.follow_to(value + ahead);
        } else if value < self.path.low() {
            self.path.follow_to(value - ahead);
        }
    }

    fn stay(&mut self) -> Pulled {
        self.arrive(self.value, None)
    }

    /// Takes the mechanism to a value of the drive, past a change point if it is there.
    fn arrive(&mut self, to: f64, limit: Option<Event>) -> Pulled {
        let (from, unit) = (self.value, self.path.unit());
        let sense = if to == from { self.sense } else { (to - from).signum() };
        let beside = sense * PAST_CHANGE * unit;
        self.follow(to + beside);
        self.follow(to - beside);
        let mut walker = self.path.walker();
        let mut pose = |value: f64| Some((value, walker.position(value)?.pose()));
        let found = pose(to).or_else(|| pose(to + beside)).or_else(|| pose(to - beside)).or_else(|| pose(from));
        let (value, pose) = found.unwrap_or_else(|| {
            // A position without neighbours.
            (from, self.path.position(&self.path.nodes[0].block, 0).pose())
        });
        (self.value, self.sense) = (value, sense);
        let kept = KEPT * unit;
        self.path.forget_outside([value - kept, value + kept]);
        Pulled { value, pose, limit }
    }
}

/// The slope at a value of the drive; `None` where that has no position.
fn slope(path: &Path<'_>, value: f64, body: BodyId, point: PointId, place: Point) -> Option<Slope> {
    let mut walker = path.walker();
    let position = path.position(walker.unit_motion(value)?, 0);
    let at = position.place(point);
    let [velocity, acceleration] = position.motion_at(body, at);
    let off = at - place;
    Some(Slope {
        first: off.dot(&velocity),
        second: velocity.norm_squared() + off.dot(&acceleration),
        is_dead: velocity.norm() <= DEAD * path.unit() * acceleration.norm(),
    })
}

/// The end of a slope between two values of the drive, of which it goes down at the first and not at the second: Newton's
/// method, kept in its bracket by bisection.
fn lowest(path: &Path<'_>, [mut down, mut up]: [f64; 2], slope: impl Fn(&Path<'_>, f64) -> Option<Slope>) -> f64 {
    let sense = (up - down).signum();
    let mut at = up;
    for _ in 0..STEPS {
        // Next to a change point there is no slope, but on both sides of it.
        let beside = [0.0, -1.0, 1.0].map(|side| at + side * PAST_CHANGE * path.unit() * sense);
        let mut between = beside.into_iter().filter(|at| (at - down) * sense > 0.0 && (up - at) * sense >= 0.0);
        let Some((found, here)) = between.find_map(|at| Some((at, slope(path, at)?))) else { return down };
        at = found;
        if here.first * sense < 0.0 {
            down = at;
        } else {
            up = at;
        }
        let newton = at - here.first / here.second;
        let is_within = (newton - down) * sense > 0.0 && (up - newton) * sense > 0.0;
        let next = if is_within && here.second > 0.0 { newton } else { 0.5 * (down + up) };
        if (next - at).abs() <= EXACT * path.unit() {
            return next;
        }
        at = next;
    }
    at
}
