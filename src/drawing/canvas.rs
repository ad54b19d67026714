use super::clip::{clipped, clipped_segment, holds, is_within};
use super::dims::Dims;
use super::held::{Held, Inset};
use super::labels::{LabelRequest, Obstacles, place_among, place_near};
use super::layout::HEADING;
use super::obstacles::Taken;
use super::shape::{Shape, around, overlap};
use super::sheet::{Drawing, Mark, Pen};
use super::text::{CAPTION, LABEL, PlacedText, RichText};
use crate::text::Untrusted;
use indexmap::IndexMap;
use kurbo::{Point, Rect, Vec2};

/// White between a panel's edge and the words on what is cut off there, in mm.
const CUT_EDGE: f64 = 2.5;

/// A panel in progress: drawn marks become obstacles; labels are placed when all is drawn.
pub(super) struct Canvas<'a> {
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

/// Length of lines through a label that has to be legible, in mm.
const STRUCK: f64 = 1.0;

/// A label without a place yet.
pub(super) struct Wanted {
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
    /// What it says before: from which step, in rising order; the label itself follows on the last.
    pub before: Vec<(u16, RichText)>,
}

impl<'a> Canvas<'a> {
    pub(super) fn new(
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
    pub(super) fn dims(&self) -> Dims {
        self.dims
    }

    /// A vector with a head of the sheet's size.
    pub(super) fn arrow(&self, from: Point, to: Point) -> Shape {
        Shape::Arrow { from, to, head: self.dims.head }
    }

    /// The enlarged detail that the panel had in the picture before.
    pub(super) fn held_inset(&self) -> Option<Inset> {
        self.held.as_ref()?.inset(self.prefix)
    }

    /// Keeps the panel's enlarged detail for the next picture.
    pub(super) fn keep_inset(&mut self, inset: Inset) {
        if let Some(held) = &mut self.held {
            held.keep_inset(self.prefix, inset);
        }
    }

    /// The panel with its border.
    pub(super) fn frame(&self) -> Rect {
        self.frame
    }

    /// Excludes the marks drawn so far from the panel's content: they are not cut off at its edge.
    pub(super) fn exclude_drawn(&mut self) {
        self.content_start = self.drawing.marks.len();
    }

    /// The panel without its border.
    pub(super) fn bounds(&self) -> Rect {
        self.taken.all().bounds
    }

    /// The panel without its border and heading, the area for lines.
    pub(super) fn room(&self) -> Rect {
        let mut room = self.bounds();
        room.y0 += HEADING;
        room
    }

    /// Draws a mark that labels keep off: off joints and arrowheads always, off lines if possible.
    pub(super) fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.add_obstacle(pen, &shape);
        self.add_mark(None, pen, shape)
    }

    /// Draws a mark with an id that nothing keeps off.
    pub(super) fn draw_below(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        let id = format!("{}-{}", self.prefix, ascii(name));
        self.add_mark(Some(id), pen, shape)
    }

    /// Sets the step with which further marks and labels appear.
    pub(super) fn set_step(&mut self, step: u16) {
        self.step = step;
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

    /// Draws a mark that appears in one step only; it is no obstacle.
    pub(super) fn draw_in_step(&mut self, step: u16, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { since: step, passing: true, ..Mark::new(pen, shape) })
    }

