//! One sheet of a scene in its layout: what is on it, and how it is drawn.

use super::compose::Composition;
use super::context::SheetContext;
use super::facts::Steps;
use super::layout::{Item, Layout};
use super::panel::{Extents, Panel, content, hints, panels};
use super::remarks;
use super::sheet::Drawing;
use super::values::{Listed, value_list};
use super::view::Series;
use super::willis::{self, WillisTable};
use super::words::StepWords;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::shown_text;
use crate::sheet::{PerSheet, Scales};

/// How often a sheet is laid out again so that it has room for the list of names without room.
const RELAID: usize = 4;

/// A sheet in its layout.
#[derive(Clone)]
pub(super) struct LaidOut<'a> {
    pub context: SheetContext<'a>,
    pub extents: Extents,
    pub contents: Contents,
    pub layout: Layout,
}

impl LaidOut<'_> {
    /// The sheet drawn. Where names have no room it is laid out again with rows for their list.
    pub(super) fn drawn(mut self) -> (Self, Drawing) {
        let mut panels = Vec::new();
        let mut drawing = self.composition().draw_again(&self.layout, &mut panels);
        for _ in 0..RELAID {
            let rows = self.wanted_rows(&drawing);
            if rows == self.contents.rows {
                break;
            }
            let Some((layout, contents)) = self.laid_out_again(rows) else { break };
            (self.contents, self.layout) = (contents, layout);
            drawing = self.composition().draw_again(&self.layout, &mut panels);
        }
        (self, drawing)
    }

    /// The layout with rows for names: at its scales or, but for a hand, at coarser ones. Rather than that these are much
    /// coarser the sheet goes without its list of results, so that names have its room.
    fn laid_out_again(&self, rows: PerSheet<usize>) -> Option<(Layout, Contents)> {
        let LaidOut { context, extents, contents, layout } = self;
        let laid_out = |contents: Contents, scales: &Scales| {
            let found = composed(context, extents, contents).layout_at(scales);
            (found.worth[..2] >= layout.worth[..2]).then_some((found, contents))
        };
        let with_rows = Contents { rows, ..*contents };
        let as_before = laid_out(with_rows, &layout.mu());
        if as_before.is_some() || context.surface.series == Series::Hand {
            return as_before;
        }
        let coarser = laid_out(with_rows, &context.figure().mu);
        let chosen = &context.surface.mu;
        let is_near = coarser.as_ref().is_some_and(|(found, _)| found.is_nearly_at(chosen));
        let without_list = || laid_out(Contents { list: None, ..*contents }, chosen);
        let without_list = contents.list.filter(|_| !is_near).and_then(|_| without_list());
        without_list.or(coarser)
    }

    /// By panel: the rows for the names that have no room on a drawing, as many as before at least.
    fn wanted_rows(&self, drawing: &Drawing) -> PerSheet<usize> {
        let mut rows = self.contents.rows;
        for unlabelled in &drawing.unlabelled {
            let panel = drawing.panels.iter().position(|(name, _)| *name == unlabelled.panel);
            if let Some(placed) = panel.and_then(|panel| self.layout.panels.get(panel)) {
                let of_panel = &mut rows[placed.needs.sheet];
                *of_panel = unlabelled.rows.max(*of_panel);
            }
        }
        rows
    }

    pub(super) fn composition(&self) -> Composition<'_> {
        described(&self.context, composed(&self.context, &self.extents, self.contents))
    }
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
    /// Whether it has Willis' table.
    pub willis: bool,
    /// The results in the list of the finished figure; none where it has no list.
    pub list: Option<Listed>,
    /// By panel: rows for the names that have no room in it.
    pub rows: PerSheet<usize>,
    /// Whether the words of steps stand elsewhere: on a narrow part of a screen.
    pub wordless: bool,
    /// Whether the finished figure is in motion: what is said of one position would be gone before it is read.
    pub moving: bool,
}

/// A sheet of the scene with panels of these extents.
pub(super) fn composed<'a>(context: &'a SheetContext<'a>, extents: &Extents, contents: Contents) -> Composition<'a> {
    let Contents { steps, only_step, table, willis, list, wordless, moving, rows } = contents;
    let mut panels = panels(context, extents, |sheet| match steps {
        Some(_) => vec![hints(context, sheet), content(context, sheet)],
        None => vec![content(context, sheet)],
    });
    panels.iter_mut().for_each(|panel| panel.needs.rows = rows[panel.needs.sheet]);
    let worksheet = table.filter(|place| *place != TablePlace::Apart);
    let worksheet = worksheet.map(|place| Worksheet::new(context, &panels, place));
    let sheet = Composition::new(context, panels).with_code(1, context.title().for_comparing());
    let sheet = sheet.with_optional(worksheet);
    if moving {
        return sheet.with(remarks::paths(context));
    }
    let Some(steps) = steps else {
        let values = list.and_then(|listed| value_list(context, listed, None));
        // The list of results takes the place of the remark: so a sheet has the same room with values and without.
        let said = |beside| remarks::agreement(context, None, beside, values.is_some());
        let (ruler, said) = match table {
            Some(TablePlace::Apart) => {
                let (ruler, said) = Ruler::with_words(context, said);
                (Some(ruler), said)
            }
            _ => (None, said(0.0)),
        };
        let willis = willis::table(context).filter(|_| willis).map(WillisTable);
        return sheet.with_optional(willis).with_optional(values).with(said).with_optional(ruler);
    };
    // On the sheets of steps values come after the last one.
    let after = Some(context.construction().step_count() as u16 + 1);
    let sheet = Composition { is_stepwise: true, ..sheet };
    if wordless {
        return sheet.with(remarks::agreement(context, None, 0.0, false));
    }
    let words = StepWords::new(context, steps, only_step);
    let height = words.height();
    let sheet = sheet.with(words);
    // They must not take more room than the words before them.
    let lists = Listed::BOTH.into_iter().filter_map(|listed| value_list(context, listed, after));
    match { lists }.find(|values| values.height() <= height) {
        Some(values) => sheet.with(values),
        None => sheet.with(remarks::agreement(context, after, 0.0, false)),
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
