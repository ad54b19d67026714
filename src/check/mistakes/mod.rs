//! The catalogue of classical mistakes. Each entry is a line of data and one small function that edits the mistake into the construction
//! at every place where it could be made; the replay lets it propagate.

mod copying;
mod lengths;
mod rates;
mod rays;
mod vectors;

use super::answer_key::AnswerKey;
use super::datum::Datum;
use super::entry::Entry;
use super::model::{Edit, Model};
use crate::construction::{Does, NumberId, NumberKind, Operation, PlaceId, Product};
use crate::words::MistakeWords;

/// A mistake of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mistake {
    /// A ray drawn parallel in place of perpendicular, or the other way round.
    TurnedRay,
    /// A cut line drawn along the guide in place of normal to it.
    TurnedCutLine,
    /// A ray drawn from the wrong plan point.
    RayFromWrongPoint,
    /// A special point taken from the wrong pair of lines.
    WrongLines,
    /// A vector laid off reversed.
    ReversedVector,
    /// A normal acceleration that points outward.
    NormalOutward,
    /// A normal part with ω in place of ω².
    OmegaNotSquared,
    /// A normal part with the diameter in place of the radius.
    Diameter,
    /// A normal part from the absolute velocity.
    NormalFromAbsolute,
    /// A normal part forgotten.
    NormalForgotten,
    /// The Coriolis part forgotten.
    CoriolisForgotten,
    /// The Coriolis part without its 2.
    CoriolisWithoutTwo,
    /// The Coriolis part turned the wrong way.
    CoriolisTurned,
    /// A Coriolis part where nothing slides.
    CoriolisWhereNone,
    /// The image of a link mirrored.
    MirroredImage,
    /// A segment measured from the wrong point.
    WrongSegment,
    /// A component taken for a length.
    Component,
    /// A wrong neighbouring length.
    WrongLength,
    /// A rate taken with the wrong sense.
    WrongSense,
    /// Revolutions per minute taken for radians per second, or the other way round.
    RevolutionsForRadians,
    /// Degrees taken for radians, or the other way round.
    DegreesForRadians,
    /// A segment taken with the wrong scale.
    WrongScale,
    /// The other assembly mode.
    OtherMode,
    /// Two numbers swapped.
    Swapped,
    /// Digits transposed.
    DigitsTransposed,
    /// A decimal slipped.
    DecimalSlipped,
    /// All values cut off in place of rounded.
    Truncated,
    /// The wrong unit written beside a value.
    WrongUnit,
    /// A value in another unit of length than the scene's, and no unit beside it.
    OtherUnit,
    /// A value off for a reason that the catalogue does not know, and gone on with.
    Unknown,
}

/// A mistake at one place of a construction.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Which mistake.
    pub mistake: Mistake,
    /// The number of the step at which it was made.
    pub step: usize,
    /// What the sentences about it name, in their order.
    pub blanks: Vec<String>,
    /// What is done otherwise, by operation.
    pub(super) edits: Vec<(usize, Edit)>,
    /// What written values are read as.
    pub(super) reinterpreted: Vec<Reinterpretation>,
    /// Numbers with which the person goes on as they were written: operation, number, value.
    pub(super) goes_on: Vec<(usize, NumberId, f64)>,
    /// Which construction is replayed: 0 for the right position, then those of other assembly modes.
    pub(super) mode: usize,
}

impl Candidate {
    /// Whether both are told in the same words.
    pub(super) fn is_told_like(&self, other: &Candidate) -> bool {
        self.mistake == other.mistake && self.blanks == other.blanks
    }
}

/// What a written value stands for in a mistake.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reinterpretation {
    pub entry: usize,
    /// The value meant; none where the written one says nothing.
    pub value: Option<f64>,
    /// Half a unit of its last digit.
    pub rounding: f64,
}

impl Reinterpretation {
    /// The value as it is meant; none where the written one says nothing.
    pub fn read(&self, written: &Datum) -> Option<Datum> {
        self.value.map(|value| Datum { value, rounding: self.rounding.max(f64::MIN_POSITIVE), ..*written })
    }
}

