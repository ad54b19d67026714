use super::Count;
use super::closing::places;
use super::tree::Way;
use crate::geometry::{Placement, Point, Turn, Vector, degrees_of, span, turn_of_degrees};
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::scene::Near;

/// Distance of a point from its rough place, in parts of the mechanism's size, above which a person means another place.
const FAR: f64 = 0.22;

/// Number of assemblies that a warning lists.
pub(super) const LISTED: usize = 8;

/// Rough places of points and angles of links, from the scene's `near`: the nearest assembly is chosen.
pub(super) struct Rough {
    points: Vec<(PointId, Point)>,
    angles: Vec<(BodyId, f64)>,
}

impl Rough {
    pub(super) fn new(mechanism: &Mechanism, near: &Near) -> Rough {
        let member = |link: BodyId| mechanism.is_sought(link);
        let of_group = |p: PointId| {
            let mut links = mechanism.links();
            links.any(|(id, body)| member(id) && body.points.contains(&p))
        };
        let points = near.points.iter();
        let points = points.filter_map(|(name, &p)| Some((mechanism.point(name)?, Point::from(p))));
        let angles = near.angles_deg.iter();
        let angles = angles.filter_map(|(name, &angle)| Some((mechanism.link(name)?, angle)));
        Rough {
            points: points.filter(|(p, _)| of_group(*p)).collect(),
            angles: angles.filter(|(link, _)| member(*link)).collect(),
        }
    }

    /// The points with rough places.
    pub(super) fn points(&self) -> &[(PointId, Point)] {
        &self.points
    }

    /// The links with rough angles, in degrees.
    pub(super) fn angles(&self) -> &[(BodyId, f64)] {
        &self.angles
    }

    pub(super) fn has_angles(&self) -> bool {
        !self.angles.is_empty()
    }

    /// Whether nothing is said of the assembly.
    pub(super) fn is_empty(&self) -> bool {
        self.count() == 0
    }

    /// The rough place of a point.
    pub(super) fn place(&self, point: PointId) -> Option<Point> {
        let found = self.points.iter().find(|(p, _)| *p == point);
        found.map(|(_, place)| *place)
    }

    /// The rough angle of a link.
    pub(super) fn angle(&self, link: BodyId) -> Option<Turn> {
        let found = self.angles.iter().find(|(l, _)| *l == link);
        found.map(|(_, angle)| turn_of_degrees(*angle))
    }

    /// Root mean square of the distances from the rough places, for the groups assembled so far; an angle counts as its
    /// chord on a circle whose radius is the mechanism's size.
    pub(super) fn distance(&self, mechanism: &Mechanism, way: &Way) -> f64 {
        let (points, _) = places(mechanism, &way.frames);
        let size = span(points.iter().copied());
        let placed = |p: PointId| {
            let mut links = mechanism.links();
            links.any(|(id, body)| way.frames.of(id).is_some() && body.points.contains(&p))
        };
        let mut sum = 0.0;
        for (p, rough) in self.points.iter().filter(|(p, _)| placed(*p)) {
            sum += (points[p.0] - rough).norm_squared();
        }
        for (link, angle) in &self.angles {
            if let Some(frame) = way.frames.of(*link) {
                let chord = chord(frame, *angle) * size;
                sum += chord * chord;
            }
        }
        (sum / self.count().max(1) as f64).sqrt()
    }

    fn count(&self) -> usize {
        self.points.len() + self.angles.len()
    }

    /// The warning that the nearest assembly is far from `near`: as a whole, or else in one of its places. `count` says
    /// how many assemblies there are.
    pub(super) fn remark(&self, mechanism: &Mechanism, nearest: &Way, count: impl FnOnce() -> Count) -> Option<String> {
        let (points, _) = places(mechanism, &nearest.frames);
        let size = span(points.iter().copied());
        let distance = self.distance(mechanism, nearest);
        if distance > 0.5 * size {
            return Some(format!(
                "`near` is {distance:.4} away (root mean square) from the closest of {} assembly modes, more than half the mechanism's size {size:.4}: \
                 check its coordinates",
                count(),
            ));
        }
        let off = |&(p, rough): &(PointId, Point)| (p, (points[p.0] - rough).norm());
        let (point, off) = self.points.iter().map(off).max_by(|a, b| a.1.total_cmp(&b.1))?;
        (off > FAR * size).then(|| {
            let (name, place) = (mechanism.point_name(point), points[point.0]);
            format!(
                "point {name} is at [{:.4}, {:.4}], {off:.4} away from its place in `near`, in the closest of {} assembly modes: check its coordinates",
                place.x,
                place.y,
                count(),
            )
        })
    }
}

/// The chord, at radius 1, from a link's angle to a rough one in degrees.
pub(super) fn chord(frame: &Placement, angle: f64) -> f64 {
    let now = degrees_of(frame.rotation * Vector::x());
    2.0 * libm::sin(0.5 * (now - angle).to_radians())
}

/// The warning that `near` does not choose, with the first assemblies listed.
pub(super) fn not_chosen(mechanism: &Mechanism, first: &[Way], count: Count) -> String {
    let listed = first.iter().take(LISTED).enumerate().map(|(index, way)| {
        let (points, _) = places(mechanism, &way.frames);
        let places = mechanism.inner_points().into_iter().map(|p| {
            let q = points[p.0];
            format!("{} ({:.2}, {:.2})", mechanism.point_name(p), q.x, q.y)
        });
        format!("{}: {}", index + 1, places.collect::<Vec<_>>().join(" "))
    });
    let listed = listed.collect::<Vec<_>>().join("; ");
    let more = if first.len() > LISTED { "; …" } else { "" };
    let links: Vec<String> = mechanism.groups.iter().map(|g| g.link_names(mechanism)).collect();
    format!(
        "links {} can be assembled in {count} ways and `near` is not given, so mode 1 is taken: {listed}{more}",
        links.join(", "),
    )
}
