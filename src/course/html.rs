//! What questions show, as HTML.

use super::question::{Field, Question};
use crate::sheet::Sheet;
use crate::text::xml;

/// A number in digits that every importer reads: nine significant ones, with a point, without an exponent.
pub(super) fn number(x: f64) -> String {
    let rounded: f64 = format!("{x:.8e}").parse().unwrap_or(x);
    (rounded + 0.0).to_string()
}

/// The picture of the scheme and what is told, with `address` in front of the files' names.
pub(super) fn head(question: &Question, address: &str) -> String {
    let language = question.words.language;
    let print = address.to_owned() + &question.print_name();
    let title = question.title.for_xml();
    let mut html = format!("<p><strong>{title}</strong></p>\n");
    html += &picture(&(address.to_owned() + &question.scheme_name()), language.course_picture(), 600);
    html += &format!("<p><a href=\"{print}\">{}</a></p>\n", xml(language.course_print()));
    question.told.iter().for_each(|told| html += &format!("<p>{told}</p>\n"));
    html
}

/// A picture with its address, `width` pixels wide where the page is.
pub(super) fn picture(address: &str, said: &str, width: u16) -> String {
    // A class of the Bootstrap that Moodle has: no picture is wider than the page.
    format!("<p><img src=\"{address}\" alt=\"{}\" width=\"{width}\" class=\"img-fluid\"></p>\n", xml(said))
}

/// The fields as tables, one for each sheet; `cell` writes the box of a field.
pub(super) fn tables(question: &Question, cell: &dyn Fn(&Field) -> String) -> String {
    let mut html = String::new();
    for sheet in Sheet::ALL {
        let fields: Vec<&Field> = question.fields.iter().filter(|field| field.sheet == sheet).collect();
        if fields.is_empty() {
            continue;
        }
        html += &format!(
            "<p><strong>{}</strong></p>\n<table class=\"table table-sm w-auto\">\n<tbody>\n",
            caption(question, sheet)
        );
        for field in fields {
            let (label, unit) = (&field.label, xml(&field.unit));
            html += &format!("<tr><th scope=\"row\">{label}</th><td>{}</td><td>&nbsp;{unit}</td></tr>\n", cell(field));
        }
        html += "</tbody>\n</table>\n";
    }
    html
}

/// The name of a sheet.
pub(super) fn caption(question: &Question, sheet: Sheet) -> String {
    let language = question.words.language;
    xml(language.sheet(sheet))
}

impl Question {
    /// The name of the file of the scheme's picture.
    pub(super) fn scheme_name(&self) -> String {
        format!("{}-scheme.svg", self.name)
    }

    /// The name of the file of the sheet to print.
    pub(super) fn print_name(&self) -> String {
        format!("{}-sheet.{}", self.name, if cfg!(feature = "pdf") { "pdf" } else { "svg" })
    }

    /// The name of the file of the key's picture.
    pub(super) fn key_name(&self) -> String {
        format!("{}-key.svg", self.name)
    }
}
