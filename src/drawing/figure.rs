use super::canvas::{CAPTION, Canvas};
use super::layout::{Aside, Layout, Placed, Wanted, layout};
use super::legend;
use super::overlay::Overlay;
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::stages::numbered;
use super::style::Style;
use super::text::{PlacedText, RichText};
use super::view::{Extent, View, fitting_scale};
use super::words;
use super::worksheet::Worksheet;
use crate::mechanism::{Class, Mechanism};
use crate::plan::{Scales, Solution, shown_text};
use crate::scene::{Panel, Scene};
use crate::words::{Language, Wording};
use kurbo::{Point, Rect};

impl Solution {
    /// The figure that the scene asks for: its panels on a sheet of paper, true to scale, all labels placed.
    #[must_use]
    pub fn figure(&self) -> Drawing {
        let scheme = Scheme::new(self);
        let extents = extents(&scheme);
        let sheet = Sheet::new(&self.scene, &scheme, &extents, false);
        compose(&self.scene, &scheme, &sheet, &extents, Shown::Figure)
    }

    /// The same figure with every step of the construction in it: [`Drawing::after_step`] gives the sheet as it stands after one of them,
    /// with what to do and the equation below the panels.
    ///
    /// Plans that the figure has no panel for are not drawn, but their steps are told.
    #[must_use]
    pub fn stepwise_figure(&self) -> Drawing {
        let scheme = Scheme::new(self);
        let extents = extents(&scheme);
        let sheet = Sheet::new(&self.scene, &scheme, &extents, true);
        compose(&self.scene, &scheme, &sheet, &extents, Shown::Steps)
    }

    /// The scales of the figure; a plan without a panel has the scale that the scene gives, or none.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let scheme = Scheme::new(self);
        let sheet = Sheet::new(&self.scene, &scheme, &extents(&scheme), false);
        let of = |panel: Panel| {
            let placed = sheet.layout.panels.iter().find(|p| p.panel == panel);
            self.scene.figure.mu(panel).or(placed.map(|p| p.mu))
        };
        Scales { length: of(Panel::Scheme), velocity: of(Panel::Velocity), acceleration: of(Panel::Acceleration) }
    }

    /// What the figure leaves out because it does not fit at a scale that the scene gives: a sentence for each such panel, with a scale that
    /// fits. Special points far away count as fitting: they are shown by their cut lines.
    #[must_use]
    pub fn overflow_warnings(&self) -> Vec<String> {
        let figure = &self.scene.figure;
        if !figure.panels.iter().any(|&panel| figure.mu(panel).is_some()) {
            return Vec::new();
        }
        let scheme = Scheme::new(self);
        let extents = extents(&scheme);
        let sheet = Sheet::new(&self.scene, &scheme, &extents, false);
        let panels = sheet.layout.panels.iter().zip(&extents);
        panels.filter_map(|(placed, (_, extent))| overflow_warning(placed, extent)).collect()
    }
}

/// What is said of a panel whose content is larger than it.
fn overflow_warning(placed: &Placed, extent: &Extent) -> Option<String> {
    // Within the panel, even if not within the white around its content.
    let (size, frame) = (extent.size() / placed.mu, placed.frame);
    if size.x <= frame.width() && size.y <= frame.height() {
        return None;
    }
    let key = match placed.panel {
        Panel::Scheme => "mu_l",
        Panel::Velocity => "mu_v",
        Panel::Acceleration => "mu_a",
    };
    let words = Wording::default();
    let panel = name(words.language, placed.panel).to_lowercase();
    let fitting = legend::short(&words, fitting_scale(extent, placed.area));
    let given = legend::short(&words, placed.mu);
    Some(format!(
        "the {panel} does not fit into its panel at {key} = {given} and is cut off there; {fitting} fits, or a larger sheet"
    ))
}

