//! A sheet whose panels and scales are held while its mechanism moves, for a hand on the picture.

use super::canvas::Held;
use super::compose::Composition;
use super::context::{Purpose, SheetContext};
use super::facts::Steps;
use super::figure::{Contents, FigureSheets, composed, described, extents_to_fit};
use super::layout::{Layout, Placed};
use super::panel::{Extents, extent_of_images, extents};
use super::plan;
use super::sheet::Drawing;
use super::values::is_hidden;
use super::view::{Extent, View, next_scale};
use crate::construction::{Plan, Solution, shown_text};
use crate::cycle::{Animation, OtherModes, Traces};
use crate::geometry;
use crate::mechanism::{GROUND, Mechanism};
use crate::scene::ScalesFor;
use crate::sheet::{Scales, Sheet};
use kurbo::{Affine, Point, Rect};
use std::sync::Arc;

/// Positions of the cycle for which there is room on the panels.
const POSITIONS: usize = 24;
/// Every so many of them is asked for the height of its words.
const WORDS_OF: usize = 4;
/// Scales that are tried for one at which the joints stay in sight.
const TRIED: usize = 6;

/// The layout of a mechanism's figure, for drawing it in any of its positions.
///
/// Scales are those of the figure in the scene's own position; the scheme's is coarser where joints would leave the panel on their
/// way, unless the scene gives it. Panels are large enough for its whole content and, as far
/// as the sheet allows, for the joints and their images in the other positions of the first drive, except for plans
/// several times as large as most: near a limit position rates and special points go to infinity. Where a position's
/// content does not fit, the panel says that it is cut at the edge; poles stay in sight. There is no work sheet.
///
/// ```
/// use kinegon::cycle::Pull;
/// use kinegon::drawing::HeldLayout;
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let own = kinegon::solve(&scene)?;
/// let layout = HeldLayout::new(&own, None, None);
/// let mut pull = Pull::new(&own, None)?;
/// for degrees in [60.0, 61.0, 62.0] {
///     let moved = own.moved(pull.to_value(degrees).pose)?;
///     let svg = layout.draw(&moved, None).svg();
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct HeldLayout {
    layout: Layout,
    /// The scales that were chosen, by panel.
    mu: Scales,
    /// By panel: the extent of all positions.
    extents: Extents,
    /// The extent of the scheme in the own position, which is held in sight.
    scheme: Option<Extent>,
    steps: Option<Steps>,
    /// The paths and ghosts, and the lengths of the mechanism that has them.
    traces: Arc<Traces>,
    mechanism: Mechanism,
    held: Held,
}

/// A place that can be taken hold of.
#[derive(Clone, Debug, PartialEq)]
pub struct Handle {
    /// The panel in which it is.
    pub panel: Sheet,
    /// The name of a point of the mechanism, or of one of a plan.
    pub name: String,
    /// Its place on the sheet.
    pub at: Point,
    /// Whether it never moves: a point of the ground, or a pole.
    pub is_fixed: bool,
}

/// A panel of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldPanel {
    /// Its name in the figure's language.
    pub name: String,
    /// Which panel it is.
    pub panel: Sheet,
    /// Its place on the sheet.
    pub frame: Rect,
    /// Whether its content is cut at the edge.
    pub is_cut: bool,
}

impl HeldLayout {
    /// The layout of a scene in its own position: for its finished figure, or with room for the words of steps; with room
    /// for other modes, if they are to be seen.
    #[must_use]
    pub fn new(own: &Solution, steps: Option<Steps>, modes: Option<&OtherModes>) -> HeldLayout {
        let traces = Arc::new(Traces::of(own));
        let mut context = with_modes(FigureSheets::with_traces(own, Arc::clone(&traces)).scaled(steps), modes);
        let animation = Animation::new(own, None, POSITIONS).ok();
        let positions = animation.as_ref().map_or(&[][..], |animation| &animation.positions);
        let own_extents = extents(&context);
        let extents: Extents = match own.scene.figure.scales {
            ScalesFor::Cycle => extents_to_fit(&context),
            _ => {
                let with_most = |&(panel, extent): &(Sheet, Extent)| {
                    let others = positions.iter().filter_map(|position| extent_of_images(position, panel));
                    (panel, extent.with_most(others))
                };
                own_extents.iter().map(with_most).collect()
            }
        };
        let contents = Contents { steps, ..Contents::default() };
        let height = |context: &SheetContext<'_>| composed(context, &extents, contents).height_below();
        let mu = context.surface.mu;
        let others = positions.iter().step_by(WORDS_OF).map(|position| height(&at_scales(position, &traces, mu)));
        let below = others.fold(height(&context), f64::max);
        let (layout, extents) = laid_out(&mut context, &own_extents, extents, contents, below);
        let scheme = own_extents.iter().find(|(panel, _)| *panel == Sheet::Scheme).map(|(_, extent)| *extent);
        let (mu, mechanism) = (context.surface.mu, own.mechanism.clone());
        HeldLayout { layout, mu, extents, scheme, steps, traces, mechanism, held: Held::default() }
    }

