//! An exercise as a question: its fields with the numbers that they know, the right one and those that a known mistake gives;
//! and what all systems show of it, as HTML.

use super::package::CourseError;
use crate::check::{AnswerKey, Mistake, Student};
use crate::construction::Tolerance;
use crate::drawing::{Drawing, RichText, SheetLabels};
use crate::exercise::{Exercise, KeyValue, MEASURABLE};
use crate::format::{Text, html_text, panels_svg};
use crate::sheet::Sheet;
use crate::text::{Untrusted, xml};
use crate::words::{Medium, NumberStyle, Wording};

/// An exercise as a question: what is told, and a field for each box of its form.
#[derive(Clone, Debug)]
pub struct Question {
    /// Its name, from which those of its files are made: letters that a path may have.
    pub name: String,
    /// Its name as lists show it, which sort by it: its number has leading zeros.
    pub listed: String,
    /// The title of its scene.
    pub title: Untrusted,
    /// How it is told.
    pub words: Wording,
    /// What the student is told, as HTML by paragraph: given numbers, scales, senses, names of points, digits.
    pub told: Vec<String>,
    /// The scheme of the student's sheet as SVG: the question shows it.
    pub scheme: Vec<u8>,
    /// The student's sheets, to be printed at their true size: as PDF, without the feature `pdf` the first as SVG.
    pub print: Vec<u8>,
    /// Scheme and plans of the key as SVG, for afterwards.
    pub key: Vec<u8>,
    /// The fields, in the order of the form.
    pub fields: Vec<Field>,
    /// The text of the exercise's scene.
    pub scene: String,
    /// Its empty form, as JSON.
    pub form: String,
}

/// A box for one number.
#[derive(Clone, Debug)]
pub struct Field {
    /// The quantity's name in forms and keys.
    pub name: String,
    /// Its name on the sheets, as HTML.
    pub label: String,
    /// By how much a careful hand may be off.
    pub allowed: f64,
    /// The unit in which the number is written.
    pub unit: String,
    /// The sheet from which it is read.
    pub sheet: Sheet,
    /// What it is worth, in marks.
    pub worth: f64,
    /// The numbers that it knows: the right one first, then those for which there are marks or feedback. No two overlap that earn or say
    /// different things.
    pub answers: Vec<Answer>,
}

impl Question {
    /// The question of an exercise with that name, listed by the other. `styled` gives the sheets and the key their looks.
    ///
    /// # Errors
    /// The exercise's figure lacks a sheet, or its sheet cannot be written as PDF.
    pub fn new(
        exercise: &Exercise,
        name: &str,
        listed: &str,
        styled: &dyn Fn(&mut Drawing),
    ) -> Result<Question, CourseError> {
        let (mut key, mut sheets) = (exercise.key_sheet(), exercise.sheets(name));
        sheets.iter_mut().chain([&mut key]).for_each(styled);
        let words = exercise.solution.wording();
        let notes = SheetLabels::of(&exercise.solution).notes(&exercise.asked());
        let digits = RichText::plain(words.language.course_digits());
        let told = exercise.given().into_iter().chain(notes).chain([digits]);
        Ok(Question {
            name: name.to_owned(),
            listed: listed.to_owned(),
            title: exercise
                .solution
                .scene
                .title
                .clone()
                .unwrap_or_else(|| words.title_of(&exercise.solution.scene.figure).as_str().into()),
            words,
            told: told.map(|text| html_text(&text)).collect(),
            scheme: picture(&exercise.sheet),
            print: printed(&sheets)?,
            key: picture(&key),
            fields: fields(exercise, &words)?,
            scene: exercise.text.clone(),
            form: exercise.form(name).json(&exercise.solution),
        })
    }

    /// Its name in lists, with its title.
    pub(super) fn list_name(&self) -> String {
        format!("{}: {}", self.listed, self.title.for_pdf())
    }

    /// The name of the file of the scheme's picture.
    pub(super) fn scheme_name(&self) -> String {
        format!("{}-scheme.svg", self.name)
    }

