//! Symbols of instant centres in sentences, and what could not be found of the centres that were asked for.

use super::{Centers, FigureOf, MOST_LINKS};
use crate::centers::LinkPair;
use crate::construction::markup::display;
use crate::mechanism::{GROUND, Mechanism, PointId};
use crate::words::Wording;

/// The symbol of the centre of two links, in markup.
pub(super) fn symbol(pair: LinkPair, figure: FigureOf, mechanism: &Mechanism, words: &Wording) -> String {
    pair.symbol(figure.primes(), mechanism, &words.notation, &|name| link_in_words(name, mechanism, words))
}

/// A link by its name, in markup; the frame as the language and the figure call it.
pub(super) fn link_in_words(name: &str, mechanism: &Mechanism, words: &Wording) -> String {
    if name == mechanism.body(GROUND).name { words.ground().to_owned() } else { display(name) }
}

/// What could not be found of the instant centres, and of the velocities and curvatures by them, that were asked for, in sentences and in markup.
#[must_use]
pub fn missing_of_centers(centers: &Centers, mechanism: &Mechanism, words: &Wording) -> Vec<String> {
    let listed = |all: Vec<String>| (!all.is_empty()).then(|| all.join(", "));
    let resting = centers.by_rates.iter().filter(|(_, place)| place.is_none());
    let resting = resting.map(|(pair, _)| symbol(*pair, FigureOf::Mechanism, mechanism, words)).collect();
    let resting = listed(resting).map(|centers| words.language.no_centers(&centers));
    let named = |points: &[PointId]| listed(points.iter().map(|point| display(mechanism.point_name(*point))).collect());
    let velocities = named(&centers.without_velocity).map(|points| words.language.no_velocities_by_centers(&points));
    let curvatures = named(&centers.without_curvature).map(|points| words.language.no_curvatures(&points));
    let too_large = centers.is_too_large.then(|| words.language.too_many_for_lines(&(MOST_LINKS - 1).to_string()));
    too_large.into_iter().chain(resting).chain(velocities).chain(curvatures).collect()
}
