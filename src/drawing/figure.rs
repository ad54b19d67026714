//! The figure of a scene: its panels with the table, the scales and the words around them; all sheets that it asks for, at
//! scales that are decided once.

use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext, Value};
use super::facts::Steps;
use super::laid_out::{Contents, LaidOut, composed};
use super::layout::{Layout, Placed};
use super::panel::{Extents, cycles_of, extents, extents_in};
use super::parts::sheets_of_parts;
use super::says;
use super::scale_bar::SCALE;
use super::shape::Shape;
use super::sheet::{Drawing, Mark};
use super::table::Table;
use super::values::{self, Listed, value_list};
use super::view::{Series, next_scale};
use super::willis;
use super::worksheet::{TablePlace, Worksheet};
use crate::construction::{Solution, plain_text};
use crate::cycle::Traces;
use crate::message::Message;
use crate::scene::{ScalesFor, SizeLimit, ValuesShown};
use crate::sheet::{Scales, Sheet};
use crate::words::Wording;
use std::cell::OnceCell;
use std::sync::Arc;

/// The sheets that have the same scales. A work sheet has them, too, but its table stands where there is room.
const SHEETS: [Option<Steps>; 3] = [Some(Steps::Fine), Some(Steps::Coarse), None];

/// How much coarser a scale may be on a sheet so that all sheets of a scene have the same.
const SHARED: f64 = 1.2;

