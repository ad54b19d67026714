use super::package::{CourseError, Element, MANIFEST, element, identifier, package, text};
use super::question::{Field, Question, head, number, read};
use crate::text::xml;

/// The exercises as a QTI 1.2 package for Canvas: a quiz for each, first a text with the picture of the scheme and the sheet to print, then a
/// numerical question for each box of its form.
///
/// Canvas gives all marks or none for a number, and says the same of every wrong one: so what known mistakes give is listed there.
///
/// Source: 1EdTech, *QTI 1.2 ASI XML binding*; the importer of Canvas (`gems/plugins/qti_exporter`).
///
/// # Errors
/// The package cannot be written.
pub fn canvas(questions: &[Question]) -> Result<Vec<u8>, CourseError> {
    let mut files = vec![(MANIFEST.to_owned(), manifest(questions)?)];
    for question in questions {
        files.push((quiz_path(question), quiz(question)?));
        files.push((question.scheme_name(), question.scheme.clone()));
        files.push((question.print_name(), question.print.clone()));
    }
    package(&files)
}

/// In the text of a question: the folder of the package's files.
const FILES: &str = "%24IMS-CC-FILEBASE%24/";

fn quiz_path(question: &Question) -> String {
    format!("{0}/{0}.xml", question.name)
}

fn manifest(questions: &[Question]) -> Result<Vec<u8>, CourseError> {
    let own = identifier(questions.first().map_or("", |question| question.name.as_str()));
    let mut resources = Vec::new();
    for question in questions {
        resources.push(resource(&question.name, "imsqti_xmlv1p2", &quiz_path(question)));
        resources
            .extend([question.scheme_name(), question.print_name()].map(|file| resource(&file, "webcontent", &file)));
    }
    let metadata = vec![text("schema", &[], "IMS Content"), text("schemaversion", &[], "1.1.3")];
    let parts = vec![
        element("metadata", &[], metadata),
        element("organizations", &[], Vec::new()),
        element("resources", &[], resources),
    ];
    let attributes = [("identifier", own.as_str()), ("xmlns", "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1")];
    element("manifest", &attributes, parts).document()
}

fn resource(name: &str, kind: &str, path: &str) -> Element {
    let file = element("file", &[("href", path)], Vec::new());
    element("resource", &[("identifier", &identifier(name)), ("type", kind), ("href", path)], vec![file])
}

fn quiz(question: &Question) -> Result<Vec<u8>, CourseError> {
    let items = question.fields.iter().zip(1..).map(|(field, number)| item(question, field, number));
    let section = element("section", &[("ident", "root_section")], [told(question)].into_iter().chain(items).collect());
    let (ident, title) = (identifier(&question.name), question.list_name());
    let quiz = element("assessment", &[("ident", &ident), ("title", &title)], vec![section]);
    element("questestinterop", &[("xmlns", "http://www.imsglobal.org/xsd/ims_qtiasiv1p2")], vec![quiz]).document()
}

/// What Canvas is to know of a question: its type, and its points.
fn about(kind: &str, points: f64) -> Element {
    let about = [("question_type", kind), ("points_possible", &points.to_string())].map(|(label, entry)| {
        element("qtimetadatafield", &[], vec![text("fieldlabel", &[], label), text("fieldentry", &[], entry)])
    });
    element("itemmetadata", &[], vec![element("qtimetadata", &[], about.into())])
}

/// What is given, before the questions.
fn told(question: &Question) -> Element {
    let ident = format!("{}-0", identifier(&question.name));
    let shown = element("presentation", &[], vec![material(&head(question, FILES))]);
    element(
        "item",
        &[("ident", &ident), ("title", &question.title.for_pdf())],
        vec![about("text_only_question", 0.0), shown],
    )
}

/// A numerical question.
fn item(question: &Question, field: &Field, number: usize) -> Element {
    let ident = format!("{}-{number}", identifier(&question.name));
    let title = format!("{number:02}. {}", field.name);
    let (sheet, label, unit) = (xml(question.words.language.sheet(field.sheet)), &field.label, xml(&field.unit));
    let asked = format!("<p>{sheet}: <strong>{label} = ?</strong> {unit}</p>");
    let blank = element("response_label", &[("ident", "answer1")], Vec::new());
    let blank = element("render_fib", &[("fibtype", "Decimal")], vec![blank]);
    let response = element("response_str", &[("ident", "response1"), ("rcardinality", "Single")], vec![blank]);
    let causes = causes(question, field);
    let mut parts = vec![
        about("numerical_question", field.worth),
        element("presentation", &[], vec![material(&asked), response]),
        element("resprocessing", &[], conditions(field, !causes.is_empty())),
    ];
    if !causes.is_empty() {
        let told = element("flow_mat", &[], vec![material(&causes)]);
        parts.push(element("itemfeedback", &[("ident", WRONG)], vec![told]));
    }
    element("item", &[("ident", &ident), ("title", &title)], parts)
}

/// The name that Canvas knows for what is said of every wrong number.
const WRONG: &str = "general_incorrect_fb";

fn conditions(field: &Field, is_wrong_told: bool) -> Vec<Element> {
    let score = [("maxvalue", "100"), ("minvalue", "0"), ("varname", "SCORE"), ("vartype", "Decimal")];
    let mut conditions = vec![element("outcomes", &[], vec![element("decvar", &score, Vec::new())])];
    for answer in field.answers.iter().filter(|answer| answer.percent == 100) {
        let [value, margin] = [answer.value, answer.tolerance].map(number);
        let [least, most] = [answer.value - answer.tolerance, answer.value + answer.tolerance].map(number);
        let own = ("respident", "response1");
        let near = text("varequal", &[own, ("margintype", "absolute"), ("margin", &margin)], &value);
        let between = element("and", &[], vec![text("vargte", &[own], &least), text("varlte", &[own], &most)]);
        let is_right = element("conditionvar", &[], vec![element("or", &[], vec![near, between])]);
        let marks = text("setvar", &[("action", "Set"), ("varname", "SCORE")], "100");
        conditions.push(element("respcondition", &[("continue", "No")], vec![is_right, marks]));
    }
    if is_wrong_told {
        let is_other = element("conditionvar", &[], vec![element("other", &[], Vec::new())]);
        let told = element("displayfeedback", &[("feedbacktype", "Response"), ("linkrefid", WRONG)], Vec::new());
        conditions.push(element("respcondition", &[("continue", "Yes")], vec![is_other, told]));
    }
    conditions
}

/// Which numbers known mistakes give, as HTML, if any do; all of them are shown to everybody, so the right number with the other sense is not told.
fn causes(question: &Question, field: &Field) -> String {
    let words = &question.words;
    let other_sense = field.answers.first().map(|right| -right.value);
    let wrong = field.answers.iter().filter(|answer| answer.percent == 0 && Some(answer.value) != other_sense);
    let wrong = wrong.filter_map(|answer| Some((answer.value, answer.said.as_ref()?)));
    let lines = wrong.map(|(value, said)| {
        let value = read(value, &field.unit, 3, words);
        format!("<li>{} {}</li>\n", xml(&words.language.course_if(&value)), xml(said))
    });
    let lines: String = lines.collect();
    if lines.is_empty() { lines } else { format!("<ul>\n{lines}</ul>") }
}

fn material(html: &str) -> Element {
    element("material", &[], vec![text("mattext", &[("texttype", "text/html")], html)])
}
