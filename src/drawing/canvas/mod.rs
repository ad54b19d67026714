//! A panel in progress: what is drawn on it (`mod.rs`), its labels (`placing.rs`), and the names without room (`unlabelled.rs`).

mod placing;
mod unlabelled;

use crate::drawing::clip::clipped_segment;
use crate::drawing::dims::Dims;
use crate::drawing::grid::Obstacles;
use crate::drawing::labels::LabelRequest;
use crate::drawing::layout::HEADING;
use crate::drawing::shape::{Shape, around};
use crate::drawing::sheet::{Drawing, Emphasis, Mark, Pen};
use crate::drawing::text::RichText;
use crate::text::Untrusted;
use indexmap::IndexMap;
use kurbo::{Point, Rect, Vec2};
use std::ops::RangeInclusive;

/// A panel in progress: drawn marks become obstacles; labels are placed when all is drawn.
pub(super) struct Canvas<'a> {
    pub drawing: &'a mut Drawing,
    name: &'a str,
    /// Prefix of the marks' ids, different for each panel.
    pub prefix: &'a str,
    /// What labels keep off, within the panel without its border.
    pub obstacles: Obstacles,
    requests: Vec<Wanted>,
    pub frame: Rect,
    /// Height of heading, scale and rows of names below the upper edge of the frame.
    pub header: f64,
    /// The lowest rows of it, which are for the names without room.
    rows: usize,
    /// Index of the first mark of the panel's content; earlier marks are not cut off at its edge.
    content_start: usize,
    /// The step of the construction with which new marks and labels appear.
    pub step: u16,
    renamed: &'a IndexMap<String, Untrusted>,
    /// Sizes of letters and signs.
    pub dims: Dims,
    /// Enlarged details under an overlay: centre and radius of circles that only labels of points inside may enter.
    reserved_circles: Vec<(Point, f64)>,
    /// Whether a student's drawing is laid over the content: labels from outside then keep off enlarged details, so that
    /// none is taken for another's.
    pub is_overlaid: bool,
    /// Whether a part of the content is shown, below heading and scale: that the rest is cut off is no news.
    pub is_part: bool,
    /// Ids of marks whose labels found no room: they are taken back.
    unnamed: Vec<String>,
    /// Where labels and enlarged details were in the picture before, if the mechanism moves.
    pub held: Option<&'a mut Held>,
}

/// A label without a place yet.
pub(super) struct Wanted {
    pub request: LabelRequest,
    /// Its mark's id without the prefix.
    pub name: String,
    pub pen: Pen,
    /// Number of the link or curve that it belongs to.
    pub number: Option<usize>,
    /// Whether it is left out if no place is free and off all lines.
    pub optional: bool,
    /// Whether it is placed after all others.
    pub last: bool,
    /// A shorter text for it, where there is no room for the whole.
    pub short: Option<RichText>,
    /// What stands in its place in earlier steps, each text with the step from which it stands there, in rising order.
    pub before: Vec<(u16, RichText)>,
    /// The step with which it appears, set when it is requested.
    pub since: u16,
    /// Whether it is there in that step alone.
    pub passing: bool,
    /// Names of marks that are left out with it.
    pub with: Vec<String>,
}

impl Wanted {
    /// A label of the usual look.
    pub(super) fn new(name: String, request: LabelRequest) -> Wanted {
        Wanted {
            request,
            name,
            pen: Pen::Label,
            number: None,
            optional: false,
            last: false,
            short: None,
            before: Vec::new(),
            since: 0,
            passing: false,
            with: Vec::new(),
        }
    }
}

impl<'a> Canvas<'a> {
    /// A panel of this name in a frame, without marks; ids of its marks begin with `prefix`.
    pub(super) fn new(
        drawing: &'a mut Drawing,
        [name, prefix]: [&'a str; 2],
        frame: Rect,
        renamed: &'a IndexMap<String, Untrusted>,
        dims: Dims,
    ) -> Self {
        drawing.panels.push((name.to_owned(), frame));
        let mut obstacles = Obstacles::new(frame.inset(-1.2));
        obstacles.strike = dims.strike;
        Self {
            content_start: drawing.marks.len(),
            drawing,
            name,
            prefix,
            obstacles,
            requests: Vec::new(),
            frame,
            header: HEADING,
            rows: 0,
            step: 0,
            renamed,
            dims,
            reserved_circles: Vec::new(),
            is_overlaid: false,
            is_part: false,
            unnamed: Vec::new(),
            held: None,
        }
    }

    /// A vector with a head of the sheet's size.
    pub(super) fn arrow(&self, from: Point, to: Point) -> Shape {
        Shape::Arrow { from, to, head: self.dims.head }
    }

    /// Excludes the marks drawn so far from the panel's content: they are not cut off at its edge.
    pub(super) fn exclude_drawn(&mut self) {
        self.content_start = self.drawing.marks.len();
    }

    /// The panel without its border and heading, the area for lines.
    pub(super) fn room(&self) -> Rect {
        let bounds = self.obstacles.bounds;
        Rect { y0: bounds.y0 + self.header, ..bounds }
    }

    /// Draws a mark that labels keep off: off joints and arrowheads always, off lines if possible.
    pub(super) fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_obstacle(pen, &shape);
        self.add_mark(None, pen, shape)
    }

    /// Draws a mark with an id, such as `velocity-ray-b-s3`, that labels keep off.
    pub(super) fn draw_named(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_obstacle(pen, &shape);
        self.draw_below(name, pen, shape)
    }

