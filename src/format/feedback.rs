use super::svg;
use crate::drawing::{Drawing, RichText, Script};
use crate::text::{Untrusted, xml};

/// The template of the page, with `{{name}}` for its contents.
const PAGE: &str = include_str!("../../templates/feedback.html");

/// What is in every page, so that a program knows its own.
pub const FEEDBACK_MARK: &str = "kinegon-feedback";

/// What a student gets back, for a browser.
#[derive(Clone, Copy, Debug)]
pub struct FeedbackPage<'a> {
    /// The exercise's title, with the student's name.
    pub title: &'a Untrusted,
    /// Code of the page's language, as in `en`.
    pub language: &'a str,
    /// The sentences, by paragraph.
    pub words: &'a [RichText],
    /// The student's drawing over the right figure; none where nothing is to be shown.
    pub figures: &'a [Drawing],
    /// Headings of the table of values.
    pub head: &'a [RichText],
    /// Its rows, each with whether its value is off; the first cell names the value, the last has the verdict.
    pub rows: &'a [(Vec<RichText>, bool)],
}

/// One self-contained HTML file without a script, which prints on A4. The letters of figures are outlines, so that they
/// look the same everywhere.
#[must_use]
pub fn feedback_html(page: &FeedbackPage<'_>) -> String {
    let words: String = page.words.iter().map(|text| format!("<p>{}</p>\n", html_text(text))).collect();
    let figures = page.figures.iter().map(|drawing| {
        // What stands before the picture belongs to a file of its own.
        let svg = svg::svg_with(drawing, svg::Text::Outlines);
        let start = svg.find("<svg").unwrap_or(0);
        format!("<figure>\n{}</figure>\n", &svg[start..])
    });
    let cells = |texts: &[RichText], tag: &str| -> String {
        texts.iter().map(|text| format!("<{tag}>{}</{tag}>", html_text(text))).collect()
    };
    let rows = page.rows.iter().map(|(texts, is_off)| {
        let class = if *is_off { " class=\"off\"" } else { "" };
        format!("<tr{class}>{}</tr>\n", cells(texts, "td"))
    });
    let rows: String = rows.collect();
    let table = match page.rows {
        [] => String::new(),
        _ => {
            format!("<table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n", cells(page.head, "th"))
        }
    };
    let contents = [
        ("mark", FEEDBACK_MARK.to_owned()),
        ("title", page.title.for_xml()),
        ("language", xml(page.language).into_owned()),
        ("words", words),
        ("figures", figures.collect()),
        ("table", table),
    ];
    filled(PAGE, &contents)
}

/// A text as HTML: its scripts as `<sub>` and `<sup>`, slanted letters as `<i>`.
#[must_use]
pub fn html_text(text: &RichText) -> String {
    let mut written = String::new();
    for run in text.runs() {
        if run.spaced {
            written.push(' ');
        }
        let tag = |script: &Script| match script {
            Script::Sub => "sub",
            Script::Super => "sup",
        };
        run.scripts.iter().for_each(|script| written.push_str(&format!("<{}>", tag(script))));
        match run.italic {
            true => written.push_str(&format!("<i>{}</i>", xml(&run.content))),
            false => written.push_str(&xml(&run.content)),
        }
        run.scripts.iter().rev().for_each(|script| written.push_str(&format!("</{}>", tag(script))));
    }
    written
}

/// A template with `{{name}}` replaced by the contents of that name, by nothing where there are none.
fn filled(template: &str, contents: &[(&str, String)]) -> String {
    let mut parts = template.split("{{");
    let mut written = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once("}}").unwrap_or((part, ""));
        let content = contents.iter().find(|(known, _)| *known == name);
        written.push_str(content.map_or("", |(_, text)| text));
        written.push_str(rest);
    }
    written
}
