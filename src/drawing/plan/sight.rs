//! What of a plan is in sight: its extent, and which points are drawn.

use crate::construction::{Plan, PointRole};
use crate::drawing::view::Extent;
use crate::geometry;
use crate::scene::{ConstructionShown, Figure};
use crate::sheet::Sheet;

/// Largest size of a plan with a point that only leads to others over that without it; a more distant one is not drawn
/// at its place, but where its line leaves the panel.
const REACH: f64 = 2.0;

/// The extent of the plan's points, without far ones that only lead to others: with each of those, taken from the
/// nearest on, the plan must not grow by more than `REACH`. A plan as in the source paper has them all.
pub(in crate::drawing) fn extent(plan: &Plan, shown: ConstructionShown) -> Extent {
    let images = extent_of_images(plan);
    let leading = plan.points.values().filter(|p| !is_image(p.role)).map(|p| p.vector.into());
    let mut leading: Vec<geometry::Point> = leading.collect();
    let size = |place: &geometry::Point| images.with(*place).size().norm();
    leading.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let mut extent = images;
    for place in leading {
        let larger = extent.with(place);
        if shown != ConstructionShown::Paper && larger.size().norm() > REACH * extent.size().norm() {
            break;
        }
        extent = larger;
    }
    extent
}

/// Whether a point stands for one of the mechanism, and does not only lead to others.
pub(super) fn is_image(role: PointRole) -> bool {
    matches!(role, PointRole::Pole | PointRole::Known | PointRole::Image)
}

/// The extent of the pole and the images alone, without the points that lead to them.
pub(in crate::drawing) fn extent_of_images(plan: &Plan) -> Extent {
    Extent::of(plan.points.values().filter(|p| is_image(p.role)).map(|p| p.vector.into()))
}

/// Whether a plan point only leads to others, in a figure that does not show such points.
pub(in crate::drawing) fn is_hidden(figure: &Figure, plan: &Plan, name: &str) -> bool {
    let role = plan.points.get(name).map(|p| p.role);
    let on_the_way = match plan.sheet {
        Sheet::Scheme | Sheet::Velocity => matches!(role, Some(PointRole::Special)),
        Sheet::Acceleration => matches!(role, Some(PointRole::Special | PointRole::Normal | PointRole::Slid)),
    };
    on_the_way && !figure.special_points
}