    /// Draws a mark with an id that nothing keeps off.
    pub(super) fn draw_below(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_mark(Some(self.id(name)), pen, shape)
    }

    /// The id in the drawing of a mark with this name in the panel.
    fn id(&self, name: &str) -> String {
        format!("{}-{}", self.prefix, ascii(name))
    }

    fn add_mark(&mut self, id: Option<String>, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { id, since: self.step, ..Mark::new(pen, shape) })
    }

    /// Draws a broad line under the subject of a step; it is no obstacle.
    pub(super) fn hint(&mut self, step: u16, from: Point, to: Point) {
        if let Some((a, b)) = clipped_segment(self.room(), from, to) {
            self.draw_in_step(step, Pen::Hint, Shape::Line(a, b));
        }
    }

    /// Draws a mark that appears in one step only; labels keep off it, but for hints.
    pub(super) fn draw_in_step(&mut self, step: u16, pen: Pen, shape: Shape) -> &mut Mark {
        if pen != Pen::Hint {
            self.add_obstacle(pen, &shape);
        }
        self.drawing.add(Mark { since: step, passing: true, ..Mark::new(pen, shape) })
    }

    fn add_obstacle(&mut self, pen: Pen, shape: &Shape) {
        match shape {
            Shape::Circle { .. } => self.obstacles.add_boxes([shape.bounds()]),
            Shape::Text(text) => self.obstacles.add_texts([text.ink_box()]),
            Shape::Line(..) if pen == Pen::Hatch => self.obstacles.add_boxes([shape.bounds()]),
            Shape::Polygon(corners) if pen == Pen::Slider => {
                let boxes = pieces(corners).map(|piece| piece.inflate(0.4, 0.4));
                self.obstacles.add_boxes(boxes);
            }
            // Areas without outline are no obstacles.
            _ if matches!(pen, Pen::LinkFill | Pen::ImageFill) => {}
            _ => self.obstacles.add_lines(shape.lines()),
        }
        self.obstacles.add_boxes(shape.head_box());
    }

    /// Reserves the place of a shape that is drawn later: enlarged details and labels keep off it.
    pub(super) fn reserve(&mut self, shape: &Shape) {
        self.add_obstacle(Pen::Student, shape);
    }

    /// Reserves a circle for labels of points in it, under an overlay.
    pub(super) fn reserve_circle(&mut self, centre: Point, radius: f64) {
        if self.is_overlaid {
            self.reserved_circles.push((centre, radius));
        }
    }

    /// Shows a part of the content: what comes with some steps, with the names of these and of the points `starts` from
    /// which they go on; all else is pale and without names.
    pub(super) fn show_part(&mut self, steps: &RangeInclusive<u16>, starts: &[String]) {
        let starts: Vec<String> = starts.iter().map(|name| format!("label-{name}-")).collect();
        self.requests.retain(|wanted| {
            let mut since = wanted.before.iter().map(|(step, _)| *step).chain([wanted.since]);
            since.any(|step| steps.contains(&step)) || starts.contains(&wanted.name) || wanted.name == "factor"
        });
        let content = self.drawing.marks.split_off(self.content_start);
        let is_seen = |mark: &Mark| mark.pen != Pen::Special || steps.contains(&mark.since);
        self.drawing.marks.extend(content.into_iter().filter(is_seen).map(|mark| {
            let is_own = steps.contains(&mark.since) || matches!(mark.pen, Pen::Pole | Pen::Frame);
            Mark { emphasis: if is_own { mark.emphasis } else { Emphasis::Earlier }, ..mark }
        }));
    }

    /// The frame below heading and scale: what leaves the frame is cut off at its edge.
    pub(super) fn below_header(&self) -> Rect {
        Rect { y0: self.frame.y0 + self.header, ..self.frame }
    }

    /// The area that its content does not leave where nothing is cut off.
    fn seen(&self) -> Rect {
        if self.is_part { self.below_header() } else { self.frame }
    }

    /// The marks of the panel's content so far.
    pub(super) fn marks(&self) -> &[Mark] {
        &self.drawing.marks[self.content_start..]
    }

    /// Whether a circle is off all obstacles and enlarged details.
    pub(super) fn is_free(&self, centre: Point, radius: f64) -> bool {
        self.obstacles.is_free(centre, radius)
            && self.reserved_circles.iter().all(|(other, own)| (*other - centre).hypot() > own + radius)
    }

    /// A point of a line, near its middle, and the side of it where a label has room: `side` rather than the opposite
    /// one. The middle without room.
    pub(super) fn free_side(&self, [from, to]: [Point; 2], side: Vec2) -> (Point, Vec2) {
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
}

/// Where labels and enlarged details stood in the picture before, and where they stand in the one that is being drawn:
/// there they stay while a mechanism moves, as long as they are clear there.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    pub before: Places,
    pub now: Places,
}

/// The places of one picture.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    /// By label: the middle of its ink from its anchor, in mm.
    pub labels: IndexMap<String, Vec2>,
    /// By panel: its enlarged detail.
    pub insets: IndexMap<String, Inset>,
}

/// A circle with an enlarged crowd of points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inset {
    /// Centre of the crowd, on the sheet.
    pub crowd: Point,
    /// Centre and radius of the circle, on the sheet.
    pub centre: Point,
    pub radius: f64,
    /// Factor of enlargement.
    pub factor: f64,
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
pub(super) fn ascii(name: &str) -> String {
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
