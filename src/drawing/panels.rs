//! The panels of a figure: their extents and their layers.

use super::canvas::Canvas;
use super::context::SheetContext;
use super::layout::{Needs, WHITE};
use super::lines::Line;
use super::panel::{Frame, Layer, Layers, Panel, numbered};
use super::plan;
use super::scheme;
use super::sheet::Pen;
use super::text::RichText;
use super::view::{Extent, View};
use crate::construction::Solution;
use crate::sheet::Sheet;

/// Weight of the size of a panel beside that in focus.
pub(super) const COMPANION: f64 = 0.2;

/// The panels with content, and its extents.
pub(super) type Extents = Vec<(Sheet, Extent)>;

/// The panels that a figure shows.
pub(super) fn extents(context: &SheetContext<'_>) -> Extents {
    let extent = |&sheet: &Sheet| match sheet {
        Sheet::Scheme => Some((sheet, scheme::sight::extent(context))),
        plan => context.plan(plan).map(|drawn| (plan, plan::sight::extent(drawn, context.figure().construction))),
    };
    context.figure().shown_panels().iter().filter_map(extent).collect()
}

/// The extent of the joints or of their images in a panel, in the position of a solution.
pub(super) fn extent_of_images(solution: &Solution, sheet: Sheet) -> Option<Extent> {
    match sheet {
        Sheet::Scheme => Some(scheme::sight::extent_of_joints(solution)),
        plan => solution.construction.plan_on(plan).map(plan::sight::extent_of_images),
    }
}

/// Panels of these extents, with layers from `layers`.
pub(super) fn panels<'a>(
    context: &SheetContext<'a>,
    extents: &[(Sheet, Extent)],
    layers: impl Fn(Sheet) -> Layers<'a>,
) -> Vec<Panel<'a>> {
    let panel = |(index, &(panel, extent)): (usize, &(Sheet, Extent))| {
        let name = context.words.language.sheet(panel);
        let line = |heading: &str| Line::new(vec![RichText::plain(heading)]);
        let frame = |index| Frame { short: Some(line(name)), ..Frame::new(line(&numbered(index, name)), Pen::Heading) };
        let lowest: Box<dyn Layer> = Box::new(frame(index));
        Panel {
            name: name.to_owned(),
            prefix: panel.as_str().to_owned(),
            // The width of the first panel's heading: it must not depend on the panel's letter.
            needs: Needs {
                above: if panel == Sheet::Scheme { scheme::above(context) } else { 0.0 },
                kind: panel.drawn(),
                extent,
                heading: frame(0).width(),
                mu: context.surface.mu[panel],
                white: WHITE,
                weight: if context.figure().focus.is_some_and(|focus| focus != panel) { COMPANION } else { 1.0 },
            },
            cut: context.words.language.cut_at_edge().to_owned(),
            unlabelled: context.words.language.names_without_room().to_owned(),
            content: context.plan(panel).map(|plan| plan::sight::extent(plan, context.figure().construction)),
            layers: std::iter::once(lowest).chain(layers(panel)).collect(),
        }
    };
    extents.iter().enumerate().map(panel).collect()
}

/// The layer with the scheme or a plan.
pub(super) fn content<'a>(context: &'a SheetContext<'a>, panel: Sheet) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, context.plan(panel)) {
        (Sheet::Scheme, _) => scheme::draw(canvas, view, context),
        (_, Some(plan)) => plan::draw(canvas, view, context, plan),
        (_, None) => {}
    })
}

/// The layer with the hints at the subject of each step.
pub(super) fn hints<'a>(context: &'a SheetContext<'a>, panel: Sheet) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, context.plan(panel)) {
        (Sheet::Scheme, _) => scheme::hints(canvas, view, context),
        (_, Some(plan)) => plan::hints(canvas, view, context, plan),
        (_, None) => {}
    })
}
