//! Panels of a sheet, each with layers: what a figure shows in them, and how large it is.

use super::canvas::{Canvas, Held};
use super::centers;
use super::context::SheetContext;
use super::dims::Dims;
use super::forces;
use super::layout::{Needs, Placed, ROW};
use super::lever;
use super::lines::Line;
use super::markers::PlacedPanel;
use super::overlay::OwnLayer;
use super::plan;
use super::scale_bar::ScaleBars;
use super::scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::speeds;
use super::text::{CAPTION, RichText};
use super::view::{Extent, Series, View};
use crate::construction::{Construction, Plan, Solution};
use crate::cycle::{Animation, differing_drives};
use crate::geometry;
use crate::scene::ConstructionShown;
use crate::sheet::Sheet;
use crate::text::Untrusted;
use crate::words::Language;
use indexmap::IndexMap;
use kurbo::{Point, Rect, Vec2};
use std::borrow::Borrow;

/// Size of panels' headings, in mm of one em.
const SIZE: f64 = 1.05 * CAPTION;
/// Positions in which the largest content of a cycle is looked for.
const POSITIONS: usize = 72;
/// Fewer, but at least so many, where there are many cycles or many points: in all positions about so many places of points,
/// or it would take seconds.
const LEAST_POSITIONS: usize = 12;
const MOST_PLACES: usize = 20_000;
/// Where a drive swings, vectors run off to infinity at the ends of its range: what is so many times as large as half of
/// the positions are is not seen whole, or the others would be too small to be read.
const RUNS_OFF: f64 = 3.0;
/// White before a heading, in mm.
const BEFORE: f64 = 2.5;
/// White between a heading and the scale beside it, in mm.
const APART: f64 = 5.0;
/// Weight of the size of a panel beside that in focus.
pub(super) const COMPANION: f64 = 0.4;

/// A panel: a frame with its heading, and layers in it.
pub(super) struct Panel<'a> {
    /// Its name, in the figure's language.
    pub name: String,
    /// Prefix of its marks' ids.
    pub prefix: String,
    /// The room that it needs.
    pub needs: Needs,
    /// The language in which it says that its content is cut off or that it has no room for all names; none where it does
    /// not say so.
    pub language: Option<&'static Language>,
    /// The extent of what is held in sight where the panel is for other positions, too.
    pub content: Option<Extent>,
    /// Its border and heading; none on a sheet that has them already.
    pub frame: Option<Frame>,
    /// Its layers, the lowest first.
    pub layers: Vec<Layer<'a>>,
    /// A student's drawing over them.
    pub own: Option<OwnLayer<'a>>,
}

/// Draws something on a panel, over what is there before.
pub(super) type Layer<'a> = Box<dyn Fn(&mut Canvas<'_>, &View) + 'a>;

impl<'a> Panel<'a> {
    /// A panel that says nothing of what it cannot show.
    pub(super) fn plain(name: &str, prefix: &str, needs: Needs, frame: Frame, layers: Vec<Layer<'a>>) -> Self {
        let (name, prefix) = (name.to_owned(), prefix.to_owned());
        Panel { name, prefix, needs, language: None, content: None, frame: Some(frame), layers, own: None }
    }

    /// Draws the panel in its place; `renamed` replaces names of points and links. What was `held` in the picture before
    /// stays where it was, if it can.
    pub(super) fn draw(
        &self,
        drawing: &mut Drawing,
        placed: &Placed,
        renamed: &IndexMap<String, Untrusted>,
        dims: &Dims,
        held: Option<&mut Held>,
    ) {
        let view = placed.view(self.content);
        let before = drawing.marks.len();
        let mut canvas = Canvas::new(drawing, [&self.name, &self.prefix], placed.frame, renamed, *dims);
        canvas.held = held;
        canvas.header = placed.header();
        canvas.keep_rows(placed.needs.rows);
        canvas.is_part = placed.needs.is_part;
        if let Some(own) = &self.own {
            own.reserve(&mut canvas, &view);
        }
        if let Some(frame) = &self.frame {
            frame.draw(&mut canvas, Some(placed));
        }
        for layer in &self.layers {
            layer(&mut canvas, &view);
        }
        if let Some(own) = &self.own {
            own.draw(&mut canvas, &view);
        }
        canvas.finish(self.language);
        if let Some(own) = &self.own {
            let mut marks = drawing.marks.split_off(before);
            own.retouch(&mut marks);
            drawing.marks.append(&mut marks);
        }
    }
}

