//! The catalogue of classical mistakes. Each is a line of data and one small function that lists the places of the
//! construction where it could be made, with the edits it makes there; a replay shows what follows from them.

mod candidate;
mod copying;
mod coriolis;
mod crank;
mod images;
mod lengths;
mod mistake;
mod position;
mod rates;
mod rays;
mod site;
mod unknown;
mod vectors;

use crate::words::MistakeWords;

pub use candidate::Candidate;
pub(super) use candidate::{Amount, Free};
pub use mistake::Mistake;
pub(super) use site::Site;

/// A line of the catalogue.
pub(super) struct Listed {
    pub mistake: Mistake,
    /// Its name in results.
    pub id: &'static str,
    /// Approximate share of the drawings with a mistake that have this one, in per cent.
    pub percent: f64,
    /// Lists it at every place of the construction where it could be made.
    find: fn(&Site<'_>) -> Vec<Candidate>,
    /// Its sentences.
    pub words: MistakeWords,
}

macro_rules! listed {
    ($($mistake:ident $id:literal $percent:literal $find:path => $words:ident,)*) => {
        [$(Listed { mistake: Mistake::$mistake, id: $id, percent: $percent, find: $find, words: MistakeWords::$words }),*]
    };
}

/// The catalogue. The percentages decide only where the values alone do not.
pub(super) const CATALOGUE: [Listed; 45] = listed! {
    TurnedRay "turned-ray" 6.0 rays::turned => turned_ray,
    TurnedCutLine "turned-cut-line" 4.0 rays::turned_cut_line => turned_cut_line,
    RayFromWrongPoint "ray-from-wrong-point" 5.0 rays::from_wrong_point => ray_from_wrong_point,
    WrongLines "wrong-lines" 4.0 rays::wrong_lines => wrong_lines,
    ReversedVector "reversed-vector" 4.0 vectors::reversed => reversed_vector,
    TurnedVector "turned-vector" 3.0 vectors::turned => turned_vector,
    VectorFromWrongPoint "vector-from-wrong-point" 3.0 vectors::from_wrong_point => vector_from_wrong_point,
    NormalOutward "normal-outward" 6.0 vectors::outward => normal_outward,
    OmegaNotSquared "omega-not-squared" 5.0 vectors::not_squared => omega_not_squared,
    OmegaOfAnotherLink "omega-of-another-link" 3.0 vectors::omega_of_another => omega_of_another_link,
    Diameter "diameter" 3.0 vectors::diameter => diameter,
    HalfTheRadius "half-the-radius" 2.0 crank::half_the_radius => half_the_radius,
    NormalFromAbsolute "normal-from-absolute" 3.0 vectors::from_absolute => normal_from_absolute,
    NormalForgotten "normal-forgotten" 6.0 vectors::normal_forgotten => normal_forgotten,
    TangentialWhereNone "tangential-where-none" 2.0 vectors::tangential_where_none => tangential_where_none,
    CoriolisForgotten "coriolis-forgotten" 6.0 coriolis::forgotten => coriolis_forgotten,
    CoriolisWithoutTwo "coriolis-without-2" 4.0 coriolis::without_two => coriolis_without_two,
    CoriolisTurned "coriolis-turned" 5.0 coriolis::turned => coriolis_turned,
    CoriolisAlong "coriolis-along-guide" 2.0 coriolis::along => coriolis_along,
    CoriolisVelocity "coriolis-wrong-velocity" 3.0 coriolis::of_wrong_velocity => coriolis_velocity,
    CoriolisWhereNone "coriolis-where-none" 2.0 coriolis::where_none => coriolis_where_none,
    CoriolisAtRest "coriolis-at-rest" 2.0 coriolis::at_rest => coriolis_at_rest,
    MirroredImage "mirrored-image" 3.0 images::mirrored => mirrored_image,
    WrongRatio "wrong-ratio" 3.0 images::wrong_ratio => wrong_ratio,
    WrongSegment "wrong-segment" 8.0 lengths::wrong_segment => wrong_segment,
    Component "component" 4.0 lengths::component => component,
    WrongLength "wrong-length" 4.0 lengths::wrong_length => wrong_length,
    OmegaFromWrongLength "omega-from-wrong-length" 4.0 rates::omega_from_wrong_length => omega_from_wrong_length,
    AlphaFromWrongLength "alpha-from-wrong-length" 3.0 rates::alpha_from_wrong_length => alpha_from_wrong_length,
    NotDividedByLength "not-divided-by-length" 2.0 rates::not_divided => not_divided_by_length,
    WrongSense "wrong-sense" 6.0 rates::wrong_sense => wrong_sense,
    SensesReversed "senses-reversed" 3.0 rates::senses_reversed => senses_reversed,
    RevolutionsForRadians "revolutions-for-radians" 5.0 rates::revolutions => revolutions_for_radians,
    RevolutionsPerSecond "revolutions-per-second" 2.0 rates::revolutions_per_second => revolutions_per_second,
    DegreesForRadians "degrees-for-radians" 3.0 rates::degrees => degrees_for_radians,
    WrongScale "wrong-scale" 4.0 rates::wrong_scale => wrong_scale,
    OtherMode "other-mode" 4.0 position::other_mode => other_mode,
    CrankAngle "crank-angle" 3.0 position::crank_angle => crank_angle,
    Swapped "swapped" 3.0 copying::swapped => swapped,
    DigitsTransposed "digits-transposed" 8.0 copying::transposed => digits_transposed,
    DecimalSlipped "decimal-slipped" 8.0 copying::decimal => decimal_slipped,
    Truncated "truncated" 1.0 copying::truncated => truncated,
    WrongUnit "wrong-unit" 5.0 copying::unit => wrong_unit,
    OtherUnit "other-unit" 3.0 copying::other_unit => other_unit,
    Unknown "unknown" 5.0 unknown::everywhere => unknown,
};

impl Mistake {
    /// All mistakes, in the order of the catalogue.
    pub fn all() -> impl Iterator<Item = Mistake> {
        CATALOGUE.iter().map(|listed| listed.mistake)
    }

    /// Its name in results, as `coriolis-forgotten`.
    #[must_use]
    pub fn id(self) -> &'static str {
        self.listed().id
    }

    /// The approximate share of the drawings with a mistake that have this one, in per cent.
    #[must_use]
    pub fn share(self) -> f64 {
        self.listed().percent
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

impl Site<'_> {
    /// All candidates of the catalogue.
    pub fn candidates(&self) -> Vec<Candidate> {
        CATALOGUE.iter().flat_map(|listed| (listed.find)(self)).collect()
    }

    /// The candidates of one mistake.
    pub fn of(&self, mistake: Mistake) -> Vec<Candidate> {
        (mistake.listed().find)(self)
    }
}
