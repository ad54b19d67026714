//! All sheets that a figure asks for, at scales that are decided once.

use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext};
use super::figure::{Contents, composed, described};
use super::layout::{Layout, Placed};
use super::legend;
use super::panels::{COMPANION, Extents, extent_of_images, extents};
use super::sheet::Drawing;
use super::step_numbers::Steps;
use super::view::{Extent, next_scale};
use super::worksheet::{TablePlace, Worksheet};
use crate::construction::Solution;
use crate::cycle::{Animation, Traces};
use crate::scene::ScalesFor;
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::words::Wording;
use kurbo::Rect;
use std::cell::OnceCell;
use std::sync::Arc;

/// The sheets that have the same scales. A work sheet has them, too, but its table stands where there is room.
const SHEETS: [Option<Steps>; 3] = [Some(Steps::Fine), Some(Steps::Coarse), None];

/// Weight of the scheme's size beside those of the plans: of equals the one with the larger scheme, which must not
/// shrink for the sake of one plan.
const SCHEME: f64 = 1.1;

/// Positions in which the largest plans of a cycle are looked for.
const POSITIONS: usize = 72;

/// Scales that are tried for one that fits.
const TRIED: usize = 120;

/// The sheets that the figure of a solved scene asks for.
///
/// Scales are decided once for all of them, and each sheet is laid out once, when it is first asked for: so a program
/// that wants more than one thing of a figure makes this once.
///
/// ```
/// use kinegon::drawing::{FigureSheets, Steps};
///
/// let scene = kinegon::Scene::read(include_str!("../../templates/four-bar.json"))?;
/// let solution = kinegon::solve(&scene)?;
/// let sheets = FigureSheets::new(&solution);
/// let (figure, steps) = (sheets.figure(), sheets.steps(Steps::Coarse));
/// assert!(sheets.overflow_warnings().is_empty() && steps.steps.len() > 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct FigureSheets<'a> {
    base: SheetContext<'a>,
    decided: OnceCell<Decided>,
    figure: OnceCell<LaidOut<'a>>,
}

/// The scales that all sheets share, and the layouts that were tried with them.
struct Decided {
    mu: Scales,
    tried: Vec<Tried>,
}

/// The layout of a sheet at the scales that were decided on.
struct Tried {
    steps: Option<Steps>,
    /// Height of its words, by which the sheet is known again.
    below: f64,
    layout: Layout,
}
struct LaidOut<'a> {
    context: SheetContext<'a>,
    extents: Extents,
    contents: Contents,
    layout: Layout,
}

impl<'a> FigureSheets<'a> {
    /// The sheets of a solution.
    #[must_use]
    pub fn new(solution: &'a Solution) -> Self {
        Self::with_traces(solution, Arc::new(Traces::of(solution)))
    }

    /// The sheets of a solution whose paths and ghosts are known.
    #[must_use]
    pub fn with_traces(solution: &'a Solution, traces: Arc<Traces>) -> Self {
        let base = SheetContext::with_traces(solution, Purpose::Figure, traces).with_values();
        FigureSheets { base, decided: OnceCell::new(), figure: OnceCell::new() }
    }

