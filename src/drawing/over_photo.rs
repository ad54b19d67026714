//! The right plans over a photographed sheet, straightened out.

use super::compose::blank;
use super::context::{Purpose, SheetContext};
use super::layout::Placed;
use super::markers::SheetCode;
use super::overlay::cross;
use super::panel::{Panel, content, panels};
use super::shape::Shape;
use super::sheet::{Drawing, Emphasis, Pen};
use super::text::{CAPTION, PlacedText, RichText};
use super::view::Extent;
use crate::construction::Solution;
use crate::scene::StyleName;
use crate::sheet::Sheet;
use kurbo::{Affine, Point, Rect, Vec2};

/// White round a plan, in which names have room, in mm.
const AROUND: f64 = 12.0;
/// Half the width of the cross of a point that was found, in mm.
const CROSS: f64 = 1.2;

/// A point of a plan that is seen on a photographed sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenPoint {
    /// On which plan.
    pub panel: Sheet,
    /// Its name, as in `b`.
    pub name: String,
    /// Its place on the sheet, in mm, y down.
    pub at: [f64; 2],
    /// Radius that holds it with 95 %, in mm.
    pub band: f64,
    /// Whether it is elsewhere than it should be: then it has its name.
    pub is_off: bool,
}

/// The right plans of a sheet at their places on it, in the accent colour of the style `paper`, and the points that were found, with circles that hold them.
///
/// In millimetres of the sheet, without ground: it is laid over the picture of the sheet.
#[must_use]
pub fn over_photo(solution: &Solution, code: &SheetCode, seen: &[SeenPoint]) -> Drawing {
    let mut solution = solution.clone();
    let figure = &mut solution.scene.figure;
    figure.style = StyleName::Paper;
    figure.page = code.page;
    figure.focus = None;
    figure.panels = code.panels.iter().map(|panel| panel.panel).collect();
    let mut context = SheetContext::new(&solution, Purpose::Drawing);
    for panel in &code.panels {
        context.surface.mu[panel.panel] = Some(panel.mu);
    }
    let unit = context.surface.dims.unit;
    let title = solution.scene.title.clone().unwrap_or_default();
    let mut drawing = blank(context.figure(), context.surface.dims.page, title);
    for placed in &code.panels {
        let Some(plan) = context.plan(placed.panel) else { continue };
        let extent = super::plan::on_paper::extent(plan, context.figure().construction);
        let all = panels(&context, &[(placed.panel, extent)], |panel| vec![content(&context, panel)]);
        for panel in all {
            // The photographed sheet has the frame.
            let panel = Panel { frame: None, content: None, ..panel };
            let area = Affine::scale(1.0 / unit).transform_rect_bbox(area(&extent, placed.origin, placed.mu));
            let place = Placed::with_area(&panel.needs, area.inflate(AROUND, AROUND), area, unit);
            panel.draw(&mut drawing, &place, &solution.scene.figure.labels, &context.surface.dims, None);
        }
    }
    drawing.marks.retain(|mark| mark.until.is_none());
    drawing.panels.clear();
    let mut drawing = drawing.enlarged(unit);
    for mark in &mut drawing.marks {
        mark.emphasis = Emphasis::New;
    }
    for point in seen {
        draw_seen(&mut drawing, &context, point);
    }
    drawing
}

/// The area of a plan's extent on the sheet, in mm.
fn area(extent: &Extent, pole: [f64; 2], mu: f64) -> Rect {
    let at = |x: f64, y: f64| Point::new(pole[0] + x / mu, pole[1] - y / mu);
    Rect::from_points(at(extent.low.x, extent.low.y), at(extent.high.x, extent.high.y))
}

/// Draws a point that was found: a cross, the circle that holds it, and where it is off its name with an asterisk.
fn draw_seen(drawing: &mut Drawing, context: &SheetContext<'_>, point: &SeenPoint) {
    let center = Point::new(point.at[0], point.at[1]);
    for arm in cross(center, CROSS) {
        drawing.draw(Pen::StudentPoint, arm);
    }
    drawing.draw(Pen::StudentPoint, Shape::Circle { center, radius: point.band.max(CROSS) });
    if point.is_off {
        let name = context.shown(&point.name, context.plan(point.panel));
        let name = RichText::math(&format!("{name}^*"));
        let from = center + Vec2::new(1.5 * CROSS, -1.2 * CROSS);
        drawing.draw(Pen::StudentPoint, Shape::Text(PlacedText::new(name, CAPTION * context.surface.dims.unit, from)));
    }
}
