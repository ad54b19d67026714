//! The figure of a scene: its panels and their layers, finished or with all steps; and the frames of an animation.

use super::canvas::Canvas;
use super::compose::{Composition, further_sheets};
use super::layout::{Item, Layout, Needs, Placed, WHITE};
use super::legend::{self, Legend};
use super::lines::{Line, Lines};
use super::markers::Signs;
use super::panel::{Frame, Layer, Layers, Panel, numbered};
use super::plan_panel;
use super::scheme::Scheme;
use super::sheet::{Drawing, Pen};
use super::text::RichText;
use super::view::{Extent, View, next_scale};
use super::words::StepWords;
use super::worksheet::{Ruler, TablePlace, Worksheet};
use crate::construction::{Solution, shown_text};
use crate::quantity::Kind;
use crate::sheet::{PerSheet, Scales, Sheet};
use crate::text::Untrusted;
use crate::words::Wording;
use kurbo::Rect;

/// Weight of the size of a panel beside that in focus.
pub(super) const COMPANION: f64 = 0.2;

/// Scales that are tried for one that fits.
const TRIED: usize = 120;

/// What a sheet has besides the panels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Contents {
    /// The steps for whose words it has room.
    pub steps: Option<Steps>,
    /// The table of measured lengths, on a work sheet.
    pub table: Option<TablePlace>,
}

/// How finely a construction is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// Every step by itself.
    Fine,
    /// Steps that belong together at once.
    Coarse,
}

