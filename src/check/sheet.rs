use super::error::CheckError;
use crate::scene::Figure;
use crate::sheet::{Scales, Sheet};
use crate::text::Untrusted;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// The values that somebody has read from a drawing, as they were written down.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// The student's name.
    pub name: Option<Untrusted>,
    /// The name of the exercise that the form belongs to, as `four-bar-7-2`: that of its folder.
    pub exercise: Option<Untrusted>,
    /// The scales of the student's sheets.
    pub mu: Scales,
    /// Which sense of rotation counts as positive; a slide is positive along its guide. If `None`, a rate without a sign
    /// is a size without a sense.
    pub positive: Option<Positive>,
    /// Whether all lengths and segments are in millimetres of paper.
    pub in_mm: bool,
    /// The values, in the order of the file.
    pub values: Vec<Given>,
    /// Places of plan points on paper.
    pub points: Vec<PointsOf>,
    /// Lines of the file that are not understood; a check tells them together with its own.
    pub faults: Vec<CheckError>,
}

impl Measured {
    /// Whether a name has the image of the ground under a slider: then the pole in other names is itself.
    pub(super) fn names_ground(&self) -> bool {
        self.values.iter().any(|given| given.name.contains(UNDER_SLIDER))
    }

    /// What is not understood of the form as a whole: lines of the file, and scales that are none.
    ///
    /// # Errors
    /// There are too many values.
    pub(super) fn all_faults(&self) -> Result<Vec<CheckError>, CheckError> {
        let places = self.points.iter().map(|plan| plan.places.len()).sum::<usize>();
        let count = self.values.len() + self.faults.len() + places;
        if count > MOST_VALUES {
            let hint = "is this a form? `kinegon check` without a form prints an empty one";
            return Err(CheckError::new(
                format!("a form has at most {MOST_VALUES} values, and here are {count}"),
                hint,
            ));
        }
        let bad = self.mu.given().filter(|(_, mu)| !(mu.is_finite() && *mu > 0.0));
        let bad = bad.map(|(sheet, _)| {
            CheckError::new(
                format!("{} is no scale", sheet.scale_key()),
                "a scale is a positive number: units of the scene per millimetre of paper",
            )
        });
        Ok(self.faults.iter().cloned().chain(bad).collect())
    }

    /// Asks for a figure at the scales of the student's own sheet, as far as the form has them.
    pub fn put_scales_into(&self, figure: &mut Figure) {
        figure.mu = self.mu.or(figure.mu);
    }
}

/// Most values of a form: more than the largest construction by hand has.
const MOST_VALUES: usize = 5_000;

/// In the names of images of the ground under a slider, as `c_ground`.
pub(super) const UNDER_SLIDER: &str = "_ground";

/// Behind the name of a length that is written in millimetres of paper.
const ON_PAPER: &str = "/mu";

/// A value as it was written down.
#[derive(Clone, Debug)]
pub struct Given {
    /// The quantity's name as it was written.
    pub name: String,
    /// Its digits as they were written, with a decimal point.
    pub text: String,
    /// Its unit where one is written.
    pub unit: Option<String>,
    /// Its place in the file, for messages: `values.omega(2)`, `line 7`.
    pub place: String,
}

impl Given {
    /// Its name without blanks and without the mark for millimetres of paper, and whether it had that.
    pub(super) fn plain_name(&self) -> (String, bool) {
        let mut name: String = self.name.chars().filter(|c| !c.is_whitespace()).collect();
        let is_on_paper = name.ends_with(ON_PAPER);
        name.truncate(name.len() - if is_on_paper { ON_PAPER.len() } else { 0 });
        (name, is_on_paper)
    }
}

/// Places of a plan's points on paper in millimetres, x right, y up; the origin and the sheet's rotation are arbitrary.
#[derive(Clone, Debug)]
pub struct PointsOf {
    /// Which plan.
    pub kind: Sheet,
    /// The places by the points' names, the pole's among them.
    pub places: IndexMap<String, [f64; 2]>,
    /// Radii round places within which the points are with 95 %, in mm: of places read from a photograph. A place without
    /// one is that of the point to a tenth of a millimetre.
    pub bands: IndexMap<String, f64>,
}

/// Largest radius round a place, in mm: no point is sought on another sheet.
pub(super) const WIDEST: f64 = 100.0;

impl PointsOf {
    /// A plan without places.
    #[must_use]
    pub fn new(kind: Sheet) -> PointsOf {
        PointsOf { kind, places: IndexMap::new(), bands: IndexMap::new() }
    }

    /// Sets the place of a point, with its radius, if it has one.
    pub fn put(&mut self, name: impl Into<String>, at: [f64; 2], band: Option<f64>) {
        let name = name.into();
        match band {
            Some(band) => self.bands.insert(name.clone(), band),
            None => self.bands.shift_remove(&name),
        };
        self.places.insert(name, at);
    }

    /// The points with their places and radii.
    pub(super) fn all(&self) -> impl Iterator<Item = (&str, [f64; 2], Option<f64>)> {
        self.places.iter().map(|(name, at)| (name.as_str(), *at, self.bands.get(name).copied()))
    }

    /// The name that the pole has among the places.
    #[must_use]
    pub fn pole(&self) -> Option<&'static str> {
        let mut written = ["π", "pi", "p'", "p"].into_iter();
        written.find(|p| self.places.contains_key(*p))
    }
}

/// Which sense of rotation counts as positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Positive {
    /// As in scenes and results.
    CounterClockwise,
    /// Opposite to scenes and results.
    Clockwise,
}

impl Positive {
    /// Both senses.
    const ALL: [Positive; 2] = [Positive::CounterClockwise, Positive::Clockwise];

    /// The sense of this word, as forms have it.
    pub(super) fn from_word(word: &str) -> Option<Positive> {
        Positive::ALL.into_iter().find(|sense| sense.as_str() == word)
    }

    /// The word for it in forms.
    pub(super) fn as_str(self) -> &'static str {
        match self {
            Positive::CounterClockwise => "counter-clockwise",
            Positive::Clockwise => "clockwise",
        }
    }
}