    /// The name of the file of the sheet to print.
    pub(super) fn print_name(&self) -> String {
        format!("{}-sheet.{}", self.name, if cfg!(feature = "pdf") { "pdf" } else { "svg" })
    }

    /// The name of the file of the key's picture.
    pub(super) fn key_name(&self) -> String {
        format!("{}-key.svg", self.name)
    }
}

/// The panels of a sheet: what is around them the page says in its own words. With outlines, as a picture in a page takes letters from whatever
/// font is there, which sets them too wide.
fn picture(sheet: &Drawing) -> Vec<u8> {
    panels_svg(sheet, Text::Glyphs).into_bytes()
}

#[cfg(feature = "pdf")]
fn printed(sheets: &[Drawing]) -> Result<Vec<u8>, CourseError> {
    Ok(crate::format::pdf_pages(sheets, None)?)
}

#[cfg(not(feature = "pdf"))]
fn printed(sheets: &[Drawing]) -> Result<Vec<u8>, CourseError> {
    Ok(sheets.first().map_or_else(Vec::new, |sheet| crate::format::svg_with(sheet, Text::Outlines).into_bytes()))
}

/// The fields of an exercise's form.
fn fields(exercise: &Exercise, words: &Wording) -> Result<Vec<Field>, CourseError> {
    let solution = &exercise.solution;
    let key = AnswerKey::new(solution, Some(Tolerance::default()));
    let student = Student::new(&key)?;
    let right = student.exact(None);
    let values = exercise.key().values;
    // As `Marks` says: a mistake that no value of its step shows is charged in the first that does.
    let shows = |place: usize, value: Option<f64>| {
        let own = values.get(student.names()[place].as_str());
        let off = value.zip(right[place]).map(|(value, right)| (value - right).abs());
        own.and_then(|own| own.allowed).zip(off).is_some_and(|(allowed, off)| off > allowed)
    };
    let mut wrong: Vec<Vec<Wrong>> = vec![Vec::new(); right.len()];
    for mistake in Mistake::all() {
        let ways = student.ways(mistake);
        let share = mistake.share() / ways.len().max(1) as f64;
        for way in &ways {
            let told = student.told(way).join(" ");
            let found = student.exact(Some(way));
            let showing = || (0..found.len()).filter(|place| shows(*place, found[*place]));
            let is_own = showing().any(|place| student.step(place) <= way.step);
            let first = if is_own { None } else { showing().next() };
            for (place, value) in found.into_iter().enumerate() {
                if let Some(value) = value.filter(|value| Some(*value) != right[place]) {
                    let follows = way.step < student.step(place) && first != Some(place);
                    wrong[place].push(Wrong { value, share, told: told.clone(), follows });
                }
            }
        }
    }
    let labels = SheetLabels::of(solution);
    let worth = solution.scene.form.clone().unwrap_or_default();
    let largest = |unit: &str| values.values().filter(|v| v.unit == unit).map(|v| v.value.abs()).fold(0.0, f64::max);
    let fields = exercise.pencil.quantities.iter().filter_map(|(asked, _)| {
        let value = values.get(asked.name())?;
        let place = student.names().iter().position(|name| name == asked.name())?;
        Some(Field {
            name: asked.name().to_owned(),
            label: html_text(&labels.quantity(asked)),
            allowed: value.allowed.unwrap_or(0.0),
            unit: value.unit.clone(),
            sheet: asked.sheet_by_hand(&solution.construction),
            worth: worth.get(asked.name()).copied().unwrap_or(1.0),
            answers: answers(value, largest(&value.unit), student.is_size(place), &wrong[place], words),
        })
    });
    Ok(fields.collect())
}

/// A number in digits that every importer reads: nine significant ones, with a point, without an exponent.
pub(super) fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.8e}").parse().unwrap_or(x);
    (rounded + 0.0).to_string()
}

/// A number as people read it, with its unit.
pub(super) fn read(value: f64, unit: &str, digits: usize, words: &Wording) -> String {
    let style = NumberStyle::significant(digits).trimmed().in_full(-5, 12).on(Medium::Figure);
    format!("{} {unit}", words.write(value, style))
}