impl Solution {
    /// The figure that the scene asks for: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        let scheme = Scheme::scaled(self).on_sheet();
        let LaidOut { sheet, layout } = scheme.laid_out(None);
        sheet.draw(&layout)
    }

    /// All sheets that the scene asks for: first the figure; then, for a work sheet whose table has no room beside the
    /// panels, the table.
    #[must_use]
    pub fn sheets(&self) -> Vec<Drawing> {
        let scheme = Scheme::scaled(self).on_sheet();
        let LaidOut { sheet, layout } = scheme.laid_out(None);
        let figure = sheet.draw(&layout);
        let is_apart = self.scene.figure.worksheet && layout.aside.is_none();
        let table = is_apart.then(|| Worksheet::new(&scheme, &sheet.panels).filled(&layout));
        let further = table.map(|table| further_sheets(&figure, scheme.dims.unit, |_| Vec::new(), table));
        std::iter::once(figure).chain(further.into_iter().flatten()).collect()
    }

    /// The same figure with every step of the construction: [`Drawing::after_step`] gives the sheet after one of them,
    /// with its caption and equation below the panels.
    ///
    /// Steps of plans without a panel have captions, too.
    #[must_use]
    pub fn stepwise_figure(&self) -> Drawing {
        let scheme = Scheme::scaled(self);
        let LaidOut { sheet, layout } = scheme.laid_out(Some(Steps::Fine));
        sheet.draw(&layout)
    }

    /// The same in coarse steps, one for each of the construction's [passages](crate::construction::Passage).
    #[must_use]
    pub fn coarse_figure(&self) -> Drawing {
        let scheme = Scheme::scaled(self);
        let LaidOut { sheet, layout } = scheme.laid_out(Some(Steps::Coarse));
        sheet.draw(&layout).in_passages(&scheme, &self.construction.passages())
    }

    /// The scales of the figure; for a plan without a panel the scene's scale, if there is one.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let scheme = Scheme::scaled(self).on_sheet();
        let layout = scheme.laid_out(None).layout;
        let of = |panel: Sheet| self.scene.figure.mu(panel).or(layout.mu(Kind::drawn_on(panel)));
        PerSheet::from_fn(of)
    }

    /// A warning for each panel whose content is cut off at a scale that the scene gives, with a scale that fits, if there is one.
    /// Special points far away count as fitting: their cut lines are shown.
    #[must_use]
    pub fn overflow_warnings(&self) -> Vec<String> {
        let figure = &self.scene.figure;
        if !figure.panels.iter().any(|&panel| figure.mu(panel).is_some()) {
            return Vec::new();
        }
        let scheme = Scheme::scaled(self).on_sheet();
        let extents = extents(&scheme);
        let LaidOut { sheet, layout } = scheme.laid_out(None);
        let warning = |(index, placed): (usize, &Placed)| {
            let (panel, extent) = extents[index];
            // Content may reach into the white margin of the frame.
            if fits_into(extent, placed, placed.frame) {
                return None;
            }
            let mut scales = scheme.mu;
            let holds = |mu: &f64| {
                scales[panel] = Some(*mu);
                let placed = &sheet.layout_at(&scales).panels[index];
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

/// By position: the extent of the joints or of their images in a panel.
pub(super) fn extents_of_images<'a>(schemes: &'a [Scheme<'_>], panel: Sheet) -> impl Iterator<Item = Extent> + 'a {
    schemes.iter().filter_map(move |scheme| match panel {
        Sheet::Scheme => Some(scheme.extent_of_joints()),
        plan => scheme.plan(plan).map(plan_panel::extent_of_images),
    })
}

/// A sheet of the scene with its layout.
struct LaidOut<'a> {
    sheet: Composition<'a>,
    layout: Layout,
}

impl Scheme<'_> {
    /// The same with the scales of the figure, or of the sheets with steps, also where each sheet has its own.
    pub(super) fn with_scales_of(self, steps: Option<Steps>) -> Self {
        let mut scheme = self.with_scales();
        if scheme.figure.shown_panels().iter().any(|&panel| scheme.mu[panel].is_none()) {
            let layout = scheme.laid_out(steps).layout;
            scheme.mu = PerSheet::from_fn(|panel| scheme.mu[panel].or(layout.mu(Kind::drawn_on(panel))));
        }
        scheme
    }

    /// The same with room for markers on a work sheet that is to have them, if its contents then have room at its
    /// scales. A figure to be shown has none.
    pub(super) fn on_sheet(self) -> Self {
        let figure = self.figure;
        if !(figure.worksheet && figure.has_markers()) {
            return self;
        }
        let marked = Self { dims: self.dims.with_markers(), ..self };
        let fits = marked.laid_out(None).layout.shows_all();
        if fits { marked } else { Self { dims: marked.dims.without_markers(), ..marked } }
    }

    /// What the small code of a sheet says besides its panels.
    pub(super) fn signs(&self, number: u16, name: &str) -> Signs {
        Signs { page: self.figure.page, number, scene: self.scene.fingerprint(), name: name.to_owned() }
    }

    /// The title of its sheets.
    pub(super) fn title(&self) -> Untrusted {
        self.scene.title.clone().unwrap_or_else(|| self.words.language.title().into())
    }

    /// The sheet with the panels. The table of a work sheet is on it where the panels leave room for it at their scales;
    /// where each sheet has scales of its own, it always is.
    fn laid_out(&self, steps: Option<Steps>) -> LaidOut<'_> {
        let extents = extents(self);
        let laid_out = |table: Option<TablePlace>| {
            let mut sheet = described(self, composed(self, &extents, Contents { steps, table }));
            sheet.signs = self.dims.free.has_markers().then(|| self.signs(1, self.title().for_comparing()));
            LaidOut { layout: sheet.layout(), sheet }
        };
        if !self.figure.worksheet {
            return laid_out(None);
        }
        if self.mu.iter().any(|(_, mu)| mu.is_none()) {
            return laid_out(Some(TablePlace::Anywhere));
        }
        let apart = laid_out(Some(TablePlace::Apart));
        let beside = laid_out(Some(TablePlace::Beside));
        let shown = |sheet: &LaidOut<'_>| [sheet.layout.worth[0], sheet.layout.worth[1]];
        let has_room = beside.layout.aside.is_some() && shown(&beside) >= shown(&apart);
        if has_room { beside } else { apart }
    }
}

/// A sheet of the scene with panels of these extents.
pub(super) fn composed<'a>(scheme: &'a Scheme<'a>, extents: &[(Sheet, Extent)], sheet: Contents) -> Composition<'a> {
    let Contents { steps, table } = sheet;
    let panels = panels(scheme, extents, |panel| match steps {
        Some(_) => vec![hints(scheme, panel), content(scheme, panel)],
        None => vec![content(scheme, panel)],
    });
    let beside: Option<Box<dyn Item>> = match table {
        None => scheme.value_list(None).filter(|_| steps.is_none()).map(|list| Box::new(list) as Box<dyn Item>),
        // A work sheet has all values in its table.
        Some(TablePlace::Apart) => None,
        Some(place) => Some(Box::new(Worksheet { place, ..Worksheet::new(scheme, &panels) })),
    };
    let has_ruler = steps.is_none() && table == Some(TablePlace::Apart);
    let ruler = has_ruler.then(|| Ruler::new(scheme));
    let agreement = agreement(scheme, ruler.as_ref().map_or(0.0, Ruler::width));
    let ruler = ruler.map(|ruler| Box::new(ruler) as Box<dyn Item>);
    let below: Vec<Box<dyn Item + 'a>> = match steps {
        None => std::iter::once(Box::new(agreement) as Box<dyn Item>).chain(ruler).collect(),
        Some(steps) => {
            let words: Box<dyn Item + 'a> = Box::new(StepWords::new(scheme, steps));
            let after = scheme.construction.step_count() as u16 + 1;
            let values = scheme.value_list(Some(after)).map(|list| Box::new(list) as Box<dyn Item>);
            let last = values.unwrap_or_else(|| Box::new(Lines { step: Some(after), ..agreement }));
            vec![words, last]
        }
    };
    Composition { is_stepwise: steps.is_some(), ..composition(scheme, panels, beside, below) }
}

