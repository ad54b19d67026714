use crate::geometry::{Placement, Point, Turn, Vector, degrees_of, turn_of_degrees};
use crate::mechanism::{BodyId, Mechanism, PointId};
use crate::scene::Near;

/// Rough places of points and angles of links, from the scene's `near`: the nearest assembly is chosen.
pub(super) struct Rough {
    /// The points with rough places.
    pub points: Vec<(PointId, Point)>,
    /// The links with rough angles, in degrees.
    pub angles: Vec<(BodyId, f64)>,
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

    /// How many places and angles there are.
    pub(super) fn count(&self) -> usize {
        self.points.len() + self.angles.len()
    }
}

/// The chord, at radius 1, from a link's angle to a rough one in degrees.
pub(super) fn chord(frame: &Placement, angle: f64) -> f64 {
    let now = degrees_of(frame.rotation * Vector::x());
    2.0 * libm::sin(0.5 * (now - angle).to_radians())
}