/// A line of the catalogue.
pub(super) struct Listed {
    pub mistake: Mistake,
    /// Its name in messages and tables of results.
    pub id: &'static str,
    /// How many of a hundred drawings with a mistake have this one, about.
    pub percent: f64,
    /// Puts it into the construction wherever it fits.
    find: fn(&Site<'_>) -> Vec<Candidate>,
    /// Its sentences.
    pub words: MistakeWords,
}

macro_rules! listed {
    ($($mistake:ident $id:literal $percent:literal $find:path => $words:ident,)*) => {
        [$(Listed { mistake: Mistake::$mistake, id: $id, percent: $percent, find: $find, words: MistakeWords::$words }),*]
    };
}

/// The catalogue. How common a mistake is decides only where values alone leave it open.
pub(super) const CATALOGUE: [Listed; 30] = listed! {
    TurnedRay "turned-ray" 6.0 rays::turned => turned_ray,
    TurnedCutLine "turned-cut-line" 4.0 rays::turned_cut_line => turned_cut_line,
    RayFromWrongPoint "ray-from-wrong-point" 5.0 rays::from_wrong_point => ray_from_wrong_point,
    WrongLines "wrong-lines" 4.0 rays::wrong_lines => wrong_lines,
    ReversedVector "reversed-vector" 6.0 vectors::reversed => reversed_vector,
    NormalOutward "normal-outward" 6.0 vectors::outward => normal_outward,
    OmegaNotSquared "omega-not-squared" 5.0 vectors::not_squared => omega_not_squared,
    Diameter "diameter" 3.0 vectors::diameter => diameter,
    NormalFromAbsolute "normal-from-absolute" 3.0 vectors::from_absolute => normal_from_absolute,
    NormalForgotten "normal-forgotten" 6.0 vectors::normal_forgotten => normal_forgotten,
    CoriolisForgotten "coriolis-forgotten" 6.0 vectors::coriolis_forgotten => coriolis_forgotten,
    CoriolisWithoutTwo "coriolis-without-2" 4.0 vectors::coriolis_without_two => coriolis_without_two,
    CoriolisTurned "coriolis-turned" 5.0 vectors::coriolis_turned => coriolis_turned,
    CoriolisWhereNone "coriolis-where-none" 2.0 vectors::coriolis_where_none => coriolis_where_none,
    MirroredImage "mirrored-image" 3.0 vectors::mirrored => mirrored_image,
    WrongSegment "wrong-segment" 4.0 lengths::wrong_segment => wrong_segment,
    Component "component" 4.0 lengths::component => component,
    WrongLength "wrong-length" 4.0 lengths::wrong_length => wrong_length,
    WrongSense "wrong-sense" 6.0 rates::wrong_sense => wrong_sense,
    RevolutionsForRadians "revolutions-for-radians" 3.0 rates::revolutions => revolutions_for_radians,
    DegreesForRadians "degrees-for-radians" 3.0 rates::degrees => degrees_for_radians,
    WrongScale "wrong-scale" 4.0 rates::wrong_scale => wrong_scale,
    OtherMode "other-mode" 4.0 rays::other_mode => other_mode,
    Swapped "swapped" 3.0 copying::swapped => swapped,
    DigitsTransposed "digits-transposed" 6.0 copying::transposed => digits_transposed,
    DecimalSlipped "decimal-slipped" 8.0 copying::decimal => decimal_slipped,
    Truncated "truncated" 1.0 copying::truncated => truncated,
    WrongUnit "wrong-unit" 5.0 copying::unit => wrong_unit,
    OtherUnit "other-unit" 3.0 copying::other_unit => other_unit,
    Unknown "unknown" 3.0 copying::unknown => unknown,
};

impl Mistake {
    /// All of them, in the order of the catalogue.
    pub fn all() -> impl Iterator<Item = Mistake> {
        CATALOGUE.iter().map(|listed| listed.mistake)
    }

    /// Its name in results, as `coriolis-forgotten`.
    #[must_use]
    pub fn id(self) -> &'static str {
        self.listed().id
    }

    /// Its line of the catalogue.
    pub(super) fn listed(self) -> &'static Listed {
        &CATALOGUE[self as usize]
    }

    /// Its sentences.
    #[must_use]
    pub fn words(self) -> MistakeWords {
        self.listed().words
    }
}

/// A construction in which mistakes are looked for.
pub(super) struct Site<'a> {
    pub model: &'a Model,
    pub key: &'a AnswerKey<'a>,
    pub entries: &'a [Entry],
    /// How many other assembly modes there are.
    pub other_modes: usize,
}

impl Site<'_> {
    /// All candidates of the catalogue.
    pub fn candidates(&self) -> Vec<Candidate> {
        CATALOGUE.iter().flat_map(|listed| (listed.find)(self)).collect()
    }

    /// The candidates of one mistake.
    pub fn of(&self, mistake: Mistake) -> Vec<Candidate> {
        (mistake.listed().find)(self)
    }

    fn operations(&self) -> impl Iterator<Item = (usize, &Operation)> {
        self.model.construction.operations.iter().enumerate()
    }

    fn operation(&self, index: usize) -> &Operation {
        &self.model.construction.operations[index]
    }

    fn candidate(&self, mistake: Mistake, operation: usize, edit: Edit, blanks: &[&str]) -> Candidate {
        Candidate {
            mistake,
            step: self.model.steps[operation],
            blanks: blanks.iter().map(|b| (*b).to_owned()).collect(),
            edits: vec![(operation, edit)],
            reinterpreted: Vec::new(),
            goes_on: Vec::new(),
            mode: 0,
        }
    }

    fn number_name(&self, number: NumberId) -> &str {
        &self.model.number_names[number.0]
    }

    fn number_kind(&self, number: NumberId) -> &NumberKind {
        &self.model.construction.numbers[number.0]
    }

    fn place_name(&self, place: PlaceId) -> &str {
        self.model.place_name(place)
    }

    /// The sums from which vectors' sizes are computed: the operation, its number, the sum, the names of the vector's ends.
    fn sums(&self) -> Vec<(usize, NumberId, &[Product], [&str; 2])> {
        let laid = self.operations().filter_map(|(_, operation)| match &operation.does {
            Does::LayOff { place, from, size, .. } => {
                let maker = self.model.makers[size.0]?;
                match &self.operation(maker).does {
                    Does::Compute { number, sum } => {
                        Some((maker, *number, sum.as_slice(), [self.place_name(*from), self.place_name(*place)]))
                    }
                    _ => None,
                }
            }
            _ => None,
        });
        // What is only read off has no name of its own.
        laid.filter(|(.., ends)| !ends[1].is_empty()).collect()
    }
}
