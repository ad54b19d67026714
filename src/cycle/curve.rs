use super::reading::{End, Reading, Sample, hull, peak, pieces, samples};
use super::sampled::{PARTS, SAME};
use super::sweep::check_plan_points;
use super::{CycleError, Event, Happening, Path, Sampled};
use crate::kernel::InputKind;
use crate::mechanism::BodyId;
use crate::quantity::{QuantityError, QuantityKind, QuantityRequest};
use std::f64::consts::TAU;

/// A curve whose values spread by less than this part of [`typical_size`] is constant.
const FLAT: f64 = 1e-6;

/// Relative difference of values that count as equal.
const EQUAL_VALUES: f64 = 1e-9;

/// A peak this many times further from the centre than the median value counts as unbounded.
const UNBOUNDED: f64 = 1e3;

/// An unbounded curve is shown up to this many times the median distance from the centre.
const SHOWN: f64 = 4.0;

/// How far above and below the window curves are sampled, in parts of the window's height: a panel has a border.
const BEYOND: f64 = 0.5;

/// Value at a dead centre that counts as zero, in parts of the curve's height.
const ZERO: f64 = 1e-6;

/// Distance from the extreme of all samples within which a sample's neighbourhood is searched, in parts of the curve's
/// height.
const NEARLY: f64 = 0.05;

/// Difference of two extremes that count as equal, in parts of the curve's height.
const EQUAL: f64 = 1e-9;

/// Distance of two extremes that count as one, in parts of the range.
const APART: f64 = 1e-6;

/// Quantities over a range of a path, as curves that can be drawn.
pub type Curves<'a> = Sampled<'a, Curve>;

/// A curve: one quantity, or several that are equal all along.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The quantities, all of one kind.
    pub asked: Vec<QuantityRequest>,
    /// Points (value of the drive, value of the quantity or size of the vector), in pieces without a gap, so dense that
    /// straight lines between them look like the curve. Angles run on without jumps of whole turns.
    pub pieces: Vec<Vec<[f64; 2]>>,
    /// Lowest and highest value to be shown: all values, or, where the curve grows without bound, as far as the rest of
    /// it stays readable.
    pub window: [f64; 2],
    /// Greatest and least values over the range, in the order of the drive's value; none on a side where the curve
    /// grows without bound, and none for a constant curve.
    pub extremes: Vec<Extreme>,
    /// The value of a constant curve.
    pub constant: Option<f64>,
    /// For ω of a link and v_r of a slider: values of the drive where it is zero, at dead centres and at the ends of
    /// the range.
    pub dead: Vec<f64>,
}

/// A greatest or least value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The drive's value.
    pub at: f64,
    /// The quantity's value; exact to rounding where the curve is smooth.
    pub value: f64,
    /// Whether it is a greatest value; else a least one.
    pub greatest: bool,
}

impl Curve {
    /// The kind of its quantities.
    #[must_use]
    pub fn kind(&self) -> QuantityKind {
        self.asked[0].kind()
    }
}

