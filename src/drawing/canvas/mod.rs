//! A panel in progress: what is drawn on it (`mod.rs`), and its labels (`placing.rs`).

mod placing;

use crate::drawing::clip::clipped_segment;
use crate::drawing::dims::Dims;
use crate::drawing::held::{Held, Inset};
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::HEADING;
use crate::drawing::obstacles::Taken;
use crate::drawing::shape::{Shape, around};
use crate::drawing::sheet::{Drawing, Mark, Pen};
use crate::drawing::text::RichText;
use crate::text::Untrusted;
use indexmap::IndexMap;
use kurbo::{Point, Rect, Vec2};

/// A panel in progress: drawn marks become obstacles; labels are placed when all is drawn.
pub(in crate::drawing) struct Canvas<'a> {
    pub drawing: &'a mut Drawing,
    /// Prefix of the marks' ids, different for each panel.
    prefix: &'a str,
    taken: Taken,
    requests: Vec<(Wanted, u16)>,
    frame: Rect,
    /// Index of the first mark of the panel's content; earlier marks are not cut off at its edge.
    content_start: usize,
    /// The step of the construction with which new marks appear.
    step: u16,
    renamed: &'a IndexMap<String, Untrusted>,
    dims: Dims,
    /// Enlarged details under an overlay: centre and radius of circles that only labels of points inside may enter.
    reserved_circles: Vec<(Point, f64)>,
    /// Whether a student's drawing is laid over the content: labels from outside then keep off enlarged details.
    is_overlaid: bool,
    /// Where labels and enlarged details were in the picture before, if the mechanism moves.
    pub held: Option<&'a mut Held>,
}

/// A label without a place yet.
pub(in crate::drawing) struct Wanted {
    pub request: LabelRequest,
    /// Its mark's id without the prefix.
    pub name: String,
    pub pen: Pen,
    /// Number of the link or curve that it belongs to.
    pub number: Option<usize>,
    /// Whether it is left out if no place is free.
    pub optional: bool,
    /// Whether it is placed after all others, near its anchor where nothing strikes it through, or not at all.
    pub last: bool,
    /// A shorter text for it, where there is no room for the whole.
    pub short: Option<RichText>,
    /// What stands in its place in earlier steps, each text with the step from which it stands there, in rising order.
    pub before: Vec<(u16, RichText)>,
}

impl Wanted {
    /// A label of the usual look.
    pub(in crate::drawing) fn new(name: String, request: LabelRequest) -> Wanted {
        let (pen, before) = (Pen::Label, Vec::new());
        Wanted { request, name, pen, number: None, optional: false, last: false, short: None, before }
    }
}

impl<'a> Canvas<'a> {
    pub(in crate::drawing) fn new(
        drawing: &'a mut Drawing,
        prefix: &'a str,
        frame: Rect,
        renamed: &'a IndexMap<String, Untrusted>,
        dims: Dims,
    ) -> Self {
        Self {
            content_start: drawing.marks.len(),
            drawing,
            prefix,
            taken: Taken::new(frame.inset(-1.2)),
            requests: Vec::new(),
            frame,
            step: 0,
            renamed,
            dims,
            reserved_circles: Vec::new(),
            is_overlaid: false,
            held: None,
        }
    }

    /// Sizes of letters and signs.
    pub(in crate::drawing) fn dims(&self) -> Dims {
        self.dims
    }

    /// A vector with a head of the sheet's size.
    pub(in crate::drawing) fn arrow(&self, from: Point, to: Point) -> Shape {
        Shape::Arrow { from, to, head: self.dims.head }
    }

    /// The enlarged detail that the panel had in the picture before.
    pub(in crate::drawing) fn held_inset(&self) -> Option<Inset> {
        self.held.as_ref()?.inset(self.prefix)
    }

    /// Keeps the panel's enlarged detail for the next picture.
    pub(in crate::drawing) fn keep_inset(&mut self, inset: Inset) {
        if let Some(held) = &mut self.held {
            held.keep_inset(self.prefix, inset);
        }
    }
    pub(in crate::drawing) fn frame(&self) -> Rect {
        self.frame
    }

    /// Excludes the marks drawn so far from the panel's content: they are not cut off at its edge.
    pub(in crate::drawing) fn exclude_drawn(&mut self) {
        self.content_start = self.drawing.marks.len();
    }

    /// The panel without its border.
    pub(in crate::drawing) fn bounds(&self) -> Rect {
        self.taken.all().bounds
    }

    /// The panel without its border and heading, the area for lines.
    pub(in crate::drawing) fn room(&self) -> Rect {
        let mut room = self.bounds();
        room.y0 += HEADING;
        room
    }

