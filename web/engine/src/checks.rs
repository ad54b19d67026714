use crate::desk::Desk;
use crate::forms::measured;
use crate::refused::Refused;
use kinegon::check::{
    AnswerKey, CheckError, CheckResult, Feedback, Marks, Measured, ReportParts, check, check_result, faults, redrawn,
    report, report_parts,
};
use kinegon::construction::Tolerance;
use kinegon::drawing::{Overlay, overlay};
use kinegon::format::html_text;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a form is checked.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CheckOptions {
    /// Marking scheme, as for `kinegon check --marks`.
    pub marks: Option<String>,
    /// Tolerance of the pencil in mm; none for what the sheet shows.
    pub pencil_mm: Option<f64>,
    /// The same in degrees.
    pub pencil_degrees: Option<f64>,
    /// Whether the student's drawing and the page for the student are made, too.
    #[serde(default)]
    pub drawn: bool,
}

/// A form that was checked.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Checked {
    /// As `kinegon check --json`; none where no value is understood.
    pub result: Option<CheckResult>,
    /// As `kinegon check`.
    pub report: String,
    /// The report piece by piece.
    pub parts: Option<Parts>,
    /// Values that are not understood, by their names in the form.
    pub faults: Vec<Fault>,
    /// The student's drawing over the right one, where it was asked for.
    pub overlays: Vec<OverlaySheet>,
    /// The page that `--feedback` writes for a browser, where it was asked for.
    pub feedback: String,
    /// The marks in words, where a marking scheme was given.
    pub marks: Option<String>,
}

/// A report piece by piece; all texts but names are HTML of `<sub>`, `<sup>` and text alone.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(rename = "ReportParts")]
pub struct Parts {
    /// How many values are right, within the tolerance, off.
    pub counts: String,
    /// How much is allowed, and how accurate the drawing is.
    pub accuracy: Vec<String>,
    /// Headings of a value's cells.
    pub columns: Vec<String>,
    /// The values in the order of `result.values`.
    pub rows: Vec<PartsRow>,
    /// About rates without a sense.
    pub senses: Option<String>,
    /// The heading of the causes, or the sentence that there are none, or that none can be told.
    pub heading: String,
    /// What was probably done.
    pub causes: Vec<CauseOf>,
    /// How sure that is.
    pub sure: Option<String>,
    /// Which values nothing explains, which plans are mirrored.
    pub further: Vec<String>,
    /// What else explains the values.
    pub others: Vec<String>,
}

/// A value of a report.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PartsRow {
    /// The name of its box in the form file.
    pub name: String,
    /// Name, own value, exact value, difference, the same on paper and in per cent, what is allowed, verdict.
    pub cells: Vec<String>,
}

/// A mistake that was probably made.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CauseOf {
    /// At which step, and what was done.
    pub done: String,
    /// That step's caption.
    pub caption: Option<String>,
    /// What it should be.
    pub should: String,
    /// Which values follow from it.
    pub follows: Option<String>,
}

/// A value that is not understood.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Fault {
    /// Its name as the form has it.
    pub name: String,
    /// Why.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

/// A sheet.
#[derive(Debug, Serialize, JsonSchema)]
pub struct OverlaySheet {
    /// The sheet.
    pub svg: String,
    /// Width in mm.
    pub width: f64,
    /// Height in mm.
    pub height: f64,
}

impl From<CheckError> for Refused {
    fn from(error: CheckError) -> Refused {
        Refused { hint: error.hint.clone(), ..Refused::whole(error.to_string()) }
    }
}

impl CheckOptions {
    /// The limits of the hand's errors, if one is given.
    fn hand(&self) -> Option<Tolerance> {
        let usual = Tolerance::default();
        let given =
            Tolerance { mm: self.pencil_mm.unwrap_or(usual.mm), degrees: self.pencil_degrees.unwrap_or(usual.degrees) };
        (self.pencil_mm.is_some() || self.pencil_degrees.is_some()).then_some(given)
    }
}

