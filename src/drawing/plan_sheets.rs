//! Sheets on which the plans of a scene are drawn by hand: an empty panel for each, with its pole and its scale.

use super::canvas::Canvas;
use super::compose::Composition;
use super::figure::composition;
use super::layout::{Item, Needs, Placed};
use super::lines::{Line, Lines};
use super::panel::{Frame, Layer, Panel};
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::sheet_notes::Fields;
use super::text::RichText;
use super::view::{Extent, View};
use super::worksheet::Ruler;
use crate::construction::Solution;
use crate::geometry;
use crate::quantity::Kind;
use crate::scene::{ConstructionShown, Page, PageSize};
use crate::sheet::{PerSheet, Scales, Sheet};
use kurbo::Point;

/// White in a panel around the right plan, in mm: a wrong one is larger.
const WHITE: f64 = 10.0;

/// The sheets for the plans that the figure shows, at these scales, with numbers from `first` on: both
/// on one sheet where both have room, else one each; on the figure's page, as it lies or turned, else on A3.
pub(super) fn plan_sheets(solution: &Solution, scales: &Scales, name: &str, first: u16) -> Vec<Drawing> {
    let own = solution.scene.figure.page;
    let shown = solution.scene.figure.shown_panels();
    let mu = PerSheet::from_fn(|sheet| scales[sheet].filter(|_| sheet.is_plan()));
    let is_wanted = |panel: &Sheet| {
        let has_plan = solution.construction.plans().any(|plan| plan.kind == *panel);
        shown.contains(panel) && has_plan && mu[*panel].is_some()
    };
    let plans: Vec<Sheet> = Sheet::PLANS.into_iter().filter(is_wanted).collect();
    let sheet = |page: Page, plans: &[Sheet], number: u16| {
        let mut solution = solution.clone();
        solution.scene.figure.page = page;
        let scheme = Scheme { mu, ..Scheme::new(&solution).for_pencil().without_values() };
        let dims = if scheme.figure.has_markers() { scheme.dims.with_markers() } else { scheme.dims };
        drawn(&Scheme { dims, ..scheme }, plans, number, name)
    };
    if plans.len() > 1
        && let (both, true) = sheet(own, &plans, first)
    {
        return vec![both];
    }
    let turned = |page: Page| Page { landscape: !page.landscape, ..page };
    let large = Page { size: PageSize::A3, ..own };
    let pages = [own, turned(own), large, turned(large)];
    let alone = |(plan, number): (&Sheet, u16)| {
        let drawn = pages.map(|page| sheet(page, &[*plan], number));
        let fitting = drawn.iter().position(|(_, fits)| *fits).unwrap_or(2);
        drawn.into_iter().nth(fitting).map(|(sheet, _)| sheet)
    };
    plans.iter().zip(first..).filter_map(alone).collect()
}

/// A sheet for some plans, and whether it has room for them.
fn drawn(scheme: &Scheme<'_>, plans: &[Sheet], number: u16, name: &str) -> (Drawing, bool) {
    let mut sheet = composed(scheme, plans);
    sheet.signs = scheme.figure.has_markers().then(|| scheme.signs(number, name));
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
fn composed<'a>(scheme: &'a Scheme<'a>, plans: &[Sheet]) -> Composition<'a> {
    let panels = plans.iter().filter_map(|plan| panel(scheme, *plan)).collect();
    let title = scheme.title();
    let (fields, own_line) = match Fields::new(scheme, &title) {
        Ok(fields) => (Some(Box::new(fields) as Box<dyn Item>), None),
        Err(line) => (None, Some(line)),
    };
    let sentence = scheme.figure.has_markers().then(|| scheme.words.language.sheet_markers().to_owned());
    let lines = Lines::of(own_line.iter().chain(&sentence), scheme.dims.width_below());
    let ruler = Ruler::below(scheme, &lines);
    let below = [Box::new(lines) as Box<dyn Item>, ruler];
    composition(scheme, panels, None, below.into_iter().chain(fields).collect())
}

/// The empty panel of a plan.
fn panel<'a>(scheme: &'a Scheme<'a>, plan: Sheet) -> Option<Panel<'a>> {
    let drawn = scheme.plan(plan)?;
    let name = scheme.words.language.sheet(plan);
    let frame = Frame::new(Line::new(vec![RichText::plain(name)]), Pen::Heading);
    let needs = Needs {
        kind: Kind::drawn_on(plan),
        extent: plan_panel::extent(drawn, ConstructionShown::Whole),
        heading: frame.width(),
        above: 0.0,
        mu: scheme.mu[plan],
        white: WHITE,
        weight: 1.0,
    };
    let pole = drawn.kind.pole();
    let layer = move |canvas: &mut Canvas<'_>, view: &View| {
        let (center, radius) = (view.at(geometry::Point::origin()), 2.0 * scheme.dims.dot);
        canvas.draw_named(&format!("point-{pole}"), Pen::Pole, Shape::Circle { center, radius });
        canvas.label_renamed(pole, &scheme.shown(pole, Some(drawn)), center, radius + 0.7, None);
    };
    Some(Panel {
        name: name.to_owned(),
        prefix: plan.as_str().to_owned(),
        needs,
        cut: scheme.words.language.cut_at_edge().to_owned(),
        unlabelled: scheme.words.language.names_without_room().to_owned(),
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
