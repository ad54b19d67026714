//! The figure of a scene: its panels with the table, the scales and the words around them.

use super::compose::Composition;
use super::context::SheetContext;
use super::layout::Item;
use super::legend;
use super::panel::Panel;
use super::panels::{Extents, content, hints, panels};
use super::step_numbers::Steps;
use super::values::value_list;
use super::words::StepWords;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::shown_text;
use crate::quantity::QuantityKind;

/// What a sheet has besides the panels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Contents {
    /// The steps for whose words it has room.
    pub steps: Option<Steps>,
    /// The only step or passage that has words, from 1; none for all.
    pub only_step: Option<usize>,
    /// The table of measured lengths, on a work sheet.
    pub table: Option<TablePlace>,
}

/// A sheet of the scene with panels of these extents.
pub(super) fn composed<'a>(context: &'a SheetContext<'a>, extents: &Extents, contents: Contents) -> Composition<'a> {
    let Contents { steps, only_step, table } = contents;
    let layers = |sheet| match steps {
        Some(_) => vec![hints(context, sheet), content(context, sheet)],
        None => vec![content(context, sheet)],
    };
    let panels = panels(context, extents, layers);
    // On the sheets of steps values come last; a work sheet has them all in its table.
    let after = steps.map(|_| context.construction().step_count() as u16 + 1);
    let has_list = steps.is_some() || table.is_none();
    let values = has_list.then(|| value_list(context, after)).flatten().map(|list| Box::new(list) as Box<dyn Item>);
    let ruler = (steps.is_none() && table == Some(TablePlace::Apart)).then(|| Ruler::new(context));
    let agreement = legend::agreement(context, after, ruler.as_ref().map_or(0.0, Ruler::width));
    let agreement: Box<dyn Item> = Box::new(agreement);
    let worksheet = |place| Worksheet { place, ..Worksheet::new(context, &panels) };
    let worksheet = table.filter(|place| *place != TablePlace::Apart).map(worksheet);
    let worksheet = worksheet.map(|table| Box::new(table) as Box<dyn Item>);
    let mut sheet = match steps {
        None => {
            let ruler = ruler.map(|ruler| Box::new(ruler) as Box<dyn Item>);
            let below = std::iter::once(agreement).chain(ruler).collect();
            Composition::new(context, panels, worksheet.or(values), below)
        }
        Some(steps) => {
            let words: Box<dyn Item + 'a> = Box::new(StepWords::new(context, steps, only_step));
            Composition::new(context, panels, worksheet, vec![words, values.unwrap_or(agreement)])
        }
    };
    sheet.is_stepwise = steps.is_some();
    sheet
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
    let described = |panel: &Panel<'_>| match panel.needs.kind {
        QuantityKind::Velocity => language.described_velocity_plan(),
        QuantityKind::Acceleration => language.described_acceleration_plan(),
        _ => language.described_scheme(),
    };
    let panels: Vec<&str> = panels.iter().map(described).collect();
    let groups = context.mechanism().groups.iter();
    let groups = groups
        .map(|group| language.described_group(group.class.in_words(language), &group.link_names(context.mechanism())));
    let description = language.description(&panels.join(", "), &groups.collect::<Vec<_>>().join("; "));
    legend::sentence_on_paths(context).into_iter().fold(description, |text, paths| format!("{text} {paths}"))
}