impl Placed {
    /// The view of the panel, moved so that a content that fits stays in sight, and always the pole of a whole plan.
    pub(super) fn view(&self, content: Option<Extent>) -> View {
        let mut view = View::new(self.mu * self.unit, &self.needs.extent, self.area);
        if let Some(content) = content.filter(|content| self.holds(content)) {
            view = view.holding(content.low, self.area).holding(content.high, self.area);
        }
        if self.needs.sheet.order().is_some() && !self.needs.is_part {
            view = view.holding(geometry::Point::origin(), self.area);
        }
        view
    }

    /// Height of heading, scale and rows of names, in mm.
    fn header(&self) -> f64 {
        self.needs.heading_height(self.frame.width())
    }

    /// The panel on a sheet, for programs that read a photograph of it.
    pub(super) fn on_paper(&self, content: Option<Extent>) -> PlacedPanel {
        let origin = self.view(content).at(geometry::Point::origin());
        let origin = [origin.x, origin.y].map(|place| place * self.unit);
        PlacedPanel { panel: self.needs.sheet, mu: self.mu, origin }
    }
}

/// A panel's border and heading.
pub(super) struct Frame {
    pub heading: Line,
    /// What stands in a panel that is too narrow for the heading.
    pub short: Option<Line>,
    pub pen: Pen,
    /// Start of the heading, from the panel's upper left corner, in mm.
    pub at: Vec2,
    /// What the panel's scale is written with, where it is written here.
    pub scale: Option<ScaleBars>,
}

impl Frame {
    /// A frame with the heading inside.
    pub(super) fn new(heading: Line, pen: Pen) -> Frame {
        Frame { heading, short: None, pen, at: Vec2::new(BEFORE, 6.0), scale: None }
    }

    /// This frame with the panel's scale beside or below the heading.
    pub(super) fn with_scale(self, context: &SheetContext<'_>) -> Frame {
        Frame { scale: Some(ScaleBars::of(context)), ..self }
    }

    /// What a panel of a sheet with this frame needs.
    pub(super) fn needs(&self, context: &SheetContext<'_>, sheet: Sheet, extent: Extent) -> Needs {
        let scale = self.scale_width(context, (sheet, extent), context.surface.mu[sheet]);
        let needs = Needs { scale, ..Needs::usual(sheet, extent, self.width()) };
        // Scales for a hand are chosen with more white: on a work sheet markers need a part of it.
        match (context.surface.series, context.surface.mu[sheet]) {
            (Series::Any, _) | (Series::Hand, None) => needs,
            _ => needs.tight(),
        }
    }

    /// Width of the panel's scale at its narrowest, in mm: of that which is given, or of any that the content may get; 0
    /// where none is written.
    pub(super) fn scale_width(&self, context: &SheetContext<'_>, of: (Sheet, Extent), given: Option<f64>) -> f64 {
        let (sheet, size) = (of.0, of.1.size());
        let page = context.surface.dims.page.map(|side| side * context.surface.dims.unit);
        let coarse = (size.x / page[0]).max(size.y / page[1]).max(f64::MIN_POSITIVE);
        self.scale.map_or(0.0, |scales| scales.least_width(sheet, given, coarse) + BEFORE + APART)
    }

    /// Smallest width of a panel with this heading, in mm.
    pub(super) fn width(&self) -> f64 {
        self.heading.width(SIZE) + 2.0 * BEFORE
    }