/// The picture of the scheme and what is told, with `address` in front of the files' names.
pub(super) fn head(question: &Question, address: &str) -> String {
    let language = question.words.language;
    let print = address.to_owned() + &question.print_name();
    let title = question.title.for_xml();
    let mut html = format!("<p><strong>{title}</strong></p>\n");
    html += &linked_picture(&(address.to_owned() + &question.scheme_name()), language.course_picture(), 600);
    html += &format!("<p><a href=\"{print}\">{}</a></p>\n", xml(language.course_print()));
    question.told.iter().for_each(|told| html += &format!("<p>{told}</p>\n"));
    html
}

/// A picture with its address, `width` pixels wide where the page is.
pub(super) fn linked_picture(address: &str, said: &str, width: u16) -> String {
    // A class of the Bootstrap that Moodle has: no picture is wider than the page.
    format!("<p><img src=\"{address}\" alt=\"{}\" width=\"{width}\" class=\"img-fluid\"></p>\n", xml(said))
}

/// The fields as tables, one for each sheet; `cell` writes the box of a field.
pub(super) fn tables(question: &Question, cell: &dyn Fn(&Field) -> String) -> String {
    let mut html = String::new();
    for sheet in Sheet::ALL {
        let fields: Vec<&Field> = question.fields.iter().filter(|field| field.sheet == sheet).collect();
        if fields.is_empty() {
            continue;
        }
        html += &format!(
            "<p><strong>{}</strong></p>\n<table class=\"table table-sm w-auto\">\n<tbody>\n",
            xml(question.words.language.sheet(sheet))
        );
        for field in fields {
            let (label, unit) = (&field.label, xml(&field.unit));
            html += &format!("<tr><th scope=\"row\">{label}</th><td>{}</td><td>&nbsp;{unit}</td></tr>\n", cell(field));
        }
        html += "</tbody>\n</table>\n";
    }
    html
}

/// A number that a field knows, with what it earns.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The number, in the field's unit.
    pub value: f64,
    /// By how much a written number may differ from it.
    pub tolerance: f64,
    /// The part of the marks, in per cent.
    pub percent: u8,
    /// What is said of it; nothing of the right one.
    pub said: Option<String>,
}

/// Least share, of all mistakes that give about the same number, of one that is named: as the check tells a cause.
const TOLD: f64 = 0.6;

/// How many times as large as the largest of its unit a number may be to be expected at all: no paper holds it.
const GROWN: f64 = 100.0;

/// What part of the largest number of its unit is nothing but rounding: whoever does not know may write 0, so it earns nothing.
const NOTHING: f64 = 1e-9;

/// Significant digits that are asked for.
const DIGITS: i32 = 3;

/// Most wrong numbers that a field knows: Moodle reads a field with one regular expression, whose work grows with its length.
const MOST: usize = 24;

/// How much of the two decades around the right value wrong numbers may hold that are paid for, in decades: so whoever guesses hits one in
/// a quarter of all cases at most.
const PAID: f64 = 0.5;

/// A number that a known mistake gives in place of the right one.
#[derive(Clone, Debug)]
struct Wrong {
    value: f64,
    /// How common the mistake is at its place.
    share: f64,
    /// What the check says of it.
    told: String,
    /// Whether the value follows from it: it was made at an earlier step, and shows before.
    follows: bool,
}

impl Answer {
    /// How much it holds of the numbers within a factor of ten of the right one, in decades.
    fn decades(&self, right: f64) -> f64 {
        let [value, right] = [self.value, right].map(f64::abs);
        let [from, to] = [(value - self.tolerance).max(0.1 * right), (value + self.tolerance).min(10.0 * right)];
        if to > from { libm::log10(to / from) } else { 0.0 }
    }

    /// Whether a number can be within the tolerances of both.
    fn overlaps(&self, other: &Answer) -> bool {
        (self.value - other.value).abs() <= self.tolerance + other.tolerance
    }
}

