//! How sheets of exercises write quantities, and their notes: room for a name, the paper that the plans need, which sense is positive, what the
//! auxiliary points of the plans are.

use super::compose::TITLE_SIZE;
use super::context::{Purpose, SheetContext};
use super::dims::MARGIN;
use super::layout::{Item, Layout};
use super::plan::on_paper::extent;
use super::sheet::Drawing;
use super::text::{CAPTION, RichText};
use crate::construction::{Plan, PointRole, Rate, Solution, VectorOf, VectorPart, image_name};
use crate::quantity::{Corners, QuantityRequest, What};
use crate::scene::{ConstructionShown, Page, PageSize};
use crate::sheet::{Order, Sheet};
use crate::words::NumberStyle;
use kurbo::{Point, Rect};

/// White on a sheet of paper around a plan, in mm.
const WHITE: f64 = 10.0;
/// Least white between the title and the fields beside it, in mm.
const GAP: f64 = 8.0;

/// How the sheets of a scene write quantities and plan points.
pub struct SheetLabels<'a>(SheetContext<'a>);

impl<'a> SheetLabels<'a> {
    /// The labels of a scene.
    #[must_use]
    pub fn of(solution: &'a Solution) -> SheetLabels<'a> {
        SheetLabels(SheetContext::new(solution, Purpose::Drawing))
    }

    /// A quantity: a segment or length by its ends, a rate by its symbol.
    #[must_use]
    pub fn quantity(&self, asked: &QuantityRequest) -> RichText {
        RichText::math(&self.0.quantity(asked))
    }

    /// The velocity or acceleration, or its part, that a segment of a plan is: `v_B` from the pole to `b`, `v_CB` from `b` to `c`, `aᵗ_CB` from the
    /// end of a normal part to `c`. `None` for other quantities, and for segments that are none of these.
    #[must_use]
    pub fn vector(&self, asked: &QuantityRequest) -> Option<RichText> {
        self.0.vector(asked).as_deref().map(RichText::math)
    }

    /// Which sense is positive, and what the auxiliary points are that the quantities name.
    #[must_use]
    pub fn notes(&self, asked: &[QuantityRequest]) -> Vec<RichText> {
        self.0.notes(asked).iter().map(|note| RichText::plain(note)).collect()
    }

    /// A point of a sheet: an image by its name in the figure's notation, an instant centre by its symbol, a joint by its label.
    #[must_use]
    pub fn place(&self, sheet: Sheet, name: &str) -> RichText {
        RichText::math(&self.0.place_name(sheet, name))
    }
}

impl SheetContext<'_> {
    /// The markup of a point of a sheet: an image by its name in the figure's notation, an instant centre by its symbol, a joint by its label.
    pub(super) fn place_name(&self, sheet: Sheet, name: &str) -> String {
        let centers = self.construction().centers.as_ref().filter(|_| sheet == Sheet::Centers);
        let center = centers.and_then(|centers| centers.all.iter().find(|center| center.name == name));
        match center {
            Some(center) => self.center_symbol(center.pair, center.figure),
            None => self.shown(name, self.plan(sheet)),
        }
    }

    /// How a quantity is written on the sheets, in markup: a segment or length by its ends, a rate by its symbol.
    pub(super) fn quantity(&self, asked: &QuantityRequest) -> String {
        let plan = match &asked.what {
            What::Segment(order, _) => self.construction().plan(*order),
            _ => None,
        };
        let between = |from: &str, to: &str| format!("{} {}", self.shown(from, plan), self.shown(to, plan));
        match &asked.what {
            What::Segment(_, [from, to]) => between(from, to),
            What::Corners(Corners { ends: [from, to], .. }) if asked.written.component.is_none() => between(from, to),
            What::Length(from, to) if asked.sheet() == Sheet::Scheme => between(from.name(), to.name()),
            _ => asked.symbol(self.mechanism(), &self.words.notation, &|name| self.shown(name, None)),
        }
    }

    /// The markup of the vector that a segment of a plan is.
    fn vector(&self, asked: &QuantityRequest) -> Option<String> {
        let What::Segment(order, [from, to]) = &asked.what else { return None };
        if asked.written.component.is_some() {
            return None;
        }
        let construction = self.construction();
        let plan = construction.plan(*order)?;
        let role = |name: &str| plan.points.get(name).map(|point| point.role);
        // The point whose image it is; that of a link, as `b3`, is written as the sheets of textbooks have it.
        let point = |image: &str| match role(image)? {
            PointRole::Normal => None,
            _ if image.contains('_') => None,
            _ => {
                let known = self.mechanism().points.iter().find(|point| image_name(point) == image);
                let mut letters = image.chars();
                let upper = || letters.next().map(|first| first.to_uppercase().chain(letters).collect::<String>());
                known.map(|point| self.shown(point, None)).or_else(upper)
            }
        };
        let (letter, notation) = (order.vector(), &self.words.notation);
        // The normal part that ends there: between which points.
        let normal = |end: &str| {
            let arrow = construction.arrows(*order).find(|arrow| arrow.to == end)?;
            let towards = match &arrow.of {
                VectorOf::Relative { to, part: VectorPart::Normal, .. } => to,
                VectorOf::Normal(special, _) => &construction.special(*special).name,
                _ => return None,
            };
            Some((arrow.from.clone(), image_name(towards), format!("_{{{towards}{}}}", point(&arrow.from)?)))
        };
        match (point(from), point(to)) {
            (_, Some(to)) if role(from) == Some(PointRole::Pole) => Some(format!("{letter}_{{{to}}}")),
            (Some(from), Some(to)) => Some(format!("{letter}_{{{to}{from}}}")),
            (Some(_), None) => {
                let (start, _, pair) = normal(to)?;
                (start == *from).then(|| format!("{letter}^{}{pair}", notation.normal))
            }
            (None, Some(_)) => {
                let (_, end, pair) = normal(from)?;
                (end == *to).then(|| format!("{letter}^{}{pair}", notation.tangential))
            }
            (None, None) => None,
        }
    }

