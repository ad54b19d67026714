//! Ink in a picture, as resvg draws it.

use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{self, Group, Node, Options, Paint, Tree};
use std::sync::Arc;

/// The box around all marks but the white ones, in mm of the sheet: left, top, right, bottom; texts as resvg sets them,
/// to test our own measuring.
pub fn ink_in(svg: &str) -> [f64; 4] {
    fn gather(group: &Group, ink: &mut [f64; 4]) {
        for node in group.children() {
            let own = match node {
                Node::Group(inner) => {
                    gather(inner, ink);
                    continue;
                }
                Node::Text(text) => text.flattened().abs_bounding_box(),
                Node::Path(path) => match path.fill().map(usvg::Fill::paint) {
                    Some(Paint::Color(colour)) if *colour != usvg::Color::white() => path.abs_bounding_box(),
                    _ => continue,
                },
                Node::Image(_) => continue,
            };
            // 96 pixels in an inch.
            let own = [own.left(), own.top(), own.right(), own.bottom()].map(|side| f64::from(side) * 25.4 / 96.0);
            for (side, own) in own.into_iter().enumerate() {
                ink[side] = if side < 2 { ink[side].min(own) } else { ink[side].max(own) };
            }
        }
    }
    let mut fonts = Database::new();
    for face in [kinegon::drawing::REGULAR, kinegon::drawing::ITALIC] {
        fonts.load_font_source(Source::Binary(Arc::new(face)));
    }
    let fontdb = Arc::new(fonts);
    let options = Options { fontdb, ..Options::default() };
    let tree = Tree::from_str(svg, &options).expect("it is SVG");
    let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut ink = [least, least, most, most];
    gather(tree.root(), &mut ink);
    ink
}
