use super::package::{CourseError, MANIFEST, element, identifier, package, text};
use super::question::Question;
use crate::format::workbench;
use crate::text::xml;
use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde_json::{Value, json};
use std::io::{self, Write};

/// The page that a course opens: it chooses an exercise for the student, tells it and has the workbench below.
const START: &str = include_str!("../../templates/scorm.html");

/// What others have made and the workbench contains, with their licences; `.ci/notices/make` writes it.
const NOTICES: &str = include_str!("../../templates/workbench-third-party.txt");

/// The names in the package of that page, of the workbench, and of what others have made.
const PAGE: &str = "index.html";
const WORKBENCH: &str = "workbench.html";
const THIRD_PARTY: &str = "THIRD-PARTY.txt";

/// The exercises as a SCORM 1.2 package: the workbench as a student gets it, with one of the exercises, the same for a student each time, and
/// what is given above it. After each check it reports how much of the form is right; with `pass`, in per cent of the marks, that is passed or
/// failed. There is no key in it.
///
/// Source: ADL, *SCORM 1.2 Content Aggregation Model* and *Run-Time Environment*.
///
/// # Errors
/// The package cannot be written.
pub fn scorm(kind: &str, questions: &[Question], pass: Option<u8>) -> Result<Vec<u8>, CourseError> {
    let exercises: io::Result<String> = questions.iter().map(exercise).collect();
    let page = START.replace("{{exercises}}", &exercises?);
    let mut files = vec![
        (MANIFEST.to_owned(), manifest(kind, questions, pass)?),
        (PAGE.to_owned(), page.into_bytes()),
        (WORKBENCH.to_owned(), workbench(None).into_bytes()),
        (THIRD_PARTY.to_owned(), NOTICES.into()),
    ];
    files.extend(questions.iter().map(|question| (question.print_name(), question.print.clone())));
    package(&files)
}

/// What the page tells of an exercise, hidden until it is chosen.
fn exercise(question: &Question) -> io::Result<String> {
    let told: String = question.told.iter().map(|told| format!("<p>{told}</p>\n")).collect();
    Ok(format!(
        "<details open hidden data-link=\"{}\">\n<summary>{}</summary>\n{told}<p><a href=\"{}\" target=\"_blank\">{}</a></p>\n</details>\n",
        link(question)?,
        question.title.for_xml(),
        question.print_name(),
        xml(question.words.language.course_print()),
    ))
}

/// The part of the workbench's address behind # that a student gets (`web/page/state/address.ts`), with the exercise and its empty form.
fn link(question: &Question) -> io::Result<String> {
    let shared = json!({ "text": question.scene, "form": begun(&question.form), "panel": "check", "student": true });
    let mut packed = DeflateEncoder::new(Vec::new(), Compression::best());
    packed.write_all(shared.to_string().as_bytes())?;
    Ok(format!("1={}", URL_SAFE_NO_PAD.encode(packed.finish()?)))
}

/// The form as a student begins with it (`web/page/panels/check/form.ts`): lengths in mm of paper, and senses chosen value by value.
fn begun(form: &str) -> String {
    let mut form: Value = serde_json::from_str(form).unwrap_or_default();
    if let Some(entries) = form.as_object_mut() {
        entries.shift_remove("positive");
        let values = entries.shift_remove("values");
        entries.insert("in".to_owned(), json!("mm"));
        entries.extend(values.map(|values| ("values".to_owned(), values)));
    }
    crate::format::json(&form)
}

fn manifest(kind: &str, questions: &[Question], pass: Option<u8>) -> Result<Vec<u8>, CourseError> {
    let title = match questions {
        [one] => one.title.for_pdf(),
        _ => crate::text::clean(kind),
    };
    let own = identifier(questions.first().map_or("", |question| question.name.as_str()));
    let attributes = [
        ("identifier", own.as_str()),
        ("version", "1.0"),
        ("xmlns", "http://www.imsproject.org/xsd/imscp_rootv1p1p2"),
        ("xmlns:adlcp", "http://www.adlnet.org/xsd/adlcp_rootv1p2"),
    ];
    let metadata = vec![text("schema", &[], "ADL SCORM"), text("schemaversion", &[], "1.2")];
    let item = [("identifier", "exercise"), ("identifierref", "page")];
    let pass = pass.map(|percent| text("adlcp:masteryscore", &[], &percent.to_string()));
    let item = element("item", &item, [text("title", &[], &title)].into_iter().chain(pass).collect());
    let course = vec![text("title", &[], &title), item];
    let course = element("organization", &[("identifier", "course")], course);
    let sheets = questions.iter().map(Question::print_name);
    let files = [PAGE, WORKBENCH, THIRD_PARTY].map(str::to_owned).into_iter().chain(sheets);
    let files = files.map(|file| element("file", &[("href", &file)], Vec::new())).collect();
    let page = [("identifier", "page"), ("type", "webcontent"), ("adlcp:scormtype", "sco"), ("href", PAGE)];
    let parts = vec![
        element("metadata", &[], metadata),
        element("organizations", &[("default", "course")], vec![course]),
        element("resources", &[], vec![element("resource", &page, files)]),
    ];
    element("manifest", &attributes, parts).document()
}
