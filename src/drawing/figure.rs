//! The figure of a scene: its panels and their layers, finished or with all steps; and the frames of an animation.

use super::canvas::Canvas;
use super::compose::Composition;
use super::layout::{Item, Needs, Placed, on_paper};
use super::legend::{self, Legend};
use super::line::Line;
use super::lines::Lines;
use super::panel::{Frame, Layer, Layers, Panel, numbered};
use super::plan_panel;
use super::scheme::Scheme;
use super::sheet::{Drawing, Pen};
use super::text::RichText;
use super::view::{Extent, View, fitting_scale};
use super::words::StepWords;
use super::worksheet::Worksheet;
use crate::construction::{Solution, shown_text};
use crate::cycle::Traces;
use crate::mechanism::Class;
use crate::quantity::{Kind, Scales};
use crate::scene::PanelName;
use crate::words::{Language, Wording};
use std::sync::Arc;

/// Drawings of a sheet with values before all values go to the table.
const ROUNDS: usize = 3;

impl Solution {
    /// The figure that the scene asks for: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        with_values(Scheme::new(self), |scheme| {
            let sheet = finished(scheme, &extents(scheme));
            sheet.draw(&sheet.layout())
        })
    }

    /// The same figure with every step of the construction: [`Drawing::after_step`] gives the sheet after one of them,
    /// with its caption and equation below the panels.
    ///
    /// Steps of plans without a panel have captions, too.
    #[must_use]
    pub fn stepwise_figure(&self) -> Drawing {
        with_values(Scheme::new(self), |scheme| {
            let sheet = stepwise(scheme, &extents(scheme), self.scene.figure.worksheet);
            sheet.draw(&sheet.layout())
        })
    }

    /// The scales of the figure; for a plan without a panel the scene's scale, if there is one.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let scheme = Scheme::new(self);
        let layout = finished(&scheme, &extents(&scheme)).layout();
        let of = |panel: PanelName| self.scene.figure.mu(panel).or(layout.mu(kind(panel)));
        Scales {
            length: of(PanelName::Scheme),
            velocity: of(PanelName::Velocity),
            acceleration: of(PanelName::Acceleration),
        }
    }

    /// A warning for each panel whose content is cut off at a scale that the scene gives, with a scale that fits.
    /// Special points far away count as fitting: their cut lines are shown.
    #[must_use]
    pub fn overflow_warnings(&self) -> Vec<String> {
        let figure = &self.scene.figure;
        if !figure.panels.iter().any(|&panel| figure.mu(panel).is_some()) {
            return Vec::new();
        }
        let scheme = Scheme::new(self);
        let extents = extents(&scheme);
        let layout = finished(&scheme, &extents).layout();
        extents
            .iter()
            .zip(&layout.panels)
            .filter_map(|((panel, extent), placed)| overflow_warning(*panel, extent, placed))
            .collect()
    }
}

/// The warning for a panel whose content is larger than its frame.
fn overflow_warning(panel: PanelName, extent: &Extent, placed: &Placed) -> Option<String> {
    // Content may reach into the white margin of the frame.
    let (size, frame) = (placed.shown(extent), placed.frame);
    if size.x <= frame.width() && size.y <= frame.height() {
        return None;
    }
    let key = match panel {
        PanelName::Scheme => "mu_l",
        PanelName::Velocity => "mu_v",
        PanelName::Acceleration => "mu_a",
    };
    let words = Wording::default();
    let panel = name(words.language, panel).to_lowercase();
    let [fitting, given] =
        [fitting_scale(extent, on_paper(placed.area, placed.unit)), placed.mu].map(|mu| words.write(mu, legend::SCALE));
    Some(format!(
        "the {panel} does not fit into its panel at {key} = {given} and is cut off there; {fitting} fits, or a larger sheet"
    ))
}

/// The stepwise figures of one mechanism in several positions, all with the same panels and scales, as frames of an
/// animation.
///
/// Panels are large enough for the whole content of position `own` and for the joints and their images in the other
/// positions, except for plans several times as large as most: near a limit position rates and special points go to
/// infinity. Content that does not fit is cut off at the panel's edge. There is no work sheet.
#[must_use]
pub fn frames(positions: &[Solution], own: usize) -> Vec<Drawing> {
    let traces = positions.get(own).map(Traces::of);
    frames_with(positions, own, traces.unwrap_or_default())
}

