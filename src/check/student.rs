//! Drawings with mistakes made on purpose: for tests of the check, and for exercises in finding mistakes.

use super::entry::{Entry, entries};
use super::measured::{AnswerKey, CheckError, Given, Measured, ON_PAPER};
use super::mistakes::{Candidate, Mistake, Site};
use super::model::{Model, in_order};
use super::names::{Names, asked_names, form_names, is_arm};
use super::report::told_alone;
use super::search::other_modes;
use crate::construction::{Change, Disturbance, Tolerance};
use crate::quantity::QuantityKind;

/// A simulated student who draws a scene and fills in the whole form.
pub struct Student<'a> {
    key: &'a AnswerKey<'a>,
    models: Vec<Model>,
    names: Vec<String>,
    entries: Vec<Entry>,
}

impl<'a> Student<'a> {
    /// A student who draws at the scales of the scene's figure.
    ///
    /// # Errors
    /// The figure lacks a sheet.
    pub fn new(key: &'a AnswerKey<'a>) -> Result<Student<'a>, CheckError> {
        let mu = key.scales;
        let mut names = form_names(&key.solution.construction);
        names.extend(asked_names(key.solution).into_iter().filter(|name| is_arm(name)));
        // A form filled with zeros gives the entries of all quantities.
        let blank = |name: &String| Given { name: name.clone(), text: "0".to_owned(), unit: None, place: name.into() };
        let form = Measured { mu, values: names.iter().map(blank).collect(), ..Measured::default() };
        let entries = entries(&form, key)?;
        let names = entries.iter().map(|entry| entry.asked.name().to_owned()).collect();
        let mut models = vec![Model::new(key, key.solution, mu, &entries)?];
        models.extend(other_modes(key, mu, &entries));
        Ok(Student { key, models, names, entries })
    }

    /// All places where a mistake of drawing, measuring or computing can be made; none for slips of writing, which need
    /// a written value first.
    #[must_use]
    pub fn ways(&self, mistake: Mistake) -> Vec<Candidate> {
        let (model, entries, other_modes) = (&self.models[0], &self.entries, self.models.len() - 1);
        let site = Site { model, key: self.key, entries, tolerances: &[], other_modes };
        let mut all = site.of(mistake);
        all.retain(|c| c.reinterpreted.is_empty() || mistake == Mistake::Truncated);
        all
    }

    /// The filled form of a drawing with these mistakes: lengths to a tenth of a millimetre of paper, rates to four
    /// digits. With a wrong scale among the mistakes lengths are written as values, not in millimetres.
    ///
    /// `hand` are the limits of errors in millimetres and degrees; `noise` gives numbers between −1 and 1, by which
    /// each error's limit is multiplied. `passed_on` are wrong values that later operations use, each with its index in
    /// the form.
    pub fn draw(
        &self,
        mistakes: &[&Candidate],
        hand: [f64; 2],
        noise: &mut dyn FnMut() -> f64,
        passed_on: &[(usize, f64)],
    ) -> Measured {
        let mode = mistakes.iter().map(|c| c.mode).max().unwrap_or(0);
        let model = &self.models[mode];
        let mut all: Vec<Disturbance> = mistakes.iter().flat_map(|c| &c.edits).cloned().collect();
        let limits = Tolerance { mm: hand[0], degrees: hand[1] };
        for (operation, which, limit, _) in model.errors(&limits) {
            all.push(Disturbance { operation, change: Change::Error(which, limit * noise()) });
        }
        for &(entry, value) in passed_on {
            if let Ok(reading) = model.readings[entry]
                && let Some(operation) = model.makers[reading.number.0]
            {
                let value = libm::copysign(value, model.exact.number(reading.number));
                all.push(Disturbance { operation, change: Change::Written(reading.number, value) });
            }
        }
        all.sort_by_key(|d| d.operation);
        let read = model.read(&model.replay(&all));
        let cuts_off = mistakes.iter().any(|c| c.mistake() == Mistake::Truncated);
        // A wrong scale shows only in values converted from millimetres.
        let in_units = mistakes.iter().any(|c| c.mistake() == Mistake::WrongScale);
        let values = self.entries.iter().zip(read).zip(&model.readings);
        let values = values.filter_map(|((entry, value), reading)| {
            let reading = reading.ok()?;
            let is_unsigned = reading.is_size();
            let value = if is_unsigned { value.abs() } else { value };
            let (text, on_paper) = match (entry.per_mm, entry.asked.kind()) {
                (Some(mu), _) if is_unsigned && !in_units => (digits(value / mu, 1, cuts_off), true),
                (_, QuantityKind::Angle) => (digits(value, 1, cuts_off), false),
                _ => (four_digits(value, cuts_off), false),
            };
            value.is_finite().then(|| Given {
                name: format!("{}{}", entry.asked.name(), if on_paper { ON_PAPER } else { "" }),
                text: signed(text, is_unsigned),
                unit: None,
                place: entry.asked.name().into(),
            })
        });
        Measured { mu: self.key.scales, values: values.collect(), ..Measured::default() }
    }

    /// The values of the form, in its order, of a drawing without errors of the hand but with this mistake; `None` for a
    /// value that is not drawn or that the mistake makes infinite. A size has no sign.
    #[must_use]
    pub fn exact(&self, mistake: Option<&Candidate>) -> Vec<Option<f64>> {
        let model = &self.models[mistake.map_or(0, |candidate| candidate.mode)];
        let changes = in_order(mistake.iter().flat_map(|candidate| &candidate.edits));
        let read = model.read(&model.replay(&changes)).into_iter().zip(&model.readings);
        read.map(|(value, reading)| {
            let reading = reading.ok()?;
            let value = if reading.is_size() { value.abs() } else { value };
            value.is_finite().then_some(value)
        })
        .collect()
    }

    /// Whether the quantity at this place of the form is read as a size, without a sign.
    #[must_use]
    pub fn is_size(&self, place: usize) -> bool {
        self.models[0].readings[place].is_ok_and(|reading| reading.is_size())
    }

    /// The number of the step that gives the quantity at this place of the form.
    #[must_use]
    pub fn step(&self, place: usize) -> usize {
        self.entries[place].step
    }

    /// What the check says of a mistake: at which step what was done, and what should have been.
    #[must_use]
    pub fn told(&self, mistake: &Candidate) -> [String; 2] {
        told_alone(mistake, &Names::new(self.key.solution), &self.key.solution.wording())
    }

    /// The names of the form's quantities.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The index in the form of a written quantity, and whether later operations use its value. Of several names for
    /// one number the first counts.
    #[must_use]
    pub fn place(&self, given: &Given) -> Option<(usize, bool)> {
        let name = given.name.trim_end_matches(ON_PAPER);
        let place = self.entries.iter().position(|e| e.asked.name() == name)?;
        let readings = &self.models[0].readings;
        let number = readings[place].ok()?.number;
        let first = readings.iter().position(|r| r.is_ok_and(|r| r.number == number))?;
        Some((first, self.models[0].used[number.0]))
    }

    /// The scene's unit of a written value; `None` for millimetres of paper.
    #[must_use]
    pub fn unit(&self, given: &Given) -> Option<String> {
        let entry = self.entries.iter().find(|e| e.asked.name() == given.name)?;
        Some(entry.asked.kind().unit(self.key.solution.scene.units))
    }

    /// The factor from a written number to the value in the scene's units.
    #[must_use]
    pub fn factor(&self, given: &Given) -> Option<f64> {
        let form = Measured { mu: self.key.scales, values: vec![given.clone()], ..Measured::default() };
        Some(entries(&form, self.key).ok()?.first()?.factor)
    }
}

/// A signed number with its plus or minus; a size without.
fn signed(text: String, is_unsigned: bool) -> String {
    if is_unsigned || text.starts_with('-') { text } else { format!("+{text}") }
}

/// A number with `decimals` decimals, rounded or cut off.
fn digits(value: f64, decimals: i32, cuts_off: bool) -> String {
    let unit = libm::exp10(f64::from(-decimals));
    let value = if cuts_off { libm::trunc(value / unit) * unit } else { value };
    format!("{value:.0$}", decimals as usize)
}

fn four_digits(value: f64, cuts_off: bool) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::floor(libm::log10(value.abs())) as i32;
    digits(value, (3 - exponent).max(0), cuts_off)
}