    /// Draws it; the scale of a panel in its place.
    pub(super) fn draw(&self, canvas: &mut Canvas<'_>, placed: Option<&Placed>) {
        let frame = canvas.frame;
        canvas.drawing.draw(Pen::Frame, Shape::rectangle(frame));
        // A short one is no smaller than captions.
        let (heading, size) = match &self.short {
            // White on the right may be narrower: letters of panels differ in width.
            Some(short) if self.width() - BEFORE > frame.width() => (short, CAPTION),
            _ => (&self.heading, SIZE),
        };
        let from = frame.origin() + self.at;
        let ink = heading.starting(canvas.drawing, self.pen, from, size);
        canvas.obstacles.add_texts([ink]);
        if let (Some(scales), Some(placed)) = (self.scale, placed) {
            let room = Rect { x0: frame.x0 + BEFORE, x1: frame.x1 - BEFORE, ..frame };
            let below = placed.needs.is_scale_below(frame.width());
            let room = if below { room } else { Rect { x0: ink.x1 + APART, ..room } };
            let bar = scales.bar_within(placed.needs.sheet, placed.mu, room.width());
            let from = Point::new(room.x1 - bar.width(), from.y);
            let from = if below { Point::new(room.x0, from.y + ROW) } else { from };
            let ink = bar.draw(canvas.drawing, from, Some(format!("scale-{}", placed.needs.sheet.as_str())));
            canvas.obstacles.add_texts([ink]);
        }
        canvas.exclude_drawn();
    }
}

/// The heading of the panel with this index, as in `(a) Scheme`.
pub(super) fn numbered(index: usize, name: &str) -> String {
    format!("({}) {name}", char::from(b'a' + index as u8))
}

/// The panels with content, and its extents.
pub(super) type Extents = Vec<(Sheet, Extent)>;

/// The panels that a figure shows.
pub(super) fn extents(context: &SheetContext<'_>) -> Extents {
    extents_with(context, scheme::on_paper::extent)
}

/// The panels that a figure shows, with this extent of the scheme.
fn extents_with(context: &SheetContext<'_>, scheme: impl Fn(&SheetContext<'_>) -> Extent) -> Extents {
    let extent = |&sheet: &Sheet| {
        let extent = match sheet {
            Sheet::Scheme => scheme(context),
            Sheet::Centers => centers::extent(context),
            Sheet::Speeds => speeds::extent(context)?,
            plan => plan_extent(plan, context.construction(), context.figure().construction)?,
        };
        Some((sheet, extent))
    };
    context.figure().shown_panels().iter().filter_map(extent).collect()
}

/// All positions of the mechanism on its branch, by drive; drives that turn equally fast have the same.
pub(super) fn cycles_of(own: &Solution) -> impl Iterator<Item = Animation> {
    let drives = differing_drives(&own.mechanism);
    let count = positions_of_each(own, drives.len(), POSITIONS);
    drives.into_iter().filter_map(move |drive| Animation::new(own, Some(&drive), count).ok())
}

/// All positions of the mechanism on its branch for one of its drives, without a name for the first.
pub(super) fn cycle_of(own: &Solution, drive: Option<&str>) -> Option<Animation> {
    Animation::new(own, drive, positions_of_each(own, 1, POSITIONS)).ok()
}

/// How many positions of each of some cycles are looked at: `most`, or fewer where that would be very many places of points.
pub(super) fn positions_of_each(own: &Solution, cycles: usize, most: usize) -> usize {
    (MOST_PLACES / (cycles * own.mechanism.points.len()).max(1)).clamp(LEAST_POSITIONS, most)
}

/// The extents of the panels over all positions of cycles: of plans that run off what is usual, of the scheme the mechanism
/// in all positions, but its special points, which go round by way of infinity, only in its own.
pub(super) fn extents_in(own: &SheetContext<'_>, cycles: impl IntoIterator<Item: Borrow<Animation>>) -> Extents {
    let mechanism = |context: &SheetContext<'_>| Extent::of(scheme::on_paper::places(context.solution));
    let seen = |cycle: &Animation| -> Vec<Extents> {
        cycle.positions.iter().map(|position| extents_with(&own.at_position(position), mechanism)).collect()
    };
    // One after another: of many drives all positions at once take gigabytes.
    let cycles = cycles.into_iter().map(|cycle| (cycle.borrow().is_round, seen(cycle.borrow())));
    let seen: Vec<(bool, Vec<Extents>)> = cycles.collect();
    let with_cycles = |(panel, extent): (Sheet, Extent)| {
        let of_panel = |all: &Extents| all.iter().find(|(own, _)| *own == panel).map(|(_, extent)| *extent);
        let whole = seen.iter().fold(extent, |whole, (is_round, all)| {
            let all = all.iter().filter_map(of_panel);
            let is_whole = *is_round || panel == Sheet::Scheme;
            if is_whole { whole.with_all(all) } else { whole.with_usual(RUNS_OFF, all) }
        });
        (panel, whole)
    };
    extents(own).into_iter().map(with_cycles).collect()
}