/// As [`frames`], with these paths and ghosts, the same in all of them.
#[must_use]
pub fn frames_with(positions: &[Solution], own: usize, traces: Traces) -> Vec<Drawing> {
    let traces = Arc::new(traces);
    let scheme = |solution| Scheme { insets: false, ..Scheme::with(solution, Arc::clone(&traces)) };
    let schemes: Vec<Scheme<'_>> = positions.iter().map(scheme).collect();
    let Some(first) = schemes.get(own) else {
        return Vec::new();
    };
    let extents: Vec<(PanelName, Extent)> = extents(first)
        .into_iter()
        .map(|(panel, extent)| {
            let others = schemes.iter().filter_map(|scheme| match panel {
                PanelName::Scheme => Some(scheme.extent_of_joints()),
                plan => scheme.plan(plan).map(plan_panel::extent_of_images),
            });
            (panel, extent.with_most(others))
        })
        .collect();
    let sheets: Vec<Composition<'_>> = schemes.iter().map(|scheme| stepwise(scheme, &extents, false)).collect();
    let below = sheets.iter().map(Composition::height_below).fold(0.0, f64::max);
    let layout = sheets[own].layout_above(below);
    sheets.iter().map(|sheet| sheet.draw(&layout)).collect()
}

/// Draws a sheet. Values whose labels find no place are listed in a table beside the panels; as it takes room, the sheet
/// is then drawn again.
fn with_values(mut scheme: Scheme<'_>, draw: impl Fn(&Scheme<'_>) -> Drawing) -> Drawing {
    // A work sheet lists all values.
    let rounds = if scheme.figure.worksheet { 0 } else { ROUNDS };
    for _ in 0..rounds {
        let drawing = draw(&scheme);
        let left_out = scheme.left_out(&drawing);
        if left_out.is_empty() {
            return drawing;
        }
        scheme.listed.extend(left_out);
    }
    if !scheme.figure.worksheet {
        scheme.list_all();
    }
    draw(&scheme)
}

/// The finished figure.
fn finished<'a>(scheme: &'a Scheme<'a>, extents: &[(PanelName, Extent)]) -> Composition<'a> {
    let panels = panels(scheme, extents, |panel| vec![content(scheme, panel)]);
    let table = scheme.figure.worksheet.then(|| Worksheet::new(scheme, &panels));
    composition(scheme, panels, table, vec![Box::new(agreement(scheme))])
}

/// The figure with all its steps.
fn stepwise<'a>(scheme: &'a Scheme<'a>, extents: &[(PanelName, Extent)], worksheet: bool) -> Composition<'a> {
    let panels = panels(scheme, extents, |panel| vec![hints(scheme, panel), content(scheme, panel)]);
    let table = worksheet.then(|| Worksheet::new(scheme, &panels));
    let after = scheme.construction.numbered_steps().count() as u16 + 1;
    let agreement = Lines { step: Some(after), ..agreement(scheme) };
    let sheet = composition(scheme, panels, table, vec![Box::new(StepWords(scheme)), Box::new(agreement)]);
    Composition { is_stepwise: true, ..sheet }
}

/// The sentences on paths, if there are any, and on how the construction agrees with the loop equations.
fn agreement(scheme: &Scheme<'_>) -> Lines {
    // Beside values, only what is not as it should be is said.
    let is_said = scheme.values.is_empty() || !legend::agrees(scheme.construction);
    let sentence = is_said.then(|| legend::agreement(&scheme.words, scheme.construction));
    Lines::of(scheme.sentence_on_paths().iter().chain(&sentence), scheme.dims.page)
}

/// A sheet with these panels, a table beside them, their scales, and items below.
pub(super) fn composition<'a>(
    scheme: &'a Scheme<'a>,
    panels: Vec<Panel<'a>>,
    table: Option<Worksheet>,
    below: Vec<Box<dyn Item + 'a>>,
) -> Composition<'a> {
    let (scene, words) = (scheme.scene, scheme.words);
    let values = || Some(Box::new(scheme.value_list()?) as Box<dyn Item>);
    let table = table.map(|table| Box::new(table) as Box<dyn Item>).or_else(values);
    let legend: Box<dyn Item> = Box::new(Legend { words, units: scene.units, dims: scheme.dims });
    let (teller, steps) = (scheme.teller(), scheme.construction.numbered_steps());
    Composition {
        scene,
        dims: scheme.dims,
        words,
        title: scene.title.as_deref().unwrap_or(words.language.title()).to_owned(),
        description: description(scheme, &panels),
        steps: steps.map(|step| shown_text(&teller.caption(&step), step.plan, &words)).collect(),
        is_stepwise: false,
        panels,
        items: table.into_iter().chain([legend]).chain(below).collect(),
    }
}