impl<'a> Curves<'a> {
    /// The curves of quantities by their names, over the part of `range` that `path` has reached; without names, ω of
    /// all driven links that turn.
    ///
    /// # Errors
    /// A name is no quantity of this mechanism, or the quantity has no value in the range; or nothing of the range has
    /// been reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], names: Option<&[String]>) -> Result<Self, CycleError> {
        let mut curves = Curves::reached(path, range)?;
        let wanted = names.filter(|names| !names.is_empty());
        let names = wanted.map_or_else(|| every_omega(path), <[String]>::to_vec);
        curves.curves = curves.of(&names)?;
        let moves = |c: &Curve| c.constant != Some(0.0);
        if wanted.is_none() && curves.curves.iter().any(moves) {
            curves.curves.retain(moves);
        }
        Ok(curves)
    }

    /// The curves of the quantities of these names; equal quantities share a curve.
    fn of(&self, names: &[String]) -> Result<Vec<Curve>, CycleError> {
        let grid = self.grid();
        let mut surveys: Vec<Survey> = Vec::new();
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) {
                continue;
            }
            let survey = self.survey(name, &grid)?;
            match surveys.iter_mut().find(|other| other.equals(&survey)) {
                Some(twin) => twin.curve.asked.extend(survey.curve.asked),
                None => surveys.push(survey),
            }
        }
        // Curves of one kind share an axis, so each is sampled over the windows of all of them.
        let shared = |survey: &Survey| {
            let alike = surveys.iter().filter(|other| other.curve.kind() == survey.curve.kind());
            hull(alike.flat_map(|other| other.curve.window))
        };
        let windows: Vec<[f64; 2]> = surveys.iter().map(shared).collect();
        Ok(surveys.into_iter().zip(windows).map(|(survey, shared)| self.finished(survey, shared)).collect())
    }

    /// The survey of the quantity of that name, sampled at these values of the drive.
    fn survey(&self, name: &str, grid: &[f64]) -> Result<Survey<'a>, CycleError> {
        let path = self.path;
        let asked = QuantityRequest::new(name, &path.mechanism)?;
        let asked = asked.for_many(&path.mechanism, || path.start_pose())?;
        if asked.written.on_paper {
            return Err(QuantityError::OnPaper(name.to_owned()).into());
        }
        asked.check_size()?;
        // The scene's own position is not singular.
        check_plan_points(path, std::slice::from_ref(&asked), [path.start()].into_iter())?;
        let mut reading = Reading::new(path, asked.clone());
        let samples = samples(&mut reading, grid);
        if samples.iter().all(|s| s.1.is_none()) {
            let why = crate::quantity::says::nowhere_in_range();
            return Err(QuantityError::NoValue(name.to_owned(), why).into());
        }
        let zero = FLAT * typical_size(path, asked.kind());
        let curve = Curve {
            asked: vec![asked],
            pieces: Vec::new(),
            window: [0.0; 2],
            extremes: Vec::new(),
            constant: None,
            dead: Vec::new(),
        };
        let mut survey = Survey { curve, reading, samples, grows: [false; 2], zero };
        let [least, most] = hull(survey.samples.iter().filter_map(|s| s.1));
        if most - least <= zero.max(EQUAL_VALUES * most.abs().max(least.abs())) {
            let middle = 0.5 * (least + most);
            let value = if middle.abs() <= zero { 0.0 } else { middle };
            survey.curve.constant = Some(value);
            survey.curve.window = [value; 2];
            return Ok(survey);
        }
        for (side, own) in self.range.into_iter().enumerate() {
            let end = path.end(side == 1).filter(|end| end.at == own);
            if let (Some(_), End::Grows(up)) = (end, survey.reading.ends[side]) {
                survey.grows[usize::from(up)] = true;
            }
        }
        survey.frame(self.range);
        Ok(survey)
    }

    /// The curve of a survey, sampled for a panel whose axis covers the values `shared`.
    fn finished(&self, survey: Survey, shared: [f64; 2]) -> Curve {
        let Survey { mut curve, mut reading, samples, grows, .. } = survey;
        if let Some(value) = curve.constant {
            curve.pieces = vec![self.range.map(|x| [x, value]).to_vec()];
            return curve;
        }
        let beyond = BEYOND * (shared[1] - shared[0]);
        let wide = [shared[0] - beyond, shared[1] + beyond];
        curve.pieces = pieces(&mut reading, &samples, wide);
        for greatest in [false, true] {
            if !grows[usize::from(greatest)] {
                let height = curve.window[1] - curve.window[0];
                let extremes = extremes(&mut reading, &curve.pieces, height, greatest);
                if let Some(extreme) = extremes.first() {
                    curve.window[usize::from(greatest)] = extreme.value;
                }
                curve.extremes.extend(extremes);
            }
        }
        curve.extremes.sort_by(|a, b| a.at.total_cmp(&b.at));
        if curve.asked[0].has_dead_centres() {
            let height = curve.window[1] - curve.window[0];
            let turns = |e: &&Event| {
                let what = &e.what;
                matches!(what, Happening::TurnsBack { .. } | Happening::SlidesBack { .. })
            };
            let dead = self.events.iter().filter(turns).map(|e| e.at);
            // At an end of the range no link can be seen to turn back, so the value alone decides.
            let rests = |at: &f64| reading.at(*at, None).is_some_and(|v| v.abs() <= ZERO * height);
            curve.dead = dead.chain(self.range).filter(rests).collect();
            curve.dead.sort_by(f64::total_cmp);
            let least = SAME * self.path.unit();
            curve.dead.dedup_by(|b, a| *b - *a <= least);
        }
        curve
    }
}

/// A curve after a first coarse sampling, which tells whether it is constant, where it is unbounded, and which values to
/// show.
struct Survey<'a> {
    curve: Curve,
    reading: Reading<'a>,
    samples: Vec<Sample>,
    /// Whether it grows without bound, downwards and upwards.
    grows: [bool; 2],
    /// Absolute tolerance for zero.
    zero: f64,
}