/// The answers of a field: the right number, for a size also with a minus; for a rate the other sense, which earns nothing; then the commonest
/// of the numbers that known mistakes give and nothing else does: one that follows earns what the right one does. `largest` is the largest number of the unit, `is_size` whether a sign says nothing.
///
/// A tolerance is that of a careful hand and half a unit of the last digit that is asked for; that of a wrong number, which has grown, has grown
/// with it. Numbers that overlap a better one are left out, and those that other mistakes give, too, unless one is clearly the commonest.
fn answers(right: &KeyValue, largest: f64, is_size: bool, wrong: &[Wrong], words: &Wording) -> Vec<Answer> {
    let allowed = right.allowed.unwrap_or(0.0);
    let answer = |value: f64, percent, said| {
        let grown = if right.value == 0.0 { 1.0 } else { (value / right.value).abs().max(1.0) };
        Answer { value, tolerance: grown * allowed + half_digit(value, largest), percent, said }
    };
    let mut answers = vec![answer(right.value, 100, None)];
    let other = match is_size {
        true => answer(-right.value, 100, None),
        false => answer(-right.value, 0, Some(words.language.course_other_sense().to_owned())),
    };
    if right.value != 0.0 && (is_size || !other.overlaps(&answers[0])) {
        answers.push(other);
    }
    let expected = wrong.iter().filter(|wrong| (NOTHING * largest..=GROWN * largest).contains(&wrong.value.abs()));
    let all: Vec<(&Wrong, Answer)> = expected.map(|wrong| (wrong, answer(wrong.value, 0, None))).collect();
    let mut sure: Vec<(f64, Answer)> = all.iter().filter_map(|(wrong, own)| told(wrong, own, &all, words)).collect();
    sure.retain(|(_, own)| answers.iter().all(|better| !better.overlaps(own)));
    sure.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut known: Vec<Answer> = Vec::new();
    let mut paid = 0.0;
    for (_, own) in sure {
        let decades = if own.percent > 0 { own.decades(right.value) } else { 0.0 };
        let is_telling = own.percent == 0 || own.tolerance <= MEASURABLE * own.value.abs();
        if is_telling && known.len() < MOST && paid + decades <= PAID && known.iter().all(|other| !other.overlaps(&own))
        {
            paid += decades;
            known.push(own);
        }
    }
    answers.extend(known);
    answers
}

/// What a number that a mistake gives earns and what is said of it, with how common the mistake is: where nearly all mistakes that give such a
/// number are earlier ones, the marks of the right one, whichever it was; where nearly all are the same one, its name. None where neither
/// is so.
fn told(wrong: &Wrong, own: &Answer, all: &[(&Wrong, Answer)], words: &Wording) -> Option<(f64, Answer)> {
    let near = || all.iter().filter(|(_, other)| other.overlaps(own));
    let share = |is_it: &dyn Fn(&Wrong) -> bool| -> f64 {
        near().filter(|(other, _)| is_it(other)).map(|(other, _)| other.share).sum()
    };
    let whole = share(&|_| true);
    let is_named = share(&|other| other.told == wrong.told) >= TOLD * whole;
    let follows = share(&|other| other.follows) >= TOLD * whole;
    if !(follows || is_named && !wrong.follows) {
        return None;
    }
    let cause = || words.language.course_cause(&wrong.told);
    let said = match is_named {
        true if wrong.follows => Some(format!("{} {}", cause(), words.language.course_follows())),
        true => Some(cause()),
        false => None,
    };
    Some((wrong.share, Answer { percent: if follows { 100 } else { 0 }, said, ..own.clone() }))
}

/// Half a unit of the last significant digit that is asked for; of nearly nothing beside the largest number of its unit that of a thousandth of it.
fn half_digit(value: f64, largest: f64) -> f64 {
    let size = value.abs().max(1e-3 * largest).max(f64::MIN_POSITIVE);
    0.5 * libm::exp10(libm::floor(libm::log10(size)) - f64::from(DIGITS - 1))
}
