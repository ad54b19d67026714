use super::clip::{clipped, clipped_segment, holds, is_within};
use super::labels::{LabelRequest, Obstacles, place};
use super::layout::HEADING;
use super::shape::{Shape, around};
use super::sheet::{Drawing, Mark, Pen};
use super::text::{LABEL, RichText};
use indexmap::IndexMap;
use kurbo::{Line, ParamCurveNearest, Point, Rect, Vec2};

/// A panel being drawn: what is drawn is remembered as an obstacle, labels are placed when all is drawn.
pub(super) struct Canvas<'a> {
    pub drawing: &'a mut Drawing,
    /// Prefix of the marks' ids, one for each panel.
    prefix: &'static str,
    obstacles: Obstacles,
    requests: Vec<(Wanted, u16)>,
    frame: Rect,
    /// How many marks the drawing has that are not of the content.
    before: usize,
    /// With which step that which is drawn now comes.
    since: u16,
    renamed: &'a IndexMap<String, String>,
    /// Circles that only names of what is shown in them enter: centre and radius.
    closed: Vec<(Point, f64)>,
    /// Whether something is drawn over the panel's own content.
    is_overlaid: bool,
}

/// A label that wants a place.
pub(super) struct Wanted {
    pub request: LabelRequest,
    /// Its mark's id without the prefix.
    pub name: String,
    pub pen: Pen,
    /// The link or the curve that it belongs to.
    pub number: Option<usize>,
    /// Whether it is left out where there is no free place for it.
    pub optional: bool,
}

impl<'a> Canvas<'a> {
    pub(super) fn new(
        drawing: &'a mut Drawing,
        prefix: &'static str,
        frame: Rect,
        renamed: &'a IndexMap<String, String>,
    ) -> Self {
        Self {
            before: drawing.marks.len(),
            drawing,
            prefix,
            obstacles: Obstacles { boxes: Vec::new(), lines: Vec::new(), bounds: frame.inset(-1.2) },
            requests: Vec::new(),
            frame,
            since: 0,
            renamed,
            closed: Vec::new(),
            is_overlaid: false,
        }
    }

    /// The panel with its border.
    pub(super) fn frame(&self) -> Rect {
        self.frame
    }

    /// Lets stand what has been drawn so far: it is not cut off at the panel's edge, and no part of the content.
    pub(super) fn settle(&mut self) {
        self.before = self.drawing.marks.len();
    }

    /// The panel without its border.
    pub(super) fn bounds(&self) -> Rect {
        self.obstacles.bounds
    }

    /// The panel without its border and heading: where lines may run.
    pub(super) fn room(&self) -> Rect {
        let mut room = self.bounds();
        room.y0 += HEADING;
        room
    }

    /// Draws a mark and remembers it as something that labels keep off: joints and arrowheads entirely, lines where they can.
    pub(super) fn draw(&mut self, pen: Pen, shape: Shape) -> &mut Mark {
        self.remember(pen, &shape);
        self.put(None, pen, shape)
    }

    /// What is drawn and asked for from now on comes with this step.
    pub(super) fn since(&mut self, step: u16) {
        self.since = step;
    }

