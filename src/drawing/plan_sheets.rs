//! Sheets on which the plans of a scene are drawn by hand: an empty panel for each, with its pole and its scale.

use super::canvas::Canvas;
use super::compose::Composition;
use super::context::{Purpose, SheetContext, Surface};
use super::layout::{Item, Needs, Placed};
use super::lines::{Line, Lines};
use super::panel::{Frame, Layer, Panel};
use super::plan::sight::extent;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::sheet_notes::Fields;
use super::text::RichText;
use super::view::{Extent, View};
use super::worksheet::Ruler;
use crate::construction::Solution;
use crate::geometry;
use crate::quantity::QuantityKind;
use crate::scene::{ConstructionShown, Page, PageSize};
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::Point;

/// White in a panel around the right plan, in mm: a wrong one is larger.
const WHITE: f64 = 10.0;

/// The sheets for the plans that the figure shows, at these scales, with numbers from `first` on: both
/// on one sheet where both have room, else one each; on the figure's page, as it lies or turned, else on A3.
pub(super) fn plan_sheets(solution: &Solution, scales: &Scales, name: &str, first: u16) -> Vec<Drawing> {
    let context = SheetContext::new(solution, Purpose::Drawing);
    let own = context.figure().page;
    let shown = context.figure().shown_panels();
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet.is_plan()));
    let is_wanted = |sheet: &Sheet| shown.contains(sheet) && context.plan(*sheet).is_some() && mu[*sheet].is_some();
    let plans: Vec<Sheet> = Sheet::PLANS.into_iter().filter(is_wanted).collect();
    let sheet = |page: Page, plans: &[Sheet], number: u16| {
        let context = context.on(Surface::on_page(page, context.figure(), mu));
        match context.wants_markers() {
            true => drawn(&context.on(context.surface.with_markers()), plans, number, name),
            false => drawn(&context, plans, number, name),
        }
    };
    if plans.len() > 1
        && let (both, true) = sheet(own, &plans, first)
    {
        return vec![both];
    }
    let turned = |page: Page| Page { landscape: !page.landscape, ..page };
    let large = Page { size: PageSize::A3, ..own };
    let alone = |(plan, number): (&Sheet, u16)| {
        let pages = [own, turned(own), large, turned(large)].into_iter();
        let fitting = pages.map(|page| sheet(page, &[*plan], number)).find_map(|(drawn, fits)| fits.then_some(drawn));
        fitting.unwrap_or_else(|| sheet(large, &[*plan], number).0)
    };
    plans.iter().zip(first..).map(alone).collect()
}

/// A sheet for some plans, and whether it has room for them.
fn drawn(context: &SheetContext<'_>, plans: &[Sheet], number: u16, name: &str) -> (Drawing, bool) {
    let mut sheet = composed(context, plans);
    sheet.signs = context.wants_markers().then(|| context.signs(number, name));
    let layout = sheet.layout();
    for (panel, placed) in sheet.panels.iter_mut().zip(&layout.panels) {
        let pole = pole(&panel.needs.extent, placed);
        // The view shows the middle of the extent at the middle of the area.
        let off = (placed.area.center() - pole) * (placed.mu * placed.unit);
        panel.needs.extent = Extent::of([geometry::Point::new(off.x, -off.y)]);
    }
    (sheet.draw(&layout), layout.shows_all())
}

/// The sheet without a layout.
fn composed<'a>(context: &'a SheetContext<'a>, plans: &[Sheet]) -> Composition<'a> {
    let panels = plans.iter().filter_map(|plan| panel(context, *plan)).collect();
    let title = context.title();
    let (fields, own_line) = match Fields::new(context, &title) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let sentence = context.wants_markers().then(|| context.words.language.sheet_markers().to_owned());
    let lines = Lines::of(own_line.iter().chain(&sentence), context.surface.dims.width_below());
    let ruler = Ruler::below(context, &lines);
    let below = [Box::new(lines) as Box<dyn Item>, ruler];
    Composition::new(context, panels, None, below.into_iter().chain(fields).collect())
}

/// The empty panel of a plan.
fn panel<'a>(context: &'a SheetContext<'a>, plan: Sheet) -> Option<Panel<'a>> {
    let drawn = context.plan(plan)?;
    let name = context.words.language.sheet(plan);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading);
    let needs = Needs {
        kind: QuantityKind::drawn_on(plan),
        extent: extent(drawn, ConstructionShown::Whole),
        heading: frame.width(),
        above: 0.0,
        mu: context.surface.mu[plan],
        white: WHITE,
        weight: 1.0,
    };
    let pole = drawn.kind.pole();
    let layer = move |canvas: &mut Canvas<'_>, view: &View| {
        let (center, radius) = (view.at(geometry::Point::origin()), 2.0 * context.surface.dims.dot);
        canvas.draw_named(&format!("point-{pole}"), Pen::Pole, Shape::Circle { center, radius });
        canvas.label_renamed(pole, &context.shown(pole, Some(drawn)), center, radius + 0.7, None);
    };
    Some(Panel {
        name: name.to_owned(),
        prefix: plan.as_str().to_owned(),
        needs,
        cut: context.words.language.cut_at_edge().to_owned(),
        unlabelled: context.words.language.names_without_room().to_owned(),
        content: None,
        layers: vec![Box::new(frame) as Box<dyn Layer>, Box::new(layer)],
    })
}

/// The place of a plan's pole in its panel, at whole millimetres of paper: as near to the middle as the plan allows, so
/// that it tells little about the plan and that others have room, too.
fn pole(plan: &Extent, placed: &Placed) -> Point {
    let (area, room, mu) = (placed.area, placed.room_of_pole(), placed.mu * placed.unit);
    let within = |middle: f64, [from, to]: [f64; 2], [first, last]: [f64; 2]| {
        let place = if from <= to { middle.clamp(from, to) } else { 0.5 * (from + to) };
        let [first, last] = [libm::ceil(first * placed.unit), libm::floor(last * placed.unit)];
        libm::round(place * placed.unit).min(last).max(first) / placed.unit
    };
    let middle = area.center();
    Point::new(
        within(middle.x, [area.x0 - plan.low.x / mu, area.x1 - plan.high.x / mu], [room.x0, room.x1]),
        within(middle.y, [area.y0 + plan.high.y / mu, area.y1 + plan.low.y / mu], [room.y0, room.y1]),
    )
}
