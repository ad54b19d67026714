use super::html::{caption, head, number};
use super::package::{CourseError, Document, MANIFEST, document, element, empty, identifier, package, text};
use super::question::{Field, Question};
use crate::text::xml;
use crate::words::{Medium, NumberStyle};
use std::io;

/// The exercises as a QTI 1.2 package for Canvas: a quiz for each, with a numerical question for each box of its form. Each question has the
/// picture of the scheme and the sheet to print.
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
    let attributes = [("identifier", own.as_str()), ("xmlns", "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1")];
    document("manifest", &attributes, |manifest| {
        element(manifest, "metadata", &[], |metadata| {
            text(metadata, "schema", &[], "IMS Content")?;
            text(metadata, "schemaversion", &[], "1.1.3")
        })?;
        empty(manifest, "organizations", &[])?;
        element(manifest, "resources", &[], |resources| {
            for question in questions {
                resource(resources, &identifier(&question.name), "imsqti_xmlv1p2", &quiz_path(question))?;
                for file in [question.scheme_name(), question.print_name()] {
                    resource(resources, &identifier(&file), "webcontent", &file)?;
                }
            }
            Ok(())
        })
    })
}

fn resource(resources: &mut Document, name: &str, kind: &str, path: &str) -> io::Result<()> {
    let attributes = [("identifier", name), ("type", kind), ("href", path)];
    element(resources, "resource", &attributes, |resource| empty(resource, "file", &[("href", path)]))
}

fn quiz(question: &Question) -> Result<Vec<u8>, CourseError> {
    let title = question.title.for_pdf();
    document("questestinterop", &[("xmlns", "http://www.imsglobal.org/xsd/ims_qtiasiv1p2")], |root| {
        element(root, "assessment", &[("ident", &identifier(&question.name)), ("title", &title)], |quiz| {
            element(quiz, "section", &[("ident", "root_section")], |section| {
                let mut fields = question.fields.iter().zip(1..);
                fields.try_for_each(|(field, number)| item(section, question, field, number))
            })
        })
    })
}

/// A numerical question.
fn item(section: &mut Document, question: &Question, field: &Field, number: usize) -> io::Result<()> {
    let ident = format!("{}-{number}", identifier(&question.name));
    let title = format!("{number}. {}", field.name);
    let asked = head(question, FILES)
        + &format!(
            "<p>{}: <strong>{} = ?</strong> {}</p>",
            caption(question, field.sheet),
            field.label,
            xml(&field.unit)
        );
    element(section, "item", &[("ident", &ident), ("title", &title)], |item| {
        element(item, "itemmetadata", &[], |metadata| {
            element(metadata, "qtimetadata", &[], |metadata| {
                [("question_type", "numerical_question"), ("points_possible", "1")].into_iter().try_for_each(
                    |(label, entry)| {
                        element(metadata, "qtimetadatafield", &[], |metadata| {
                            text(metadata, "fieldlabel", &[], label)?;
                            text(metadata, "fieldentry", &[], entry)
                        })
                    },
                )
            })
        })?;
        element(item, "presentation", &[], |shown| {
            material(shown, &asked)?;
            element(shown, "response_str", &[("ident", "response1"), ("rcardinality", "Single")], |response| {
                element(response, "render_fib", &[("fibtype", "Decimal")], |blank| {
                    empty(blank, "response_label", &[("ident", "answer1")])
                })
            })
        })?;
        let causes = causes(question, field);
        element(item, "resprocessing", &[], |processing| conditions(processing, field, !causes.is_empty()))?;
        if causes.is_empty() {
            return Ok(());
        }
        element(item, "itemfeedback", &[("ident", WRONG)], |feedback| {
            element(feedback, "flow_mat", &[], |flow| material(flow, &causes))
        })
    })
}

/// The name that Canvas knows for what is said of every wrong number.
const WRONG: &str = "general_incorrect_fb";

fn conditions(processing: &mut Document, field: &Field, is_wrong_told: bool) -> io::Result<()> {
    element(processing, "outcomes", &[], |outcomes| {
        let score = [("maxvalue", "100"), ("minvalue", "0"), ("varname", "SCORE"), ("vartype", "Decimal")];
        empty(outcomes, "decvar", &score)
    })?;
    for answer in field.answers.iter().filter(|answer| answer.percent == 100) {
        let [value, margin] = [answer.value, answer.tolerance].map(number);
        let [least, most] = [answer.value - answer.tolerance, answer.value + answer.tolerance].map(number);
        let own = ("respident", "response1");
        element(processing, "respcondition", &[("continue", "No")], |condition| {
            element(condition, "conditionvar", &[], |variable| {
                element(variable, "or", &[], |or| {
                    text(or, "varequal", &[own, ("margintype", "absolute"), ("margin", &margin)], &value)?;
                    element(or, "and", &[], |and| {
                        text(and, "vargte", &[own], &least)?;
                        text(and, "varlte", &[own], &most)
                    })
                })
            })?;
            text(condition, "setvar", &[("action", "Set"), ("varname", "SCORE")], "100")
        })?;
    }
    if !is_wrong_told {
        return Ok(());
    }
    element(processing, "respcondition", &[("continue", "Yes")], |condition| {
        element(condition, "conditionvar", &[], |variable| empty(variable, "other", &[]))?;
        empty(condition, "displayfeedback", &[("feedbacktype", "Response"), ("linkrefid", WRONG)])
    })
}

/// Which numbers known mistakes give, as HTML, if any do; all of them are shown to everybody, so the right number with the other sense is not told.
fn causes(question: &Question, field: &Field) -> String {
    let words = &question.words;
    let other_sense = field.answers.first().map(|right| -right.value);
    let wrong = field.answers.iter().filter(|answer| Some(answer.value) != other_sense);
    let wrong = wrong.filter_map(|answer| Some((answer.value, answer.said.as_ref()?)));
    let lines = wrong.map(|(value, said)| {
        let value = format!(
            "{} {}",
            words.write(value, NumberStyle::significant(3).trimmed().in_full(-5, 12).on(Medium::Figure)),
            field.unit
        );
        format!("<li>{} {}</li>\n", xml(&words.language.course_if(&value)), xml(said))
    });
    let lines: String = lines.collect();
    if lines.is_empty() { lines } else { format!("<ul>\n{lines}</ul>") }
}

fn material(document: &mut Document, html: &str) -> io::Result<()> {
    element(document, "material", &[], |material| text(material, "mattext", &[("texttype", "text/html")], html))
}