    fn put(&mut self, id: Option<String>, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { id, since: self.since, ..Mark::new(pen, shape) })
    }

    /// A broad line under what the step is about; nothing keeps off it.
    pub(super) fn hint(&mut self, step: u16, from: Point, to: Point) {
        if let Some((a, b)) = clipped_segment(self.room(), from, to) {
            self.passing(step, Pen::Hint, Shape::Line(a, b));
        }
    }

    /// A mark that is there in one step alone; nothing keeps off it.
    pub(super) fn passing(&mut self, step: u16, pen: Pen, shape: Shape) -> &mut Mark {
        self.drawing.add(Mark { since: step, passing: true, ..Mark::new(pen, shape) })
    }

    /// The same, findable by a name such as `velocity-ray-b-s3`.
    pub(super) fn draw_named(&mut self, name: &str, pen: Pen, shape: Shape) -> &mut Mark {
        self.remember(pen, &shape);
        let id = format!("{}-{}", self.prefix, ascii(name));
        self.put(Some(id), pen, shape)
    }

    fn remember(&mut self, pen: Pen, shape: &Shape) {
        match shape {
            Shape::Circle { .. } | Shape::Text(_) => self.obstacles.boxes.push(shape.bounds()),
            Shape::Line(..) if pen == Pen::Hatch => self.obstacles.boxes.push(shape.bounds()),
            Shape::Polygon(corners) if pen == Pen::Slider => {
                let boxes = pieces(corners).map(|piece| piece.inflate(0.4, 0.4));
                self.obstacles.boxes.extend(boxes);
            }
            // Areas without outline: names may stand in them.
            _ if matches!(pen, Pen::LinkFill | Pen::ImageFill) => {}
            _ => self.obstacles.lines.extend(shape.lines()),
        }
        self.obstacles.boxes.extend(shape.head_box());
    }

    /// Keeps circles and labels off something that is drawn later.
    pub(super) fn expect(&mut self, shape: &Shape) {
        self.remember(Pen::Student, shape);
    }

    /// From now on something is drawn over the panel's content: names are more than usual, and none may go astray.
    pub(super) fn overlay(&mut self) {
        self.is_overlaid = true;
    }

    /// Lets names of what lies outside a circle keep off it, under an overlay.
    pub(super) fn close(&mut self, centre: Point, radius: f64) {
        if self.is_overlaid {
            self.closed.push((centre, radius));
        }
    }

    /// How many of the lines and things drawn so far a short segment would cross.
    pub(super) fn in_the_way(&self, from: Point, to: Point) -> usize {
        let side = |a: Point, b: Point, p: Point| (b - a).cross(p - a);
        let crosses = |&&(a, b): &&(Point, Point)| {
            side(a, b, from) * side(a, b, to) < 0.0 && side(from, to, a) * side(from, to, b) < 0.0
        };
        let own = Rect::from_points(from, to);
        let touches = |area: &&Rect| area.overlaps(own);
        let lines = self.obstacles.lines.iter().filter(crosses).count();
        lines + self.obstacles.boxes.iter().filter(touches).count()
    }

    /// What has been drawn of the content so far.
    pub(super) fn marks(&self) -> &[Mark] {
        &self.drawing.marks[self.before..]
    }

    /// Whether nothing has been drawn within a circle, and none that shows a crowded place reaches into it.
    pub(super) fn is_free(&self, centre: Point, radius: f64) -> bool {
        let far = radius * radius;
        let is_off_line = |&(a, b): &(Point, Point)| Line::new(a, b).nearest(centre, 1e-3).distance_sq > far;
        let is_off_box = |area: &Rect| {
            let nearest = Point::new(centre.x.clamp(area.x0, area.x1), centre.y.clamp(area.y0, area.y1));
            (nearest - centre).hypot2() > far
        };
        self.obstacles.lines.iter().all(is_off_line)
            && self.obstacles.boxes.iter().all(is_off_box)
            && self.closed.iter().all(|(other, own)| (*other - centre).hypot() > own + radius)
    }

    /// Keeps labels off a box.
    pub(super) fn keep_off(&mut self, area: Rect) {
        self.obstacles.boxes.push(area);
    }

    /// Asks for a label beside `anchor`, at least `clearance` away; `name` is its text unless the scene renames it.
    pub(super) fn label(
        &mut self,
        name: &str,
        standard: &str,
        anchor: Point,
        clearance: f64,
        prefer: Option<Vec2>,
        priority: u8,
    ) -> &mut Wanted {
        let markup = self.renamed.get(name).map_or(standard, String::as_str);
        let request = LabelRequest { text: RichText::math(markup), size: LABEL, anchor, clearance, prefer, priority };
        self.ask(name, request)
    }

    /// Asks for a label of the usual look; `name` is the end of its mark's id.
    pub(super) fn ask(&mut self, name: &str, request: LabelRequest) -> &mut Wanted {
        self.want(Wanted { request, name: format!("label-{name}"), pen: Pen::Label, number: None, optional: false })
    }

    /// Asks for a label of any look.
    pub(super) fn want(&mut self, wanted: Wanted) -> &mut Wanted {
        self.requests.push((wanted, self.since));
        &mut self.requests.last_mut().expect("a request was added").0
    }

    /// Asks for words beside `anchor`.
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

    /// The text that a name is shown by.
    pub(super) fn shown(&self, name: &str, standard: &str) -> String {
        let renamed = self.renamed.get(name);
        renamed.map_or_else(|| standard.to_owned(), Clone::clone)
    }

    /// Places and draws the labels, and cuts off what leaves the panel; what lies outside has no name.
    pub(super) fn finish(mut self) {
        let mut requests = std::mem::take(&mut self.requests);
        requests.retain(|(wanted, _)| holds(self.frame, wanted.request.anchor));
        let shown = |anchor: Point| self.closed.iter().any(|(centre, radius)| (anchor - *centre).hypot() < *radius);
        let (within, outside): (Vec<_>, Vec<_>) =
            requests.into_iter().partition(|(wanted, _)| shown(wanted.request.anchor));
        self.place(within);
        for (centre, radius) in std::mem::take(&mut self.closed) {
            self.obstacles.boxes.extend(strips(centre, radius));
        }
        self.place(outside);
        self.cut_off();
    }

    /// Places labels and draws them.
    fn place(&mut self, requests: Vec<(Wanted, u16)>) {
        let asked: Vec<LabelRequest> = requests.iter().map(|w| w.0.request.clone()).collect();
        for (label, (wanted, since)) in place(&asked, &self.obstacles).into_iter().zip(requests) {
            if label.crowded && wanted.optional {
                continue;
            }
            self.since = since;
            if let Some((a, b)) = label.leader {
                self.put(None, Pen::Leader, Shape::Line(a, b));
            }
            let id = format!("{}-{}", self.prefix, ascii(&wanted.name));
            let mark = self.put(Some(id), wanted.pen, Shape::Text(label.text));
            mark.number = wanted.number;
        }
    }

    /// Cuts off what leaves the panel.
    fn cut_off(&mut self) {
        let marks = &mut self.drawing.marks;
        let leaves = |mark: &Mark| !is_within(self.frame, &mark.shape);
        if !marks[self.before..].iter().any(leaves) {
            return;
        }
        for mark in marks.split_off(self.before) {
            let mut id = mark.id;
            for shape in clipped(self.frame, mark.shape) {
                marks.push(Mark { id: id.take(), shape, ..mark });
            }
        }
    }
}

/// Boxes that cover a circle together.
fn strips(centre: Point, radius: f64) -> impl Iterator<Item = Rect> {
    const COUNT: usize = 8;
    let height = 2.0 * radius / COUNT as f64;
    (0..COUNT).map(move |index| {
        let low = height * index as f64 - radius;
        // Widest where the strip is nearest to the middle.
        let nearest = 0.0_f64.clamp(low, low + height);
        let half = (radius * radius - nearest * nearest).max(0.0).sqrt();
        Rect::new(-half, low, half, low + height) + centre.to_vec2()
    })
}

/// Boxes that cover a polygon together; along a turned block several small ones leave more room than a large one.
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

/// A name fit for an XML id: other letters than ASCII ones by their code, so that names stay different.
fn ascii(name: &str) -> String {
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
