//! The figure of a scene: its panels with the table, the scales and the words around them; all sheets that it asks for, at
//! scales that are decided once.

use super::compose::{Composition, further_sheets};
use super::context::{Purpose, SheetContext, Value};
use super::facts::Steps;
use super::layout::{Item, Layout, Placed};
use super::panel::{Extents, Panel, content, cycles_of, extents, extents_in, hints, panels};
use super::remarks;
use super::scale_bar::SCALE;
use super::shape::Shape;
use super::sheet::{Drawing, Mark};
use super::values::{self, value_list};
use super::view::{Series, next_scale};
use super::words::StepWords;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::{Solution, plain_text, shown_text};
use crate::cycle::Traces;
use crate::scene::{ScalesFor, ValuesShown};
use crate::sheet::{Scales, Sheet};
use crate::words::Wording;
use std::cell::OnceCell;
use std::sync::Arc;

/// The sheets that have the same scales. A work sheet has them, too, but its table stands where there is room.
const SHEETS: [Option<Steps>; 3] = [Some(Steps::Fine), Some(Steps::Coarse), None];

/// How much coarser a scale may be on a sheet so that all sheets of a scene have the same.
const SHARED: f64 = 1.2;

/// How much coarser a scale may be for the list of results.
const STEP: f64 = 1.25;

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
}

