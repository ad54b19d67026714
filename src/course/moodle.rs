use super::package::{CourseError, Element, element, html, text};
use super::question::{Field, Question, head, linked_picture, number, read, tables};
use crate::text::xml;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The questions as Moodle XML: a category of that kind of mechanism below `Kinegon`, and in it a cloze question for each exercise, with its
/// scheme, its sheet to print, its key as general feedback, and a numerical field for each box of the form.
///
/// Source: `question/format/xml` and `question/type/multianswer` of Moodle 4.
///
/// # Errors
/// The XML cannot be written.
pub fn moodle(kind: &str, questions: &[Question]) -> Result<Vec<u8>, CourseError> {
    let kind = crate::text::clean(kind);
    let path = format!("$course$/Kinegon/{}", kind.replace('/', "//"));
    let path = element("category", &[], vec![text("text", &[], &path)]);
    let category = element("question", &[("type", "category")], vec![path]);
    let questions = questions.iter().map(|asked| question(asked, &kind));
    element("quiz", &[], [category].into_iter().chain(questions).collect()).document()
}

/// In the text of a question: the folder of its files.
const FILES: &str = "@@PLUGINFILE@@/";

fn question(question: &Question, kind: &str) -> Element {
    // Weights of Moodle are whole.
    let is_whole = question.fields.iter().all(|field| field.worth.fract() == 0.0);
    let weight = |worth: f64| libm::round(if is_whole { worth } else { 100.0 * worth });
    let asked = harmless(&head(question, FILES)) + &tables(question, &|own| field(own, weight(own.worth)));
    let key = key(question);
    let told = vec![
        html(&asked),
        file(&question.scheme_name(), &question.scheme),
        file(&question.print_name(), &question.print),
    ];
    let tags = ["Kinegon", kind].map(|tag| element("tag", &[], vec![text("text", &[], tag)]));
    let parts = vec![
        element("name", &[], vec![text("text", &[], &question.list_name())]),
        element("questiontext", &[("format", "html")], told),
        element("generalfeedback", &[("format", "html")], vec![html(&key), file(&question.key_name(), &question.key)]),
        text("penalty", &[], "0.3333333"),
        text("hidden", &[], "0"),
        text("idnumber", &[], &question.name),
        element("tags", &[], tags.into()),
    ];
    element("question", &[("type", "cloze")], parts)
}

/// The key: its picture, and all values with what a careful hand may be off by.
fn key(question: &Question) -> String {
    let words = &question.words;
    let cell = |field: &Field| {
        let right = field.answers.first().map_or(0.0, |right| right.value);
        let [right, allowed] = [(right, 4), (field.allowed, 2)].map(|(value, digits)| read(value, "", digits, words));
        xml(&format!("{}\u{a0}±\u{a0}{}", right.trim_end(), allowed.trim_end())).into_owned()
    };
    let picture = linked_picture(&(FILES.to_owned() + &question.key_name()), words.language.course_key(), 900);
    format!("{picture}{}<p>{}</p>\n", tables(question, &cell), xml(words.language.exercise_allowed()))
}

fn file(name: &str, bytes: &[u8]) -> Element {
    text("file", &[("name", name), ("path", "/"), ("encoding", "base64")], &STANDARD.encode(bytes))
}

/// The field of a cloze question, as `{2:NUMERICAL:=-3.00113:0.0616~%0%3.00113:0.0616#other sense}`; before the kind its weight.
fn field(field: &Field, weight: f64) -> String {
    let answers = field.answers.iter().map(|answer| {
        let part = match answer.percent {
            100 => "=".to_owned(),
            part => format!("%{part}%"),
        };
        let said = answer.said.as_ref().map(|said| format!("#{}", feedback(said)));
        format!("{part}{}:{}{}", number(answer.value), number(answer.tolerance), said.unwrap_or_default())
    });
    format!("{{{weight}:NUMERICAL:{}}}", answers.collect::<Vec<String>>().join("~"))
}

/// A text of HTML in which nothing opens or ends a field.
fn harmless(html: &str) -> String {
    html.replace('{', "&#123;").replace('}', "&#125;")
}

/// A text as feedback in a field. Moodle takes one layer of entities off; what is left is HTML.
fn feedback(text: &str) -> String {
    let mut written = String::new();
    for letter in xml(text).chars() {
        match letter {
            '&' => written.push_str("&amp;"),
            '{' | '}' | '~' | '#' | '\\' | '=' | '%' => written.push_str(&format!("&#{};", u32::from(letter))),
            letter => written.push(letter),
        }
    }
    written
}