    /// The figure: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        let laid_out = self.laid_out();
        laid_out.composition().draw(&laid_out.layout)
    }

    /// All finished sheets: first the figure; then, for a work sheet whose table has no room beside the panels, the table.
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        let LaidOut { context, layout, .. } = self.laid_out();
        let sheet = self.laid_out().composition();
        let figure = sheet.draw(layout);
        let is_apart = context.figure().worksheet && layout.aside.is_none();
        let table = is_apart.then(|| Worksheet::new(context, &sheet.panels).filled(layout));
        let further = table.map(|table| further_sheets(&figure, context.surface.dims.unit, |_| Vec::new(), table));
        std::iter::once(figure).chain(further.into_iter().flatten()).collect()
    }

    /// The figure with every step of the construction, or in coarse steps with every
    /// [passage](crate::construction::Passage): [`Drawing::after_step`] gives the sheet after one of them, with its
    /// caption and equation below the panels. Steps of plans without a panel have captions, too.
    #[must_use]
    pub fn steps(&self, steps: Steps) -> Drawing {
        let laid_out = self.lay_out(self.scaled(), Some(steps));
        let drawing = laid_out.composition().draw(&laid_out.layout);
        match steps {
            Steps::Fine => drawing,
            Steps::Coarse => drawing.in_passages(&laid_out.context, &laid_out.context.construction().passages()),
        }
    }

    /// The scales of the figure; for a plan without a panel the scene's scale, if there is one.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let figure = self.base.figure();
        let mu = self.decided().mu;
        let are_known =
            figure.scales != ScalesFor::Sheet || figure.shown_panels().iter().all(|&sheet| mu[sheet].is_some());
        let chosen = if are_known { mu } else { self.laid_out().layout.mu() };
        let of = |sheet: Sheet| figure.mu[sheet].or(chosen[sheet]);
        PerSheet::from_fn(of)
    }

    /// A warning for each panel of the figure whose content is cut off at a scale that the scene gives, with a scale that
    /// fits, if there is one. Special points far away count as fitting: their cut lines are shown.
    #[must_use]
    pub fn overflow_warnings(&self) -> Vec<String> {
        let figure = self.base.figure();
        if !figure.panels.iter().any(|&panel| figure.mu[panel].is_some()) {
            return Vec::new();
        }
        let LaidOut { context, extents, layout, .. } = self.laid_out();
        let sheet = OnceCell::new();
        let warning = |(index, placed): (usize, &Placed)| {
            let (panel, extent) = extents[index];
            // Content may reach into the white margin of the frame.
            if fits_into(extent, placed, placed.frame) {
                return None;
            }
            let mut mu = context.surface.mu;
            let holds = |tried: &f64| {
                mu[panel] = Some(*tried);
                let sheet: &Composition<'_> = sheet.get_or_init(|| self.laid_out().composition());
                let placed = &sheet.layout_at(&mu).panels[index];
                fits_into(extent, placed, placed.area)
            };
            // No sheet is ten metres long.
            let first = next_scale(placed.mu.max(1e-4 * extent.size().norm()));
            let coarser = std::iter::successors(Some(first), |mu| Some(next_scale(1.01 * mu)));
            let fitting = coarser.take(TRIED).find(holds);
            Some(overflow_warning(panel, placed.mu, fitting))
        };
        layout.panels.iter().enumerate().filter_map(warning).collect()
    }

    /// The symbols of the values that the figure asks for and that stand nowhere on its drawing: their labels found no
    /// room, and the list of results does not have them.
    #[must_use]
    pub fn values_without_room(&self, drawing: &Drawing) -> Vec<String> {
        self.base.values_without_room(drawing)
    }

    /// The context of sheets at their scales: the common ones, or where each sheet has its own, those of the finished
    /// figure or of the sheets with steps.
    pub(super) fn context_of(&self, steps: Option<Steps>) -> SheetContext<'a> {
        let mut context = self.scaled();
        let shown = context.figure().shown_panels();
        if shown.iter().any(|&sheet| context.surface.mu[sheet].is_none()) {
            let own = self.lay_out(context.clone(), steps).layout.mu();
            context.surface.mu = PerSheet::from_fn(|sheet| context.surface.mu[sheet].or(own[sheet]));
        }
        context
    }

    fn scaled(&self) -> SheetContext<'a> {
        let mut context = self.base.clone();
        context.surface.mu = self.decided().mu;
        context
    }

    fn decided(&self) -> &Decided {
        self.decided.get_or_init(|| Decided::of(&self.base))
    }

    /// The finished figure. A work sheet that is to have markers has room for them, if its contents then have room at
    /// their scales.
    fn laid_out(&self) -> &LaidOut<'a> {
        self.figure.get_or_init(|| {
            let context = self.scaled();
            let marked = (context.figure().worksheet && context.wants_markers())
                .then(|| self.lay_out(context.on(context.surface.with_markers()), None))
                .filter(|marked| marked.layout.shows_all());
            marked.unwrap_or_else(|| self.lay_out(context, None))
        })
    }

    /// A sheet at the context's scales. The table of a work sheet is on it where the panels leave room for it at these
    /// scales; where each sheet has scales of its own, it always is.
    fn lay_out(&self, context: SheetContext<'a>, steps: Option<Steps>) -> LaidOut<'a> {
        let extents = extents(&context);
        let laid_out = |table: Option<TablePlace>| {
            let contents = Contents { steps, only_step: None, table };
            let sheet = composed_on(&context, &extents, contents);
            let mut tried = self.decided().tried.iter().filter(|_| table.is_none());
            let known = tried.find(|tried| tried.steps == steps && tried.below == sheet.height_below());
            (contents, known.map_or_else(|| sheet.layout(), |known| known.layout.clone()))
        };
        let (contents, layout) = if !context.figure().worksheet {
            laid_out(None)
        } else if context.surface.mu.iter().any(|(_, mu)| mu.is_none()) {
            laid_out(Some(TablePlace::Anywhere))
        } else {
            let (apart, beside) = (laid_out(Some(TablePlace::Apart)), laid_out(Some(TablePlace::Beside)));
            let shown = |layout: &Layout| [layout.worth[0], layout.worth[1]];
            let has_room = beside.1.aside.is_some() && shown(&beside.1) >= shown(&apart.1);
            if has_room { beside } else { apart }
        };
        LaidOut { context, extents, contents, layout }
    }
}