/// A sheet in its layout.
#[derive(Clone)]
pub(super) struct LaidOut<'a> {
    pub context: SheetContext<'a>,
    pub extents: Extents,
    pub contents: Contents,
    pub layout: Layout,
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
        FigureSheets { base, extents: OnceCell::new(), scales: OnceCell::new(), figure: OnceCell::new() }
    }

    /// The figure: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        let laid_out = self.laid_out();
        laid_out.composition().draw(&laid_out.layout)
    }

    /// All finished sheets: first the figure; then, for a work sheet whose table has no room beside the panels, the table,
    /// or a table of the values that have no room, where the figure asks for values.
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        let laid_out = self.laid_out();
        let LaidOut { context, layout, .. } = laid_out;
        let sheet = laid_out.composition();
        let mut sheets = vec![sheet.draw(layout)];
        if context.figure().worksheet && layout.aside.is_none() {
            let table = Worksheet::new(context, &sheet.panels, TablePlace::Apart).filled(layout);
            sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, |_| Vec::new(), table));
        }
        if !context.figure().worksheet && context.figure().values.is_some() {
            let table = values::table(context, self.unplaced(&sheets[0]));
            sheets.extend(further_sheets(&sheets[0], context.surface.dims.unit, |_| Vec::new(), table));
        }
        sheets
    }

    /// The figure with every step of the construction, or in coarse steps with every
    /// [passage](crate::construction::Passage): [`Drawing::after_step`] gives the sheet after one of them, with its
    /// caption and equation below the panels. Steps of plans without a panel have captions, too.
    #[must_use]
    pub fn steps(&self, steps: Steps) -> Drawing {
        let laid_out = self.laid_out_as(Some(steps));
        laid_out.composition().draw(&laid_out.layout).in_steps(steps, &laid_out.context)
    }

    /// The scales of the figure on paper, for a projector those that it would have on A4; for a plan without a panel the
    /// scene's scale, if there is one.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let figure = self.base.figure();
        if self.base.surface.series == Series::Any {
            return FigureSheets::of(self.base.on_paper()).scales();
        }
        figure.mu.or(self.laid_out().layout.mu())
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
            if placed.holds(&extent) {
                return None;
            }
            let mut mu = context.surface.mu;
            let holds = |tried: &f64| {
                mu[panel] = Some(*tried);
                let sheet: &Composition<'_> = sheet.get_or_init(|| self.laid_out().composition());
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

    /// The symbols of the values that the figure asks for and that have no room on its drawing: they are in a table on the
    /// sheet after it.
    #[must_use]
    pub fn values_without_room(&self, drawing: &Drawing) -> Vec<String> {
        self.unplaced(drawing).map(|value| plain_text(&value.symbol)).collect()
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
        let is_listed = self.laid_out().contents.list;
        let is_shown = move |value: &&Value| has(value) || is_listed && value.is_listed();
        self.base.values.iter().filter(move |value| !is_shown(value))
    }

    /// What the list of results costs, where scales on paper are coarser for it; none where it costs nothing.
    #[must_use]
    pub fn cost_of_list(&self) -> Option<String> {
        let (without, with) = (self.scaled(None).surface, &self.laid_out().layout);
        let coarser = with.panels.iter().filter_map(|placed| {
            let (symbol, before) = (placed.needs.sheet.facts().scale_symbol, without.mu[placed.needs.sheet]?);
            let [now, before] = [placed.mu, before].map(|mu| Wording::default().write(mu, SCALE));
            (now != before).then(|| format!("{symbol} = {now} in place of {before}"))
        });
        let coarser: Vec<String> = coarser.collect();
        let is_told = without.series != Series::Any && !coarser.is_empty();
        is_told.then(|| format!("scales leave room for the list of results: {}", coarser.join(", ")))
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

    /// The finished figure in its layout, or the sheets with steps in theirs.
    pub(super) fn laid_out_as(&self, steps: Option<Steps>) -> LaidOut<'a> {
        if steps.is_none() {
            return self.laid_out().clone();
        }
        let mut context = self.scaled(steps);
        if context.surface.series == Series::Any {
            context.surface.told = Some(self.scales());
        }
        self.lay_out(context, steps)
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
            let has_list = !figure.context.figure().worksheet && value_list(&figure.context, None).is_some();
            if has_list { self.listed(figure) } else { figure }
        })
    }

    /// The finished figure with the list of its results: where that has room at the scales, or costs none of them more than
    /// a step.
    fn listed(&self, without: LaidOut<'a>) -> LaidOut<'a> {
        let contents = Contents { list: true, ..without.contents };
        let LaidOut { context, extents, layout, .. } = &without;
        let sheet = composed(context, extents, contents);
        let is_near = |with: &Layout| layout.mu().given().all(|(panel, mu)| with.mu_of(panel) <= Some(STEP * mu));
        let tried = [layout.mu(), context.figure().mu].into_iter().map(|scales| sheet.layout_at(&scales));
        let found = tried.into_iter().find(|with| with.shows_all() && is_near(with));
        drop(sheet);
        match found {
            Some(layout) => LaidOut { layout, contents, ..without },
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

    /// The scales for a hand that draws the plans, and of work sheets, forms and exercises: the scene's, else the finest of
    /// 1, 2, 2.5, 5 × 10^k at which all sheets of the figure have room on paper. Those of the figure are
    /// [`FigureSheets::scales`].
    #[must_use]
    pub fn scales(&self) -> Scales {
        FigureSheets::of(SheetContext::new(self, Purpose::Figure).for_hand()).scales()
    }
}

impl LaidOut<'_> {
    fn composition(&self) -> Composition<'_> {
        described(&self.context, composed(&self.context, &self.extents, self.contents))
    }
}

/// The scales of all sheets: the same where that makes no sheet's content much smaller, and for a hand always; on a
/// projector, where nobody lays a ruler, each sheet has its own.
fn sheets_scales(context: &SheetContext<'_>, extents: &Extents) -> [Scales; SHEETS.len()] {
    let (figure, given) = (context.figure(), context.surface.mu);
    if figure.shown_panels().iter().all(|&panel| given[panel].is_some()) {
        return [given; SHEETS.len()];
    }
    let sheets = SHEETS.map(|steps| composed(context, extents, Contents { steps, ..Contents::default() }));
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
        ScalesFor::Cycle => extents_in(context, &cycles_of(context.solution)),
        ScalesFor::Position | ScalesFor::Sheet => extents(context),
    }
}

