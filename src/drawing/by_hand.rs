//! The sheets of a drawing board: a sheet with what a hand has drawn on it, on a part of a screen or on paper.

use super::canvas::Canvas;
use super::centers;
use super::clip::clipped_segment;
use super::compose::titled;
use super::context::{Purpose, SheetContext};
use super::exercise::plan_sheet_with;
use super::held_layout::Pane;
use super::labels::LabelRequest;
use super::overlay::cross;
use super::scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Emphasis, Pen};
use super::text::{CAPTION, RichText};
use super::view::{Extent, View, on_sheet};
use crate::construction::{Solution, display};
use crate::geometry::{Point as Place, Vector};
use crate::scene::ConstructionShown;
use crate::sheet::{Order, Scales, Sheet};
use kurbo::Rect;

/// What a hand has drawn on a sheet, in units of the sheet from the pole, or from the scheme's first point.
#[derive(Clone, Debug)]
pub struct HandSheet {
    /// Which sheet.
    pub sheet: Sheet,
    /// Its lines.
    pub lines: Vec<HandLine>,
    /// Its vectors.
    pub vectors: Vec<HandVector>,
    /// Its points, those that are there from the beginning left out.
    pub points: Vec<HandPoint>,
}

/// A line through the whole sheet.
#[derive(Clone, Debug)]
pub struct HandLine {
    /// Its name.
    pub name: String,
    /// A place of it.
    pub at: Vector,
    /// Its unit direction.
    pub along: Vector,
    /// How it looks.
    pub look: HandLook,
}

/// A vector that is laid off.
#[derive(Clone, Debug)]
pub struct HandVector {
    /// Where it begins.
    pub from: Vector,
    /// Where it ends.
    pub to: Vector,
    /// How it looks.
    pub look: HandLook,
}

/// A point that has been found.
#[derive(Clone, Debug)]
pub struct HandPoint {
    /// Its name.
    pub name: String,
    /// Its place.
    pub at: Vector,
    /// How it looks.
    pub look: HandLook,
}

/// How something on a hand's sheet looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandLook {
    /// As it was drawn.
    Drawn,
    /// It is wrong.
    Wrong,
    /// It only follows from something wrong.
    Following,
    /// A hint: not drawn yet.
    Ghost,
}

/// A sheet of a drawing board: how large it is, and where the pole or the scheme's first point stands on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandPaper {
    /// Units of the sheet per millimetre.
    pub mu: f64,
    /// Width and height in millimetres.
    pub size: [f64; 2],
    /// Where the pole or the scheme's first point stands, in millimetres from the upper left corner, y down.
    pub origin: [f64; 2],
}

/// White around a plan on its sheet, in parts of the larger side, and at least so many mm: a wrong plan is larger.
const AROUND: [f64; 2] = [0.3, 25.0];

/// Half the width of the cross by which something wrong is struck, in radii of a point.
const STRUCK: f64 = 3.5;

impl HandPaper {
    /// Longest side of a paper, in mm: a hundred metres.
    pub const LONGEST: f64 = 1e5;

    /// The sheet of a scheme or a plan at a scale, with room for what may come out wrong, and for other places, in units of the sheet from its
    /// origin; `None` for a plan that is not there, and at a scale at which no paper is large enough.
    #[must_use]
    pub fn of(
        solution: &Solution,
        sheet: Sheet,
        mu: f64,
        others: impl IntoIterator<Item = Vector>,
    ) -> Option<HandPaper> {
        let context = SheetContext::new(solution, Purpose::Exercise);
        let extent = match sheet.order() {
            None if sheet == Sheet::Centers => centers::extent(&context),
            None if sheet == Sheet::Forces => super::forces::extent(context.construction())?,
            None => scheme::on_paper::extent(&context),
            Some(order) => super::plan::on_paper::extent(context.construction().plan(order)?, ConstructionShown::Whole),
        };
        let origin = origin(&context, sheet);
        let extent = others.into_iter().fold(extent.with(origin), |extent, place| extent.with(origin + place));
        let larger = extent.size().amax() / mu;
        let white = if sheet == Sheet::Scheme { AROUND[1] } else { (AROUND[0] * larger).max(AROUND[1]) };
        let rounded = |mm: f64| libm::ceil(mm / 5.0) * 5.0;
        let [left, above] =
            [rounded((origin.x - extent.low.x) / mu + white), rounded((extent.high.y - origin.y) / mu + white)];
        let size = extent.size() / mu;
        let [width, height] = [size.x, size.y].map(|side| rounded(side + 2.0 * white));
        (width.max(height) <= HandPaper::LONGEST).then_some(HandPaper {
            mu,
            size: [width, height],
            origin: [left, above],
        })
    }

