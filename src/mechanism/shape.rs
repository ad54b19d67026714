use crate::geometry::{Point, Vector, cross, unit};
use crate::scene::{Length, Link, STRAIGHT, Shape};

/// How certain it is on which side of a link's axis its third point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The scene says it, or it makes no difference.
    Certain,
    /// Nothing says it: the counter-clockwise side was taken.
    Unknown,
    /// The triangle is nearly flat, and its mirror image fits the rough places almost as well.
    Doubtful,
}

/// Height of a triangle, in parts of its longest side, below which it counts as nearly flat.
const FLAT: f64 = 0.1;

/// Ratio of the distances from rough places, root mean square, from which on they tell a triangle from its mirror image.
const CLEAR: f64 = 3.0;

/// Whether a triangle is nearly flat and its mirror image fits the rough places almost as well.
fn is_doubtful(local: &[Point], rough: &[Point]) -> bool {
    let [a, b, c] = [local[0], local[1], local[2]];
    let longest = [b - a, c - a, c - b].map(|side| side.norm()).into_iter().fold(0.0, f64::max);
    let height = cross(b - a, c - a).abs() / longest;
    let mirrored: Vec<Point> = local.iter().map(|p| Point::new(p.x, -p.y)).collect();
    height < FLAT * longest && misfit(&mirrored, rough) < CLEAR * CLEAR * misfit(local, rough)
}

/// The least sum of squared distances between points and places, over all placements of the points.
fn misfit(points: &[Point], places: &[Point]) -> f64 {
    let mean = |all: &[Point]| all.iter().fold(Vector::zeros(), |sum, p| sum + p.coords) / all.len() as f64;
    let (middle, centre) = (mean(points), mean(places));
    let pairs = points.iter().zip(places).map(|(p, q)| (p.coords - middle, q.coords - centre));
    let (mut squares, mut cosine, mut sine) = (0.0, 0.0, 0.0);
    for (p, q) in pairs {
        squares += p.norm_squared() + q.norm_squared();
        cosine += p.dot(&q);
        sine += cross(p, q);
    }
    (squares - 2.0 * libm::hypot(cosine, sine)).max(0.0)
}

/// The coordinates of a link's points in its own frame: origin in the first point, x axis towards the second, unless
/// the link has a shape of its own.
///
/// `approximate` gives rough places in the fixed frame, which decide on which side of the axis the third point of a
/// triangle lies.
pub(super) fn local_points(link: &Link, approximate: impl Fn(&str) -> Option<Point>) -> (Vec<Point>, Side) {
    match &link.shape {
        Shape::Bare => (vec![Point::origin(); link.points.len()], Side::Certain),
        Shape::Local(places) => {
            let at = |name: &String| places.get(name).map_or_else(Point::origin, |&p| p.into());
            (link.points.iter().map(at).collect(), Side::Certain)
        }
        Shape::Lengths(lengths) => match link.points.as_slice() {
            [a, b] => (vec![Point::origin(), Point::new(length_between(lengths, a, b), 0.0)], Side::Certain),
            [a, b, c] => {
                let rough: Option<Vec<Point>> = link.points.iter().map(|name| approximate(name)).collect();
                let area = rough.as_deref().map(|rough| cross(rough[1] - rough[0], rough[2] - rough[0]));
                let [ab, ac, bc] = [(a, b), (a, c), (b, c)].map(|(p, q)| length_between(lengths, p, q));
                let third = triangle(ab, ac, bc);
                let side = if area.is_some_and(|area| area < 0.0) { -1.0 } else { 1.0 };
                let points = vec![Point::origin(), Point::new(ab, 0.0), Point::new(third.x, side * third.y)];
                let side = match rough {
                    _ if third.y == 0.0 => Side::Certain,
                    None => Side::Unknown,
                    Some(rough) if is_doubtful(&points, &rough) => Side::Doubtful,
                    Some(_) => Side::Certain,
                };
                (points, side)
            }
            more => (vec![Point::origin(); more.len()], Side::Certain),
        },
    }
}

/// The given length between two points, which a checked scene has.
fn length_between(lengths: &[Length], a: &str, b: &str) -> f64 {
    lengths.iter().find(|length| length.joins(a, b)).map_or(0.0, |length| length.value)
}

/// The third corner, at y ≥ 0, of a triangle with base `ab` on the x axis and sides `ac`, `bc`.
///
/// Sums and differences come before products, and the height from Kahan's stable form of Heron's formula (W. Kahan,
/// *Miscalculating Area and Angles of a Needle-like Triangle*, 2014). Lengths that fail to close by rounding only make
/// a straight link.
fn triangle(ab: f64, ac: f64, bc: f64) -> Point {
    let x = 0.5 * (ab + (ac - bc) * ((ac + bc) / ab));
    let mut sides = [ab, ac, bc];
    sides.sort_by(f64::total_cmp);
    let [c, b, a] = sides;
    if (a - b - c).abs() <= STRAIGHT * a {
        return Point::new(x, 0.0);
    }
    let sixteen_areas = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    Point::new(x, 0.5 * sixteen_areas.max(0.0).sqrt() / ab)
}

/// The unit vector along `v`, which is not zero in a checked scene.
pub(super) fn direction(v: Vector) -> Vector {
    unit(v).unwrap_or_else(Vector::x)
}