/// The warning for a panel whose content is larger than its frame, with a scale that fits, if there is one.
fn overflow_warning(panel: Sheet, given: f64, fitting: Option<f64>) -> String {
    let (key, words) = (panel.facts().scale_key, Wording::default());
    let panel = words.language.sheet(panel).to_lowercase();
    let written = |mu| words.write(mu, SCALE);
    let fitting = fitting.map_or_else(|| "none".to_owned(), written);
    let given = written(given);
    format!(
        "the {panel} does not fit into its panel at {key} = {given} and is cut off there; {fitting} fits, or a larger sheet"
    )
}

/// What a sheet has besides the panels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Contents {
    /// The steps for whose words it has room.
    pub steps: Option<Steps>,
    /// The only step or passage that has words, from 1; none for all.
    pub only_step: Option<usize>,
    /// The table of measured lengths, on a work sheet.
    pub table: Option<TablePlace>,
    /// Whether the finished figure has the list of results.
    pub list: bool,
    /// Whether the words of steps stand elsewhere: on a narrow part of a screen.
    pub wordless: bool,
    /// Whether the finished figure is in motion: what is said of one position would be gone before it is read.
    pub moving: bool,
}

/// A sheet of the scene with panels of these extents.
pub(super) fn composed<'a>(context: &'a SheetContext<'a>, extents: &Extents, contents: Contents) -> Composition<'a> {
    let Contents { steps, only_step, table, list, wordless, moving } = contents;
    let panels = panels(context, extents, |sheet| match steps {
        Some(_) => vec![hints(context, sheet), content(context, sheet)],
        None => vec![content(context, sheet)],
    });
    let worksheet = table.filter(|place| *place != TablePlace::Apart);
    let worksheet = worksheet.map(|place| Worksheet::new(context, &panels, place));
    let sheet = Composition::new(context, panels).with_code(1, context.title().for_comparing());
    let sheet = sheet.with_optional(worksheet);
    if moving {
        return sheet.with(remarks::paths(context));
    }
    let Some(steps) = steps else {
        let values = if list { value_list(context, None) } else { None };
        let ruler = (table == Some(TablePlace::Apart)).then(|| Ruler::new(context));
        let agreement = remarks::agreement(context, None, ruler.as_ref().map_or(0.0, Ruler::width));
        return sheet.with_optional(values).with(agreement).with_optional(ruler);
    };
    // On the sheets of steps values come after the last one.
    let after = Some(context.construction().step_count() as u16 + 1);
    let sheet = Composition { is_stepwise: true, ..sheet };
    if wordless {
        return sheet.with(remarks::agreement(context, None, 0.0));
    }
    let words = StepWords::new(context, steps, only_step);
    let height = words.height();
    let sheet = sheet.with(words);
    // They must not take more room than the words before them.
    match value_list(context, after).filter(|values| values.height() <= height) {
        Some(values) => sheet.with(values),
        None => sheet.with(remarks::agreement(context, after, 0.0)),
    }
}

/// A sheet with its description and the captions of its steps.
pub(super) fn described<'a>(context: &SheetContext<'_>, mut sheet: Composition<'a>) -> Composition<'a> {
    let (teller, steps) = (context.teller(), context.construction().numbered_steps());
    sheet.description = description(context, &sheet.panels);
    sheet.steps = steps.map(|step| shown_text(&teller.caption(&step), step.plan, &context.words)).collect();
    sheet
}

/// One sentence about the figure, for readers who cannot see it.
fn description(context: &SheetContext<'_>, panels: &[Panel<'_>]) -> String {
    let language = context.words.language;
    let panels: Vec<&str> = panels.iter().map(|panel| language.described_sheet(panel.needs.sheet)).collect();
    let groups = context.mechanism().groups.iter();
    let groups = groups
        .map(|group| language.described_group(group.class.in_words(language), &group.link_names(context.mechanism())));
    let description = language.description(&panels.join(", "), &groups.collect::<Vec<_>>().join("; "));
    remarks::sentence_on_paths(context).into_iter().fold(description, |text, paths| format!("{text} {paths}"))
}