/// The extent of a plan, about its pole, or of polygons of forces or levers about their origin; none of what a position does
/// not have, and of the scheme.
pub(super) fn plan_extent(sheet: Sheet, construction: &Construction, details: ConstructionShown) -> Option<Extent> {
    match sheet {
        Sheet::Scheme | Sheet::Centers | Sheet::Speeds => None,
        Sheet::Forces => forces::extent(construction),
        Sheet::Lever => lever::extent(construction),
        Sheet::Velocity | Sheet::Acceleration => Some(plan::on_paper::extent(construction.plan_on(sheet)?, details)),
    }
}

/// White between the heading of a panel and its content for what stands there, in mm.
fn above(context: &SheetContext<'_>, sheet: Sheet) -> f64 {
    match sheet {
        Sheet::Speeds => speeds::ABOVE,
        Sheet::Forces => scheme::above(context).max(forces::ABOVE),
        Sheet::Velocity | Sheet::Acceleration => 0.0,
        _ => scheme::above(context),
    }
}

/// Panels of these extents, with layers from `layers`.
pub(super) fn panels<'a>(
    context: &SheetContext<'a>,
    extents: &[(Sheet, Extent)],
    layers: impl Fn(Sheet) -> Vec<Layer<'a>>,
) -> Vec<Panel<'a>> {
    let panel = |(index, &(sheet, extent)): (usize, &(Sheet, Extent))| {
        let name = &context.sheet_name(sheet);
        let line = |heading: &str| Line::new(vec![RichText::plain(heading)]);
        let frame = |index| Frame {
            short: Some(line(name)),
            ..Frame::new(line(&numbered(index, name)), Pen::Heading).with_scale(context)
        };
        // The width of the first panel's heading: it must not depend on the panel's letter.
        let own = frame(0).needs(context, sheet, extent);
        let needs = Needs {
            above: above(context, sheet),
            below: if sheet == Sheet::Speeds { speeds::below(context, own.white) } else { 0.0 },
            mu: context.surface.mu[sheet],
            weight: if context.figure().focus.is_some_and(|focus| focus != sheet) {
                COMPANION
            } else {
                Needs::weight_of(sheet)
            },
            ..own
        };
        Panel {
            language: Some(context.words.language),
            content: context.plan(sheet).map(|plan| plan::on_paper::extent(plan, context.figure().construction)),
            ..Panel::plain(name, sheet.as_str(), needs, frame(index), layers(sheet))
        }
    };
    extents.iter().enumerate().map(panel).collect()
}

/// The layer with the scheme or a plan.
pub(super) fn content<'a>(context: &'a SheetContext<'a>, sheet: Sheet) -> Layer<'a> {
    layer(context, sheet, [scheme::draw, centers::draw, forces::draw, lever::draw, speeds::draw], plan::draw)
}

/// The layer with the hints at the subject of each step.
pub(super) fn hints<'a>(context: &'a SheetContext<'a>, sheet: Sheet) -> Layer<'a> {
    layer(context, sheet, [scheme::hints, centers::hints, |_, _, _| (), lever::hints, |_, _, _| ()], plan::hints)
}

/// A layer of the scheme or of a plan; a plan that a position does not have is not drawn.
fn layer<'a>(
    context: &'a SheetContext<'a>,
    sheet: Sheet,
    [of_scheme, of_centers, of_forces, of_lever, of_speeds]: [fn(&mut Canvas<'_>, &View, &SheetContext<'_>); 5],
    of_plan: fn(&mut Canvas<'_>, &View, &SheetContext<'_>, &Plan),
) -> Layer<'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match sheet {
        Sheet::Scheme => of_scheme(canvas, view, context),
        Sheet::Centers => of_centers(canvas, view, context),
        Sheet::Forces => of_forces(canvas, view, context),
        Sheet::Lever => of_lever(canvas, view, context),
        Sheet::Speeds => of_speeds(canvas, view, context),
        Sheet::Velocity | Sheet::Acceleration => {
            if let Some(plan) = context.plan(sheet) {
                of_plan(canvas, view, context, plan);
            }
        }
    })
}
