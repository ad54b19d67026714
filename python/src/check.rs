use crate::refused::Refused;
use crate::solution::{Solution, tolerance};
use kinegon::board::{DrawingResult, Given, HandDrawing, Judge, own_drawing};
use kinegon::check::{AnswerKey, Awarded, Checked, Feedback, Marks, Measured, Prepared, check_result, redrawn, report};
use kinegon::drawing::{Drawing, overlay};
use kinegon::format::json_line;
use kinegon::scene::SizeLimit;
use pyo3::FromPyObject;

/// How values are checked.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct CheckOptions {
    /// Marking scheme.
    marks: Option<String>,
    /// Limit of the hand's errors in mm.
    mm: Option<f64>,
    /// The same in degrees.
    degrees: Option<f64>,
    /// How many mistakes at once are looked for.
    depth: usize,
    /// Whether the form is known to be a table.
    is_table: bool,
}

/// A form that was checked, or the one that a drawing gives.
struct Judged<'a> {
    measured: Measured,
    drawing: Option<DrawingResult>,
    key: AnswerKey<'a>,
    checked: Checked,
    marks: Option<Awarded>,
}

impl Solution {
    /// Kinegon's own construction as a drawing.
    pub fn own_drawing(&self) -> Result<String, Refused> {
        let solution = self.by_hand()?;
        Ok(own_drawing(&Given::new(solution), &solution.scales()))
    }

    pub fn empty_form(&self, is_table: bool) -> Result<String, Refused> {
        let solution = self.by_hand()?;
        let form = Measured::empty(solution.scales(), None);
        Ok(if is_table { form.csv(solution) } else { form.json(solution) })
    }

    /// Judges a form, and hands on what was found.
    fn judged<T>(
        &self,
        form: &str,
        options: &CheckOptions,
        then: impl FnOnce(&Judged<'_>) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        if !(1..=6).contains(&options.depth) {
            return Err(Refused::new("KinegonError", "depth is from 1 to 6", None));
        }
        let hand = tolerance(options.mm, options.degrees)?;
        let shown = self.by_hand()?;
        shown.check_form().map_err(|error| self.scene.refused(error))?;
        let key_of = |solution| AnswerKey { depth: options.depth, ..AnswerKey::new(solution, hand) };
        let mut drawing = None;
        let measured = if HandDrawing::is_one(form) {
            self.allow(SizeLimit::BOARD)?;
            // A drawing is checked and marked by what it gives.
            let (judge, drawn, words) = (Judge::new(&key_of(shown)), HandDrawing::read(form)?, shown.wording());
            let judged = judge.judge(&drawn).map_err(|error| {
                let why = words.language.says(&error.message);
                Refused::new("KinegonError", format!("did.{}: {why}", error.entry), None)
            })?;
            drawing = Some(judged.result(&judge, &drawn, &words));
            judge.form(&drawn, &judged)
        } else if !options.is_table && Measured::is_json(form) {
            Measured::read_json(form)?
        } else {
            Measured::read_csv(form)?
        };
        let with_centers = measured.with_centers(shown);
        let key = key_of(with_centers.as_ref().unwrap_or(shown));
        let scheme = options.marks.as_ref().map(|text| -> Result<_, Refused> { Ok(Marks::read(text)?.of(&key)?) });
        let scheme = scheme.transpose()?;
        let prepared = Prepared::new(&key);
        let checked = if drawing.is_some() { prepared.check_drawn(&measured) } else { prepared.check(&measured) }?;
        let marks = scheme.map(|scheme| scheme.award(&checked));
        then(&Judged { measured, drawing, key, checked, marks })
    }

    /// The result as JSON, the report, and whether it is passed.
    pub fn checked(&self, form: &str, options: &CheckOptions) -> Result<(String, String, bool), Refused> {
        self.judged(form, options, |judged| judged.result())
    }

    pub fn page_for_student(&self, form: &str, options: &CheckOptions) -> Result<String, Refused> {
        self.judged(form, options, |Judged { measured, key, checked, marks, .. }| {
            Ok(Feedback::new(measured, key, checked, marks.as_ref())?.html())
        })
    }

    /// The student's points and lines over the right figure, at the student's scales.
    pub fn overlay(&self, form: &str, options: &CheckOptions) -> Result<Vec<Drawing>, Refused> {
        self.judged(form, options, |Judged { measured, key, checked, .. }| {
            let mut solution = key.solution.clone();
            solution.scene.figure.mu = measured.mu.or(solution.scene.figure.mu);
            let drawn = redrawn(measured, key, checked)?;
            Ok(overlay(&solution, &drawn))
        })
    }
}

impl Judged<'_> {
    /// The result as JSON, the report, and whether it is passed.
    fn result(&self) -> Result<(String, String, bool), Refused> {
        let Judged { measured, drawing, key, checked, marks } = self;
        let words = key.solution.wording();
        let line = marks.as_ref().map_or_else(String::new, |marks| marks.line(&words) + "\n");
        if let Some(result) = drawing {
            let report = result.report(&words) + &line;
            let mut file = serde_json::json!({ "drawing": result });
            if let Some(marks) = marks {
                file["marks"] = serde_json::json!(marks);
            }
            return Ok((json_line(&file), report, result.passed));
        }
        let mut result = check_result(checked, key, measured.name.clone());
        result.marks = *marks;
        Ok((json_line(&result), report(checked, key) + &line, checked.is_passed()))
    }
}
