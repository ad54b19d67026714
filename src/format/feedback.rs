use super::svg;
use crate::drawing::{Drawing, Overlay, RichText, Script};
use crate::text::{Untrusted, xml};

/// The template of the page, with `{{name}}` for its contents.
const PAGE: &str = include_str!("../../templates/feedback.html");

/// What is in every page, so that a program knows its own.
pub const FEEDBACK_MARK: &str = "kinegon-feedback";

/// One self-contained HTML file without a script, which prints on A4. The letters of figures are outlines, so that they
/// look the same everywhere.
///
/// `figures` show the student's drawing over the right figure; words and values are those of `overlay`. `language` is the
/// code of the page's, as in `en`.
#[must_use]
pub fn feedback_html(title: &Untrusted, language: &str, figures: &[Drawing], overlay: &Overlay) -> String {
    let html = |text: &String| html_text(&Overlay::set(text));
    let words: String = overlay.words.iter().map(|text| format!("<p>{}</p>\n", html(text))).collect();
    let figures = figures.iter().map(|drawing| {
        // What stands before the picture belongs to a file of its own.
        let svg = svg::svg_with(drawing, svg::Text::Outlines);
        let start = svg.find("<svg").unwrap_or(0);
        format!("<figure>\n{}</figure>\n", &svg[start..])
    });
    let cells = |texts: &[String], tag: &str| -> String {
        texts.iter().map(|text| format!("<{tag}>{}</{tag}>", html(text))).collect()
    };
    let rows = overlay.values.iter().map(|value| {
        let class = if value.is_off { " class=\"off\"" } else { "" };
        format!("<tr{class}>{}</tr>\n", cells(&value.cells, "td"))
    });
    let rows: String = rows.collect();
    let table = if rows.is_empty() {
        rows
    } else {
        let head = cells(&overlay.head, "th");
        format!("<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n")
    };
    let contents = [
        ("mark", FEEDBACK_MARK.to_owned()),
        ("title", overlay.titled(title).for_xml()),
        ("language", xml(language).into_owned()),
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