/// How much coarser a scale may be for Willis' table, which somebody has asked for.
const COST_OF_WILLIS: f64 = 2.0;

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
    /// What must fit.
    extents: OnceCell<Extents>,
    /// The scales of the sheets, in the order of [`SHEETS`].
    scales: OnceCell<[Scales; SHEETS.len()]>,
    figure: OnceCell<LaidOut<'a>>,
    /// The figure with room for the list of names that have none, drawn.
    drawn: OnceCell<(LaidOut<'a>, Drawing)>,
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
        Self::of(SheetContext::with_traces(solution, Purpose::Figure, traces).with_values())
    }

    fn of(base: SheetContext<'a>) -> Self {
        FigureSheets {
            base,
            extents: OnceCell::new(),
            scales: OnceCell::new(),
            figure: OnceCell::new(),
            drawn: OnceCell::new(),
        }
    }

    /// The figure: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        self.drawn().1.clone()
    }

    /// All finished sheets: first the figure; then, for a work sheet whose table has no room beside the panels, the table,
    /// or a table of the values that have no room, where the figure asks for values.
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        let (laid_out, figure) = self.drawn();
        let LaidOut { context, layout, .. } = laid_out;
        let mut sheets = vec![figure.clone()];
        if context.figure().worksheet && layout.aside().is_none() {
            let sheet = laid_out.composition();
            let table = Worksheet::new(context, &sheet.panels, TablePlace::Apart).filled(layout);
            sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, |_| Vec::new(), table));
        }
        if !context.figure().worksheet && !context.values.is_empty() {
            let table = values::table(context, self.in_table(&sheets[0]));
            sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, |_| Vec::new(), table));
        }
        if let Some(table) = self.willis_without_room() {
            sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, |_| Vec::new(), table));
        }
        if !context.figure().worksheet {
            sheets.extend(sheets_of_parts(context, layout, figure));
        }
        sheets
    }

    /// The figure with every step of the construction, or in coarse steps with every
    /// [passage](crate::construction::Passage): [`Drawing::after_step`] gives the sheet after one of them, with its
    /// caption and equation below the panels. Steps of plans without a panel have captions, too.
    #[must_use]
    pub fn steps(&self, steps: Steps) -> Drawing {
        let (laid_out, drawing) = self.steps_laid_out(steps).drawn();
        drawing.in_steps(steps, &laid_out.context)
    }

    /// The scales of the figure on paper, for a projector those that it would have on A4; for a plan without a panel the
    /// scene's scale, if there is one.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let figure = self.base.figure();
        if self.base.surface.series == Series::Any {
            return FigureSheets::of(self.base.on_paper()).scales();
        }
        figure.mu.or(self.settled().layout.mu())
    }

    /// A warning for each panel of the figure whose content is cut off at a scale that the scene gives, with a scale that
    /// fits, if there is one. Special points far away count as fitting: their cut lines are shown.
    #[must_use]
    pub fn overflow_warnings(&self) -> Vec<Message> {
        let figure = self.base.figure();
        if !figure.panels.iter().any(|&panel| figure.mu[panel].is_some()) {
            return Vec::new();
        }
        let laid_out = self.settled();
        let LaidOut { context, extents, layout, .. } = laid_out;
        let sheet = OnceCell::new();
        let warning = |(index, placed): (usize, &Placed)| {
            let (panel, extent) = extents[index];
            if placed.holds(&extent) {
                return None;
            }
            let mut mu = context.surface.mu;
            let holds = |tried: &f64| {
                mu[panel] = Some(*tried);
                let sheet: &Composition<'_> = sheet.get_or_init(|| laid_out.composition());
                sheet.layout_at(&mu).panels[index].holds(&extent)
            };
            // No sheet is ten metres long.
            let first = next_scale(placed.mu.max(1e-4 * extent.size().norm()));
            let coarser = std::iter::successors(Some(first), |mu| Some(next_scale(1.01 * mu)));
            let fitting = coarser.take(TRIED).find(holds);
            Some(overflow_warning(panel, placed.mu, fitting))
        };
        layout.panels.iter().enumerate().filter_map(warning).collect()
    }

    /// The symbols of the values that have no room on the figure's drawing and are in a table on the sheet after it: all where the
    /// figure asks for values, the main results where its style has them.
    #[must_use]
    pub fn values_without_room(&self, drawing: &Drawing) -> Vec<String> {
        self.in_table(drawing).map(|value| plain_text(&value.symbol)).collect()
    }

    /// Whether Willis' table has no room beside the figure's panels and is on a further sheet.
    #[must_use]
    pub fn is_willis_apart(&self) -> bool {
        self.willis_without_room().is_some()
    }

    fn willis_without_room(&self) -> Option<Table> {
        let LaidOut { context, contents, .. } = self.settled();
        willis::table(context).filter(|_| !context.figure().worksheet && !contents.willis)
    }

    /// How many values have no room on the figure's drawing and are in no table, because nobody has asked for them.
    #[must_use]
    pub fn values_left_out(&self, drawing: &Drawing) -> usize {
        self.unplaced(drawing).count() - self.in_table(drawing).count()
    }

    /// The values of the table after a figure.
    fn in_table(&self, drawing: &Drawing) -> impl Iterator<Item = &Value> {
        let is_asked = self.base.figure().values.is_some();
        let main: Vec<&str> = self.base.main_values().map(|value| value.name.as_str()).collect();
        self.unplaced(drawing).filter(move |value| is_asked || main.contains(&value.name.as_str()))
    }

    /// The values whose labels found no room, and which are not in the list of results.
    fn unplaced(&self, drawing: &Drawing) -> impl Iterator<Item = &Value> {
        // A label without room for the number has the symbol alone.
        let has = |value: &Value| {
            let (panel, whole) = (format!("{}-", value.panel.as_str()), value.text().content());
            let is_its = |mark: &Mark| match (&mark.shape, &mark.id) {
                (Shape::Text(text), Some(id)) => id.starts_with(&panel) && text.text.content() == whole,
                _ => false,
            };
            drawing.marks.iter().any(is_its)
        };
        let LaidOut { context, contents, .. } = self.settled();
        let list = contents.list.and_then(|listed| value_list(context, listed, None));
        let is_shown = move |value: &&Value| has(value) || list.as_ref().is_some_and(|list| list.has(value));
        self.base.values.iter().filter(move |value| !is_shown(value))
    }

    /// What the list of results, or one of names without room, costs where scales on paper are coarser for it; none where it
    /// costs nothing.
    #[must_use]
    pub fn cost_of_list(&self) -> Option<Message> {
        let (without, LaidOut { layout, contents, .. }) = (self.scaled(None).surface, self.settled());
        let coarser = layout.panels.iter().filter_map(|placed| {
            let (symbol, before) = (placed.needs.sheet.facts().scale_symbol, without.mu[placed.needs.sheet]?);
            let [now, before] = [placed.mu, before].map(|mu| Wording::default().write(mu, SCALE));
            (now != before).then(|| says::in_place_of(symbol, now, before))
        });
        let coarser: Vec<Message> = coarser.collect();
        let is_told = without.series != Series::Any && !coarser.is_empty();
        let cost = if contents.list.is_some() { says::cost_of_list } else { says::cost_of_names };
        is_told.then(|| cost(Message::list(coarser, ", ")))
    }

    /// The context of the finished figure, or of the sheets with steps, at their scales. They do not depend on values, which
    /// have the room that is left.
    pub(super) fn scaled(&self, steps: Option<Steps>) -> SheetContext<'a> {
        let mut context = self.base.clone();
        let sheet = SHEETS.iter().position(|sheet| *sheet == steps).unwrap_or_default();
        let scales = || sheets_scales(&self.base.with_values_as(ValuesShown::Hidden), self.extents());
        context.surface.mu = self.scales.get_or_init(scales)[sheet];
        context
    }

    /// The context of the sheets, without scales but those that the scene gives.
    pub(super) fn unscaled(&self) -> SheetContext<'a> {
        self.base.clone()
    }

    /// The finished figure, drawn.
    fn drawn(&self) -> &(LaidOut<'a>, Drawing) {
        self.drawn.get_or_init(|| self.laid_out().clone().drawn())
    }

    /// The finished figure in its last layout: for a hand, whose scales must not hang on letters, without drawing it.
    fn settled(&self) -> &LaidOut<'a> {
        if self.base.surface.series == Series::Hand { self.laid_out() } else { &self.drawn().0 }
    }

    /// The sheets with steps in their layout, without room for names that have none.
    fn steps_laid_out(&self, steps: Steps) -> LaidOut<'a> {
        let mut context = self.scaled(Some(steps));
        if context.surface.series == Series::Any {
            context.surface.told = Some(self.scales());
        }
        self.lay_out(context, Some(steps))
    }

    /// The finished figure in its layout, or the sheets with steps in theirs.
    pub(super) fn laid_out_as(&self, steps: Option<Steps>) -> LaidOut<'a> {
        steps.map_or_else(|| self.settled().clone(), |steps| self.steps_laid_out(steps).drawn().0)
    }

    /// The finished figure. A work sheet that is to have markers has room for them, if its contents then have room at
    /// their scales.
    fn laid_out(&self) -> &LaidOut<'a> {
        self.figure.get_or_init(|| {
            let context = self.scaled(None);
            let marked = context.with_markers();
            let marked = (context.figure().worksheet && marked.surface.dims.free.has_markers())
                .then(|| self.lay_out(marked, None))
                .filter(|marked| marked.layout.shows_all());
            let figure = marked.unwrap_or_else(|| self.lay_out(context, None));
            if figure.context.figure().worksheet { figure } else { self.listed(self.with_willis(figure)) }
        })
    }

    /// The finished figure with Willis' table, if it asks for it: at its scales, or else at coarser ones where the panels are still well seen.
    /// Where it has no such room it is on the next sheet.
    fn with_willis(&self, without: LaidOut<'a>) -> LaidOut<'a> {
        let LaidOut { context, extents, layout, .. } = &without;
        if willis::table(context).is_none() {
            return without;
        }
        let contents = Contents { willis: true, ..without.contents };
        let tried = [layout.mu(), context.figure().mu];
        let laid_out = tried.iter().map(|scales| composed(context, extents, contents).layout_at(scales));
        let fits = |with: &Layout| {
            let is_seen = with.shows_all() && with.is_roomy();
            with.aside().is_some() && is_seen && with.costs_at_most(COST_OF_WILLIS, &layout.mu())
        };
        match { laid_out }.find(fits) {
            Some(layout) => LaidOut { layout, contents, ..without },
            None => without,
        }
    }

    /// The finished figure with a list of its results: of all or of the main ones where that has room at the scales, or else
    /// costs none of them much.
    fn listed(&self, without: LaidOut<'a>) -> LaidOut<'a> {
        let LaidOut { context, extents, layout, .. } = &without;
        let tried = [layout.mu(), context.figure().mu].into_iter().flat_map(|scales| {
            Listed::BOTH.into_iter().filter_map(move |listed| {
                value_list(context, listed, None)?;
                let contents = Contents { list: Some(listed), ..without.contents };
                Some((composed(context, extents, contents).layout_at(&scales), contents))
            })
        });
        let is_seen = |with: &Layout| with.shows_all() && (!without.contents.willis || with.is_roomy());
        let found = { tried }.find(|(with, _)| is_seen(with) && with.is_nearly_at(&layout.mu()));
        match found {
            Some((layout, contents)) => LaidOut { layout, contents, ..without },
            None => without,
        }
    }

    /// What must fit on the sheets.
    fn extents(&self) -> &Extents {
        self.extents.get_or_init(|| extents_to_fit(&self.base))
    }

    /// A sheet at the context's scales. The table of a work sheet is on it where the panels leave room for it.
    fn lay_out(&self, context: SheetContext<'a>, steps: Option<Steps>) -> LaidOut<'a> {
        let extents = self.extents().clone();
        let laid_out = |table: Option<TablePlace>| {
            let contents = Contents { steps, table, ..Contents::default() };
            (contents, composed(&context, &extents, contents).layout())
        };
        let (contents, layout) = if !context.figure().worksheet {
            laid_out(None)
        } else {
            let (apart, beside) = (laid_out(Some(TablePlace::Apart)), laid_out(Some(TablePlace::Beside)));
            let shown = |layout: &Layout| [layout.worth[0], layout.worth[1]];
            let has_room = beside.1.aside().is_some() && shown(&beside.1) >= shown(&apart.1);
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

    /// The scales for a hand that draws the plans, and of work sheets, forms and exercises: the scene's, else the finest of
    /// 1, 2, 2.5, 5 × 10^k at which all sheets of the figure have room on paper. Those of the figure are
    /// [`FigureSheets::scales`].
    #[must_use]
    pub fn scales(&self) -> Scales {
        FigureSheets::of(SheetContext::new(self, Purpose::Figure).for_hand()).scales()
    }
}

/// The scales of all sheets: the same where that makes no sheet's content much smaller, and for a hand always; on a
/// projector, where nobody lays a ruler, each sheet has its own.
fn sheets_scales(context: &SheetContext<'_>, extents: &Extents) -> [Scales; SHEETS.len()] {
    let (figure, given) = (context.figure(), context.surface.mu);
    if figure.shown_panels().iter().all(|&panel| given[panel].is_some()) {
        return [given; SHEETS.len()];
    }
    // Words of steps that no sheet shows need no room; with very many points they take time.
    let has_steps = SizeLimit::STEPS.check(&context.solution.scene).is_ok();
    // A ruler takes room from the words below the panels of a work sheet; a hand has the same scales without one.
    let table = (context.surface.series == Series::Hand).then_some(TablePlace::Apart);
    let sheets = SHEETS.map(|steps| {
        let steps = steps.filter(|_| has_steps);
        composed(context, extents, Contents { steps, table: table.filter(|_| steps.is_none()), ..Contents::default() })
    });
    let own = sheets.each_ref().map(|sheet| given.or(sheet.layout().mu()));
    if figure.scales == ScalesFor::Sheet || context.surface.series == Series::Any {
        return own;
    }
    // Of the sets of scales that the sheets would have by themselves, and their mixtures, the finest that fits on all.
    let mut sets = own.iter().skip(1).fold(vec![own[0]], |sets, other| mixed(&sets, other));
    let coarseness = |set: &Scales| set.given().map(|(_, mu)| libm::log(mu)).sum::<f64>();
    sets.sort_by(|a, b| coarseness(a).total_cmp(&coarseness(b)));
    let fits = |set: &&Scales| sheets.iter().all(|sheet| sheet.layout_at(set).shows_all());
    let Some(shared) = (if sets.len() == 1 { sets.first() } else { sets.iter().find(fits) }) else { return own };
    let is_near = |own: &Scales| own.given().all(|(sheet, mu)| shared[sheet].is_some_and(|most| most <= SHARED * mu));
    let is_shared = context.surface.series == Series::Hand || own.iter().all(is_near);
    if is_shared { [*shared; SHEETS.len()] } else { own }
}

/// Sets of scales, and those in which scales of another set stand in the place of their own.
fn mixed(sets: &[Scales], other: &Scales) -> Vec<Scales> {
    let mut all = sets.to_vec();
    for sheet in Sheet::ALL {
        for mut set in all.clone() {
            set[sheet] = other[sheet];
            if !all.contains(&set) {
                all.push(set);
            }
        }
    }
    all
}

/// What must fit at the scales: the content in the scene's own position, or in all positions of its cycle.
pub(super) fn extents_to_fit(context: &SheetContext<'_>) -> Extents {
    match context.figure().scales {
        ScalesFor::Cycle => extents_in(context, cycles_of(context.solution)),
        ScalesFor::Position | ScalesFor::Sheet => extents(context),
    }
}

/// The warning for a panel whose content is larger than its frame, with a scale that fits, if there is one.
fn overflow_warning(panel: Sheet, given: f64, fitting: Option<f64>) -> Message {
    let name = match panel {
        Sheet::Scheme => says::scheme(),
        Sheet::Velocity => says::velocity_plan(),
        Sheet::Acceleration => says::acceleration_plan(),
        Sheet::Centers => says::centers(),
        Sheet::Forces => says::force_plan(),
        Sheet::Lever => says::lever(),
        Sheet::Speeds => says::speeds(),
    };
    let written = |mu| Wording::default().write(mu, SCALE);
    let fitting = fitting.map_or_else(says::no_scale, |mu| written(mu).into());
    says::overflow(name, panel.facts().scale_key, written(given), fitting)
}
