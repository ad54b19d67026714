//! Centrodes: the curves on which the instant centre of a link and the frame runs, in the frame and in the link.

use super::reading::{CurveReader, Sampler};
use super::{CycleError, Path, Position, Sampled, Walker};
use crate::geometry::{Point, Vector, cross};
use crate::mechanism::{BodyId, GROUND, PointId};
use crate::quantity::{Pole, QuantityRequest, State, What};
use crate::scene::Head;

/// Largest distance of a centrode from the middle of the straight line between two samples, in sizes of the mechanism.
const TOLERANCE: f64 = 2e-5;

/// Distance of two samples at the smallest distance that counts as a gap, in sizes of the mechanism.
const GAP: f64 = 1e-2;

/// Distance from the mechanism's own position up to which a centrode is followed, in sizes of the mechanism: it may run through infinity.
const REACH: f64 = 1.6;

/// Samples of a centrode besides those of the grid, at most: next to a change point its places are not certain.
const MOST: usize = 20_000;

/// The centrodes of a link, in the scene's frame and unit of length: while the mechanism moves, the moving one rolls on the fixed one.
#[derive(Clone, Debug)]
pub struct Centrode {
    /// The link.
    pub link: BodyId,
    /// Its name.
    pub name: String,
    /// Values of the drive and places of the centre in the frame, in pieces without a gap, as far as they are near the mechanism: the curve may run through
    /// infinity. None of a link that turns about a point of the frame, or that does not turn.
    pub fixed: Vec<Vec<(f64, Point)>>,
    /// The same in the link, where it stands in the scene's own position: both touch in the centre.
    pub moving: Vec<Vec<(f64, Point)>>,
    /// The centre in the scene's own position; none at infinity, or farther away than is shown.
    pub own: Option<Point>,
}

impl<'a> Sampled<'a, Centrode> {
    /// The centrodes of links by their names, over the part of `range` that `path` has reached.
    ///
    /// # Errors
    /// A name is no link of this mechanism, or nothing of the range has been reached.
    pub fn centrodes(path: &'a Path<'a>, range: [f64; 2], links: &[String]) -> Result<Self, CycleError> {
        let mut centrodes = Sampled::<Centrode>::reached(path, range)?;
        let grid = centrodes.grid();
        for name in links {
            centrodes.curves.push(Centrode::new(path, name, &grid)?);
        }
        Ok(centrodes)
    }
}

impl Centrode {
    /// The centrodes of the link of that name, sampled between these values of the drive as densely as they are curved.
    pub(super) fn new(path: &Path<'_>, name: &str, grid: &[f64]) -> Result<Centrode, CycleError> {
        let ground = &path.mechanism.body(GROUND).name;
        let asked = QuantityRequest::new(&format!("{}({name},{ground})", Head::Center.word()), &path.mechanism)?;
        let What::Pole(pole) = &asked.what else { return Err(CycleError::NoPath(crate::text::shown(name))) };
        let link = pole.of.link();
        let mut centrode = Centrode { link, name: name.to_owned(), fixed: Vec::new(), moving: Vec::new(), own: None };
        let Some(own) = path.walker().position(path.start()).map(|position| Standing::of(&position, link, pole)) else {
            return Ok(centrode);
        };
        let mut reader = Reader { asked: &asked, pole, walker: path.walker(), own, is_moving: false, path };
        centrode.own = reader.at(path.start(), None);
        centrode.fixed = reader.pieces(grid);
        reader.is_moving = true;
        centrode.moving = reader.pieces(grid);
        Ok(centrode)
    }
}

/// Where a link stands: a point of it and its direction; and the middle of the mechanism.
#[derive(Clone, Copy)]
struct Standing {
    point: Point,
    along: Vector,
    middle: Point,
}

impl Standing {
    fn of(state: &Position<'_>, link: BodyId, pole: &Pole) -> Standing {
        let corners = (0..pole.points).map(|point| state.place(PointId(point)));
        let middle = crate::geometry::BoundingBox::of(corners)
            .corners
            .map_or_else(Point::origin, |[a, b]| nalgebra::center(&a, &b));
        Standing { point: state.place(pole.near), along: state.axis(link).unwrap_or_else(Vector::x), middle }
    }

    /// A place that moves with the link from here to another standing.
    fn carried(self, place: Point, to: Standing) -> Point {
        let (cosine, sine) = (self.along.dot(&to.along), cross(self.along, to.along));
        let arm = place - self.point;
        to.point + Vector::new(cosine * arm.x - sine * arm.y, sine * arm.x + cosine * arm.y)
    }
}

struct Reader<'r, 'a> {
    asked: &'r QuantityRequest,
    pole: &'r Pole,
    walker: Walker<'a>,
    /// In the scene's own position.
    own: Standing,
    /// Whether it is the curve in the link.
    is_moving: bool,
    path: &'a Path<'a>,
}

impl Reader<'_, '_> {
    fn pieces(&mut self, grid: &[f64]) -> Vec<Vec<(f64, Point)>> {
        let (Some(&first), Some(&last)) = (grid.first(), grid.last()) else { return Vec::new() };
        let mut sampler = Sampler::new(self, [first, last], MOST);
        for &value in grid {
            let place = sampler.curve.at(value, None);
            sampler.go_on((value, place));
        }
        let mut pieces = sampler.pieces();
        // A centre that stays where it is has no curve.
        let size = self.path.size;
        pieces.retain(|piece| crate::geometry::span(piece.iter().map(|(_, place)| *place)) > GAP * size);
        pieces
    }
}

impl CurveReader for Reader<'_, '_> {
    type Value = Point;

    fn at(&mut self, value: f64, _: Option<Point>) -> Option<Point> {
        let position = self.walker.position(value)?;
        let place = self.asked.place_of(self.pole, &position).ok()?;
        let place = match self.is_moving {
            true => Standing::of(&position, self.pole.of.link(), self.pole).carried(place, self.own),
            false => place,
        };
        ((place - self.own.middle).norm() <= REACH * self.path.size).then_some(place)
    }

    fn is_joined(&self, a: Point, b: Point) -> bool {
        (a - b).norm() <= GAP * self.path.size
    }

    fn is_straight(&self, a: Point, middle: Point, b: Point) -> bool {
        (middle - nalgebra::center(&a, &b)).norm() <= TOLERANCE * self.path.size
    }
}
