use crate::desk::Desk;
use crate::refused::Refused;
use kinegon::check::says;
use kinegon::check::{
    AnswerKey, CheckError, CheckResult, Feedback, Marks, Measured, ReportParts, check, check_result, faults, redrawn,
    report, report_parts,
};
use kinegon::construction::Tolerance;
use kinegon::drawing::{Overlay, overlay};
use kinegon::format::html_text;
use kinegon::words::Language;
use kinegon::{Message, Problem};
use serde::{Deserialize, Serialize};

/// How a form is checked.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
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
#[derive(Debug, Default, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Checked {
    /// As `kinegon check --json`; none where no value is understood.
    pub result: Option<CheckResult>,
    /// As `kinegon check`.
    pub report: String,
    /// The report piece by piece; all texts but names are HTML of `<sub>`, `<sup>` and text alone.
    pub parts: Option<ReportParts>,
    /// Values that are not understood, by their names in the form.
    pub faults: Vec<Fault>,
    /// The student's drawing over the right one, where it was asked for.
    pub overlays: Vec<SheetPicture>,
    /// The page that `--feedback` writes for a browser, where it was asked for.
    pub feedback: String,
    /// The marks in words, where a marking scheme was given.
    pub marks: Option<String>,
}

/// A value that is not understood.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Fault {
    /// Its name as the form has it.
    pub name: String,
    /// Why.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
}

/// A sheet of paper.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct SheetPicture {
    /// The picture; one unit of it is a millimetre of the sheet.
    pub svg: String,
    /// Width in mm.
    pub width: f64,
    /// Height in mm.
    pub height: f64,
}

impl From<CheckError> for Refused {
    fn from(error: CheckError) -> Refused {
        let message = Message::list([error.place, error.message], "");
        Refused::whole(Problem { message, hint: error.hint })
    }
}

/// The values of a form: JSON or a table.
pub fn measured(text: &str) -> Result<Measured, Refused> {
    if Measured::is_json(text) {
        Measured::read_json(text).map_err(|error| Refused::of(text, error))
    } else {
        Measured::read_csv(text).map_err(Refused::from)
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
            return Err(Refused::whole(says::tolerance(Tolerance::LARGEST)));
        }
        let language = self.language();
        let told = self.told(text)?;
        told.check_form().map_err(|error| Refused::of(text, error))?;
        let with_centers = measured.with_centers(&told);
        let solution = with_centers.as_ref().unwrap_or(&told);
        let key = AnswerKey::new(solution, options.hand());
        let words = solution.wording();
        let scheme = options.marks.as_ref().map(|marks| {
            let read = Marks::read(marks).map_err(|error| Refused::of(marks, error))?;
            read.of(&key).map_err(Refused::from)
        });
        let scheme = scheme.transpose()?;
        let found = set_faults_apart(&mut measured, &key, language);
        if measured.values.is_empty() && measured.points.is_empty() && !found.is_empty() {
            return Ok(Checked { faults: found, ..Checked::default() });
        }
        let checked = check(&measured, &key)?;
        let marks = scheme.map(|scheme| scheme.award(&checked));
        let mut result = check_result(&checked, &key, measured.name.clone());
        let (mut overlays, mut feedback) = (Vec::new(), String::new());
        // The component shows neither, and does without what draws them.
        let is_workbench = cfg!(feature = "workbench");
        if is_workbench && options.drawn {
            overlays = sheets(&key, redrawn(&measured, &key, &checked)?);
            feedback = Feedback::new(&measured, &key, &checked, marks.as_ref())?.html();
        }
        let line = marks.as_ref().map(|marks| marks.line(&words));
        result.marks = marks;
        let end = line.as_ref().map_or_else(String::new, |line| format!("{line}\n"));
        Ok(Checked {
            result: Some(result),
            report: report(&checked, &key) + &end,
            parts: is_workbench.then(|| report_parts(&checked, &key).set(|text| html_text(&Overlay::set(&text)))),
            faults: found,
            overlays,
            feedback,
            marks: line,
        })
    }
}

/// Takes the values that are not understood out of a form.
fn set_faults_apart(measured: &mut Measured, key: &AnswerKey<'_>, language: &Language) -> Vec<Fault> {
    let found = faults(measured, key);
    let fault = |(place, error): &(usize, CheckError)| Fault {
        name: measured.values[*place].name.clone(),
        message: language.says(&error.message),
        hint: error.hint.as_ref().map(|hint| language.says(hint)),
    };
    let told = found.iter().map(fault).collect();
    for (place, _) in found.iter().rev() {
        measured.values.remove(*place);
    }
    told
}

/// The student's drawing over the right one, as large as the sheet allows; words and table stand on the page.
fn sheets(key: &AnswerKey<'_>, redrawn: Overlay) -> Vec<SheetPicture> {
    let mut solution = key.solution.clone();
    let figure = &mut solution.scene.figure;
    figure.mu = Default::default();
    let drawn = Overlay { words: Vec::new(), values: Vec::new(), ..redrawn };
    let sheets = overlay(&solution, &drawn);
    sheets.iter().map(|sheet| SheetPicture { svg: sheet.svg(), width: sheet.width, height: sheet.height }).collect()
}
