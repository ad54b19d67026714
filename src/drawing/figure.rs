//! The figure of a scene: its panels with the table, the scales and the words around them.

use super::compose::Composition;
use super::context::SheetContext;
use super::layout::Item;
use super::legend::{self, Legend};
use super::lines::Lines;
use super::panel::Panel;
use super::panels::{Extents, content, hints, panels};
use super::step_numbers::Steps;
use super::values::value_list;
use super::words::StepWords;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::shown_text;
use crate::cycle::Times;
use crate::quantity::Kind;
use crate::text::Untrusted;
use crate::words::{Medium, NumberStyle};

/// Number style of the steps between ticks.
const STEP: NumberStyle = NumberStyle::significant(3).trimmed().in_full(-3, 6).on(Medium::Figure);

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
    let panels = panels(context, extents, |panel| match steps {
        Some(_) => vec![hints(context, panel), content(context, panel)],
        None => vec![content(context, panel)],
    });
    let beside: Option<Box<dyn Item>> = match table {
        None => value_list(context, None).filter(|_| steps.is_none()).map(|list| Box::new(list) as Box<dyn Item>),
        // A work sheet has all values in its table.
        Some(TablePlace::Apart) => None,
        Some(place) => Some(Box::new(Worksheet { place, ..Worksheet::new(context, &panels) })),
    };
    let has_ruler = steps.is_none() && table == Some(TablePlace::Apart);
    let ruler = has_ruler.then(|| Ruler::new(context));
    let agreement = agreement(context, ruler.as_ref().map_or(0.0, Ruler::width));
    let ruler = ruler.map(|ruler| Box::new(ruler) as Box<dyn Item>);
    let below: Vec<Box<dyn Item + 'a>> = match steps {
        None => std::iter::once(Box::new(agreement) as Box<dyn Item>).chain(ruler).collect(),
        Some(steps) => {
            let words: Box<dyn Item + 'a> = Box::new(StepWords::new(context, steps, only_step));
            let after = context.construction().step_count() as u16 + 1;
            let values = value_list(context, Some(after)).map(|list| Box::new(list) as Box<dyn Item>);
            let last = values.unwrap_or_else(|| Box::new(Lines { step: Some(after), ..agreement }));
            vec![words, last]
        }
    };
    Composition { is_stepwise: steps.is_some(), ..composition(context, panels, beside, below) }
}

/// The sentences on paths, if there are any, and on how the construction agrees with the loop equations. Beside values
/// and on a projector only what is not as it should be is said. `beside` mm of the width are kept free.
fn agreement(context: &SheetContext<'_>, beside: f64) -> Lines {
    let (sentence, agrees) = legend::agreement(&context.words, context.construction());
    let is_said = !agrees || (context.values.is_empty() && !context.is_projected());
    let sentence = is_said.then_some(sentence);
    Lines::of(sentence_on_paths(context).iter().chain(&sentence), context.surface.dims.width_below() - beside)
}

/// A sheet with these panels, a table beside them, their scales, and items below.
pub(super) fn composition<'a>(
    context: &'a SheetContext<'a>,
    panels: Vec<Panel<'a>>,
    table: Option<Box<dyn Item>>,
    below: Vec<Box<dyn Item + 'a>>,
) -> Composition<'a> {
    let (scene, words) = (context.scene(), context.words);
    let legend: Box<dyn Item> = Box::new(Legend { words, units: scene.units, dims: context.surface.dims });
    Composition {
        scene,
        dims: context.surface.dims,
        words,
        title: context.title(),
        description: String::new(),
        steps: Vec::new(),
        is_stepwise: false,
        panels,
        items: table.into_iter().chain([legend]).chain(below).collect(),
        signs: None,
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
    let described = |panel: &Panel<'_>| match panel.needs.kind {
        Kind::Velocity => language.described_velocity_plan(),
        Kind::Acceleration => language.described_acceleration_plan(),
        _ => language.described_scheme(),
    };
    let panels: Vec<&str> = panels.iter().map(described).collect();
    let groups = context.mechanism().groups.iter();
    let groups = groups
        .map(|group| language.described_group(group.class.in_words(language), &group.link_names(context.mechanism())));
    let description = language.description(&panels.join(", "), &groups.collect::<Vec<_>>().join("; "));
    sentence_on_paths(context).into_iter().fold(description, |text, paths| format!("{text} {paths}"))
}

/// The sentence on the paths and their ticks, in markup.
fn sentence_on_paths(context: &SheetContext<'_>) -> Option<String> {
    let Times { drive, step, time, .. } = context.traces.times.as_ref()?;
    let shown = |name: &str| context.shown(name, None);
    let points: Vec<String> = context.traces.paths.iter().map(|path| shown(&path.name)).collect();
    let (language, units) = (context.words.language, context.scene().units);
    let number = |value: f64| context.words.write(value, STEP);
    let step = match drive.is_angle() {
        true => format!("{}°", number(*step)),
        false => format!("{} {}", number(*step), units.length.as_str()),
    };
    let drive = context.figure().labels.get(&drive.name).map_or_else(|| drive.name.clone(), Untrusted::for_setting);
    let points = points.join(", ");
    let mut sentence = match time {
        Some(time) => {
            let time = format!("{} {}", number(*time), units.time.as_str());
            language.paths_in_time(&points, &step, &drive, &time)
        }
        None => language.paths(&points, &step, &drive),
    };
    if context.traces.paths.iter().any(|path| !path.beyond.is_empty()) {
        sentence = format!("{sentence} {}", language.paths_beyond());
    }
    Some(sentence)
}