/// The panels with content, and its extents.
pub(super) fn extents(scheme: &Scheme<'_>) -> Vec<(PanelName, Extent)> {
    let extent = |&panel: &PanelName| match panel {
        PanelName::Scheme => Some((panel, scheme.extent())),
        plan => scheme.plan(plan).map(|plan| (panel, plan_panel::extent(plan))),
    };
    scheme.figure.panels.iter().filter_map(extent).collect()
}

/// Panels of these extents, with layers from `layers`.
pub(super) fn panels<'a>(
    scheme: &Scheme<'a>,
    extents: &[(PanelName, Extent)],
    layers: impl Fn(PanelName) -> Layers<'a>,
) -> Vec<Panel<'a>> {
    let panel = |(index, &(panel, extent)): (usize, &(PanelName, Extent))| {
        let name = name(scheme.words.language, panel);
        let frame = |index| Frame::new(Line::new(vec![RichText::plain(&numbered(index, name))]), Pen::Heading);
        let lowest: Box<dyn Layer> = Box::new(frame(index));
        Panel {
            name: name.to_owned(),
            prefix: panel.as_str(),
            // The width of the first panel's heading: it must not depend on the panel's letter.
            needs: Needs { kind: kind(panel), extent, heading: frame(0).width(), mu: scheme.figure.mu(panel) },
            layers: std::iter::once(lowest).chain(layers(panel)).collect(),
        }
    };
    extents.iter().enumerate().map(panel).collect()
}

/// The layer with the scheme or a plan.
pub(super) fn content<'a>(scheme: &'a Scheme<'a>, panel: PanelName) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, scheme.plan(panel)) {
        (PanelName::Scheme, _) => scheme.draw(canvas, view),
        (_, Some(plan)) => plan_panel::draw(canvas, view, scheme, plan),
        (_, None) => {}
    })
}

/// The layer with the hints at the subject of each step.
pub(super) fn hints<'a>(scheme: &'a Scheme<'a>, panel: PanelName) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, scheme.plan(panel)) {
        (PanelName::Scheme, _) => scheme.hints(canvas, view),
        (_, Some(plan)) => plan_panel::hints(canvas, view, scheme, plan),
        (_, None) => {}
    })
}

/// The kind of quantity that a panel shows to scale.
fn kind(panel: PanelName) -> Kind {
    match panel {
        PanelName::Scheme => Kind::Length,
        PanelName::Velocity => Kind::Velocity,
        PanelName::Acceleration => Kind::Acceleration,
    }
}

fn name(language: &Language, panel: PanelName) -> &str {
    match panel {
        PanelName::Scheme => language.scheme(),
        PanelName::Velocity => language.velocity_plan(),
        PanelName::Acceleration => language.acceleration_plan(),
    }
}

/// One sentence about the figure, for readers who cannot see it.
fn description(scheme: &Scheme<'_>, panels: &[Panel<'_>]) -> String {
    let language = scheme.words.language;
    let described = |panel: &Panel<'_>| match panel.needs.kind {
        Kind::Velocity => language.described_velocity_plan(),
        Kind::Acceleration => language.described_acceleration_plan(),
        _ => language.described_scheme(),
    };
    let panels: Vec<&str> = panels.iter().map(described).collect();
    let groups = scheme.mechanism.groups.iter().map(|group| {
        let class = match group.class {
            Class::Higher => language.higher(),
            other => other.numeral(),
        };
        language.described_group(class, &group.link_names(scheme.mechanism))
    });
    let description = language.description(&panels.join(", "), &groups.collect::<Vec<_>>().join("; "));
    scheme.sentence_on_paths().into_iter().fold(description, |text, paths| format!("{text} {paths}"))
}