    /// The figure in a position of the same mechanism, or of one with other lengths; with other modes, pale. With steps
    /// [`Drawing::after_step`] gives the sheet after one of them.
    #[must_use]
    pub fn draw(&self, solution: &Solution, modes: Option<&OtherModes>) -> Drawing {
        let context = self.context_of(solution, modes);
        let drawing = described(&context, self.composed(&context, None)).draw(&self.layout);
        match self.steps {
            Some(steps) => drawing.in_steps(steps, &context),
            None => drawing,
        }
    }

    /// The figure while a hand moves the mechanism, drawn quicker: names stay beside their points where they were in the
    /// picture before, and only the words of a step are written. It is the sheet after that step; without a step the
    /// finished figure. The first picture is [`Self::draw`]'s, and so should be the last.
    #[must_use]
    pub fn drag(&mut self, solution: &Solution, modes: Option<&OtherModes>, step: Option<usize>) -> Drawing {
        let mut held = std::mem::take(&mut self.held);
        let construction = &solution.construction;
        let count = match self.steps {
            Some(Steps::Coarse) => construction.passages().len(),
            _ => construction.step_count(),
        };
        let step = step.map(|step| step.clamp(1, count.max(1)));
        let context = self.context_of(solution, modes);
        let mut sheet = self.composed(&context, step);
        sheet.steps = vec![String::new(); construction.step_count()];
        if let Some(step) = step.and_then(|number| construction.numbered_step(number)) {
            sheet.steps[step.number - 1] = shown_text(&context.teller().caption(&step), step.plan, &context.words);
        }
        let drawing = sheet.draw_holding(&self.layout, Some(&mut held));
        self.held = held;
        match (self.steps, step) {
            (Some(steps), Some(step)) => drawing.in_steps(steps, &context).after_step(step),
            _ => drawing,
        }
    }

    /// The scale of a panel, in units per mm of paper.
    #[must_use]
    pub fn mu(&self, panel: Sheet) -> Option<f64> {
        self.layout.mu_of(panel)
    }

    /// The panels of one of the layout's drawings.
    #[must_use]
    pub fn panels(&self, drawing: &Drawing) -> Vec<HeldPanel> {
        let panel = |(placed, (name, frame)): (&Placed, &(String, Rect))| {
            let panel = placed.needs.sheet;
            let says = format!("{}-cut", panel.as_str());
            let is_cut = drawing.marks.iter().any(|mark| mark.id.as_ref() == Some(&says));
            HeldPanel { name: name.clone(), panel, frame: *frame, is_cut }
        };
        self.layout.panels.iter().zip(&drawing.panels).map(panel).collect()
    }

    /// The points of the mechanism on the sheet.
    #[must_use]
    pub fn handles(&self, solution: &Solution) -> Vec<Handle> {
        let Some(view) = self.scheme_view() else { return Vec::new() };
        let mechanism = &solution.mechanism;
        let handle = |point| Handle {
            panel: Sheet::Scheme,
            name: mechanism.point_name(point).to_owned(),
            at: self.enlarged() * view.at(solution.pose.point(point)),
            is_fixed: mechanism.body(GROUND).has(point),
        };
        mechanism.point_ids().map(handle).collect()
    }

    /// The place in the scene under a place of the sheet; none without a scheme.
    #[must_use]
    pub fn place(&self, at: Point) -> Option<geometry::Point> {
        Some(self.scheme_view()?.under(self.enlarged().inverse() * at))
    }

    /// The points of the plans on the sheet, without those that the figure does not show.
    #[must_use]
    pub fn plan_handles(&self, solution: &Solution) -> Vec<Handle> {
        let plans = self.plan_views(solution);
        let handles = plans.into_iter().flat_map(|(panel, plan, view)| {
            let shown = plan.points.iter().filter(|(name, _)| !is_hidden(&solution.scene.figure, plan, name));
            shown.map(move |(name, point)| Handle {
                panel,
                name: name.clone(),
                at: self.enlarged() * view.at(point.vector.into()),
                is_fixed: name == plan.order.pole(),
            })
        });
        handles.collect()
    }

