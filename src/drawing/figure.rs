use super::canvas::{CAPTION, Canvas};
use super::layout::{Layout, Placed, Wanted, layout};
use super::legend;
use super::plan_panel;
use super::scheme::Scheme;
use super::shape::Shape;
use super::sheet::{Drawing, Pen};
use super::stages::numbered;
use super::text::{PlacedText, RichText};
use super::view::View;
use super::words;
use crate::mechanism::Mechanism;
use crate::plan::{Construction, Scales, plain_text};
use crate::position::Pose;
use crate::scene::{Panel, Scene};
use kurbo::Point;

/// The figure that a scene asks for: its panels on a sheet of paper, true to scale, all labels placed.
#[must_use]
pub fn figure(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    construction: &Construction,
) -> Drawing {
    compose(scene, mechanism, pose, construction, false)
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
    compose(scene, mechanism, pose, construction, true)
}

fn compose(
    scene: &Scene,
    mechanism: &Mechanism,
    pose: &Pose,
    construction: &Construction,
    by_steps: bool,
) -> Drawing {
    let scheme = Scheme::new(scene, mechanism, pose, construction);
    let layout = divide(scene, &scheme, if by_steps { words::HEIGHT } else { 0.0 });
    let [width, height] = scene.figure.page.size_mm();
    let mut drawing = Drawing::new(width, height);
    let title = scene
        .title
        .as_deref()
        .unwrap_or("Velocity and acceleration plans");
    drawing.title = title.to_owned();
    drawing.description = description(mechanism, &layout);
    let heading = PlacedText::new(
        RichText::verbatim(title),
        5.2,
        Point::new(layout.title.x0, layout.title.y0 + 5.6),
    );
    drawing.draw(Pen::Heading, Shape::Text(heading));
    for (index, placed) in layout.panels.iter().enumerate() {
        panel(&mut drawing, index, placed, &scheme, by_steps);
    }
    legend::draw(&mut drawing, layout.legend, scene.units, &layout.panels);
    let steps = numbered(construction).map(|(_, _, step)| plain_text(&step.caption));
    drawing.steps = steps.collect();
    if by_steps {
        words::draw(&mut drawing, &layout, scene.units, &scheme);
    } else {
        legend::agreement(&mut drawing, layout.legend, construction);
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
    let layout = divide(scene, &scheme, 0.0);
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

/// The sheet divided among the panels that have something to show; so much room is left for words.
fn divide(scene: &Scene, scheme: &Scheme<'_>, words: f64) -> Layout {
    let figure = &scene.figure;
    let wanted: Vec<Wanted> = figure
        .panels
        .iter()
        .filter_map(|&panel| {
            let (extent, mu) = match panel {
                Panel::Scheme => (scheme.extent(), figure.mu_l),
                Panel::Velocity => {
                    let plan = &scheme.construction.velocity;
                    (plan_panel::extent(plan), figure.mu_v)
                }
                Panel::Acceleration => {
                    let plan = scheme.construction.acceleration.as_ref()?;
                    (plan_panel::extent(plan), figure.mu_a)
                }
            };
            Some(Wanted { panel, extent, mu })
        })
        .collect();
    layout(figure.page.size_mm(), &wanted, words)
}

fn panel(
    drawing: &mut Drawing,
    index: usize,
    placed: &Placed,
    scheme: &Scheme<'_>,
    by_steps: bool,
) {
    let frame = Shape::Polygon(legend::corners(placed.frame));
    drawing.draw(Pen::Frame, frame);
    let (prefix, heading) = match placed.panel {
        Panel::Scheme => ("scheme", "Scheme"),
        Panel::Velocity => ("velocity", "Velocity plan"),
        Panel::Acceleration => ("acceleration", "Acceleration plan"),
    };
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
            let view = View::new(placed.mu, &scheme.extent(), placed.area);
            if by_steps {
                scheme.hints(&mut canvas, &view);
            }
            scheme.draw(&mut canvas, &view);
            None
        }
        Panel::Velocity => Some(&scheme.construction.velocity),
        Panel::Acceleration => scheme.construction.acceleration.as_ref(),
    };
    if let Some(plan) = plan {
        let view = View::new(placed.mu, &plan_panel::extent(plan), placed.area);
        if by_steps {
            plan_panel::hints(&mut canvas, &view, scheme, plan);
        }
        plan_panel::draw(&mut canvas, &view, scheme, plan);
    }
    canvas.finish();
}

/// The figure in a sentence, for those who cannot see it.
fn description(mechanism: &Mechanism, layout: &Layout) -> String {
    let panels: Vec<&str> = layout
        .panels
        .iter()
        .map(|p| match p.panel {
            Panel::Scheme => "the mechanism to scale",
            Panel::Velocity => "its velocity plan",
            Panel::Acceleration => "its acceleration plan",
        })
        .collect();
    let groups: Vec<String> = mechanism
        .groups
        .iter()
        .map(|g| {
            format!(
                "class {}, links {}",
                g.class.numeral(),
                g.link_names(mechanism)
            )
        })
        .collect();
    format!(
        "Panels: {}. Assur groups: {}.",
        panels.join(", "),
        groups.join("; ")
    )
}
