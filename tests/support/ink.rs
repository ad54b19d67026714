//! Ink in a picture, where usvg puts it, the reader of SVG under resvg.

use resvg::usvg::{Color, Fill, Group, Node, Options, Paint, Tree};
use std::sync::Arc;
use usvg::WriteOptions;
use usvg::fontdb::{Database, Source};

/// A picture with the outlines of letters in place of its texts, set from the bundled fonts.
pub fn outlined(svg: &str) -> String {
    let mut fonts = Database::new();
    for face in [kinegon::drawing::REGULAR, kinegon::drawing::ITALIC] {
        fonts.load_font_source(Source::Binary(Arc::new(face)));
    }
    let options = usvg::Options { fontdb: Arc::new(fonts), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).expect("it is SVG");
    tree.to_string(&WriteOptions { preserve_text: false, ..WriteOptions::default() })
}

/// The box around all marks but the white ones, in mm of the sheet: left, top, right, bottom; texts as usvg sets them,
/// to test our own measuring.
pub fn ink_in(svg: &str) -> [f64; 4] {
    fn gather(group: &Group, ink: &mut [f64; 4]) {
        for node in group.children() {
            let own = match node {
                Node::Group(inner) => {
                    gather(inner, ink);
                    continue;
                }
                Node::Path(path) => match path.fill().map(Fill::paint) {
                    Some(Paint::Color(colour)) if *colour != Color::white() => path.abs_bounding_box(),
                    _ => continue,
                },
                Node::Text(_) | Node::Image(_) => continue,
            };
            // 96 pixels in an inch.
            let own = [own.left(), own.top(), own.right(), own.bottom()].map(|side| f64::from(side) * 25.4 / 96.0);
            for (side, own) in own.into_iter().enumerate() {
                ink[side] = if side < 2 { ink[side].min(own) } else { ink[side].max(own) };
            }
        }
    }
    let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut ink = [least, least, most, most];
    let tree = Tree::from_str(&outlined(svg), &Options::default()).expect("it is SVG");
    gather(tree.root(), &mut ink);
    ink
}