/// What a figure shows.
#[derive(Clone, Copy)]
pub(super) enum Shown<'a> {
    /// The finished figure.
    Figure,
    /// The same with other words below its scales.
    Words(&'a [RichText]),
    /// The same with all its steps.
    Steps,
    /// The same under a student's drawing.
    Overlay(&'a Overlay),
}

/// The stepwise figures of one mechanism in several positions, all with the same panels and scales, so that they can be shown one
/// after another.
///
/// Panels are large enough for all that the position `own` has, and for the joints and their images in the others, but for plans
/// several times as large as most: near a limit position rates grow without bound, and special points run to infinity. What does not
/// fit is cut off at the panel's edge. Moving figures are for the screen: none is a work sheet.
#[must_use]
pub fn frames(positions: &[Solution], own: usize) -> Vec<Drawing> {
    let schemes: Vec<Scheme<'_>> =
        positions.iter().map(|solution| Scheme { insets: false, ..Scheme::new(solution) }).collect();
    let Some(scene) = positions.get(own).map(|solution| &solution.scene) else {
        return Vec::new();
    };
    let first = &schemes[own];
    let extents: Vec<(Panel, Extent)> = extents(first)
        .into_iter()
        .map(|(panel, extent)| {
            let others = schemes.iter().filter_map(|scheme| match panel {
                Panel::Scheme => Some(scheme.extent_of_joints()),
                Panel::Velocity => Some(plan_panel::extent_of_images(&scheme.construction.velocity)),
                Panel::Acceleration => {
                    let plan = scheme.construction.acceleration.as_ref()?;
                    Some(plan_panel::extent_of_images(plan))
                }
            });
            (panel, extent.with_most(others))
        })
        .collect();
    let most = schemes.iter().map(|scheme| scheme.agreement().len());
    let lines = most.max().unwrap_or_default();
    let below = words_below(lines, true);
    let sheet =
        Sheet { layout: Sheet::divided(scene, first, &extents, below, &|_| vec![Aside::Nothing]), worksheet: None };
    let draw = |scheme: &Scheme<'_>| compose(scene, scheme, &sheet, &extents, Shown::Steps);
    schemes.iter().map(draw).collect()
}

/// The sheet with its panels, its scales, and what is said below them.
pub(super) fn compose(
    scene: &Scene,
    scheme: &Scheme<'_>,
    sheet: &Sheet,
    extents: &[(Panel, Extent)],
    shown: Shown<'_>,
) -> Drawing {
    let layout = &sheet.layout;
    let (mechanism, construction) = (scheme.mechanism, scheme.construction);
    let [width, height] = scene.figure.page.size_mm();
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(scene.figure.style);
    let language = scheme.words.language;
    let title = scene.title.as_deref().unwrap_or(language.title);
    drawing.title = match shown {
        Shown::Overlay(Overlay { name: Some(name), .. }) => format!("{title} – {name}"),
        _ => title.to_owned(),
    };
    drawing.language = language.code;
    drawing.description = description(language, mechanism, layout);
    draw_title(&mut drawing, layout.title);
    for (index, placed) in layout.panels.iter().enumerate() {
        let own = extents.iter().find(|(panel, _)| *panel == placed.panel);
        if let Some((_, extent)) = own {
            let view = View::new(placed.mu, extent, placed.area);
            panel(&mut drawing, index, placed, &view, scheme, shown);
        }
    }
    let words = &scheme.words;
    if let (Some(worksheet), Some(area)) = (&sheet.worksheet, layout.table) {
        worksheet.draw(&mut drawing, area, &layout.panels, words);
    }
    legend::draw(&mut drawing, layout, words, scene.units);
    let steps = numbered(construction);
    let steps = steps.map(|(_, plan, step)| shown_text(&step.caption, plan, words));
    drawing.steps = steps.collect();
    match shown {
        Shown::Figure => {
            legend::draw_lines(&mut drawing, layout, scheme.agreement().to_vec());
        }
        Shown::Steps => {
            words::draw(&mut drawing, layout, scene.units, scheme);
            // After the last step.
            let from = drawing.marks.len();
            legend::draw_lines(&mut drawing, layout, scheme.agreement().to_vec());
            for mark in &mut drawing.marks[from..] {
                (mark.since, mark.passing) = (drawing.steps.len() as u16 + 1, true);
            }
        }
        Shown::Words(lines) => legend::draw_lines(&mut drawing, layout, lines.to_vec()),
        Shown::Overlay(_) => {}
    }
    drawing
}

/// The title above the panels, smaller where it would not fit.
pub(super) fn draw_title(drawing: &mut Drawing, room: Rect) {
    let title = RichText::verbatim(&drawing.title);
    let size = TITLE_SIZE * (room.width() / title.width(TITLE_SIZE)).min(1.0);
    let heading = PlacedText::new(title, size, Point::new(room.x0, room.y0 + 5.6));
    drawing.draw(Pen::Heading, Shape::Text(heading));
}

/// The panels that have something to show, and how much.
pub(super) fn extents(scheme: &Scheme<'_>) -> Vec<(Panel, Extent)> {
    let panels = scheme.figure.panels.iter();
    let extents = panels.filter_map(|&panel| {
        let extent = match panel {
            Panel::Scheme => scheme.extent(),
            Panel::Velocity => plan_panel::extent(&scheme.construction.velocity),
            Panel::Acceleration => plan_panel::extent(scheme.construction.acceleration.as_ref()?),
        };
        Some((panel, extent))
    });
    extents.collect()
}

/// The sheet of a figure, divided up, and the table of a work sheet.
pub(super) struct Sheet {
    pub layout: Layout,
    pub worksheet: Option<Worksheet>,
}

impl Sheet {
    /// The sheet for these panels, with room for the words of steps or without.
    fn new(scene: &Scene, scheme: &Scheme<'_>, extents: &[(Panel, Extent)], by_steps: bool) -> Self {
        let page = scene.figure.page.size_mm();
        let table = || Worksheet::new(scheme, scene.units, extents, page);
        let worksheet = scene.figure.worksheet.then(table);
        let below = words_below(scheme.agreement().len(), by_steps);
        let asides = |room| match &worksheet {
            Some(table) => table.asides(room),
            None => vec![Aside::Nothing],
        };
        Self { layout: Self::divided(scene, scheme, extents, below, &asides), worksheet }
    }

    /// The sheet with so much room below the scales. They stand in as few rows as hold them.
    pub(super) fn divided(
        scene: &Scene,
        scheme: &Scheme<'_>,
        extents: &[(Panel, Extent)],
        below: f64,
        asides: &dyn Fn(Rect) -> Vec<Aside>,
    ) -> Layout {
        let wanted = extents.iter().map(|&(panel, extent)| Wanted {
            panel,
            extent,
            heading: heading(scheme, 0, panel).width(HEADING_SIZE) + 2.0 * BEFORE_HEADING,
            mu: scene.figure.mu(panel),
        });
        let wanted: Vec<Wanted> = wanted.collect();
        let page = scene.figure.page.size_mm();
        let in_columns = |columns: usize| {
            let heights = [legend::height(wanted.len(), columns), below];
            layout(page, &wanted, heights, columns, asides)
        };
        let mut layout = in_columns(MOST_COLUMNS);
        for columns in (1..MOST_COLUMNS).rev() {
            if legend::fits(&layout, &scheme.words, scene.units) {
                break;
            }
            layout = in_columns(columns);
        }
        layout
    }
}

/// Columns of scales in the legend at most.
const MOST_COLUMNS: usize = 3;

/// Room that is needed below the scales, for so many lines and for the words of steps.
fn words_below(lines: usize, by_steps: bool) -> f64 {
    let least = if by_steps { words::HEIGHT } else { 0.0 };
    legend::height_of_lines(lines).max(least)
}

fn panel(drawing: &mut Drawing, index: usize, placed: &Placed, view: &View, scheme: &Scheme<'_>, shown: Shown<'_>) {
    let frame = Shape::Polygon(legend::corners(placed.frame));
    drawing.draw(Pen::Frame, frame);
    let name = name(scheme.words.language, placed.panel);
    drawing.panels.push((name.to_owned(), placed.frame));
    let start = Point::new(placed.frame.x0 + BEFORE_HEADING, placed.frame.y0 + 6.0);
    let heading = PlacedText::new(heading(scheme, index, placed.panel), HEADING_SIZE, start);
    let from = drawing.marks.len();
    let mut canvas = Canvas::new(drawing, placed.panel.as_str(), placed.frame, &scheme.figure.labels);
    canvas.draw(Pen::Heading, Shape::Text(heading));
    let student = match shown {
        Shown::Overlay(overlay) => Some(overlay),
        _ => None,
    };
    if let Some(overlay) = student {
        overlay.announce(&mut canvas, view, scheme, placed.panel);
    }
    let with_hints = !matches!(shown, Shown::Figure | Shown::Words(_));
    let plan = match placed.panel {
        Panel::Scheme => {
            if with_hints {
                scheme.hints(&mut canvas, view);
            }
            scheme.draw(&mut canvas, view);
            None
        }
        Panel::Velocity => Some(&scheme.construction.velocity),
        Panel::Acceleration => scheme.construction.acceleration.as_ref(),
    };
    if let Some(plan) = plan {
        if with_hints {
            plan_panel::hints(&mut canvas, view, scheme, plan);
        }
        plan_panel::draw(&mut canvas, view, scheme, plan);
    }
    if let Some(overlay) = student {
        overlay.draw(&mut canvas, view, scheme, placed.panel);
    }
    canvas.finish();
    if let Some(overlay) = student {
        overlay.emphasise(&mut drawing.marks, from, scheme);
    }
}

/// Size of the title.
const TITLE_SIZE: f64 = 5.2;
/// Size of panels' headings, and the white before them.
const HEADING_SIZE: f64 = 1.05 * CAPTION;
const BEFORE_HEADING: f64 = 2.5;

fn name(language: &Language, panel: Panel) -> &'static str {
    match panel {
        Panel::Scheme => language.scheme,
        Panel::Velocity => language.velocity_plan,
        Panel::Acceleration => language.acceleration_plan,
    }
}

/// What stands above the panel of this number.
fn heading(scheme: &Scheme<'_>, index: usize, panel: Panel) -> RichText {
    let letter = char::from(b'a' + index as u8);
    let name = name(scheme.words.language, panel);
    RichText::plain(&format!("({letter}) {name}"))
}

/// The figure in a sentence, for those who cannot see it.
fn description(language: &Language, mechanism: &Mechanism, layout: &Layout) -> String {
    let panels: Vec<&str> = layout
        .panels
        .iter()
        .map(|p| match p.panel {
            Panel::Scheme => language.described_scheme,
            Panel::Velocity => language.described_velocity_plan,
            Panel::Acceleration => language.described_acceleration_plan,
        })
        .collect();
    let groups: Vec<String> = mechanism
        .groups
        .iter()
        .map(|g| {
            let class = match g.class {
                Class::Higher => language.higher,
                other => other.numeral(),
            };
            (language.described_group)(class, &g.link_names(mechanism))
        })
        .collect();
    (language.description)(&panels.join(", "), &groups.join("; "))
}