    /// Draws a mark with an id, such as `velocity-ray-b-s3`, that labels keep off.
    pub(super) fn draw_named(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
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
    pub(super) fn reserve(&mut self, shape: &Shape) {
        self.add_obstacle(Pen::Student, shape);
    }

    /// Notes that a student's drawing is laid over the content: with more labels none may be taken for another's.
    pub(super) fn set_overlaid(&mut self) {
        self.is_overlaid = true;
    }

    /// Reserves a circle for labels of points in it, under an overlay.
    pub(super) fn reserve_circle(&mut self, centre: Point, radius: f64) {
        if self.is_overlaid {
            self.reserved_circles.push((centre, radius));
        }
    }

    /// Number of obstacles, lines and boxes, that a short segment crosses.
    pub(super) fn crossings_with(&self, from: Point, to: Point) -> usize {
        self.taken.crossings_with(from, to)
    }

    /// The marks of the panel's content so far.
    pub(super) fn marks(&self) -> &[Mark] {
        &self.drawing.marks[self.content_start..]
    }

    /// Whether a box overlaps a joint, an arrowhead or other words.
    pub(super) fn is_taken(&self, area: Rect) -> bool {
        self.taken.overlaps(area)
    }

    /// Whether a circle is off all obstacles and enlarged details.
    pub(super) fn is_free(&self, centre: Point, radius: f64) -> bool {
        self.taken.is_free(centre, radius)
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

    /// Keeps labels off a box.
    pub(super) fn keep_off(&mut self, area: Rect) {
        self.taken.add_box(area);
    }

    /// Requests a label beside `anchor`, at least `clearance` mm away: `standard`, unless the scene renames `name`.
    pub(super) fn label(
        &mut self,
        name: &str,
        standard: &str,
        anchor: Point,
        clearance: f64,
        prefer: Option<Vec2>,
        priority: u8,
    ) -> &mut Wanted {
        let markup = self.shown(name, standard);
        let request = LabelRequest { text: RichText::math(&markup), size: LABEL, anchor, clearance, prefer, priority };
        self.ask(name, request)
    }

    /// Requests a label of the usual look; `name` is the end of its mark's id.
    pub(super) fn ask(&mut self, name: &str, request: LabelRequest) -> &mut Wanted {
        self.request_label(Wanted {
            request,
            name: format!("label-{name}"),
            pen: Pen::Label,
            number: None,
            optional: false,
            last: false,
            short: None,
            before: Vec::new(),
        })
    }

    /// Requests a label of any look.
    pub(super) fn request_label(&mut self, wanted: Wanted) -> &mut Wanted {
        self.requests.push((wanted, self.step));
        &mut self.requests.last_mut().expect("a request was added").0
    }

    /// Requests plain words beside `anchor`.
    pub(super) fn words(&mut self, name: &str, words: &str, anchor: Point) {
        let request = LabelRequest {
            text: RichText::plain(words),
            size: LABEL,
            anchor,
            clearance: 1.0,
            prefer: None,
            priority: 3,
        };
        self.ask(name, request);
    }

    /// The text shown for a name: `standard` unless the scene renames it.
    pub(super) fn shown(&self, name: &str, standard: &str) -> String {
        let renamed = self.renamed.get(name);
        renamed.map_or_else(|| standard.to_owned(), Untrusted::for_setting)
    }

    /// Places and draws the labels, and cuts off marks at the panel's edge. Labels of points outside the panel are left
    /// out; `cut` says that something is, `unlabelled` that there is no room for all names, which are returned.
    pub(super) fn finish(mut self, cut: &str, unlabelled: &str) -> Vec<String> {
        let leaves = |mark: &&Mark| !mark.passing && !is_within(self.frame, &mark.shape);
        let cut_from = self.marks().iter().filter(leaves).map(|mark| mark.since).min();
        if let Some(step) = cut_from {
            self.say("cut", cut, step);
        }
        let mut requests = std::mem::take(&mut self.requests);
        requests.retain(|(wanted, _)| holds(self.frame, wanted.request.anchor));
        let shown =
            |anchor: Point| self.reserved_circles.iter().any(|(centre, radius)| (anchor - *centre).hypot() < *radius);
        let (within, outside): (Vec<_>, Vec<_>) =
            requests.into_iter().partition(|(wanted, _)| shown(wanted.request.anchor));
        let first = self.drawing.marks.len();
        let mut left_out = self.place(within);
        for (centre, radius) in std::mem::take(&mut self.reserved_circles) {
            self.taken.add_boxes(strips(centre, radius));
        }
        left_out.append(&mut self.place(outside));
        if !left_out.is_empty() {
            left_out.append(&mut self.say_unlabelled(unlabelled, first));
        }
        self.cut_off();
        left_out
    }

    /// Says in a corner that there is no room for all names. Labels, which begin with the mark `first`, give way; these
    /// are returned.
    fn say_unlabelled(&mut self, words: &str, first: usize) -> Vec<String> {
        let boxes = self.drawing.marks[first..].iter().map(|mark| mark.shape.bounds());
        self.taken.add_boxes(boxes.collect::<Vec<_>>());
        let labels = self.drawing.marks.split_off(first);
        let Some(area) = self.say("unlabelled", words, 0) else { return Vec::new() };
        let mut left_out = Vec::new();
        for mark in labels {
            match &mark.shape {
                Shape::Text(text) if overlap(text.ink_box(), area) => {
                    left_out.push(text.text.content());
                    // Its leader comes before it.
                    let marks = &mut self.drawing.marks;
                    let has_leader = marks.last().is_some_and(|last| last.pen == Pen::Leader);
                    marks.truncate(marks.len() - usize::from(has_leader));
                }
                _ => self.drawing.marks.push(mark),
            }
        }
        left_out
    }

    /// Says something in a corner of the panel from a step on; `name` is the end of its mark's id. Returns its box.
    fn say(&mut self, name: &str, words: &str, step: u16) -> Option<Rect> {
        if words.is_empty() {
            return None;
        }
        let text = RichText::plain(words);
        let size = Vec2::new(text.width(CAPTION), CAPTION);
        let (left, right) = (self.frame.x0 + CUT_EDGE, self.frame.x1 - CUT_EDGE - size.x);
        let (top, bottom) = (self.frame.y0 + HEADING, self.frame.y1 - CUT_EDGE);
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top + CAPTION)];
        let corners = corners.map(|(x, y)| Point::new(x, y));
        let place = |from: Point| PlacedText::new(text.clone(), CAPTION, from);
        let covered = |from: &Point| {
            let ink = place(*from).ink_box().inflate(0.5, 0.5);
            let Obstacles { boxes, lines, .. } = self.taken.all();
            let lines = lines.iter().filter(|(a, b)| clipped_segment(ink, *a, *b).is_some()).count();
            lines + 4 * boxes.iter().filter(|area| overlap(**area, ink)).count()
        };
        let from = corners.into_iter().min_by_key(covered)?;
        self.step = step;
        let text = place(from);
        let area = text.ink_box();
        self.taken.add_box(area);
        let id = format!("{}-{name}", self.prefix);
        self.add_mark(Some(id), Pen::Caption, Shape::Text(text));
        Some(area.inflate(1.0, 1.0))
    }