impl Solution {
    /// The figure that the scene asks for: see [`FigureSheets::figure`].
    #[must_use]
    pub fn figure(&self) -> Drawing {
        FigureSheets::new(self).figure()
    }

    /// All finished sheets that the scene asks for: see [`FigureSheets::sheets`].
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        FigureSheets::new(self).sheets()
    }

    /// The figure with every step of the construction: see [`FigureSheets::steps`].
    #[must_use]
    pub fn stepwise_figure(&self) -> Drawing {
        FigureSheets::new(self).steps(Steps::Fine)
    }

    /// The figure in coarse steps, one for each of the construction's passages: see [`FigureSheets::steps`].
    #[must_use]
    pub fn coarse_figure(&self) -> Drawing {
        FigureSheets::new(self).steps(Steps::Coarse)
    }

    /// The scales of the figure: see [`FigureSheets::scales`].
    #[must_use]
    pub fn scales(&self) -> Scales {
        FigureSheets::new(self).scales()
    }
}

impl LaidOut<'_> {
    fn composition(&self) -> Composition<'_> {
        described(&self.context, composed_on(&self.context, &self.extents, self.contents))
    }
}

/// A sheet, with the signs of one that has markers.
fn composed_on<'a>(context: &'a SheetContext<'a>, extents: &Extents, contents: Contents) -> Composition<'a> {
    let signs = || context.signs(1, context.title().for_comparing());
    let signs = context.surface.dims.free.has_markers().then(signs);
    Composition { signs, ..composed(context, extents, contents) }
}

