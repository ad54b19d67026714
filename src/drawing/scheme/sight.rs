//! What of the mechanism is in sight: its extent, and which special points are near enough to stand at their places.

use crate::construction::{Solution, Special};
use crate::cycle::Traces;
use crate::drawing::context::{Purpose, SheetContext};
use crate::drawing::view::Extent;
use crate::geometry::{Point, Vector, span};
use crate::mechanism::{GROUND, Mark, Mechanism, PointId};
use crate::position::Pose;
use crate::scene::ConstructionShown;

/// Largest size of the scheme with a special point over that without it; more distant points are not drawn at their
/// places: they would make the mechanism small.
const REACH: f64 = 1.4;
/// Largest such size where they are to stand at their places: on sheets of exercises, and in figures as in the source paper.
const REACH_OF_PENCIL: f64 = 2.5;
/// Room for the arrow towards a more distant one, in parts of the mechanism's size.
const ARROW: f64 = 0.12;
/// Length of a guide on the ground to either side of its block, in parts of the mechanism's size.
const GUIDE: f64 = 0.06;

/// The extent of all points, of paths, ghosts and other modes, and of the special points, or of the arrows to those too
/// far away.
pub(in crate::drawing) fn extent(context: &SheetContext<'_>) -> Extent {
    let special = context.special().filter_map(|special| reached(context, special));
    let places = places(context.solution).chain(special);
    let modes = context.modes.shown.iter().flat_map(|(_, pose)| pose.points.iter().copied());
    Extent::of(places.chain(places_of_traces(&context.traces)).chain(modes))
}

/// The extent of a position without what depends on the figure.
pub(in crate::drawing) fn extent_of_joints(solution: &Solution) -> Extent {
    Extent::of(places(solution))
}

/// Whether a special point is near enough to be drawn at its place.
pub(in crate::drawing) fn is_near(context: &SheetContext<'_>, special: &Special) -> bool {
    let points = || context.solution.pose.points.iter().copied();
    let reach = if has_far_points(context) { REACH_OF_PENCIL } else { REACH };
    special.place.finite().is_some_and(|place| span(points().chain([place])) <= reach * span(points()))
}

/// The circles of joints: centre, and radius in the scene's unit of length; zero for a pin.
pub(super) fn circles(mechanism: &Mechanism, pose: &Pose) -> impl Iterator<Item = (PointId, f64)> {
    let marks = mechanism.joints.iter().flat_map(|joint| joint.marks.iter().copied());
    marks.filter_map(|mark| match mark {
        Mark::Circle { center, towards, part } => Some((center, part * pose.arm(center, towards).norm())),
        Mark::Block(_) => None,
    })
}

/// Whether special points far from the mechanism stand at their places.
fn has_far_points(context: &SheetContext<'_>) -> bool {
    context.purpose != Purpose::Figure || context.figure().construction == ConstructionShown::Paper
}

/// A place that the extent of the scheme reaches for a special point: its own or, of a distant one, the end of its
/// arrow.
fn reached(context: &SheetContext<'_>, special: &Special) -> Option<Point> {
    let place = special.place.finite()?;
    if is_near(context, special) {
        return Some(place);
    }
    let start = special.cuts.iter().find_map(|cut| cut.start()).filter(|_| !has_far_points(context))?;
    let start = context.solution.pose.point(start);
    let size = span(context.solution.pose.points.iter().copied());
    Some(start + (place - start).normalize() * (ARROW * size))
}

/// The points of a position, the ends of guides on the ground, and the corners around circles.
fn places(solution: &Solution) -> impl Iterator<Item = Point> {
    let (mechanism, pose) = (&solution.mechanism, &solution.pose);
    let circles = circles(mechanism, pose).flat_map(|(center, radius)| {
        let (center, arm) = (pose.point(center), Vector::new(radius, radius));
        [center - arm, center + arm]
    });
    pose.points.iter().copied().chain(guide_ends(mechanism, pose)).chain(circles)
}

/// Points that extend the scheme for guides on the ground.
fn guide_ends(mechanism: &Mechanism, pose: &Pose) -> impl Iterator<Item = Point> {
    let reach = GUIDE * span(pose.points.iter().copied());
    let sliders = mechanism.slider_ids();
    sliders.filter(|&id| mechanism.slider(id).on == GROUND).flat_map(move |id| {
        let (at, arm) = (pose.point(mechanism.slider(id).at), pose.guide(id) * reach);
        [at - arm, at + arm]
    })
}

fn places_of_traces(traces: &Traces) -> impl Iterator<Item = Point> {
    let pieces = traces.paths.iter().flat_map(|path| path.pieces.iter().chain(&path.beyond).flatten());
    let ghosts = traces.ghosts.iter().flat_map(|ghost| ghost.points.iter().copied());
    pieces.map(|(_, place)| *place).chain(ghosts)
}
