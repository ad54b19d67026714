use super::canvas::{CAPTION, Canvas};
use super::layout::{Layout, Placed, Wanted, layout};
use super::legend;
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::stages::numbered;
use super::style::Style;
use super::text::{PlacedText, RichText};
use super::view::{Extent, View};
use super::words;
use crate::mechanism::{Class, Mechanism};
use crate::plan::{Construction, Scales, shown_text};
use crate::position::Pose;
use crate::scene::{Figure, Panel, Scene};
use crate::words::Language;
use kurbo::Point;

/// The figure that a scene asks for: its panels on a sheet of paper, true to scale, all labels placed.
#[must_use]
pub fn figure(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    construction: &Construction,
) -> Drawing {
    let scheme = Scheme::new(scene, mechanism, pose, construction);
    let extents = extents(&scheme);
    let layout = divide(&scene.figure, &extents, 0.0);
    compose(scene, &scheme, &layout, &extents, false)
}

/// The same figure with every step of the construction in it: [`Drawing::after_step`] gives the sheet as it stands after one of them,
/// with what to do and the equation below the panels.
///
/// Plans that the figure has no panel for are not drawn, but their steps are told.
#[must_use]
pub fn stepwise(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    construction: &Construction,
) -> Drawing {
    let scheme = Scheme::new(scene, mechanism, pose, construction);
    let extents = extents(&scheme);
    let layout = divide(&scene.figure, &extents, words::HEIGHT);
    compose(scene, &scheme, &layout, &extents, true)
}

/// The stepwise figures of one mechanism in several positions, all with the same panels and scales, so that they can be shown one
/// after another.
///
/// Panels are large enough for all that the position `own` has, and for the joints and their images in the others, but for plans
/// several times as large as most: near a limit position rates grow without bound, and special points run to infinity. What does not
/// fit is cut off at the panel's edge.
#[must_use]
pub fn frames(
    scene: &Scene,
    mechanism: &Mechanism,
    positions: &[(Pose, Construction)],
    own: usize,
) -> Vec<Drawing> {
    let scheme = |(pose, construction)| Scheme {
        insets: false,
        ..Scheme::new(scene, mechanism, pose, construction)
    };
    let schemes: Vec<Scheme<'_>> = positions.iter().map(|(p, c)| scheme((p, c))).collect();
    let Some(first) = schemes.get(own) else {
        return Vec::new();
    };
    let extents: Vec<(Panel, Extent)> = extents(first)
        .into_iter()
        .map(|(panel, extent)| {
            let others = schemes.iter().filter_map(|scheme| match panel {
                Panel::Scheme => Some(scheme.extent_of_joints()),
                Panel::Velocity => {
                    Some(plan_panel::extent_of_images(&scheme.construction.velocity))
                }
                Panel::Acceleration => {
                    let plan = scheme.construction.acceleration.as_ref()?;
                    Some(plan_panel::extent_of_images(plan))
                }
            });
            (panel, extent.with_most(others))
        })
        .collect();
    let layout = divide(&scene.figure, &extents, words::HEIGHT);
    let draw = |scheme: &Scheme<'_>| compose(scene, scheme, &layout, &extents, true);
    schemes.iter().map(draw).collect()
}

