use crate::scene::Figure;
use crate::sheet::{Scales, Sheet};
use crate::text::{Untrusted, shown};
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

    /// The scales that are none.
    pub(super) fn bad_scales(&self) -> impl Iterator<Item = CheckError> {
        let bad = self.mu.given().filter(|(_, mu)| !(mu.is_finite() && *mu > 0.0));
        bad.map(|(sheet, _)| {
            CheckError::new(
                format!("{} is no scale", sheet.scale_key()),
                "a scale is a positive number: units of the scene per millimetre of paper",
            )
        })
    }

    /// Asks for a figure at the scales of the student's own sheet, as far as the form has them.
    pub fn put_scales_into(&self, figure: &mut Figure) {
        figure.set_scales(self.mu.or(figure.given_scales()));
    }
}

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

/// Why values cannot be checked: what, and what to try.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}{message}")]
#[non_exhaustive]
pub struct CheckError {
    /// The place in the file, followed by a colon; may be empty.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

impl CheckError {
    /// An error about the form as a whole.
    pub(super) fn new(message: impl Into<String>, hint: impl Into<String>) -> CheckError {
        CheckError { place: String::new(), message: message.into(), hint: Some(hint.into()) }
    }

    /// An error about something that somebody wrote, which begins the message.
    pub(super) fn about(written: &str, says: &str, hint: impl Into<String>) -> CheckError {
        CheckError::new(format!("`{}` {says}", shown(written)), hint)
    }

    /// All errors of a form in one: each with its place, and what to try; `None` where there are none.
    pub(super) fn all(mut errors: Vec<CheckError>) -> Option<CheckError> {
        if errors.len() < 2 {
            return errors.pop();
        }
        let lines = errors.iter().map(|error| match &error.hint {
            Some(hint) => format!("\n  {error}: {hint}"),
            None => format!("\n  {error}"),
        });
        let message = format!("{} things in this form are not understood:{}", errors.len(), lines.collect::<String>());
        Some(CheckError { place: String::new(), message, hint: None })
    }

    /// The error with its place in the file.
    pub(super) fn at(mut self, place: &str) -> CheckError {
        self.place = format!("{place}: ");
        self
    }
}
