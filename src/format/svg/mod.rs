//! SVG: a sheet as one file, its panels alone, or a group for each step (`mod.rs`); marks in groups (`marks.rs`), shapes
//! (`shapes.rs`) and texts (`letters.rs`).

mod letters;
mod marks;
mod shapes;

use super::number::number;
use crate::drawing::{Drawing, Mark, Pen};
use crate::text::xml;
use kurbo::Rect;
pub use marks::Text;
use marks::{Drawn, body, drawn, write_marks};
use shapes::attribute;
use std::collections::BTreeMap;
use std::fmt::Write;
use svg::Node;
use svg::node::Blob;
use svg::node::element::Element;

impl Drawing {
    /// The drawing as the text of an SVG file, with its texts as letters: [`svg_with`] has other forms.
    pub fn svg(&self) -> String {
        svg_with(self, Text::Letters)
    }
}

/// The drawing as the text of an SVG file: true to scale in mm, one group for consecutive marks of one pen.
///
/// Looks are attributes of groups, because some programs ignore style sheets. Texts as letters name the bundled font
/// first and are set run by run at measured places, so that they look the same wherever that font is installed, and
/// nearly so elsewhere. Marks whose numbers are not finite are left out.
pub fn svg_with(drawing: &Drawing, text: Text) -> String {
    document(drawing, text, body(drawing, text), whole(drawing))
}

/// The panels of a drawing, without the title, tables and sentences around them, at the same scale: for pages that say these themselves. No mark
/// has a name. A drawing without panels is shown whole.
pub fn panels_svg(drawing: &Drawing, text: Text) -> String {
    let boxes = || drawing.panels.iter().map(|(_, area)| *area);
    let Some(area) = boxes().reduce(|all, area| all.union(area)) else {
        return svg_with(drawing, text);
    };
    let mut shown = drawing.clone();
    shown.marks.retain(|mark| boxes().any(|area| area.contains(mark.shape.drawn_box().center())));
    shown.marks.iter_mut().for_each(|mark| mark.id = None);
    document(drawing, text, body(&shown, text), area.inflate(WHITE, WHITE))
}

/// White around panels that stand alone, in mm: their frames are as wide as elsewhere.
const WHITE: f64 = 0.5;

/// The box of a whole sheet.
fn whole(drawing: &Drawing) -> Rect {
    Rect::new(0.0, 0.0, drawing.width, drawing.height)
}

/// As [`svg_with`], with a group for each step of the construction, `step-01` and so on, around the marks that it
/// draws; the group's title is the step's caption. Marks that must lie below earlier ones (areas, cut lines) are in a
/// second group `step-01-under`.
///
/// With all groups shown the file looks like the finished figure.
pub fn layered_svg(drawing: &Drawing, text: Text) -> String {
    document(drawing, text, groups(drawing, text), whole(drawing))
}

/// The marks with a group for each pile of marks that come and go together, from the lowest to the highest; those that
/// are shown in one step only are left out. Groups `step-03-until-07` with what later marks replace are hidden: all
/// groups together are the finished figure.
fn groups(drawing: &Drawing, text: Text) -> String {
    let lies_below = |mark: &Mark| matches!(mark.pen, Pen::LinkFill | Pen::ImageFill | Pen::Construction | Pen::Hint);
    // By whether they lie above, the step that draws them, and the step from which later marks stand in their place.
    let mut piles: BTreeMap<(bool, u16, Option<u16>), Vec<Drawn<'_>>> = BTreeMap::new();
    for (mark, has_halo) in drawn(drawing).into_iter().filter(|(mark, _)| !mark.passing) {
        piles.entry((!lies_below(mark), mark.since, mark.until)).or_default().push((mark, has_halo));
    }
    let digits = drawing.steps.len().to_string().len().max(2);
    let mut written = String::new();
    for ((is_above, step, until), marks) in piles {
        if step == 0 {
            write_marks(&mut written, drawing, text, &marks);
            continue;
        }
        let suffix = if is_above { "" } else { "-under" };
        let replaced = until.map_or_else(String::new, |until| format!("-until-{until:0digits$}"));
        written.push_str("<g");
        attribute(&mut written, "id", &format!("step-{step:0digits$}{replaced}{suffix}"));
        if until.is_some() {
            attribute(&mut written, "visibility", "hidden");
        }
        written.push_str(">\n");
        if let (true, None, Some(words)) = (is_above, until, drawing.steps.get(usize::from(step) - 1)) {
            let _ = writeln!(written, "<title>{}</title>", xml(words));
        }
        write_marks(&mut written, drawing, text, &marks);
        written.push_str("</g>\n");
    }
    written.truncate(written.trim_end().len());
    written
}

/// The bundled font, then fonts of about the same width for where it is not installed.
const FONTS: &str = "Libertinus Serif, Cambria, Times New Roman, serif";

/// A complete file around the marks, which shows that part of the sheet.
fn document(drawing: &Drawing, text: Text, marks: String, area: Rect) -> String {
    let [left, top, width, height] = [area.x0, area.y0, area.width(), area.height()].map(number);
    let mut root = element(
        "svg",
        [
            ("xmlns", "http://www.w3.org/2000/svg".into()),
            ("width", format!("{width}mm")),
            ("height", format!("{height}mm")),
            ("viewBox", format!("{left} {top} {width} {height}")),
            ("fill", "none".into()),
            ("role", "img".into()),
        ],
    );
    if text == Text::Letters {
        root.assign("font-family", FONTS);
        root.assign("text-rendering", "geometricPrecision");
    }
    if !drawing.title.is_blank() {
        root.append(Blob::new(format!("<title>{}</title>", drawing.title.for_xml())));
    }
    if !drawing.description.is_empty() {
        root.append(Blob::new(format!("<desc>{}</desc>", xml(&drawing.description))));
    }
    let mut paper =
        element("rect", [("width", width), ("height", height), ("fill", drawing.style.background().to_string())]);
    for (name, place) in [("x", left), ("y", top)] {
        if place != "0" {
            paper.assign(name, place);
        }
    }
    root.append(paper);
    root.append(Blob::new(marks));
    let mut file = root.to_string();
    file.push('\n');
    file
}

fn element<const N: usize>(name: &str, attributes: [(&str, String); N]) -> Element {
    let mut element = Element::new(name);
    for (name, value) in attributes {
        element.assign(name, value);
    }
    element
}
