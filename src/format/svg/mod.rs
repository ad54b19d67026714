//! SVG: a sheet as one file, its panels alone, or a group for each step, with marks in groups of those that look alike;
//! shapes and texts are in `shapes.rs`.

mod shapes;

use super::number::number;
use crate::drawing::{Cap, Colour, Drawing, Look, Mark, Pen, PlacedText, Shape};
use crate::text::xml;
use kurbo::Rect;
use shapes::{FINEST, IN_FINEST, attribute, definitions, length, write_glyphs, write_outline, write_shape, write_text};
use std::collections::BTreeMap;
use std::fmt::Write;
use svg::Node;
use svg::node::Blob;
use svg::node::element::Element;

/// How texts are written in an SVG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Text {
    /// As letters: small, searchable and editable; shown in the bundled font where it is installed, else in a similar
    /// one.
    #[default]
    Letters,
    /// As the outlines of the bundled font's letters: exactly the same in every program, whatever fonts it has.
    Outlines,
    /// As outlines, each glyph once in the file: half as large where many letters are the same, but not a path for each text.
    Glyphs,
}

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

/// A mark, and whether it is a text that needs its halo.
type Drawn<'a> = (&'a Mark, bool);

/// All marks whose numbers are finite.
fn drawn(drawing: &Drawing) -> Vec<Drawn<'_>> {
    drawing.marks.iter().zip(drawing.halos()).filter(|(mark, _)| mark.shape.is_drawable()).collect()
}

/// All marks, written straight into one string: building an element for each would take many times as long.
fn body(drawing: &Drawing, text: Text) -> String {
    let drawn = drawn(drawing);
    let each = if text == Text::Letters { 160 } else { 600 };
    let mut written = String::with_capacity(each * drawn.len());
    write_marks(&mut written, drawing, text, &drawn);
    written.truncate(written.trim_end().len());
    if text == Text::Glyphs {
        written += &definitions(drawn.iter().filter_map(|(mark, _)| placed(mark)));
    }
    written
}

/// Writes marks in drawing order, with a group for consecutive marks that look alike.
fn write_marks(written: &mut String, drawing: &Drawing, text: Text, marks: &[Drawn<'_>]) {
    let alike = |(a, _): &Drawn<'_>, (b, _): &Drawn<'_>| {
        let of = |mark: &Mark| (mark.pen, mark.emphasis, is_text(mark));
        of(a) == of(b) && (a.number == b.number || drawing.look(a) == drawing.look(b))
    };
    for marks in marks.chunk_by(alike) {
        let first = marks[0].0;
        let look = drawing.look(first);
        if is_text(first) {
            write_texts(written, text, &look, drawing.style.background(), marks);
        } else {
            open_line_group(written, &look);
            for (mark, _) in marks {
                written.push('\n');
                write_shape(written, &look, &mark.shape, mark.id.as_deref());
            }
            written.push_str("\n</g>\n");
        }
    }
}

fn is_text(mark: &Mark) -> bool {
    placed(mark).is_some()
}

fn placed(mark: &Mark) -> Option<&PlacedText> {
    if let Shape::Text(text) = &mark.shape { Some(text) } else { None }
}

/// Opens a group of marks that are not texts.
fn open_line_group(written: &mut String, look: &Look) {
    written.push_str("<g");
    if let Some(stroke) = look.stroke {
        attribute(written, "stroke", &stroke.to_string());
        length(written, "stroke-width", look.width);
        if !look.dash.is_empty() {
            let lengths: Vec<String> = look.dash.iter().copied().map(number).collect();
            attribute(written, "stroke-dasharray", &lengths.join(" "));
        }
        if look.cap == Cap::Round {
            attribute(written, "stroke-linecap", "round");
        }
        attribute(written, "stroke-linejoin", "round");
    }
    if let Some(fill) = look.fill {
        attribute(written, "fill", &fill.to_string());
    }
    written.push('>');
}

/// Writes texts of one pen; those with a halo (marked true) twice, first outlined in the background's colour, because
/// not every program knows the attribute `paint-order` that puts a stroke behind its letters. All halos come before all
/// letters, so that none covers a neighbour.
fn write_texts(written: &mut String, text: Text, look: &Look, background: Colour, marks: &[Drawn<'_>]) {
    if marks.iter().any(|mark| mark.1) {
        written.push_str("<g");
        attribute(written, "fill", &background.to_string());
        attribute(written, "stroke", &background.to_string());
        match text {
            Text::Letters => length(written, "stroke-width", look.halo),
            Text::Outlines | Text::Glyphs => {
                length(written, "stroke-width", look.halo / FINEST);
                attribute(written, "transform", IN_FINEST);
            }
        }
        attribute(written, "stroke-linejoin", "round");
        attribute(written, "aria-hidden", "true");
        written.push('>');
        for (mark, _) in marks.iter().filter(|mark| mark.1) {
            write_label(written, text, mark, None);
        }
        written.push_str("\n</g>\n");
    }
    written.push_str("<g");
    attribute(written, "fill", &look.ink.to_string());
    if text != Text::Letters {
        attribute(written, "transform", IN_FINEST);
    }
    written.push('>');
    for (mark, _) in marks {
        write_label(written, text, mark, mark.id.as_deref());
    }
    written.push_str("\n</g>\n");
}

/// Writes a text on a line of its own.
fn write_label(written: &mut String, text: Text, mark: &Mark, id: Option<&str>) {
    if let Some(placed) = placed(mark) {
        written.push('\n');
        match text {
            Text::Letters => write_text(written, placed, id),
            Text::Outlines => write_outline(written, placed, id),
            Text::Glyphs => write_glyphs(written, placed, id),
        }
    }
}
