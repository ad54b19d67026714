//! Points whose paths the figure shows, and ghosts of the links: only what moves in a known way has them.

use std::ops::RangeInclusive;

use super::error::SceneError;
use super::figure::Figure;
use super::given_by::GivenBy;
use super::names::Names;
use super::read::Scene;
use super::slider::Slider;
use super::words::{list, shortened};
use super::wrong::Wrong;

/// How many ghosts a figure may have.
const GHOSTS: RangeInclusive<usize> = 2..=72;

impl Scene {
    /// Whether the paths of these points over the cycle of the drive, and so many ghosts, can be drawn.
    ///
    /// # Errors
    /// The first that cannot; its path is `trace.0` or `ghosts`, and it has no place in the text.
    pub fn check_traced(&self, trace: &[String], ghosts: Option<usize>) -> Result<(), SceneError> {
        let names = Names::new(&self.ground, &self.links);
        let figure = Figure { trace: trace.to_vec(), ghosts, ..Figure::default() };
        check_traced(self.given_by, &names, &self.sliders, &figure).map_err(|wrong| SceneError {
            path: wrong.paths.first().map_or_else(String::new, |path| path.join(".")),
            place: None,
            message: wrong.message,
            hint: wrong.hint,
        })
    }
}

/// Refuses paths of what is no point of a moving link, and paths and ghosts where nothing can be moved.
pub(super) fn check_traced(
    given_by: GivenBy,
    names: &Names<'_>,
    sliders: &[Slider],
    figure: &Figure,
) -> Result<(), Wrong> {
    for (index, point) in figure.trace.iter().enumerate() {
        let path = ["trace", &index.to_string()];
        check_point(&path, names, point)?;
        if figure.trace[..index].contains(point) {
            return Err(Wrong::value(&path, format!("point {point} stands twice")));
        }
    }
    if let Some(count) = figure.ghosts.filter(|count| !GHOSTS.contains(count)) {
        let (least, most) = (GHOSTS.start(), GHOSTS.end());
        let message = format!("the number of ghosts is from {least} to {most}, not {count}");
        return Err(Wrong::value(&["ghosts"], message));
    }
    let (key, what) = match (figure.trace.first(), figure.ghosts) {
        (Some(point), _) => ("trace", format!("point {point} has no path")),
        (None, Some(_)) => ("ghosts", "there are no other positions to draw".to_owned()),
        (None, None) => return Ok(()),
    };
    if given_by == GivenBy::Drawing {
        let hint = "a scene with `lengths` or `shape` and a drive with its `angle` or `position`";
        let message = format!("a drawn configuration cannot be moved, so {what}");
        return Err(Wrong::value(&[key], message).hint(hint));
    }
    let is_driven = names.links.values().any(|link| link.drive.is_some()) || sliders.iter().any(|s| s.drive.is_some());
    if !is_driven {
        let message = format!("there is no drive to move the mechanism, so {what}");
        return Err(Wrong::value(&[key], message).hint(r#"give a link a "drive""#));
    }
    Ok(())
}

/// Refuses what is no point of a moving link: other names, points of the ground, special points, points under others.
fn check_point(path: &[&str], names: &Names<'_>, point: &str) -> Result<(), Wrong> {
    let moving = || {
        let mut moving: Vec<&str> = Vec::new();
        for name in names.links.values().flat_map(|link| &link.points) {
            if !names.on_ground(name) && !moving.contains(&name.as_str()) {
                moving.push(name);
            }
        }
        format!("points that move are {}", list(moving.into_iter()))
    };
    if names.on_ground(point) {
        return Err(Wrong::value(path, format!("point {point} is on the ground and has no path")).hint(moving()));
    }
    if names.is_point(point) {
        return Ok(());
    }
    if names.check_reserved(point).is_err() {
        let message = format!("{} is a name of the construction, and no point of a link", shortened(point));
        return Err(Wrong::value(path, message).hint(moving()));
    }
    names.point(path, point)
}