    /// A place of the sheet in the plan of a panel: in mm of paper from the pole, x right, y up; none without that panel.
    #[must_use]
    pub fn plan_place(&self, solution: &Solution, panel: Sheet, at: Point) -> Option<geometry::Vector> {
        let (_, _, view) = self.plan_views(solution).into_iter().find(|(own, ..)| *own == panel)?;
        let off = at - self.enlarged() * view.at(geometry::Point::origin());
        Some(geometry::Vector::new(off.x, -off.y))
    }

    /// The context of a position at the scales of the layout.
    fn context_of<'a>(&self, solution: &'a Solution, modes: Option<&'a OtherModes>) -> SheetContext<'a> {
        // The links are the same, but their lengths may not be.
        let [a, b] = [&solution.mechanism, &self.mechanism].map(|mechanism| mechanism.bodies.as_slice());
        let traces = match a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.local == b.local) {
            true => Arc::clone(&self.traces),
            false => Arc::new(Traces::of(solution)),
        };
        with_modes(at_scales(solution, &traces, self.mu), modes)
    }

    fn composed<'a>(&self, context: &'a SheetContext<'a>, only_step: Option<usize>) -> Composition<'a> {
        let contents = Contents { steps: self.steps, only_step, ..Contents::default() };
        let mut composition = composed(context, &self.extents, contents);
        // The frame stands still, where the scene's own position is in sight.
        for panel in composition.panels.iter_mut().filter(|panel| panel.needs.sheet == Sheet::Scheme) {
            panel.content = self.scheme;
        }
        composition
    }

    fn scheme_view(&self) -> Option<View> {
        Some(self.layout.placed(Sheet::Scheme)?.view(self.scheme))
    }

    /// The plans that are shown, with their views.
    fn plan_views<'a>(&self, solution: &'a Solution) -> Vec<(Sheet, &'a Plan, View)> {
        let shown = solution.construction.plans().filter_map(|plan| {
            let sheet = plan.sheet();
            let content = plan::on_paper::extent(plan, solution.scene.figure.construction);
            Some((sheet, plan, self.layout.placed(sheet)?.view(Some(content))))
        });
        shown.collect()
    }

    /// From units of the layout to mm of paper.
    fn enlarged(&self) -> Affine {
        Affine::scale(self.layout.panels.first().map_or(1.0, |placed| placed.unit))
    }
}

/// The layout in which the own position is seen whole and no joint leaves the scheme on its way, because a hand holds it: at
/// the finest scale of the scheme that allows it, with room for the plans of all positions, else of the own one. The scale is
/// put into the context. Where there is no such layout it is the own position's, as on the sheets of its steps. With the
/// extents that it has room for.
fn laid_out(
    own: &mut SheetContext<'_>,
    own_extents: &Extents,
    all: Extents,
    contents: Contents,
    below: f64,
) -> (Layout, Extents) {
    // Plans: the shown position only; scheme: the whole cycle.
    let joints = |(all, own): (&(Sheet, Extent), &(Sheet, Extent))| if own.0 == Sheet::Scheme { *all } else { *own };
    let least: Extents = all.iter().zip(own_extents).map(joints).collect();
    let scale = own.surface.mu[Sheet::Scheme];
    let is_free = own.figure().mu[Sheet::Scheme].is_none() && all.iter().any(|(panel, _)| *panel == Sheet::Scheme);
    let coarser = |mu: &Option<f64>| Some(mu.map(|mu| next_scale(1.01 * mu)));
    for mu in std::iter::successors(Some(scale), coarser).take(if is_free { TRIED } else { 1 }) {
        own.surface.mu[Sheet::Scheme] = mu;
        for extents in [&all, &least] {
            let layout = composed(own, extents, contents).layout_above(below);
            let seen = least.iter().zip(&layout.panels).all(|((_, extent), placed)| placed.holds(extent));
            if seen {
                return (layout, extents.clone());
            }
        }
    }
    own.surface.mu[Sheet::Scheme] = scale;
    let mut layout = composed(own, own_extents, contents).layout_above(below);
    // It shows the middle of all positions.
    for (placed, (_, extent)) in layout.panels.iter_mut().zip(&all) {
        placed.needs.extent = *extent;
    }
    (layout, all)
}

/// The context of a position at scales that are given.
fn at_scales<'a>(solution: &'a Solution, traces: &Arc<Traces>, mu: Scales) -> SheetContext<'a> {
    let mut context = SheetContext::with_traces(solution, Purpose::Figure, Arc::clone(traces)).with_values();
    context.surface.mu = mu;
    context
}

fn with_modes<'a>(context: SheetContext<'a>, modes: Option<&'a OtherModes>) -> SheetContext<'a> {
    SheetContext { modes: modes.unwrap_or(context.modes), ..context }
}