    /// A place of the sheet, in millimetres from the upper left corner, y down.
    #[must_use]
    pub fn at(&self, place: Vector) -> [f64; 2] {
        [self.origin[0] + place.x / self.mu, self.origin[1] - place.y / self.mu]
    }

    /// What is at such a place, in units of the sheet.
    #[must_use]
    pub fn under(&self, [x, y]: [f64; 2]) -> Vector {
        Vector::new((x - self.origin[0]) * self.mu, (self.origin[1] - y) * self.mu)
    }
}

/// A sheet of a drawing board: the scheme, or the pole of a plan, with what the hand has drawn. Letters are so many millimetres high.
#[must_use]
pub fn hand_sheet(solution: &Solution, hand: &HandSheet, paper: &HandPaper, letters: f64) -> Drawing {
    let solution = &bare(solution);
    let mut context = SheetContext::new(solution, Purpose::Exercise);
    let [width, height] = paper.size;
    context.surface = context.surface.on_pane(Pane { width, height, letters, words: false }, &solution.scene.figure);
    let dims = context.surface.dims;
    let [across, down] = dims.page;
    let frame = Rect::new(0.0, 0.0, across, down);
    // Units of the layout per millimetre.
    let unit = CAPTION / letters;
    let middle = origin(&context, hand.sheet) + paper.under([0.5 * width, 0.5 * height]);
    let view = View::new(paper.mu / unit, &Extent { low: middle, high: middle }, frame);
    let mut drawing = titled(context.figure(), &dims, context.title());
    let mut canvas = Canvas::new(&mut drawing, ["", hand.sheet.as_str()], frame, &context.figure().labels, dims);
    canvas.header = 0.0;
    draw(&mut canvas, &view, &context, hand);
    canvas.finish(None);
    drawing.panels.clear();
    drawing.enlarged(1.0 / unit).after_step(0)
}

/// The plans and the figure of instant centres of a drawing board on sheets of paper like those of an exercise, with markers by which a photograph of them is read;
/// `note` stands below them.
#[must_use]
pub fn hand_sheets(
    solution: &Solution,
    hand: &[HandSheet],
    scales: &Scales,
    name: &str,
    note: Option<&str>,
) -> Vec<Drawing> {
    let solution = &bare(solution);
    let plans = hand.iter().filter(|hand| hand.sheet.has_places());
    (2..)
        .zip(plans)
        .map(|(number, hand)| {
            let layer = |canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>| {
                draw_own(canvas, view, context, hand);
            };
            plan_sheet_with(solution, scales, name, (hand.sheet, number), &layer, note)
        })
        .collect()
}

/// The solution with a figure that shows the mechanism alone.
fn bare(solution: &Solution) -> Solution {
    let mut solution = solution.clone();
    let figure = &mut solution.scene.figure;
    figure.special_points = false;
    figure.construction = ConstructionShown::Whole;
    solution
}

fn origin(context: &SheetContext<'_>, sheet: Sheet) -> Place {
    let has_own = sheet.order().is_some() || sheet == Sheet::Forces;
    if has_own { Place::origin() } else { context.construction().origin }
}

fn draw(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>, hand: &HandSheet) {
    match hand.sheet.order() {
        Some(order) => pole(canvas, view, context, order),
        None if hand.sheet == Sheet::Centers => scheme::draw_bare(canvas, view, context, |_| true),
        None if hand.sheet == Sheet::Forces => super::forces::draw_starts(canvas, view, context),
        None => scheme::draw(canvas, view, context),
    }
    draw_own(canvas, view, context, hand);
}

