//! A sheet whose panels and scales are held while its mechanism moves, for a hand on the picture.

use super::canvas::Held;
use super::compose::Composition;
use super::context::{Purpose, SheetContext, Surface};
use super::facts::Steps;
use super::figure::{FigureSheets, extents_to_fit};
use super::laid_out::{Contents, LaidOut, composed, described};
use super::layout::{Layout, Needs, Placed};
use super::panel::{Extents, cycle_of, cycles_of, extents_in, positions_of_each};
use super::sheet::Drawing;
use super::speeds::{SpeedScales, scales_in};
use super::values::is_hidden;
use super::view::{Extent, Series, View};
use crate::construction::{Plan, Solution, shown_text};
use crate::cycle::{Animation, OtherModes, Pull, Traces};
use crate::geometry;
use crate::mechanism::{GROUND, Mechanism};
use crate::sheet::Sheet;
use kurbo::{Affine, Point, Rect};
use std::sync::Arc;

/// Every so many of them is asked for the height of its words.
const WORDS_OF: usize = 12;
/// How much the size of the mechanism counts beside that of a plan, which fills its panel in few positions only; in a
/// lesson on the plans no more than they.
const HERO: f64 = 1.5;
/// Into so many parts at most the range of a drive that moves alone is divided.
const PULLED: usize = 48;

/// A part of a screen on which a figure is shown; its lengths are in pixels. A drawing for it has its proportions, and is
/// to be shown as large as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pane {
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// Height of the em of its letters.
    pub letters: f64,
    /// Whether the words of a step are on the sheet; where it is narrow they are better read beside it.
    pub words: bool,
}

/// The layout of a mechanism's figure, for drawing it in any of its positions: scales, panels and poles stand still.
///
/// That [of the figure](HeldLayout::of_figure) is that of the file: in the scene's own position it is drawn as there; in
/// others what leaves its panel is cut off. That [of the cycle](HeldLayout::of_cycle) has room for all positions, on the
/// figure's page or on a part of a screen; of a drive that swings, whose vectors run off to infinity at the ends of its
/// range, it has room for all in which they are not far larger than in most; those that run off have their size at the
/// edge. A panel says that its content is cut. [At rest](HeldLayout::at_rest) plans may be larger.
///
/// ```
/// use kinegon::cycle::Pull;
/// use kinegon::drawing::HeldLayout;
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let own = kinegon::solve(&scene)?;
/// let layout = HeldLayout::of_cycle(&own, None, None, None);
/// let mut pull = Pull::new(&own, None)?;
/// for degrees in [60.0, 61.0, 62.0] {
///     let moved = own.moved(pull.to_value(degrees).pose)?;
///     let svg = layout.draw(&moved, None).svg();
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct HeldLayout {
    pub(super) layout: Layout,
    /// The panels at the scales that are held, from which plans [at rest](HeldLayout::at_rest) come.
    pub(super) cycle: Vec<Placed>,
    /// Where it is laid out, at the scales that were chosen.
    surface: Surface,
    /// By panel: the extent that is seen.
    extents: Extents,
    contents: Contents,
    /// The paths and ghosts, and the lengths of the mechanism that has them.
    traces: Arc<Traces>,
    mechanism: Mechanism,
    held: Held,
}

/// All positions of a mechanism on its branch, by drive: for its layouts on several surfaces they are computed once.
///
/// Of several drives they are those that time brings, in which all move together, and those of each alone.
pub struct Positions(Vec<Animation>);

impl Positions {
    /// Those of a scene's mechanism; none of one that stands still.
    #[must_use]
    pub fn of(own: &Solution) -> Positions {
        let drives = own.mechanism.drive_names();
        let count = positions_of_each(own, drives.len(), PULLED);
        let alone = drives.iter().filter(|_| drives.len() > 1).filter_map(|drive| pulled(own, drive, count));
        Positions(cycles_of(own).chain(alone).collect())
    }
}

