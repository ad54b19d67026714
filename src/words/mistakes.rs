//! The sentences of mistakes: for each what was done and what should be, declared once with the names of their blanks.

use super::Wording;
use super::catalogue::Declared;
use super::sentences;

/// Turns the text for a blank into the text that is shown.
type Show = fn(&Wording, &str) -> String;

/// Declares the mistakes. The function behind a blank's name shows its text; without one the text stays as it is.
macro_rules! mistakes {
    ($($(#[$about:meta])+ $mistake:ident ($($blank:ident $(: $shown:ident)?),*);)+) => {
        /// A mistake, by the common key of its two sentences.
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum MistakeWords { $($(#[$about])+ $mistake),+ }

        /// The keys and blanks of every catalogue, behind [those of all others](sentences).
        pub(super) const MISTAKES: &[Declared] = &[$(
            Declared { key: concat!(stringify!($mistake), ".done"), blanks: &[$(stringify!($blank)),*], needs_all: false },
            Declared { key: concat!(stringify!($mistake), ".should"), blanks: &[$(stringify!($blank)),*], needs_all: false },
        )+];

        /// For each mistake, how its blanks are shown.
        const SHOWN: &[&[Show]] = &[$(&[$(mistakes!(@shown $($shown)?)),*]),+];
    };
    (@shown) => { unchanged };
    (@shown $shown:ident) => { $shown };
}

mistakes! {
    /// A ray between two plan points, turned by 90°.
    turned_ray(from, to);
    /// Both rays to an image, turned by 90°.
    turned_rays(from, to, other);
    /// The cut line through a joint for a special point, turned by 90°.
    turned_cut_line(joint, point);
    /// The ray to an image, drawn through the wrong plan point.
    ray_from_wrong_point(image, wrong, right);
    /// A special point, marked on wrong cut lines.
    wrong_lines(point, wrong: line, right: line);
    /// A vector between two plan points, of opposite sense.
    reversed_vector(from, to);
    /// A vector between two plan points, turned by 90°.
    turned_vector(from, to);
    /// A crank's vectors in both plans, turned by an angle.
    turned_vectors(from, to, degrees: number);
    /// A vector laid off from the wrong plan point.
    vector_from_wrong_point(end, wrong, right);
    /// A normal part between two plan points, of opposite sense.
    normal_outward(from, to, rate: symbol, length: symbol);
    /// Several normal parts of opposite sense.
    normals_outward(vectors);
    /// A normal part from ω in place of ω².
    omega_not_squared(from, to, rate: symbol, length: symbol);
    /// Several normal parts from ω in place of ω².
    omegas_not_squared(vectors);
    /// A normal part or a Coriolis acceleration with another link's ω; `factor` is a length or a velocity.
    omega_of_another_link(from, to, rate: symbol, factor: symbol, wrong: symbol);
    /// A normal part of twice the size.
    diameter(from, to, rate: symbol, length: symbol);
    /// All products of a crank of twice the size.
    diameter_throughout(length: symbol);
    /// All products of a crank of half the size.
    half_the_radius(length: symbol);
    /// A normal part from an absolute velocity, or that of another link, given by its segment.
    normal_from_absolute(from, to, rate: symbol, length: symbol, velocity);
    /// A missing normal part.
    normal_forgotten(from, to, rate: symbol, length: symbol);
    /// Several missing normal parts.
    normals_forgotten(vectors);
    /// A tangential part of a crank that turns evenly.
    tangential_where_none(from, to, rate: symbol, length: symbol);
    /// A missing Coriolis part.
    coriolis_forgotten(from, to, rate: symbol, velocity: symbol);
    /// A Coriolis part of half the size.
    coriolis_without_two(from, to, rate: symbol, velocity: symbol);
    /// A Coriolis part of opposite sense.
    coriolis_turned(from, to, rate: symbol, velocity: symbol);
    /// A Coriolis part along the guide.
    coriolis_along(from, to, rate: symbol, velocity: symbol);
    /// A Coriolis part with another velocity, given by its segment.
    coriolis_velocity(from, to, rate: symbol, velocity: symbol, wrong);
    /// The same with another ω besides.
    coriolis_velocity_and_omega(from, to, rate: symbol, velocity: symbol, wrong, omega: symbol);
    /// A Coriolis part where nothing slides.
    coriolis_where_none(from, to, rate: symbol, length: symbol);
    /// A Coriolis part of a slider on a guide at rest.
    coriolis_at_rest(from, to, rate: symbol, velocity: symbol);
    /// The image of a link, mirrored; `other` is the image that fixes the side.
    mirrored_image(start, point, other);
    /// The image of a point on a line of its link, on the wrong side of an end.
    beyond_end(start, point, other);
    /// The line between two images, divided from its wrong end.
    wrong_ratio(from, to, point);
    /// The line between two images, divided in the inverse ratio.
    inverse_ratio(from, to, point);
    /// The triangle on two images with its distances from both exchanged.
    distances_exchanged(from, to, point);
    /// The same on the wrong side besides.
    distances_exchanged_and_mirrored(from, to, point);
    /// A segment measured between the wrong plan points.
    wrong_segment(segment, from, to);
    /// A component of a segment in place of its length.
    component(segment, axis: axis, from, to);
    /// A length measured between the wrong points.
    wrong_length(length: symbol, from, to);
    /// The same wherever the length is used.
    wrong_length_throughout(length: symbol, from, to);
    /// An angular velocity found with another link's length.
    omega_from_wrong_length(rate: symbol, from, to, length: symbol);
    /// The same, and its normal part with that length.
    omega_and_normal_from_wrong_length(rate: symbol, from, to, length: symbol, normal);
    /// An angular acceleration found with another link's length.
    alpha_from_wrong_length(rate: symbol, from, to, length: symbol);
    /// A rate without division by its length.
    not_divided_by_length(rate: symbol, length: symbol);
    /// A rate of opposite sense.
    wrong_sense(rate: symbol);
    /// A given rate of opposite sense, of which the first vector shows it.
    wrong_sense_given(rate: symbol, from, to);
    /// The senses of all rates of rotation reversed.
    senses_reversed();
    /// A rate in revolutions per minute in place of radians per second, or the other way round.
    revolutions_for_radians(rate: symbol);
    /// A given rate taken in another unit.
    rate_in_other_unit(rate: symbol, number: number, given, taken);
    /// The same in revolutions per second.
    revolutions_per_second(rate: symbol);
    /// A rate in degrees in place of radians, or the other way round.
    degrees_for_radians(rate: symbol);
    /// A segment by the wrong scale; all segments of a sheet where `segment` is empty.
    wrong_scale(segment: segments, wrong, scale);
    /// The same without any scale.
    scale_forgotten(segment: segments, scale);
    /// The mechanism in another assembly mode.
    other_mode();
    /// The mechanism with its crank at another angle.
    crank_angle(link, wrong: number, right: number);
    /// Two quantities in each other's place.
    swapped(first, second);
    /// Two digits of a number in each other's place.
    digits_transposed(quantity, written: number, meant: number);
    /// A number with its decimal mark in the wrong place.
    decimal_slipped(quantity, written: number, meant: number);
    /// All numbers cut off in place of rounded.
    truncated();
    /// A value with the wrong unit beside it.
    wrong_unit(quantity, number: number, wrong, right);
    /// A value in another unit than the scene's own, without that unit beside it.
    other_unit(quantity, number: number, unit, own);
    /// A quantity that no mistake of the catalogue explains.
    unknown(quantity);
}

impl Wording {
    /// The two sentences of a mistake, what was probably done and what should be; `blanks` in the order of their
    /// declaration.
    #[must_use]
    pub fn mistake(&self, mistake: MistakeWords, blanks: &[String]) -> [String; 2] {
        let (mistake, blanks) = variant(mistake, blanks);
        let mistake = mistake as usize;
        let given = blanks.into_iter().chain(core::iter::repeat(""));
        let shown: Vec<String> = SHOWN[mistake].iter().zip(given).map(|(shown, blank)| shown(self, blank)).collect();
        let shown: Vec<&str> = shown.iter().map(String::as_str).collect();
        [0, 1].map(|which| self.language.sentences[sentences::COUNT + 2 * mistake + which].filled(&shown))
    }
}

/// The sentences for a mistake that was made in more than one place or in a special way, as its blanks show; the other
/// mistakes and blanks as they are.
fn variant(mistake: MistakeWords, blanks: &[String]) -> (MistakeWords, Vec<&str>) {
    use MistakeWords as M;
    let blanks: Vec<&str> = blanks.iter().map(String::as_str).collect();
    match (mistake, blanks.as_slice()) {
        // A wrong scale without a name is a forgotten one.
        (M::wrong_scale, &[segment, "", scale, ..]) => (M::scale_forgotten, vec![segment, scale]),
        (M::turned_ray, &[from, to, other, _]) => (M::turned_rays, vec![from, to, other]),
        (M::turned_vector, [_, _, _]) => (M::turned_vectors, blanks),
        (M::normal_outward, &["", vectors]) => (M::normals_outward, vec![vectors]),
        (M::omega_not_squared, &["", vectors]) => (M::omegas_not_squared, vec![vectors]),
        (M::normal_forgotten, &["", vectors]) => (M::normals_forgotten, vec![vectors]),
        (M::half_the_radius, &[_, _, _, length]) => (M::half_the_radius, vec![length]),
        (M::diameter, &["", "", _, length]) => (M::diameter_throughout, vec![length]),
        (M::mirrored_image, [_, _, _, "end"]) => (M::beyond_end, blanks),
        (M::wrong_ratio, [_, _, _, "inverse"]) => (M::inverse_ratio, blanks),
        (M::wrong_ratio, [_, _, _, "triangle"]) => (M::distances_exchanged, blanks),
        (M::wrong_ratio, [_, _, _, "mirrored"]) => (M::distances_exchanged_and_mirrored, blanks),
        (M::wrong_length, [_, _, _, _]) => (M::wrong_length_throughout, blanks),
        (M::omega_from_wrong_length, [_, _, _, _, _]) => (M::omega_and_normal_from_wrong_length, blanks),
        (M::revolutions_for_radians | M::revolutions_per_second | M::degrees_for_radians, [_, _, _, _]) => {
            (M::rate_in_other_unit, blanks)
        }
        (M::coriolis_velocity, [_, _, _, _, _, _]) => (M::coriolis_velocity_and_omega, blanks),
        (M::wrong_sense, [_, _, _]) => (M::wrong_sense_given, blanks),
        _ => (mistake, blanks),
    }
}

fn unchanged(_: &Wording, text: &str) -> String {
    text.to_owned()
}

/// A number with the wording's decimal mark.
fn number(words: &Wording, written: &str) -> String {
    words.number(written.to_owned())
}

/// The symbol of a rate or a length: `ω_2` for `omega(2)`, `L_AB` for `L(A,B)`.
fn symbol(_: &Wording, name: &str) -> String {
    let inner = |head: &str| name.strip_prefix(head).and_then(|n| n.strip_suffix(')'));
    if let Some(link) = inner("omega(") {
        return format!("ω_{link}");
    }
    if let Some(link) = inner("alpha(") {
        return format!("α_{link}");
    }
    if let Some(ends) = inner("L(") {
        return format!("L_{}", ends.replace(',', ""));
    }
    name.to_owned()
}

/// A line of the scheme: a cut line, a guide, or a line through two points.
fn line(words: &Wording, name: &str) -> String {
    if let Some(special) = name.strip_prefix("cut line of ") {
        words.language.line_cut(special)
    } else if let Some(slider) = name.strip_prefix("guide of ") {
        words.language.line_guide(slider)
    } else {
        words.language.line_through(name)
    }
}

/// The word for the axis of a component, `x` or else `y`.
fn axis(words: &Wording, name: &str) -> String {
    (if name == "x" { words.language.horizontal() } else { words.language.vertical() }).to_owned()
}

/// A segment, or all segments of a sheet for an empty name.
fn segments(words: &Wording, name: &str) -> String {
    (if name.is_empty() { words.language.all_segments() } else { name }).to_owned()
}
