//! What a check starts from: the answer key, and the values of a form as they were written down, with what is not
//! understood of them.

use super::on_paper::PaperPoints;
use super::says;
use crate::construction::{Solution, Tolerance};
use crate::geometry::{Vector, complex_product};
use crate::message::Message;
use crate::sheet::{Scales, Sheet};
use crate::text::Untrusted;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// How many times as large as usual an honest hand's errors may be where nobody has said how accurate it should be: up to
/// 1 mm and 1° with the usual tolerance.
pub const LENIENCY: f64 = 10.0 / 3.0;

/// How many mistakes at once are usually looked for.
pub const DEPTH: usize = 5;

/// What a student's values are compared with: the solved scene, and the accuracy expected of a hand.
#[derive(Clone, Copy, Debug)]
pub struct AnswerKey<'a> {
    /// The right solution of the scene, with accelerations.
    pub solution: &'a Solution,
    /// The scales of the scene's figure.
    pub scales: Scales,
    /// Limits of the errors of an honest hand.
    pub tolerance: Tolerance,
    /// How many times as large an honest hand's errors may be where the scatter of all values shows that they are. 1: the
    /// tolerance rules.
    pub leniency: f64,
    /// Largest number of mistakes that are looked for together.
    pub depth: usize,
}

impl<'a> AnswerKey<'a> {
    /// The key of a scene at the scales of its figure. Without limits of the hand's errors those of a sharp pencil hold,
    /// and the scatter of all values shows how much larger they may be.
    #[must_use]
    pub fn new(solution: &'a Solution, hand: Option<Tolerance>) -> AnswerKey<'a> {
        AnswerKey {
            solution,
            scales: solution.scales(),
            tolerance: hand.unwrap_or_default(),
            leniency: if hand.is_some() { 1.0 } else { LENIENCY },
            depth: DEPTH,
        }
    }
}

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
    /// Places of points on paper, by sheet.
    pub points: Vec<PointsOf>,
    /// Whether the places are those of sheets that lie as they were printed, x along the scheme's; else each plan may lie turned.
    pub upright: bool,
    /// How many stages of hints the student opened in the workbench.
    pub hints: u64,
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
            return Err(CheckError::new(says::too_many(MOST_VALUES, count), says::is_this_a_form()));
        }
        let bad = self.mu.given().filter(|(_, mu)| !(mu.is_finite() && *mu > 0.0));
        let bad =
            bad.map(|(sheet, _)| CheckError::new(says::no_scale(sheet.facts().scale_key), says::scale_is_positive()));
        Ok(self.faults.iter().cloned().chain(bad).collect())
    }
}

/// Most values of a form: more than the largest construction by hand has.
const MOST_VALUES: usize = 5_000;

/// In the names of images of the ground under a slider, as `c_ground`.
pub(super) const UNDER_SLIDER: &str = "_ground";

/// Behind the name of a length that is written in millimetres of paper.
pub(super) const ON_PAPER: &str = "/mu";

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
    pub place: Message,
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

/// Places of a sheet's points on paper in millimetres, x right, y up; from where they are measured is arbitrary, and so is the sheet's rotation unless
/// the form is [upright](Measured::upright).
#[derive(Clone, Debug)]
pub struct PointsOf {
    /// Of which sheet.
    pub sheet: Sheet,
    /// The places by the points' names, that of the sheet's [origin](super::PaperPoints::origin) among them.
    pub places: IndexMap<String, PlacedPoint>,
}

/// The place of a point on a student's sheet, in mm, y up.
#[derive(Clone, Copy, Debug)]
pub struct PlacedPoint {
    /// Where it is.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm, where it is read from a photograph; `None` where a hand has written or put it.
    pub band: Option<f64>,
}

/// Largest radius round a place, in mm: no point is sought on another sheet.
pub(super) const WIDEST: f64 = 100.0;

impl PointsOf {
    /// A sheet without places.
    #[must_use]
    pub fn new(sheet: impl Into<Sheet>) -> PointsOf {
        PointsOf { sheet: sheet.into(), places: IndexMap::new() }
    }

    /// Sets the place of a point, with its radius, if it has one.
    pub fn put(&mut self, name: impl Into<String>, at: [f64; 2], band: Option<f64>) {
        self.places.insert(name.into(), PlacedPoint { at, band });
    }

    /// The name that the sheet's origin has among the places.
    pub(super) fn origin<'p>(&self, points: &PaperPoints<'p>) -> Option<&'p str> {
        let own = [points.origin()];
        let written = if self.sheet.order().is_some() { &["π", "pi", "p'", "p"][..] } else { &own };
        written.iter().copied().find(|name| self.places.contains_key(*name))
    }

    /// Whether the places are those of a mirrored plan: no rotation brings them near the right ones, but one of the
    /// mirror image does.
    pub(super) fn is_mirrored(&self, points: &PaperPoints<'_>) -> bool {
        // Two centres of which one is wrong may look like that.
        let Some(pole) = self.origin(points).filter(|_| self.sheet.order().is_some()) else {
            return false;
        };
        let pole = Vector::from(self.places[pole].at);
        // The rotation of least squares, as the sum of complex products z̄ w, and z w for the mirror image (Umeyama 1991).
        let (mut turned, mut mirrored) = (Vector::zeros(), Vector::zeros());
        let (mut right, mut written) = (0.0, 0.0);
        for (name, place) in &self.places {
            let Some(z) = points.right(name) else { continue };
            let w = Vector::from(place.at) - pole;
            turned += Vector::new(z.dot(&w), z.x * w.y - z.y * w.x);
            mirrored += complex_product(z, w);
            right += z.norm_squared();
            written += w.norm_squared();
        }
        // The sum of squares that remains after the best rotation and scaling.
        let rest = |sum: Vector| written - sum.norm_squared() / right;
        right > 0.0 && rest(turned) > 0.01 * written && rest(mirrored) < 0.25 * rest(turned)
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
    pub place: Message,
    /// What is wrong.
    pub message: Message,
    /// What to try.
    pub hint: Option<Message>,
}

impl CheckError {
    /// An error about the form as a whole.
    pub(super) fn new(message: Message, hint: Message) -> CheckError {
        CheckError { place: "".into(), message, hint: Some(hint) }
    }

    /// All errors of a form in one: each with its place, and what to try; `None` where there are none.
    pub(super) fn all(mut errors: Vec<CheckError>) -> Option<CheckError> {
        if errors.len() < 2 {
            return errors.pop();
        }
        let count = errors.len();
        let lines = errors.into_iter().map(|CheckError { place, message, hint }| {
            let told = Message::list(["\n  ".into(), place, message], "");
            Message::list(std::iter::once(told).chain(hint), ": ")
        });
        let message = says::not_understood(count, Message::list(lines, ""));
        Some(CheckError { place: "".into(), message, hint: None })
    }

    /// The error with its place in the file.
    pub(super) fn at(self, place: impl Into<Message>) -> CheckError {
        CheckError { place: Message::list([place.into(), ": ".into()], ""), ..self }
    }
}