impl Decided {
    /// Scales at which the content fits on every sheet: of the sets between those that the sheets themselves would have,
    /// the one with the largest contents.
    fn of(context: &SheetContext<'_>) -> Decided {
        let (figure, given) = (context.figure(), context.surface.mu);
        if figure.scales == ScalesFor::Sheet || figure.shown_panels().iter().all(|&panel| given[panel].is_some()) {
            return Decided { mu: given, tried: Vec::new() };
        }
        let extents = extents_to_fit(context);
        let sheets = SHEETS.map(|steps| composed(context, &extents, Contents { steps, ..Contents::default() }));
        let own: Vec<Layout> = sheets.iter().map(|sheet| sheet.layout()).collect();
        let fitting = |mu: &Scales| -> Option<(Scales, Vec<Tried>)> {
            let tried = sheets.iter().zip(SHEETS).map(|(sheet, steps)| {
                let layout = sheet.layout_at(mu);
                let fits = layout.worth[0] > 0.0 && layout.worth[1] as usize == extents.len();
                fits.then(|| Tried { steps, below: sheet.height_below(), layout })
            });
            Some((*mu, tried.collect::<Option<_>>()?))
        };
        // By panel: the scales between the finest and the coarsest that a sheet would have.
        let choices = extents.iter().enumerate().map(|(index, &(panel, _))| {
            let own = own.iter().map(|layout| layout.panels[index].mu);
            (panel, scales_between(own))
        });
        let mut sets = combined(given, &choices.collect::<Vec<_>>());
        let weight = |panel: Sheet| match panel {
            Sheet::Scheme if figure.focus.is_some() => COMPANION,
            Sheet::Scheme => SCHEME,
            _ => 1.0,
        };
        // The sum of the logarithms of the scales: the set with the largest contents comes first.
        let coarseness = |set: &Scales| set.given().map(|(panel, mu)| weight(panel) * libm::log(mu)).sum();
        sets.sort_by(|a, b| f64::total_cmp(&coarseness(a), &coarseness(b)));
        let coarsest = sets.last().copied().unwrap_or(given);
        let (mu, mut tried) = sets.iter().find_map(fitting).unwrap_or((coarsest, Vec::new()));
        // For a cycle more had to fit than the sheets show.
        tried.retain(|_| figure.scales != ScalesFor::Cycle);
        Decided { mu, tried }
    }
}

/// What must fit at the scales: the content in the scene's own position or, for a cycle, in all positions of the first
/// drive.
pub(super) fn extents_to_fit(context: &SheetContext<'_>) -> Extents {
    let own = extents(context);
    if context.figure().scales != ScalesFor::Cycle {
        return own;
    }
    let Ok(animation) = Animation::new(context.solution, None, POSITIONS) else {
        return own;
    };
    let with_others = |(panel, extent): (Sheet, Extent)| {
        let others = animation.positions.iter().filter_map(|position| extent_of_images(position, panel));
        // At the ends of a range rates go to infinity.
        let all = if animation.is_round { extent.with_all(others) } else { extent.with_most(others) };
        (panel, all)
    };
    own.into_iter().map(with_others).collect()
}

/// The round scales from the finest to the coarsest of some.
fn scales_between(own: impl Iterator<Item = f64>) -> Vec<f64> {
    let (finest, coarsest) = own.fold((f64::INFINITY, 0.0_f64), |(low, high), mu| (low.min(mu), high.max(mu)));
    let next = |mu: &f64| Some(next_scale(1.01 * mu)).filter(|next| *next < coarsest);
    let mut all: Vec<f64> = std::iter::successors(Some(finest), next).collect();
    all.push(coarsest);
    all.dedup();
    all
}

/// All sets with a scale of each panel.
fn combined(given: Scales, choices: &[(Sheet, Vec<f64>)]) -> Vec<Scales> {
    choices.iter().fold(vec![given], |sets, (panel, scales)| {
        let with = |set: Scales| {
            scales.iter().map(move |&mu| {
                let mut set = set;
                set[*panel] = Some(mu);
                set
            })
        };
        sets.into_iter().flat_map(with).collect()
    })
}

/// Whether a content fits into a part of its panel.
fn fits_into(extent: Extent, placed: &Placed, area: Rect) -> bool {
    let (size, area) = (placed.shown(&extent), area.inflate(1e-6, 1e-6));
    size.x <= area.width() && size.y <= area.height()
}

/// The warning for a panel whose content is larger than its frame, with a scale that fits, if there is one.
fn overflow_warning(panel: Sheet, given: f64, fitting: Option<f64>) -> String {
    let (key, words) = (panel.scale_key(), Wording::default());
    let panel = words.language.sheet(panel).to_lowercase();
    let written = |mu| words.write(mu, legend::SCALE);
    let fitting = fitting.map_or_else(|| "none".to_owned(), written);
    let given = written(given);
    format!(
        "the {panel} does not fit into its panel at {key} = {given} and is cut off there; {fitting} fits, or a larger sheet"
    )
}