impl Desk {
    /// The verdict on the values of a form; those that are not understood are told apart, and the others are checked.
    pub fn check(&mut self, text: &str, form: &str, options: &CheckOptions) -> Result<Checked, Refused> {
        let mut measured = measured(form)?;
        let given = [options.pencil_mm, options.pencil_degrees];
        if given.into_iter().flatten().any(|limit| !(0.0..=Tolerance::LARGEST).contains(&limit)) {
            let message = format!("the tolerance of a pencil is from 0 to {}", Tolerance::LARGEST);
            return Err(Refused::whole(message));
        }
        let solution = self.solution(text)?;
        let key = AnswerKey::new(solution, options.hand());
        let words = solution.wording();
        let scheme = options.marks.as_ref().map(|marks| {
            let read = Marks::read(marks).map_err(|error| Refused::of(marks, error))?;
            read.of(&key).map_err(Refused::from)
        });
        let scheme = scheme.transpose()?;
        let found = set_faults_apart(&mut measured, &key);
        if measured.values.is_empty() && measured.points.is_empty() && !found.is_empty() {
            return Ok(Checked::without_values(found));
        }
        let checked = check(&measured, &key)?;
        let marks = scheme.map(|scheme| scheme.award(&checked));
        let mut result = check_result(&checked, &key, &words, measured.name.clone());
        let mut drawn = Drawn::default();
        if options.drawn {
            let overlay = redrawn(&measured, &key, &checked, &words)?;
            drawn.overlays = sheets(&key, overlay);
            drawn.feedback = Feedback::new(&measured, &key, &checked, marks.as_ref(), &words)?.html();
        }
        let line = marks.as_ref().map(|marks| marks.line(&words));
        result.marks = marks;
        let end = line.as_ref().map_or_else(String::new, |line| format!("{line}\n"));
        Ok(Checked {
            result: Some(result),
            report: report(&checked, &key, &words) + &end,
            parts: Some(Parts::of(report_parts(&checked, &key, &words))),
            faults: found,
            overlays: drawn.overlays,
            feedback: drawn.feedback,
            marks: line,
        })
    }
}

impl Checked {
    fn without_values(faults: Vec<Fault>) -> Checked {
        Checked {
            result: None,
            report: String::new(),
            parts: None,
            faults,
            overlays: Vec::new(),
            feedback: String::new(),
            marks: None,
        }
    }
}

/// What is drawn of a checked form.
#[derive(Default)]
struct Drawn {
    overlays: Vec<OverlaySheet>,
    feedback: String,
}

/// Takes the values that are not understood out of a form.
fn set_faults_apart(measured: &mut Measured, key: &AnswerKey<'_>) -> Vec<Fault> {
    let found = faults(measured, key);
    let fault = |(place, error): &(usize, CheckError)| Fault {
        name: measured.values[*place].name.clone(),
        message: error.message.clone(),
        hint: error.hint.clone(),
    };
    let told = found.iter().map(fault).collect();
    for (place, _) in found.iter().rev() {
        measured.values.remove(*place);
    }
    told
}

/// The student's drawing over the right one, as large as the sheet allows; words and table stand on the page.
fn sheets(key: &AnswerKey<'_>, redrawn: Overlay) -> Vec<OverlaySheet> {
    let mut solution = key.solution.clone();
    let figure = &mut solution.scene.figure;
    figure.set_scales(Default::default());
    let drawn = Overlay { words: Vec::new(), values: Vec::new(), ..redrawn };
    let sheets = overlay(&solution, &drawn);
    sheets.iter().map(|sheet| OverlaySheet { svg: sheet.svg(), width: sheet.width, height: sheet.height }).collect()
}

impl Parts {
    fn of(parts: ReportParts) -> Parts {
        let html = |text: &String| html_text(&Overlay::set(text));
        let all = |texts: &[String]| texts.iter().map(html).collect();
        let rows = parts.rows.iter().map(|row| PartsRow { name: row.name.clone(), cells: all(&row.cells) });
        let causes = parts.causes.iter().map(|cause| CauseOf {
            done: html(&cause.done),
            caption: cause.caption.as_ref().map(html),
            should: html(&cause.should),
            follows: cause.follows.as_ref().map(html),
        });
        Parts {
            counts: html(&parts.counts),
            accuracy: all(&parts.accuracy),
            columns: all(&parts.columns),
            rows: rows.collect(),
            senses: parts.senses.as_ref().map(html),
            heading: html(&parts.heading),
            causes: causes.collect(),
            sure: parts.sure.as_ref().map(html),
            further: all(&parts.further),
            others: all(&parts.others),
        }
    }
}