    /// The notes for a sheet with these quantities: senses, and auxiliary points.
    pub(super) fn notes(&self, asked: &[QuantityRequest]) -> Vec<String> {
        std::iter::once(self.note_on_senses(asked)).chain(self.note_on_points(asked)).collect()
    }

    /// Which sense is positive, of links and of slides.
    fn note_on_senses(&self, asked: &[QuantityRequest]) -> String {
        let language = self.words.language;
        let slides = asked.iter().filter(|a| matches!(a.what, What::Rate(Rate::Slide(..))));
        let slides: Vec<String> = slides.map(|asked| self.quantity(asked)).collect();
        match slides.is_empty() {
            true => language.exercise_senses().to_owned(),
            false => language.exercise_senses_of_slides(&slides.join(", ")),
        }
    }

    /// What the auxiliary points are that the quantities name; none where there are no such points.
    fn note_on_points(&self, asked: &[QuantityRequest]) -> Option<String> {
        let language = self.words.language;
        let is_named = |plan: &Plan, name: &str| {
            asked.iter().any(|asked| match &asked.what {
                What::Segment(order, [from, to]) => *order == plan.order && (from == name || to == name),
                _ => false,
            })
        };
        // By the letter of their names: the ends of normal, Coriolis and sliding parts.
        let ends = ["n", "k", "r"].map(|letter| {
            let mut points: Vec<String> = Vec::new();
            for plan in self.construction().plans() {
                let own =
                    |name: &str| name.split_once('_').is_some_and(|(own, _)| own.trim_end_matches('\'') == letter);
                for arrow in
                    self.construction().arrows(plan.order).filter(|arrow| own(&arrow.to) && is_named(plan, &arrow.to))
                {
                    let shown = self.shown(&arrow.to, Some(plan));
                    if !points.contains(&shown) {
                        points.push(shown);
                    }
                }
            }
            points.join(", ")
        });
        let [normal, coriolis, sliding] = &ends;
        let told = [
            (normal, language.exercise_normal_ends(normal)),
            (coriolis, language.exercise_coriolis_ends(coriolis)),
            (sliding, language.exercise_sliding_ends(sliding)),
        ];
        let told: Vec<String> = told.into_iter().filter(|(points, _)| !points.is_empty()).map(|told| told.1).collect();
        (!told.is_empty()).then(|| language.exercise_points(&told.join("; ")))
    }

    /// The sizes of both plans on paper, and the paper on which each of them has room; none without their scales.
    pub(super) fn note_on_paper(&self) -> Option<String> {
        let mut largest = [0.0_f64; 2];
        let sizes = Order::ALL.map(|order| {
            let mu = self.figure().mu[order.sheet()]?;
            let size = extent(self.construction().plan(order)?, ConstructionShown::Whole).size() / mu;
            let (short, long) = (size.x.min(size.y), size.x.max(size.y));
            largest = [largest[0].max(short), largest[1].max(long)];
            let [x, y] = [size.x, size.y].map(|mm| self.words.on_paper(libm::ceil(mm), 1.0, NumberStyle::shortest()));
            Some(format!("{}\u{a0}×\u{a0}{}\u{a0}mm", x?, y?))
        });
        let [velocity, acceleration] = sizes;
        let paper = paper_for(largest, self.surface.page);
        Some(self.words.language.exercise_room(&velocity?, &acceleration?, paper))
    }
}

/// The smallest paper with room for contents of that short and long side, in mm: of the sheet's own size or larger.
fn paper_for(content: [f64; 2], page: Page) -> &'static str {
    let own = match page.size {
        PageSize::Letter => ("Letter", [215.9, 279.4]),
        _ => ("A4", [210.0, 297.0]),
    };
    let all = [own, ("A3", [297.0, 420.0]), ("A2", [420.0, 594.0]), ("A1", [594.0, 841.0])];
    let fits = |paper: &[f64; 2]| paper.iter().zip(content).all(|(side, content)| content + 2.0 * WHITE <= *side);
    all.iter().find(|(_, paper)| fits(paper)).map_or("A0", |(name, _)| name)
}

/// Lines for name and date at the right end of the title's line; below the scales where the title leaves no room.
pub(super) struct Fields {
    fields: RichText,
    /// Their right end, in mm.
    right: f64,
}

impl Fields {
    /// The lines beside the title of a sheet, or else a sentence to stand below it.
    pub(super) fn new(context: &SheetContext<'_>) -> (Option<Fields>, Option<String>) {
        let text = context.words.language.exercise_name();
        let (fields, title) = (RichText::plain(text), RichText::verbatim(context.title()));
        let dims = &context.surface.dims;
        let room = match dims.free.has_markers() {
            true => 0.5 * (dims.page[0] - dims.free.middle) - dims.free.edge,
            false => dims.page[0] - 2.0 * MARGIN - title.width(TITLE_SIZE) - GAP,
        };
        let right = dims.page[0] - dims.free.edge;
        match fields.width(CAPTION) <= room {
            true => (Some(Fields { fields, right }), None),
            false => (None, Some(text.to_owned())),
        }
    }
}

impl Item for Fields {
    fn draw(&self, drawing: &mut Drawing, _: &Layout, _: Option<Rect>) {
        let from = Point::new(self.right - self.fields.width(CAPTION), super::compose::TITLE_LINE);
        drawing.caption(self.fields.clone(), from);
    }
}
