//! The text of a scene as a workbench opens it: with what the command line asks for written into it.

use super::files::Source;
use super::message::Failure;
use crate::construction::Solution;
use crate::mechanism::BodyId;
use crate::scene::{Figure, Scene, with_figure, with_near};

/// A scene's text with that figure and, where a mode is asked for, with the places of the solution as rough places.
pub(super) fn text(
    source: &Source,
    own: &Scene,
    solution: &Solution,
    figure: &Figure,
    mode: Option<usize>,
) -> Result<String, Failure> {
    let rewritten = || {
        let text = with_figure(&source.text, figure)?;
        if mode.is_some() { with_near(&text, &places(own, solution)) } else { Ok(text) }
    };
    rewritten().map_err(|error| source.fail(error))
}

/// The places of the points that are sought, and the angles of links that the scene gives roughly.
fn places(own: &Scene, solution: &Solution) -> Vec<(String, Vec<f64>)> {
    let Solution { mechanism, pose, .. } = solution;
    let sought = mechanism.for_positions();
    let points = sought.inner_points().into_iter();
    let points = points.map(|p| (sought.point_name(p).to_owned(), pose.point(p)));
    let points = points.map(|(name, place)| (name, vec![rounded(place.x), rounded(place.y)]));
    let angle = |id: BodyId| pose.axes[id.0].map(|axis| libm::atan2(axis.y, axis.x).to_degrees());
    let links = mechanism.links().filter(|(_, body)| own.near.angles_deg.contains_key(&body.name));
    let angles = links.filter_map(|(id, body)| Some((format!("angle({})", body.name), vec![rounded(angle(id)?)])));
    points.chain(angles).collect()
}

/// A rough place needs no more than six digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