fn compose(
    scene: &Scene,
    scheme: &Scheme<'_>,
    layout: &Layout,
    extents: &[(Panel, Extent)],
    by_steps: bool,
) -> Drawing {
    let (mechanism, construction) = (scheme.mechanism, scheme.construction);
    let [width, height] = scene.figure.page.size_mm();
    let mut drawing = Drawing::new(width, height);
    drawing.style = Style::named(scene.figure.style);
    let language = scheme.words.language;
    let title = scene.title.as_deref().unwrap_or(language.title);
    drawing.title = title.to_owned();
    drawing.language = language.code;
    drawing.description = description(language, mechanism, layout);
    let heading = PlacedText::new(
        RichText::verbatim(title),
        5.2,
        Point::new(layout.title.x0, layout.title.y0 + 5.6),
    );
    drawing.draw(Pen::Heading, Shape::Text(heading));
    for (index, placed) in layout.panels.iter().enumerate() {
        let shown = extents.iter().find(|(panel, _)| *panel == placed.panel);
        if let Some((_, extent)) = shown {
            let view = View::new(placed.mu, extent, placed.area);
            panel(&mut drawing, index, placed, &view, scheme, by_steps);
        }
    }
    let words = &scheme.words;
    legend::draw(
        &mut drawing,
        layout.legend,
        words,
        scene.units,
        &layout.panels,
    );
    let steps = numbered(construction);
    let steps = steps.map(|(_, plan, step)| shown_text(&step.caption, plan, words));
    drawing.steps = steps.collect();
    if by_steps {
        words::draw(&mut drawing, layout, scene.units, scheme);
        // After the last step.
        let from = drawing.marks.len();
        legend::agreement(&mut drawing, layout.legend, words, construction);
        for mark in &mut drawing.marks[from..] {
            (mark.since, mark.passing) = (drawing.steps.len() as u16 + 1, true);
        }
    } else {
        legend::agreement(&mut drawing, layout.legend, words, construction);
    }
    drawing
}

/// The scales of the figure that a scene asks for; a plan without a panel has the scale that the scene gives, or none.
#[must_use]
pub fn scales(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    construction: &Construction,
) -> Scales {
    let scheme = Scheme::new(scene, mechanism, pose, construction);
    let layout = divide(&scene.figure, &extents(&scheme), 0.0);
    let of = |panel: Panel, given: Option<f64>| {
        let placed = layout.panels.iter().find(|p| p.panel == panel);
        given.or(placed.map(|p| p.mu))
    };
    Scales {
        length: of(Panel::Scheme, scene.figure.mu_l),
        velocity: of(Panel::Velocity, scene.figure.mu_v),
        acceleration: of(Panel::Acceleration, scene.figure.mu_a),
    }
}

/// The panels that have something to show, and how much.
fn extents(scheme: &Scheme<'_>) -> Vec<(Panel, Extent)> {
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

/// The sheet divided among the panels; so much room is left for words.
fn divide(figure: &Figure, extents: &[(Panel, Extent)], words: f64) -> Layout {
    let wanted = extents.iter().map(|&(panel, extent)| {
        let mu = match panel {
            Panel::Scheme => figure.mu_l,
            Panel::Velocity => figure.mu_v,
            Panel::Acceleration => figure.mu_a,
        };
        Wanted { panel, extent, mu }
    });
    let wanted: Vec<Wanted> = wanted.collect();
    layout(figure.page.size_mm(), &wanted, words)
}

fn panel(
    drawing: &mut Drawing,
    index: usize,
    placed: &Placed,
    view: &View,
    scheme: &Scheme<'_>,
    by_steps: bool,
) {
    let frame = Shape::Polygon(legend::corners(placed.frame));
    drawing.draw(Pen::Frame, frame);
    let language = scheme.words.language;
    let (prefix, heading) = match placed.panel {
        Panel::Scheme => ("scheme", language.scheme),
        Panel::Velocity => ("velocity", language.velocity_plan),
        Panel::Acceleration => ("acceleration", language.acceleration_plan),
    };
    drawing.panels.push((heading.to_owned(), placed.frame));
    let letter = char::from(b'a' + index as u8);
    let heading = PlacedText::new(
        RichText::plain(&format!("({letter}) {heading}")),
        1.1 * CAPTION,
        Point::new(placed.frame.x0 + 2.5, placed.frame.y0 + 5.2),
    );
    let mut canvas = Canvas::new(drawing, prefix, placed.frame, &scheme.figure.labels);
    canvas.draw(Pen::Heading, Shape::Text(heading));
    let plan = match placed.panel {
        Panel::Scheme => {
            if by_steps {
                scheme.hints(&mut canvas, view);
            }
            scheme.draw(&mut canvas, view);
            None
        }
        Panel::Velocity => Some(&scheme.construction.velocity),
        Panel::Acceleration => scheme.construction.acceleration.as_ref(),
    };
    if let Some(plan) = plan {
        if by_steps {
            plan_panel::hints(&mut canvas, view, scheme, plan);
        }
        plan_panel::draw(&mut canvas, view, scheme, plan);
    }
    canvas.finish();
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
