//! The sentences of the report on a student's values, and of each mistake of the catalogue.

mod english;
mod spanish;

pub(super) use english::ENGLISH;
pub(super) use spanish::SPANISH;

/// The sentences of a mistake, with its blanks in order.
#[derive(Clone, Copy, Debug)]
pub struct MistakeWords {
    /// What was probably done.
    pub done: fn(&[String]) -> String,
    /// What it should be.
    pub should: fn(&[String]) -> String,
}

/// The report on a student's values.
#[derive(Clone, Copy, Debug)]
pub struct CheckWords {
    /// Heading: right values, values within the tolerance, values that are off.
    pub counts: fn(usize, usize, usize) -> String,
    /// Verdict.
    pub right: &'static str,
    /// Verdict.
    pub within: &'static str,
    /// Verdict.
    pub off: &'static str,
    /// Verdict.
    pub unjudged: &'static str,
    /// Headings of the columns: quantity, written, expected, difference, on the sheet, in per cent, allowed, verdict.
    pub columns: [&'static str; 8],
    /// Limits of the hand, in mm and degrees.
    pub tolerance: fn(&str, &str) -> String,
    /// Heading.
    pub probably: &'static str,
    /// Heading where nothing is to be explained.
    pub nothing: &'static str,
    /// Where no single mistake explains the values.
    pub no_single: &'static str,
    /// Where nothing in the catalogue does.
    pub none: &'static str,
    /// Number of a step.
    pub step: fn(usize) -> String,
    /// Before the first step.
    pub whole: &'static str,
    /// Before what it should be.
    pub instead: &'static str,
    /// Values that follow.
    pub follows: fn(&str) -> String,
    /// Where no value follows.
    pub follows_none: &'static str,
    /// Probability in per cent.
    pub sure: fn(&str) -> String,
    /// Heading of other explanations.
    pub others: &'static str,
    /// Behind one that values cannot tell from the first.
    pub alike: &'static str,
    /// Values without an explanation.
    pub unexplained: fn(&str) -> String,
    /// Plan whose places are the mirror image of the right ones.
    pub mirrored: fn(&str) -> String,

    // The drawing over the right figure.
    /// What its lines are: as it should be, the student's, where it went wrong.
    pub key: [&'static str; 3],
    /// How many values follow, and how they are marked in the table.
    pub follows_marked: fn(usize, &str) -> String,
    /// Point, millimetres on paper from the panel's edge.
    pub beyond: fn(&str, &str) -> String,
    /// Plan, degrees: how far a student's points were turned to lie over the right ones.
    pub turned: fn(&str, &str) -> String,

    // Mistakes; the blanks of each stand in its sentences.
    /// Two plan points.
    pub turned_ray: MistakeWords,
    /// Joint, special point.
    pub turned_cut_line: MistakeWords,
    /// Point that the ray leads to, wrong and right point.
    pub ray_from_wrong_point: MistakeWords,
    /// Special point, wrong and right line.
    pub wrong_lines: MistakeWords,
    /// Two plan points.
    pub reversed_vector: MistakeWords,
    /// Two plan points, rate, length.
    pub normal_outward: MistakeWords,
    /// The same.
    pub omega_not_squared: MistakeWords,
    /// The same.
    pub diameter: MistakeWords,
    /// The same.
    pub normal_from_absolute: MistakeWords,
    /// The same.
    pub normal_forgotten: MistakeWords,
    /// Two plan points, two rates.
    pub coriolis_forgotten: MistakeWords,
    /// The same.
    pub coriolis_without_two: MistakeWords,
    /// The same.
    pub coriolis_turned: MistakeWords,
    /// Two plan points, rate, length.
    pub coriolis_where_none: MistakeWords,
    /// Start, point laid off wrong, point that gives the side.
    pub mirrored_image: MistakeWords,
    /// Segment, wrong ends.
    pub wrong_segment: MistakeWords,
    /// Quantity, axis, ends.
    pub component: MistakeWords,
    /// Length, wrong ends.
    pub wrong_length: MistakeWords,
    /// Rate.
    pub wrong_sense: MistakeWords,
    /// Rate.
    pub revolutions_for_radians: MistakeWords,
    /// Rate.
    pub degrees_for_radians: MistakeWords,
    /// Segment (empty for all of a sheet), wrong scale (empty for none), right scale.
    pub wrong_scale: MistakeWords,
    /// None.
    pub other_mode: MistakeWords,
    /// Two quantities.
    pub swapped: MistakeWords,
    /// Quantity, written and meant digits.
    pub digits_transposed: MistakeWords,
    /// Quantity, written and meant digits.
    pub decimal_slipped: MistakeWords,
    /// None.
    pub truncated: MistakeWords,
    /// Quantity, digits, wrong and right unit.
    pub wrong_unit: MistakeWords,
    /// Quantity, digits, the unit that they are in, the scene's unit.
    pub other_unit: MistakeWords,
    /// Quantity.
    pub unknown: MistakeWords,
}

/// A quantity's name as people write it.
fn symbol(name: &str) -> String {
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

/// ω² L, of a mistake whose blanks are two plan points, a rate and a length.
fn normal(blanks: &[String]) -> String {
    format!("{}² {}", symbol(&blanks[2]), symbol(&blanks[3]))
}

/// 2 ω v, of a mistake whose blanks are two plan points, a rate and a velocity.
fn coriolis(blanks: &[String]) -> String {
    format!("2 {} {}", symbol(&blanks[2]), symbol(&blanks[3]))
}

/// What a line of the scheme is: `S3` of the cut line of S3, `3/2` of the guide of 3/2, else two of its points.
enum Line<'a> {
    Cut(&'a str),
    Guide(&'a str),
    Through(&'a str),
}

impl Line<'_> {
    fn of(name: &str) -> Line<'_> {
        if let Some(special) = name.strip_prefix("cut line of ") {
            Line::Cut(special)
        } else if let Some(slider) = name.strip_prefix("guide of ") {
            Line::Guide(slider)
        } else {
            Line::Through(name)
        }
    }
}