/// The sentences on paths, if there are any, and on how the construction agrees with the loop equations. Beside values
/// and on a projector only what is not as it should be is said. `beside` mm of the width are kept free.
fn agreement(scheme: &Scheme<'_>, beside: f64) -> Lines {
    let (sentence, agrees) = legend::agreement(&scheme.words, scheme.construction);
    let is_said = !agrees || (scheme.values.is_empty() && !scheme.is_projected());
    let sentence = is_said.then_some(sentence);
    Lines::of(scheme.sentence_on_paths().iter().chain(&sentence), scheme.dims.width_below() - beside)
}

/// A sheet with these panels, a table beside them, their scales, and items below.
pub(super) fn composition<'a>(
    scheme: &'a Scheme<'a>,
    panels: Vec<Panel<'a>>,
    table: Option<Box<dyn Item>>,
    below: Vec<Box<dyn Item + 'a>>,
) -> Composition<'a> {
    let (scene, words) = (scheme.scene, scheme.words);
    let legend: Box<dyn Item> = Box::new(Legend { words, units: scene.units, dims: scheme.dims });
    Composition {
        scene,
        dims: scheme.dims,
        words,
        title: scheme.title(),
        description: String::new(),
        steps: Vec::new(),
        is_stepwise: false,
        panels,
        items: table.into_iter().chain([legend]).chain(below).collect(),
        signs: None,
    }
}

/// A sheet with its description and the captions of its steps.
pub(super) fn described<'a>(scheme: &Scheme<'_>, mut sheet: Composition<'a>) -> Composition<'a> {
    let (teller, steps) = (scheme.teller(), scheme.construction.numbered_steps());
    sheet.description = description(scheme, &sheet.panels);
    sheet.steps = steps.map(|step| shown_text(&teller.caption(&step), step.plan, &scheme.words)).collect();
    sheet
}

/// The panels with content, and its extents.
pub(super) fn extents(scheme: &Scheme<'_>) -> Vec<(Sheet, Extent)> {
    let extent = |&panel: &Sheet| match panel {
        Sheet::Scheme => Some((panel, scheme.extent())),
        plan => scheme.plan(plan).map(|plan| (panel, plan_panel::extent(plan, scheme.figure.construction))),
    };
    scheme.figure.shown_panels().iter().filter_map(extent).collect()
}

/// Panels of these extents, with layers from `layers`.
pub(super) fn panels<'a>(
    scheme: &Scheme<'a>,
    extents: &[(Sheet, Extent)],
    layers: impl Fn(Sheet) -> Layers<'a>,
) -> Vec<Panel<'a>> {
    let panel = |(index, &(panel, extent)): (usize, &(Sheet, Extent))| {
        let name = scheme.words.language.sheet(panel);
        let line = |heading: &str| Line::new(vec![RichText::plain(heading)]);
        let frame = |index| Frame { short: Some(line(name)), ..Frame::new(line(&numbered(index, name)), Pen::Heading) };
        let lowest: Box<dyn Layer> = Box::new(frame(index));
        Panel {
            name: name.to_owned(),
            prefix: panel.as_str().to_owned(),
            // The width of the first panel's heading: it must not depend on the panel's letter.
            needs: Needs {
                above: if panel == Sheet::Scheme { scheme.above() } else { 0.0 },
                kind: Kind::drawn_on(panel),
                extent,
                heading: frame(0).width(),
                mu: scheme.mu[panel],
                white: WHITE,
                weight: if scheme.figure.focus.is_some_and(|focus| focus != panel) { COMPANION } else { 1.0 },
            },
            cut: scheme.words.language.cut_at_edge().to_owned(),
            unlabelled: scheme.words.language.names_without_room().to_owned(),
            content: scheme.plan(panel).map(|plan| plan_panel::extent(plan, scheme.figure.construction)),
            layers: std::iter::once(lowest).chain(layers(panel)).collect(),
        }
    };
    extents.iter().enumerate().map(panel).collect()
}

/// The layer with the scheme or a plan.
pub(super) fn content<'a>(scheme: &'a Scheme<'a>, panel: Sheet) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, scheme.plan(panel)) {
        (Sheet::Scheme, _) => scheme.draw(canvas, view),
        (_, Some(plan)) => plan_panel::draw(canvas, view, scheme, plan),
        (_, None) => {}
    })
}

/// The layer with the hints at the subject of each step.
pub(super) fn hints<'a>(scheme: &'a Scheme<'a>, panel: Sheet) -> Box<dyn Layer + 'a> {
    Box::new(move |canvas: &mut Canvas<'_>, view: &View| match (panel, scheme.plan(panel)) {
        (Sheet::Scheme, _) => scheme.hints(canvas, view),
        (_, Some(plan)) => plan_panel::hints(canvas, view, scheme, plan),
        (_, None) => {}
    })
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
    let groups = scheme.mechanism.groups.iter();
    let groups = groups
        .map(|group| language.described_group(group.class.in_words(language), &group.link_names(scheme.mechanism)));
    let description = language.description(&panels.join(", "), &groups.collect::<Vec<_>>().join("; "));
    scheme.sentence_on_paths().into_iter().fold(description, |text, paths| format!("{text} {paths}"))
}