    /// Draws a mark that labels keep off: off joints and arrowheads always, off lines if possible.
    pub(in crate::drawing) fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_obstacle(pen, &shape);
        self.add_mark(None, pen, shape)
    }

    /// Draws a mark with an id that nothing keeps off.
    pub(in crate::drawing) fn draw_below(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        let id = format!("{}-{}", self.prefix, ascii(name));
        self.add_mark(Some(id), pen, shape)
    }

    /// Sets the step with which further marks and labels appear.
    pub(in crate::drawing) fn set_step(&mut self, step: u16) {
        self.step = step;
    }

    fn add_mark(&mut self, id: Option<String>, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { id, since: self.step, ..Mark::new(pen, shape) })
    }

    /// Draws a broad line under the subject of a step; it is no obstacle.
    pub(in crate::drawing) fn hint(&mut self, step: u16, from: Point, to: Point) {
        if let Some((a, b)) = clipped_segment(self.room(), from, to) {
            self.draw_in_step(step, Pen::Hint, Shape::Line(a, b));
        }
    }

    /// Draws a mark that appears in one step only; it is no obstacle.
    pub(in crate::drawing) fn draw_in_step(&mut self, step: u16, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { since: step, passing: true, ..Mark::new(pen, shape) })
    }

    /// Draws a mark with an id, such as `velocity-ray-b-s3`, that labels keep off.
    pub(in crate::drawing) fn draw_named(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_obstacle(pen, &shape);
        let id = format!("{}-{}", self.prefix, ascii(name));
        self.add_mark(Some(id), pen, shape)
    }

    fn add_obstacle(&mut self, pen: Pen, shape: &Shape) {
        match shape {
            Shape::Circle { .. } | Shape::Text(_) => self.taken.add_box(shape.bounds()),
            Shape::Line(..) if pen == Pen::Hatch => self.taken.add_box(shape.bounds()),
            Shape::Polygon(corners) if pen == Pen::Slider => {
                let boxes = pieces(corners).map(|piece| piece.inflate(0.4, 0.4));
                self.taken.add_boxes(boxes);
            }
            // Areas without outline are no obstacles.
            _ if matches!(pen, Pen::LinkFill | Pen::ImageFill) => {}
            _ => self.taken.add_lines(shape.lines()),
        }
        self.taken.add_boxes(shape.head_box());
    }

    /// Reserves the place of a shape that is drawn later: enlarged details and labels keep off it.
    pub(in crate::drawing) fn reserve(&mut self, shape: &Shape) {
        self.add_obstacle(Pen::Student, shape);
    }

    /// Notes that a student's drawing is laid over the content: with more labels none may be taken for another's.
    pub(in crate::drawing) fn set_overlaid(&mut self) {
        self.is_overlaid = true;
    }

    /// Reserves a circle for labels of points in it, under an overlay.
    pub(in crate::drawing) fn reserve_circle(&mut self, centre: Point, radius: f64) {
        if self.is_overlaid {
            self.reserved_circles.push((centre, radius));
        }
    }

    /// Number of obstacles, lines and boxes, that a short segment crosses.
    pub(in crate::drawing) fn crossings_with(&self, from: Point, to: Point) -> usize {
        self.taken.crossings_with(from, to)
    }

    /// The marks of the panel's content so far.
    pub(in crate::drawing) fn marks(&self) -> &[Mark] {
        &self.drawing.marks[self.content_start..]
    }

    /// Whether a box overlaps a joint, an arrowhead or other words.
    pub(in crate::drawing) fn is_taken(&self, area: Rect) -> bool {
        self.taken.overlaps(area)
    }

    /// Whether a circle is off all obstacles and enlarged details.
    pub(in crate::drawing) fn is_free(&self, centre: Point, radius: f64) -> bool {
        self.taken.is_free(centre, radius)
            && self.reserved_circles.iter().all(|(other, own)| (*other - centre).hypot() > own + radius)
    }

    /// A point of a line, near its middle, and the side of it where a label has room: `side` rather than the opposite
    /// one. The middle without room.
    pub(in crate::drawing) fn free_side(&self, [from, to]: [Point; 2], side: Vec2) -> (Point, Vec2) {
        const SHARES: [f64; 7] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74];
        // A circle of the height of a label, at its near end.
        const RADIUS: f64 = 2.2;
        let places = SHARES.into_iter().flat_map(|share| [side, -side].map(|side| (from.lerp(to, share), side)));
        let has_room = |(point, side): &(Point, Vec2)| {
            let sideways = Vec2::new(side.x.signum() * 2.0, 0.0);
            [0.0, 1.0, 2.0, 3.0].iter().all(|k| self.is_free(*point + *side * (RADIUS + 0.6) + sideways * *k, RADIUS))
        };
        places.into_iter().find(has_room).unwrap_or((from.midpoint(to), side))
    }

    /// Keeps labels off a box.
    pub(in crate::drawing) fn keep_off(&mut self, area: Rect) {
        self.taken.add_box(area);
    }
}

/// Boxes that together cover a polygon; several small ones along a rotated block take less area than one.
fn pieces(corners: &[Point]) -> impl Iterator<Item = Rect> {
    let cuts = match corners {
        &[a, b, c, d] => {
            let count = ((b - a).hypot() / (c - b).hypot()).ceil().clamp(1.0, 16.0);
            let at = move |k: f64| [a.lerp(b, k / count), d.lerp(c, k / count)];
            let piece = move |k: usize| [at(k as f64), at(k as f64 + 1.0)].concat();
            (0..count as usize).map(piece).collect()
        }
        _ => vec![corners.to_vec()],
    };
    cuts.into_iter().map(move |piece| around(&piece))
}

/// A name as part of an XML id: characters other than ASCII letters and digits become their codes, so that different
/// names stay different.
pub(in crate::drawing) fn ascii(name: &str) -> String {
    let mut id = String::new();
    for c in name.chars() {
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' => id.push(c),
            'π' => id.push_str("pi"),
            '\'' => id.push_str("prime"),
            ' ' | ',' => id.push('-'),
            other => id.push_str(&format!("u{:x}", other as u32)),
        }
    }
    id
}
