//! What is said of mistakes: two sentences each, declared once with the names of their blanks.

use super::Wording;
use super::catalogue::Declared;
use super::sentences::SENTENCES;

/// How a blank's text is shown.
type Shown = fn(&Wording, &str) -> String;

/// Makes the list of mistakes. Behind a blank's name stands how it is shown, where it is not shown as it is.
macro_rules! mistakes {
    ($($(#[$about:meta])+ $mistake:ident ($($blank:ident $(: $shown:ident)?),*);)+) => {
        /// The sentences of a mistake: what was probably done, and what it should be.
        #[expect(non_camel_case_types, reason = "they are the keys of the catalogues")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum MistakeWords { $($(#[$about])+ $mistake),+ }

        /// The keys and blanks that every catalogue has, behind those of other sentences.
        pub(super) const MISTAKES: &[Declared] = &[$(
            Declared { key: concat!(stringify!($mistake), ".done"), blanks: &[$(stringify!($blank)),*], needs_all: false },
            Declared { key: concat!(stringify!($mistake), ".should"), blanks: &[$(stringify!($blank)),*], needs_all: false },
        )+];

        /// How each one's blanks are shown.
        const SHOWN: &[&[Shown]] = &[$(&[$(mistakes!(@shown $($shown)?)),*]),+];
    };
    (@shown) => { as_it_is };
    (@shown $shown:ident) => { $shown };
}

mistakes! {
    /// Between two plan points.
    turned_ray(from, to);
    /// For a special point.
    turned_cut_line(joint, point);
    /// To an image.
    ray_from_wrong_point(image, wrong, right);
    /// For a special point.
    wrong_lines(point, wrong: line, right: line);
    /// Between two plan points.
    reversed_vector(from, to);
    /// Between two plan points.
    normal_outward(from, to, rate: symbol, length: symbol);
    /// The same.
    omega_not_squared(from, to, rate: symbol, length: symbol);
    /// The same.
    diameter(from, to, rate: symbol, length: symbol);
    /// The same.
    normal_from_absolute(from, to, rate: symbol, length: symbol);
    /// The same.
    normal_forgotten(from, to, rate: symbol, length: symbol);
    /// The same.
    coriolis_forgotten(from, to, rate: symbol, velocity: symbol);
    /// The same.
    coriolis_without_two(from, to, rate: symbol, velocity: symbol);
    /// The same.
    coriolis_turned(from, to, rate: symbol, velocity: symbol);
    /// The same.
    coriolis_where_none(from, to, rate: symbol, length: symbol);
    /// `other` is the image that gives the side.
    mirrored_image(start, point, other);
    /// Between wrong ends.
    wrong_segment(segment, from, to);
    /// Between the right ends.
    component(segment, axis: axis, from, to);
    /// Between wrong ends.
    wrong_length(length: symbol, from, to);
    /// Of a rate.
    wrong_sense(rate: symbol);
    /// Of a rate.
    revolutions_for_radians(rate: symbol);
    /// Of a rate.
    degrees_for_radians(rate: symbol);
    /// Of a segment, or of all on a sheet where it has no name.
    wrong_scale(segment: segments, wrong, scale);
    /// The same, with no scale in place of a wrong one.
    scale_forgotten(segment: segments, scale);
    /// Of the whole drawing.
    other_mode();
    /// Two quantities.
    swapped(first, second);
    /// Of a quantity; its digits.
    digits_transposed(quantity, written: number, meant: number);
    /// Of a quantity; its digits.
    decimal_slipped(quantity, written: number, meant: number);
    /// Of all quantities.
    truncated();
    /// Of a quantity; both units.
    wrong_unit(quantity, number: number, wrong, right);
    /// Of a quantity; the unit that it is in, and the scene's own.
    other_unit(quantity, number: number, unit, own);
    /// Of a quantity.
    unknown(quantity);
}

impl Wording {
    /// What was probably done in a mistake, and what it should be, with its blanks in the order of their declaration.
    #[must_use]
    pub fn mistake(&self, mistake: MistakeWords, blanks: &[String]) -> [String; 2] {
        // A scale that was left out has no name.
        let (mistake, blanks) = match blanks {
            [segment, wrong, scale, ..] if mistake == MistakeWords::wrong_scale && wrong.is_empty() => {
                (MistakeWords::scale_forgotten as usize, vec![segment, scale])
            }
            _ => (mistake as usize, blanks.iter().collect()),
        };
        let given = blanks.into_iter().map(String::as_str).chain(core::iter::repeat(""));
        let shown: Vec<String> = SHOWN[mistake].iter().zip(given).map(|(shown, blank)| shown(self, blank)).collect();
        let shown: Vec<&str> = shown.iter().map(String::as_str).collect();
        [0, 1].map(|which| self.language.sentences[SENTENCES.len() + 2 * mistake + which].filled(&shown))
    }
}

fn as_it_is(_: &Wording, text: &str) -> String {
    text.to_owned()
}

/// A number with its decimal mark.
fn number(words: &Wording, written: &str) -> String {
    words.number(written.to_owned())
}

/// A quantity's name as people write it.
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

/// Of which axis a component is.
fn axis(words: &Wording, name: &str) -> String {
    (if name == "x" { words.language.horizontal() } else { words.language.vertical() }).to_owned()
}

/// A segment, or all of a sheet where it has no name.
fn segments(words: &Wording, name: &str) -> String {
    (if name.is_empty() { words.language.all_segments() } else { name }).to_owned()
}
