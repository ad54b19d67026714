//! What the places of plan points on paper tell: distances, and whether a plan is mirrored.

use super::names::Names;
use super::sheet::PointsOf;
use crate::construction::Plan;
use crate::geometry::Vector;
use crate::sheet::Sheet;
use indexmap::IndexMap;

/// The distance of two given places.
pub(super) struct Distance<'p> {
    /// The name of the segment.
    pub name: String,
    /// The point at its end.
    pub to: &'p str,
    pub mm: f64,
    /// Half the width of the range in which it may be, in mm.
    pub rounding: f64,
}

/// The distances between given places: from the pole to each point, and those between points that a step names.
pub(super) fn distances<'p>(
    plan: Sheet,
    places: &'p IndexMap<String, [f64; 2]>,
    bands: &IndexMap<String, f64>,
    names: &Names<'_>,
) -> Vec<Distance<'p>> {
    let distance = |from: &str, to: &'p str| {
        let [p, q] = [from, to].map(|n| places[n]);
        let (mm, rounding) = (libm::hypot(q[0] - p[0], q[1] - p[1]), rounding(bands, [from, to]));
        Distance { name: plan.segment_name(from, to), to, mm, rounding }
    };
    let points = || places.keys().map(String::as_str).filter(|name| *name != plan.pole());
    let from_pole = points().map(|name| distance(plan.pole(), name));
    let between = points().flat_map(|a| points().map(move |b| (a, b))).map(|(a, b)| distance(a, b));
    from_pole.chain(between.filter(|distance| names.order.contains_key(&distance.name))).collect()
}

/// Half the width of the range in which the distance of two places may be, in mm: people write places to a tenth or a
/// hundredth of a millimetre; places from a photograph have their radii.
fn rounding(bands: &IndexMap<String, f64>, ends: [&str; 2]) -> f64 {
    let [a, b] = ends.map(|name| bands.get(name).copied().unwrap_or(0.0));
    libm::hypot(a, b).max(0.05)
}

/// Whether the places are those of the mirrored plan: no rotation brings them near the right ones, but one of the
/// mirror image does.
pub(super) fn is_mirrored(points: &PointsOf, plan: &Plan) -> bool {
    let Some(pole) = points.pole().and_then(|p| points.places.get(p)) else {
        return false;
    };
    let pairs = points.places.iter().filter_map(|(name, at)| {
        let right = plan.points.get(name)?.vector;
        Some((right, Vector::new(at[0] - pole[0], at[1] - pole[1])))
    });
    let pairs: Vec<(Vector, Vector)> = pairs.collect();
    // The rotation of least squares, as the sum of complex products z̄ w, and z w for the mirror image (Umeyama 1991).
    let (mut turned, mut mirrored) = (Vector::zeros(), Vector::zeros());
    let (mut right, mut written) = (0.0, 0.0);
    for (z, w) in &pairs {
        turned += Vector::new(z.dot(w), z.x * w.y - z.y * w.x);
        mirrored += Vector::new(z.x * w.x - z.y * w.y, z.x * w.y + z.y * w.x);
        right += z.norm_squared();
        written += w.norm_squared();
    }
    // The sum of squares that remains after the best rotation and scaling.
    let rest = |sum: Vector| written - sum.norm_squared() / right;
    right > 0.0 && rest(turned) > 0.01 * written && rest(mirrored) < 0.25 * rest(turned)
}
