use kurbo::Rect;
use svg::Node;
use svg::node::Blob;
use svg::node::element::Element;

mod glyphs;
#[cfg(test)]
mod ink;
mod layers;
mod shapes;

#[cfg(test)]
pub(crate) use ink::ink_in;

use super::number::{number, push_number};
use super::outline::{FINEST, IN_FINEST, Tracer};
use crate::drawing::{Cap, Colour, Drawing, Look, Mark, PlacedText, Shape};
use crate::text::xml;
use shapes::{write_path, write_shape};

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
    /// The same, with each glyph once in the file: half as large where many letters are the same, but not a path for each text.
    Glyphs,
}

impl Drawing {
    /// The drawing as the text of an SVG file, with its texts as letters.
    ///
    /// The same as [`svg_with`] for [`Text::Letters`].
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
    document(drawing, text, layers::groups(drawing, text), whole(drawing))
}

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

/// A mark, and whether it is a text that needs its halo.
type Drawn<'a> = (&'a Mark, bool);

/// All marks whose numbers are finite.
fn drawn(drawing: &Drawing) -> Vec<Drawn<'_>> {
    drawing.marks.iter().zip(drawing.halos()).filter(|(mark, _)| mark.shape.is_drawable()).collect()
}

/// All marks, written straight into one string: building an `Element` for each would take many times as long.
fn body(drawing: &Drawing, text: Text) -> String {
    let drawn = drawn(drawing);
    let each = if text == Text::Letters { 160 } else { 600 };
    let mut written = String::with_capacity(each * drawn.len());
    write_marks(&mut written, drawing, text, &drawn);
    written.truncate(written.trim_end().len());
    if text == Text::Glyphs {
        written += &glyphs::definitions(&drawn);
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

/// The bundled font, then fonts of about the same width for where it is not installed.
pub(super) const FONTS: &str = "Libertinus Serif, Cambria, Times New Roman, serif";

fn is_text(mark: &Mark) -> bool {
    matches!(mark.shape, Shape::Text(_))
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
    if let Shape::Text(placed) = &mark.shape {
        written.push('\n');
        match text {
            Text::Letters => write_text(written, placed, id),
            Text::Outlines => write_outline(written, placed, id),
            Text::Glyphs => glyphs::write(written, placed, id),
        }
    }
}

fn write_id(written: &mut String, id: Option<&str>) {
    let Some(id) = id else { return };
    // Nearly all names need no escaping.
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
    if id.bytes().all(plain) {
        attribute(written, "id", id);
    } else {
        attribute(written, "id", &xml(id));
    }
}

fn length(written: &mut String, name: &str, value: f64) {
    for part in [" ", name, "=\""] {
        written.push_str(part);
    }
    push_number(written, value);
    written.push('"');
}

/// Writes a text as one path, in hundredths of a mm.
fn write_outline(written: &mut String, text: &PlacedText, id: Option<&str>) {
    write_path(written, id, "", |data| {
        let mut tracer = Tracer::new(data);
        for run in text.runs() {
            run.outline(|glyph, origin| tracer.trace(glyph, origin, run.size));
        }
    });
}

/// Writes a text as letters: each run at its measured place, without white space between the elements, which would be
/// visible.
fn write_text(written: &mut String, text: &PlacedText, id: Option<&str>) {
    let several = text.text.runs().len() > 1;
    written.push_str("<text");
    write_id(written, id);
    // A text of one run needs no inner element.
    if several {
        length(written, "font-size", text.size);
        written.push('>');
    }
    for run in text.runs() {
        if several {
            written.push_str("<tspan");
        }
        if !several || run.size != text.size {
            length(written, "font-size", run.size);
        }
        if run.italic {
            attribute(written, "font-style", "italic");
        }
        length(written, "x", run.origin.x);
        length(written, "y", run.origin.y);
        written.push('>');
        written.push_str(&xml(run.content));
        if several {
            written.push_str("</tspan>");
        }
    }
    written.push_str("</text>");
}

fn attribute(written: &mut String, name: &str, value: &str) {
    for part in [" ", name, "=\"", value, "\""] {
        written.push_str(part);
    }
}

fn element<const N: usize>(name: &str, attributes: [(&str, String); N]) -> Element {
    let mut element = Element::new(name);
    for (name, value) in attributes {
        element.assign(name, value);
    }
    element
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Pen, Point, RichText};

    #[test]
    fn hostile_texts_are_escaped() {
        let mut drawing = Drawing::new(10.0, 10.0);
        drawing.title = "a < b & \"c\" \u{1}".into();
        let text = PlacedText::new(RichText::verbatim("<tspan>&\u{0}"), 4.0, Point::new(1.0, 5.0));
        drawing.draw_named("x\"><script>", Pen::Label, Shape::Text(text));
        let file = drawing.svg();
        assert!(file.contains("<title>a &lt; b &amp; &quot;c&quot; </title>"), "{file}");
        assert!(file.contains("&lt;tspan&gt;&amp;</text>"), "{file}");
        assert!(file.contains("id=\"x&quot;&gt;&lt;script&gt;\""), "{file}");
        assert!(!file.contains('\u{0}') && !file.contains('\u{1}'));
    }

    #[test]
    fn outlines_need_no_font() {
        let mut drawing = Drawing::new(60.0, 30.0);
        let line = Shape::Line(Point::new(0.0, 10.0), Point::new(60.0, 10.0));
        drawing.draw(Pen::Link, line);
        let text = PlacedText::new(RichText::math("S_3"), 4.0, Point::new(5.0, 11.0));
        drawing.draw_named("label-S3", Pen::Label, Shape::Text(text));
        let text = PlacedText::new(RichText::verbatim("l漢"), 4.0, Point::new(30.0, 25.0));
        drawing.draw(Pen::Caption, Shape::Text(text));
        let file = svg_with(&drawing, Text::Outlines);
        assert!(!file.contains("<text") && !file.contains("font"), "{file}");
        assert!(file.contains("<path id=\"label-S3\" d=\"m"), "{file}");
        // Halo and letters are the same outlines.
        let data = |from: &str| {
            let rest = &file[file.find(from).expect("it is there") + from.len()..];
            rest[..rest.find('"').expect("it ends")].to_owned()
        };
        let halo = "aria-hidden=\"true\">\n<path d=\"";
        assert_eq!(data(halo), data("id=\"label-S3\" d=\""));
        assert!(file.contains("stroke-width=\"60\" transform=\"scale(.01)\""));
        // A letter that the font lacks is an empty box: a path inside another.
        assert!(file.contains("m92-215l192 0 0 264-192 0zm20 244l152 0 0-224-152 0z"), "{file}");
    }

    #[test]
    fn marks_that_are_not_finite_are_left_out() {
        let mut drawing = Drawing::new(10.0, 10.0);
        drawing.draw(Pen::Link, Shape::Line(Point::new(f64::NAN, 0.0), Point::new(1.0, 1.0)));
        drawing.draw(Pen::Link, Shape::Circle { center: Point::ORIGIN, radius: f64::INFINITY });
        let file = drawing.svg();
        assert!(!file.contains("<path") && !file.contains("<circle"));
    }

    #[test]
    fn empty_texts_are_left_out() {
        let mut drawing = Drawing::new(10.0, 10.0);
        let empty = PlacedText::new(RichText::plain(""), 4.0, Point::new(1.0, 5.0));
        drawing.draw(Pen::Caption, Shape::Text(empty));
        assert!(!drawing.svg().contains("<text"));
    }

    #[test]
    fn arrows_are_one_named_group() {
        let mut drawing = Drawing::new(50.0, 50.0);
        drawing.draw_named(
            "vector-v",
            Pen::Velocity,
            Shape::Arrow { from: Point::new(0.0, 10.0), to: Point::new(20.0, 10.0), head: 2.6 },
        );
        let file = drawing.svg();
        let arrow = "<g id=\"vector-v\"><path d=\"M0 10L18.18 10\"/><path fill=\"#0b4f8a\" stroke=\"none\" \
                     d=\"M20 10L17.4 10.442L17.816 10L17.4 9.558Z\"/></g>";
        assert!(file.contains(arrow), "{file}");
    }
}