impl Survey<'_> {
    /// Whether two quantities are of one kind and equal at all samples.
    fn equals(&self, other: &Survey) -> bool {
        let equal = |(a, b): (&Sample, &Sample)| match (a.1, b.1) {
            (Some(a), Some(b)) => (a - b).abs() <= self.zero.max(EQUAL_VALUES * a.abs()),
            (a, b) => a.is_none() && b.is_none(),
        };
        let mut pairs = self.samples.iter().zip(&other.samples);
        self.curve.kind() == other.curve.kind() && pairs.all(equal)
    }

    /// Finds the window, and where the curve grows without bound within the range.
    fn frame(&mut self, [low, high]: [f64; 2]) {
        let (kind, samples, reading) = (self.curve.kind(), &self.samples, &mut self.reading);
        let even = even(samples);
        // The window of a rate includes zero, that of an angle or a place need not.
        let centre = if kind.is_rate() { 0.0 } else { median(even.iter().copied()) };
        let typical = median(even.iter().map(|y| (y - centre).abs())).max(self.zero);
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let peaks: Vec<[f64; 2]> = (0..samples.len()).filter_map(|i| peak(reading, samples, i, sign)).collect();
            // An angle is always bounded.
            let unbounded = |p: &[f64; 2]| kind != QuantityKind::Angle && (p[1] - centre) * sign > UNBOUNDED * typical;
            self.grows[side] |= peaks.iter().any(unbounded);
            let grows = self.grows[side];
            let inner = |p: &&[f64; 2]| !grows || !unbounded(p) && p[0] > low && p[0] < high;
            let found = peaks.iter().filter(inner).map(|p| p[1]);
            let bound = hull(samples.iter().filter_map(|s| s.1))[side];
            // An unbounded curve is shown up to a typical distance or to its own last sample, whichever is nearer.
            let shown = centre + sign * SHOWN * typical;
            let least = if grows && sign * shown < sign * bound { shown } else { bound };
            self.curve.window[side] = found.fold(least, |a, b| if sign * b > sign * a { b } else { a });
        }
    }
}

/// The places where a curve of that height is greatest, or least; several where the values there are equal.
fn extremes(reading: &mut Reading, pieces: &[Vec<[f64; 2]>], height: f64, greatest: bool) -> Vec<Extreme> {
    let sign = if greatest { 1.0 } else { -1.0 };
    let all = || pieces.iter().flatten();
    let best = hull(all().map(|p| p[1]))[usize::from(greatest)];
    let mut found: Vec<[f64; 2]> = Vec::new();
    for piece in pieces {
        let samples: Vec<Sample> = piece.iter().map(|p| (p[0], Some(p[1]))).collect();
        for (index, [_, value]) in piece.iter().enumerate() {
            if sign * (best - value) <= NEARLY * height {
                found.extend(peak(reading, &samples, index, sign));
            }
        }
    }
    let best = found.iter().map(|p| sign * p[1]).fold(f64::NEG_INFINITY, f64::max);
    found.retain(|p| best - sign * p[1] <= EQUAL * height);
    let [low, high] = hull(all().map(|p| p[0]));
    found.dedup_by(|b, a| b[0] - a[0] <= APART * (high - low));
    let extreme = |p: &[f64; 2]| Extreme {
        at: p[0],
        // A zero with rounding errors is written as zero.
        value: if p[1].abs() <= EQUAL * height { 0.0 } else { p[1] },
        greatest,
    };
    found.iter().map(extreme).collect()
}

/// Names of the angular velocities of all driven links, or of the driving ones where there are no others.
fn every_omega(path: &Path) -> Vec<String> {
    let is_input = |id: BodyId| path.kernel.inputs.iter().any(|input| input.body == id);
    let names = |inputs: bool| -> Vec<String> {
        let links = path.mechanism.links().filter(|(id, _)| is_input(*id) == inputs);
        links.map(|(_, body)| format!("omega({})", body.name)).collect()
    };
    let driven = names(false);
    if driven.is_empty() { names(true) } else { driven }
}

/// The order of magnitude of a quantity of that kind in a mechanism of this size with these drives.
fn typical_size(path: &Path, kind: QuantityKind) -> f64 {
    let size = path.size;
    let inputs = path.kernel.inputs.iter().map(|input| match input.kind {
        InputKind::Turning { .. } => [input.rate.abs(), input.second.abs()],
        InputKind::Sliding { .. } => [input.rate.abs() / size, input.second.abs() / size],
    });
    let [first, second] = inputs.fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    let second = second.max(first * first);
    match kind {
        QuantityKind::Angle => 360.0,
        QuantityKind::AngularVelocity => first,
        QuantityKind::AngularAcceleration => second,
        QuantityKind::RotationalSpeed => first * path.mechanism.time.in_a_minute() / TAU,
        QuantityKind::SpeedRatio => 1.0,
        QuantityKind::Position | QuantityKind::Length => size,
        QuantityKind::Velocity => first * size,
        QuantityKind::Acceleration => second * size,
        // How large forces are, only their curves tell.
        QuantityKind::Force | QuantityKind::Moment | QuantityKind::Power => 0.0,
    }
}

/// The median of some numbers, of an even count the upper of the two in the middle; zero of none.
fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// Values at equal steps of the drive, each taken from the next sample.
fn even(samples: &[Sample]) -> Vec<f64> {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return Vec::new();
    };
    let step = (last.0 - first.0) / PARTS as f64;
    let at = |k: usize| {
        let x = first.0 + step * k as f64;
        let next = samples.partition_point(|s| s.0 < x);
        samples.get(next.min(samples.len() - 1))?.1
    };
    (0..=PARTS).filter_map(at).collect()
}