/// Positions that a drive reaches while the others stand, one more than `count`.
fn pulled(own: &Solution, drive: &str, count: usize) -> Option<Animation> {
    let mut pull = Pull::new(own, Some(drive)).ok()?;
    let start = pull.value();
    let turn = if pull.drive().is_angle { 360.0 } else { 2.0 * start.abs() };
    let [low, high] = pull.ends().map(|end| end.map(|end| end.at));
    let from = low.unwrap_or_else(|| high.map_or(start, |high| high - turn));
    let way = high.unwrap_or(from + turn) - from;
    let poses = (0..=count).map(|k| pull.to_value(from + way * k as f64 / count as f64).pose);
    let positions: Vec<Solution> = poses.filter_map(|pose| own.moved(pose).ok()).collect();
    let is_round = low.is_none() && high.is_none();
    Some(Animation { drive: None, values: Vec::new(), positions, own: 0, is_round })
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
    /// The layout of a scene's figure in its file: of the finished figure, or of its sheets with steps; with room for other
    /// modes, too, if they are to be seen.
    #[must_use]
    pub fn of_figure(own: &Solution, steps: Option<Steps>, modes: Option<&OtherModes>) -> HeldLayout {
        let sheets = FigureSheets::new(own);
        if modes.is_none() {
            return HeldLayout::of(sheets.laid_out_as(steps));
        }
        let context = with_modes(sheets.unscaled(), modes);
        let extents = extents_to_fit(&context);
        HeldLayout::new(context, extents, Contents { steps, ..Contents::default() }, 0.0)
    }

    /// The layout of all positions of a scene's mechanism, on a part of a screen or else on the figure's page: for its
    /// finished figure, or with room for the words of steps; with other modes, if they are to be seen.
    #[must_use]
    pub fn of_cycle(
        own: &Solution,
        steps: Option<Steps>,
        modes: Option<&OtherModes>,
        pane: Option<Pane>,
    ) -> HeldLayout {
        HeldLayout::of_positions(own, &Positions::of(own), steps, modes, pane)
    }

    /// That of the cycle, where its positions are known.
    #[must_use]
    pub fn of_positions(
        own: &Solution,
        Positions(cycles): &Positions,
        steps: Option<Steps>,
        modes: Option<&OtherModes>,
        pane: Option<Pane>,
    ) -> HeldLayout {
        let sheets = FigureSheets::new(own);
        let mut context = sheets.unscaled();
        if let Some(pane) = pane {
            context.surface = context.surface.on_pane(pane, context.figure());
        }
        let contents = Contents { steps, wordless: pane.is_some_and(|pane| !pane.words), ..Contents::default() };
        let has_words = steps.is_some() && !contents.wordless;
        if has_words && context.surface.series == Series::Any {
            context.surface.told = Some(sheets.scales());
        }
        let mut context = with_modes(context, modes);
        context.surface.speeds = speed_scales(own, cycles);
        let extents = extents_in(&context, cycles);
        let positions = cycles.iter().flat_map(|cycle| cycle.positions.iter().step_by(WORDS_OF));
        let heights = positions.filter(|_| has_words).map(|position| {
            let context = context.at_position(position).with_values();
            composed(&context, &extents, contents).height_below()
        });
        let below = heights.fold(0.0, f64::max);
        HeldLayout::new(context, extents, contents, below)
    }

    /// The layout of the positions through which a drive, without a name the first, takes a scene's mechanism in a film: on
    /// the figure's page, at any scales, which bars show.
    pub(super) fn of_film(own: &Solution, drive: Option<&str>) -> HeldLayout {
        let mut context = FigureSheets::new(own).unscaled();
        (context.surface.series, context.surface.details) = (Series::Any, false);
        let cycle = cycle_of(own, drive);
        context.surface.speeds = speed_scales(own, cycle.as_slice());
        let extents = extents_in(&context, cycle);
        HeldLayout::new(context, extents, Contents { moving: true, ..Contents::default() }, 0.0)
    }

    /// The layout of a context for these extents, with at least `below` mm for words.
    fn new(mut context: SheetContext<'_>, extents: Extents, contents: Contents, below: f64) -> HeldLayout {
        let mut sheet = composed(&context, &extents, contents);
        let scheme = sheet.panels.iter_mut().find(|panel| panel.needs.sheet == Sheet::Scheme);
        if let Some(scheme) = scheme.filter(|_| context.figure().focus.is_none() && contents.steps.is_none()) {
            scheme.needs.weight = HERO;
        }
        let layout = sheet.layout_above(sheet.height_below().max(below));
        drop(sheet);
        context.surface.mu = context.surface.mu.or(layout.mu());
        HeldLayout::of(LaidOut { context, extents, contents, layout })
    }

    fn of(LaidOut { mut context, extents, contents, layout }: LaidOut<'_>) -> HeldLayout {
        if context.surface.speeds.is_none() {
            context.surface.speeds = speed_scales(context.solution, &[]);
        }
        HeldLayout {
            cycle: layout.panels.clone(),
            layout,
            surface: context.surface,
            extents,
            contents,
            traces: Arc::clone(&context.traces),
            mechanism: context.mechanism().clone(),
            held: Held::default(),
        }
    }

    /// The figure in a position of the same mechanism, or of one with other lengths; with other modes, pale. With steps
    /// [`Drawing::after_step`] gives the sheet after one of them.
    #[must_use]
    pub fn draw(&self, solution: &Solution, modes: Option<&OtherModes>) -> Drawing {
        let context = self.context_of(solution, modes);
        let drawing = described(&context, self.composed(&context, None)).draw(&self.layout);
        match self.contents.steps {
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
        let construction = solution.shown_construction();
        let count = match self.contents.steps {
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
        let drawing = sheet.draw_holding(&self.layout, &mut held);
        self.held = held;
        match (self.contents.steps, step) {
            (Some(steps), Some(step)) => drawing.in_steps(steps, &context).after_step(step),
            _ => drawing,
        }
    }

    /// A layout on the way from another with the same panels to this one: it has gone that share of it, from 0 to 1. With
    /// other panels it is this one.
    #[must_use]
    pub fn eased_from(&self, before: &HeldLayout, share: f64) -> HeldLayout {
        let sheets =
            |layout: &HeldLayout| -> Vec<Sheet> { layout.layout.panels.iter().map(|p| p.needs.sheet).collect() };
        let mut eased = self.clone();
        if sheets(self) == sheets(before) {
            for (now, before) in eased.layout.panels.iter_mut().zip(&before.layout.panels) {
                *now = between(before, now, share);
            }
        }
        eased
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
        let context = SheetContext::with_traces(solution, Purpose::Figure, traces).with_values();
        with_modes(SheetContext { surface: self.surface, ..context }, modes)
    }

    fn composed<'a>(&self, context: &'a SheetContext<'a>, only_step: Option<usize>) -> Composition<'a> {
        let mut composition = composed(context, &self.extents, Contents { only_step, ..self.contents });
        for panel in &mut composition.panels {
            // The view stands still.
            panel.content = None;
        }
        composition
    }

    fn scheme_view(&self) -> Option<View> {
        Some(self.layout.placed(Sheet::Scheme)?.view(None))
    }

    /// The plans that are shown, with their views.
    fn plan_views<'a>(&self, solution: &'a Solution) -> Vec<(Sheet, &'a Plan, View)> {
        let shown = solution.shown_construction().plans().filter_map(|plan| {
            let sheet = plan.sheet();
            Some((sheet, plan, self.layout.placed(sheet)?.view(None)))
        });
        shown.collect()
    }

    /// From units of the layout to mm of paper.
    fn enlarged(&self) -> Affine {
        Affine::scale(self.layout.panels.first().map_or(1.0, |placed| placed.unit))
    }
}

/// The scales of the speed diagram of a mechanism in its own position and in those of cycles.
fn speed_scales(own: &Solution, cycles: &[Animation]) -> Option<SpeedScales> {
    let positions = cycles.iter().flat_map(|cycle| &cycle.positions);
    scales_in(std::iter::once(own).chain(positions).map(|position| &position.construction))
}

/// The place of a panel on the way from one to another.
fn between(from: &Placed, to: &Placed, share: f64) -> Placed {
    let rect =
        |a: Rect, b: Rect| Rect::from_points(a.origin().lerp(b.origin(), share), corner(a).lerp(corner(b), share));
    let point = |a: geometry::Point, b: geometry::Point| a + share * (b - a);
    let [a, b] = [from, to].map(|placed| placed.needs.extent);
    let extent = Extent { low: point(a.low, b.low), high: point(a.high, b.high) };
    Placed {
        needs: Needs { extent, ..to.needs },
        frame: rect(from.frame, to.frame),
        area: rect(from.area, to.area),
        // Equal steps of the eye.
        mu: from.mu * libm::pow(to.mu / from.mu, share),
        unit: to.unit,
    }
}

fn corner(rect: Rect) -> Point {
    Point::new(rect.x1, rect.y1)
}

fn with_modes<'a>(context: SheetContext<'a>, modes: Option<&'a OtherModes>) -> SheetContext<'a> {
    SheetContext { modes: modes.unwrap_or(context.modes), ..context }
}
