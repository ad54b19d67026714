use super::columns::{Column, Columns};
use super::extreme::{Extreme, extremes};
use super::reading::Reading;
use super::samples::{hull, pieces, samples};
use super::survey::{CurveSurvey, PARTS};
use super::{CycleError, Event, Happening, Path};
use crate::mechanism::BodyId;
use crate::quantity::{Asked, Kind, QuantityError};

/// Parts of every segment of the path at which it is looked at too: no feature of the motion is smaller.
const PARTS_OF_SEGMENT: usize = 2;

/// How far beyond what is worth showing curves are sampled, in parts of its height: a panel has a border.
const BEYOND: f64 = 0.5;

/// The part of a curve's height below which it is zero at a dead centre.
const ZERO: f64 = 1e-6;

/// What differs by less than this part of itself is the same.
const SAME: f64 = 1e-9;

/// Quantities over a range of a path, as curves that can be drawn.
#[derive(Clone, Debug)]
pub struct Curves<'a> {
    /// The path.
    pub path: &'a Path<'a>,
    /// Lowest and highest value of the drive that are shown: the part of the range that the path has reached.
    pub range: [f64; 2],
    /// In the order in which they were asked for.
    pub curves: Vec<Curve>,
    /// What happens in the range, in the order of the drive's value.
    pub events: Vec<Event>,
}

/// A curve: one quantity, or several that are equal all along.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The quantities, all of one kind.
    pub asked: Vec<Asked>,
    /// Values of the drive and of the quantity (of a vector its size), in pieces without a gap: straight lines between them look like
    /// the curve. Angles go on without jumps of whole turns.
    pub pieces: Vec<Vec<[f64; 2]>>,
    /// Lowest and highest value that are worth showing: all values, or where the curve grows without bound so much of it that the
    /// rest stays readable.
    pub window: [f64; 2],
    /// Its greatest and its least values over the range, in the order of the drive's value; none where it grows without bound, and
    /// none for a curve that is constant.
    pub extremes: Vec<Extreme>,
    /// Its value where that is everywhere the same.
    pub constant: Option<f64>,
    /// For ω of a link and v_r of a slider: where it is zero, at dead centres and at the ends of the range.
    pub dead: Vec<f64>,
}

impl Curve {
    /// The kind of its quantities.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.asked[0].kind()
    }
}

impl<'a> Curves<'a> {
    /// The curves of quantities by their names, over the part of a range that `path` has reached; without names ω of all links that follow the drives and turn.
    ///
    /// # Errors
    /// A name is no quantity of this mechanism, or one without a value in the range; or nothing of the range has been reached.
    pub fn new(path: &'a Path<'a>, range: [f64; 2], names: Option<&[String]>) -> Result<Self, CycleError> {
        let mut low = range[0].min(range[1]).max(path.low());
        let mut high = range[0].max(range[1]).min(path.high());
        // A range without width shows nothing; one of a few roundings has no curve in it.
        if high.is_nan() || low.is_nan() || high - low <= SAME * path.unit() {
            let [from, to] = [low, high].map(|v| path.drive.amount(v));
            let hint = "a range with more room between --from and --to";
            return Err(CycleError::Range(format!("from {from} to {to} there is no room for a curve\n  try: {hint}")));
        }
        // The path stops just before its limits.
        for (side, above) in [(&mut low, false), (&mut high, true)] {
            let end = if above { path.high() } else { path.low() };
            let limit = path.limit(above).filter(|_| *side == end);
            *side = limit.unwrap_or(*side);
        }
        let mut curves = Curves { path, range: [low, high], curves: Vec::new(), events: Vec::new() };
        let inside = |e: &Event| (low..=high).contains(&e.at);
        curves.events = path.events().into_iter().filter(inside).collect();
        let wanted = names.filter(|names| !names.is_empty());
        let names = wanted.map_or_else(|| every_omega(path), <[String]>::to_vec);
        curves.add(&names)?;
        let moves = |c: &Curve| c.constant != Some(0.0);
        if wanted.is_none() && curves.curves.iter().any(moves) {
            curves.curves.retain(moves);
        }
        Ok(curves)
    }

    /// Adds the curves of quantities.
    fn add(&mut self, names: &[String]) -> Result<(), CycleError> {
        let grid = self.grid();
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
        // Curves of one kind share an axis, so each is sampled as far as all of them reach.
        let shared = |own: &CurveSurvey| {
            let alike = surveys.iter().filter(|other| other.kind() == own.kind());
            hull(alike.flat_map(|other| other.window))
        };
        let shared: Vec<[f64; 2]> = surveys.iter().map(shared).collect();
        self.curves = surveys.into_iter().zip(shared).map(|(survey, shared)| self.curve(survey, shared)).collect();
        Ok(())
    }

    /// The quantity of that name, which must have a curve.
    fn checked(&self, name: &str) -> Result<Asked, CycleError> {
        let path = self.path;
        let asked = Asked::new(name, path.mechanism)?;
        if asked.is_on_paper() {
            let why = "a length on paper belongs to the figure of one position\n  try: the name without `/mu`";
            return Err(QuantityError::NoValue(name.to_owned(), why).into());
        }
        let column = Column { asked: asked.clone() };
        // The scene's own position is surely not singular.
        Columns::of(path, vec![column]).check([path.start()].into_iter())?;
        Ok(asked)
    }

    /// Where curves are looked at first.
    fn grid(&self) -> Vec<f64> {
        let [low, high] = self.range;
        let part = |k: usize, parts: usize, [a, b]: [f64; 2]| a + (b - a) * k as f64 / parts as f64;
        let mut grid: Vec<f64> = (0..=PARTS).map(|k| part(k, PARTS, [low, high])).collect();
        let segments = self.path.segments.iter();
        let inner =
            segments.flat_map(|s| (0..PARTS_OF_SEGMENT).map(move |k| part(k, PARTS_OF_SEGMENT, [s.from, s.to])));
        grid.extend(inner.filter(|x| (low..high).contains(x)));
        grid.sort_by(f64::total_cmp);
        grid.dedup_by(|b, a| *b - *a <= SAME * (high - low));
        let last = grid.len() - 1;
        grid[last] = high;
        grid
    }

    /// The curve, sampled for a panel that shows `shared`.
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
            // Nothing can be seen to turn back at an end of the range.
            let rests = |at: &f64| {
                let value = reading.at(*at, None);
                value.is_some_and(|v| v.abs() <= ZERO * height)
            };
            curve.dead = dead.chain(self.range).filter(rests).collect();
            curve.dead.sort_by(f64::total_cmp);
            let least = SAME * self.path.unit();
            curve.dead.dedup_by(|b, a| *b - *a <= least);
        }
        curve
    }
}

/// Names of the angular velocities of all links that follow, or of the drives where nothing follows.
fn every_omega(path: &Path) -> Vec<String> {
    let driven = |id: BodyId| path.kernel.inputs.iter().any(|input| input.body == id);
    let links = |drives: bool| {
        let links = path.mechanism.links().filter(|(id, _)| driven(*id) == drives);
        links.map(|(_, body)| format!("omega({})", body.name)).collect::<Vec<_>>()
    };
    let following = links(false);
    if following.is_empty() { links(true) } else { following }
}