    /// Places labels and draws them; returns those for which there is no room.
    fn place(&mut self, requests: Vec<(Wanted, u16)>) -> Vec<String> {
        let mut left_out = Vec::new();
        let (last, requests): (Vec<_>, Vec<_>) = requests.into_iter().partition(|(wanted, _)| wanted.last);
        let mut asked: Vec<LabelRequest> = requests.iter().map(|w| w.0.request.clone()).collect();
        let ids: Vec<String> = match self.held {
            Some(_) => requests.iter().map(|(wanted, _)| format!("{}-{}", self.prefix, wanted.name)).collect(),
            None => Vec::new(),
        };
        let before = self.held.as_ref().filter(|held| held.has_picture());
        let before: Option<Vec<_>> = before.map(|held| ids.iter().map(|id| held.label(id)).collect());
        let mut placed = place_among(&asked, &self.taken, before.as_deref());
        let mut is_shortened = false;
        for ((label, (wanted, _)), asked) in placed.iter().zip(&requests).zip(&mut asked) {
            if let (true, Some(short)) = (label.crowded || label.struck > STRUCK, &wanted.short) {
                (asked.text, is_shortened) = (short.clone(), true);
            }
        }
        if is_shortened {
            placed = place_among(&asked, &self.taken, before.as_deref());
        }
        if let Some(held) = &mut self.held {
            let free = ids.into_iter().zip(&placed).zip(&asked).filter(|((_, label), _)| !label.crowded);
            free.for_each(|((id, label), asked)| held.keep_label(id, label.text.ink_box().center() - asked.anchor));
        }
        for (label, (wanted, since)) in placed.into_iter().zip(requests) {
            if label.left_out || wanted.optional && label.crowded {
                if !wanted.optional {
                    left_out.push(label.text.text.content());
                }
                continue;
            }
            if !last.is_empty() {
                self.taken.add_box(label.text.ink_box());
            }
            self.step = wanted.before.first().map_or(since, |(first, _)| *first);
            if let Some((a, b)) = label.leader {
                self.add_mark(None, Pen::Leader, Shape::Line(a, b));
            }
            for (index, (step, text)) in wanted.before.iter().enumerate() {
                let next = wanted.before.get(index + 1).map_or(since, |(next, _)| *next);
                let text = part_of(&label.text, text, wanted.request.anchor);
                self.step = *step;
                let mark = self.add_mark(None, wanted.pen, Shape::Text(text));
                (mark.number, mark.until) = (wanted.number, Some(next));
            }
            self.step = since;
            let id = format!("{}-{}", self.prefix, ascii(&wanted.name));
            let mark = self.add_mark(Some(id), wanted.pen, Shape::Text(label.text));
            mark.number = wanted.number;
        }
        for (wanted, since) in last {
            let label = place_near(&wanted.request, &self.taken).filter(|label| label.struck <= STRUCK);
            let Some(label) = label else { continue };
            self.taken.add_box(label.text.ink_box());
            self.step = since;
            let id = format!("{}-{}", self.prefix, ascii(&wanted.name));
            self.add_mark(Some(id), wanted.pen, Shape::Text(label.text)).number = wanted.number;
        }
        left_out
    }

    /// Cuts off the content's marks at the panel's edge.
    fn cut_off(&mut self) {
        let marks = &mut self.drawing.marks;
        let leaves = |mark: &Mark| !is_within(self.frame, &mark.shape);
        if !marks[self.content_start..].iter().any(leaves) {
            return;
        }
        for mark in marks.split_off(self.content_start) {
            let mut id = mark.id;
            for shape in clipped(self.frame, mark.shape) {
                marks.push(Mark { id: id.take(), shape, ..mark });
            }
        }
    }
}

/// A shorter text within the box of a label, on its line, as near to the anchor as possible.
fn part_of(whole: &PlacedText, part: &RichText, anchor: Point) -> PlacedText {
    let (ink, own) = (whole.ink_box(), part.ink_box(whole.size));
    let left = (anchor.x - 0.5 * own.width()).min(ink.x1 - own.width()).max(ink.x0);
    PlacedText::new(part.clone(), whole.size, Point::new(left - own.x0, whole.origin.y)).anchored(whole.anchor)
}

/// Boxes that together cover a circle.
fn strips(centre: Point, radius: f64) -> impl Iterator<Item = Rect> {
    const COUNT: usize = 8;
    let height = 2.0 * radius / COUNT as f64;
    (0..COUNT).map(move |index| {
        let low = height * index as f64 - radius;
        // The strip's widest chord is the one nearest to the centre.
        let nearest = 0.0_f64.clamp(low, low + height);
        let half = (radius * radius - nearest * nearest).max(0.0).sqrt();
        Rect::new(-half, low, half, low + height) + centre.to_vec2()
    })
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