fn pole(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>, order: Order) {
    let (center, radius) = (view.at(Place::origin()), 2.0 * context.surface.dims.dot);
    canvas.draw_named(&format!("point-{}", order.pole()), Pen::Pole, Shape::Circle { center, radius });
    let name = RichText::math(&context.shown(order.pole(), context.construction().plan(order)));
    canvas.ask(&format!("{}-", order.pole()), LabelRequest::new(name, center, radius + 0.7, None, 2));
}

/// Draws what the hand has drawn.
fn draw_own(canvas: &mut Canvas<'_>, view: &View, context: &SheetContext<'_>, hand: &HandSheet) {
    let origin = origin(context, hand.sheet);
    let at = |place: Vector| view.at(origin + place);
    canvas.step = 0;
    for line in &hand.lines {
        let (middle, along) = (at(line.at), on_sheet(line.along));
        let reach = (canvas.frame.center() - middle).hypot() + canvas.frame.width() + canvas.frame.height();
        let Some((a, b)) = clipped_segment(canvas.room(), middle - along * reach, middle + along * reach) else {
            continue;
        };
        let pen = line.look.pen(if hand.sheet.order().is_none() { Pen::Construction } else { Pen::Ray });
        canvas.draw_named(&format!("line-{}", line.name), pen, Shape::Line(a, b)).emphasis = line.look.emphasis();
        line.look.strike(canvas, a.midpoint(b), context);
        // The name stands at the end that is higher on the sheet, where fewer lines meet.
        let end = if a.y < b.y { a.lerp(b, 0.06) } else { b.lerp(a, 0.06) };
        let text = RichText::math(&display(&line.name));
        let mut request = LabelRequest::new(text, end, 0.8, None, 0);
        request.size = CAPTION;
        request.may_stand_apart = false;
        let asked = canvas.ask(&format!("line-{}-", line.name), request);
        asked.optional = true;
        asked.pen = line.look.label(asked.pen);
    }
    let pen = match hand.sheet {
        Sheet::Acceleration => Pen::Acceleration,
        _ => Pen::Velocity,
    };
    for (index, vector) in hand.vectors.iter().enumerate() {
        let [from, to] = [vector.from, vector.to].map(at);
        vector.look.strike(canvas, from.midpoint(to), context);
        let arrow = canvas.arrow(from, to);
        canvas.draw_named(&format!("vector-{index}"), vector.look.pen(pen), arrow).emphasis = vector.look.emphasis();
    }
    for point in &hand.points {
        let (center, radius) = (at(point.at), context.surface.dims.dot);
        let pen = match point.look {
            HandLook::Wrong => Pen::WrongPoint,
            HandLook::Drawn | HandLook::Following | HandLook::Ghost => Pen::ImagePoint,
        };
        let mark = canvas.draw_named(&format!("point-{}", point.name), pen, Shape::Circle { center, radius });
        mark.emphasis = point.look.emphasis();
        point.look.strike(canvas, center, context);
        let name = RichText::math(&context.place_name(hand.sheet, &point.name));
        let asked = canvas.ask(&format!("{}-", point.name), LabelRequest::new(name, center, radius + 0.7, None, 2));
        asked.pen = point.look.label(asked.pen);
    }
}

impl HandLook {
    fn pen(self, usual: Pen) -> Pen {
        match self {
            HandLook::Drawn | HandLook::Following => usual,
            HandLook::Wrong => Pen::Wrong,
            HandLook::Ghost => Pen::Hint,
        }
    }

    fn label(self, usual: Pen) -> Pen {
        if self == HandLook::Wrong { Pen::WrongPoint } else { usual }
    }

    /// Strikes what is wrong, as teachers do: it is known without its colour, too.
    fn strike(self, canvas: &mut Canvas<'_>, at: kurbo::Point, context: &SheetContext<'_>) {
        if self == HandLook::Wrong {
            for arm in cross(at, STRUCK * context.surface.dims.dot) {
                canvas.draw(Pen::WrongPoint, arm);
            }
        }
    }

    fn emphasis(self) -> Emphasis {
        match self {
            HandLook::Drawn | HandLook::Wrong | HandLook::Ghost => Emphasis::default(),
            HandLook::Following => Emphasis::Earlier,
        }
    }
}
