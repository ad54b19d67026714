use super::columns::{Column, Columns};
use super::extreme::{Extreme, extremes};
use super::reading::Reading;
use super::samples::{hull, pieces, samples};
use super::survey::{CurveSurvey, PARTS};
use super::{CycleError, Event, Happening, Path};
use crate::Problem;
use crate::mechanism::BodyId;
use crate::quantity::{QuantityError, QuantityKind, QuantityRequest};

/// Parts into which first samples divide every segment of the path: no feature of the motion is smaller.
const PARTS_OF_SEGMENT: usize = 2;

/// How far above and below the window curves are sampled, in parts of the window's height: a panel has a border.
const BEYOND: f64 = 0.5;

/// Value at a dead centre that counts as zero, in parts of the curve's height.
const ZERO: f64 = 1e-6;

/// Difference of two values of the drive that counts as none, in parts of a turn or of the range.
const SAME: f64 = 1e-9;

/// Quantities over a range of a path, as curves that can be drawn.
#[derive(Clone, Debug)]
pub struct Curves<'a> {
    /// The path.
    pub path: &'a Path<'a>,
    /// Lowest and highest value of the drive that are shown: the part of the range that the path has reached.
    pub range: [f64; 2],
    /// The curves, in the order in which they were asked for.
    pub curves: Vec<Curve>,
    /// The events in the range, in the order of the drive's value.
    pub events: Vec<Event>,
}

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
        let shown = Shown::new(path, range)?;
        let mut curves = Curves { path, range: shown.range, curves: Vec::new(), events: shown.events };
        let wanted = names.filter(|names| !names.is_empty());
        let names = wanted.map_or_else(|| every_omega(path), <[String]>::to_vec);
        curves.add(&names)?;
        let moves = |c: &Curve| c.constant != Some(0.0);
        if wanted.is_none() && curves.curves.iter().any(moves) {
            curves.curves.retain(moves);
        }
        Ok(curves)
    }

    /// Adds the curves of the quantities of these names; equal quantities share a curve.
    fn add(&mut self, names: &[String]) -> Result<(), CycleError> {
        let grid = grid(self.path, self.range);
        let mut surveys: Vec<CurveSurvey> = Vec::new();
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) {
                continue;
            }
            let asked = self.checked(name)?;
            let mut reading = Reading::new(self.path, asked.clone());
            let samples = samples(&mut reading, &grid);
            if samples.iter().all(|s| s.1.is_none()) {
                let why = "it has none at any position of the range";
                return Err(QuantityError::NoValue(name.clone(), why).into());
            }
            let survey = CurveSurvey::new(self.path, self.range, asked, reading, samples);
            match surveys.iter_mut().find(|other| other.equals(&survey)) {
                Some(twin) => twin.asked.extend(survey.asked),
                None => surveys.push(survey),
            }
        }
        // Curves of one kind share an axis, so each is sampled over the windows of all of them.
        let shared = |survey: &CurveSurvey| {
            hull(surveys.iter().filter(|other| other.kind() == survey.kind()).flat_map(|other| other.window))
        };
        let windows: Vec<[f64; 2]> = surveys.iter().map(shared).collect();
        self.curves = surveys.into_iter().zip(windows).map(|(survey, shared)| self.curve(survey, shared)).collect();
        Ok(())
    }

    /// The quantity of that name, if it can have a curve.
    fn checked(&self, name: &str) -> Result<QuantityRequest, CycleError> {
        let path = self.path;
        let asked = QuantityRequest::new(name, &path.mechanism)?;
        if asked.is_on_paper() {
            return Err(QuantityError::OnPaper(name.to_owned()).into());
        }
        let column = Column { asked: asked.clone() };
        // The scene's own position is not singular.
        Columns::of(path, vec![column]).check([path.start()].into_iter())?;
        Ok(asked)
    }

    /// The curve, sampled for a panel whose axis covers the values `shared`.
    fn curve(&self, mut survey: CurveSurvey, shared: [f64; 2]) -> Curve {
        let mut curve = Curve {
            asked: survey.asked,
            pieces: Vec::new(),
            window: survey.window,
            extremes: Vec::new(),
            constant: survey.constant,
            dead: Vec::new(),
        };
        if let Some(value) = curve.constant {
            curve.pieces = vec![self.range.map(|x| [x, value]).to_vec()];
            return curve;
        }
        let reading = &mut survey.reading;
        let beyond = BEYOND * (shared[1] - shared[0]);
        let wide = [shared[0] - beyond, shared[1] + beyond];
        curve.pieces = pieces(reading, &survey.samples, wide);
        for greatest in [false, true] {
            if !survey.grows[usize::from(greatest)] {
                let height = curve.window[1] - curve.window[0];
                let extremes = extremes(reading, &curve.pieces, height, greatest);
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

/// The part of a range that a path has reached.
pub(super) struct Shown {
    /// Its lowest and highest value of the drive, limits included.
    pub range: [f64; 2],
    /// The events in it, in the order of the drive's value.
    pub events: Vec<Event>,
}

impl Shown {
    /// The part of this range that the path has reached.
    pub fn new(path: &Path, range: [f64; 2]) -> Result<Self, CycleError> {
        let mut low = range[0].min(range[1]).max(path.low());
        let mut high = range[0].max(range[1]).min(path.high());
        // There is no curve in a range without width, or of a few roundings' width.
        if high.is_nan() || low.is_nan() || high - low <= SAME * path.unit() {
            let [from, to] = [low, high].map(|v| path.drive.amount(v));
            let hint = "a range with more room between --from and --to";
            let problem = Problem::new(format!("from {from} to {to} there is no room for a curve"));
            return Err(CycleError::Range(problem.hint(hint)));
        }
        // The path stops just before its limits; the range includes them.
        if low == path.low() {
            low = path.limit(false).unwrap_or(low);
        }
        if high == path.high() {
            high = path.limit(true).unwrap_or(high);
        }
        let inside = |e: &Event| (low..=high).contains(&e.at);
        Ok(Shown { range: [low, high], events: path.events().into_iter().filter(inside).collect() })
    }
}

/// Values of the drive at which all curves and ways are sampled first.
pub(super) fn grid(path: &Path, [low, high]: [f64; 2]) -> Vec<f64> {
    let part = |k: usize, parts: usize, [a, b]: [f64; 2]| a + (b - a) * k as f64 / parts as f64;
    let mut grid: Vec<f64> = (0..=PARTS).map(|k| part(k, PARTS, [low, high])).collect();
    for segment in &path.segments {
        let inner = (0..PARTS_OF_SEGMENT).map(|k| part(k, PARTS_OF_SEGMENT, [segment.from, segment.to]));
        grid.extend(inner.filter(|x| (low..high).contains(x)));
    }
    grid.sort_by(f64::total_cmp);
    grid.dedup_by(|b, a| *b - *a <= SAME * (high - low));
    let last = grid.len() - 1;
    grid[last] = high;
    grid
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
