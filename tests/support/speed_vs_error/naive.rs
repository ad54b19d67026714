//! The source paper's procedure step by step (Quintero et al. 2011, Eqs. 1–30): special points as crossings, rays, measured
//! segments, four linear equations. With a pencil that errs it is a drawing by hand.

use super::measure::{Pins, Rates};
use nalgebra::{Matrix4, Vector4};

type Vector = [f64; 2];

/// One of the three drawings.
#[derive(Clone, Copy)]
pub enum Sheet {
    Scheme,
    Velocity,
    Acceleration,
}

/// What puts points on paper.
pub trait Pencil {
    /// Where a point ends up.
    fn mark(&mut self, sheet: Sheet, point: Vector) -> Vector;

    /// Whether a point of the scheme can be drawn at all.
    fn reaches(&self, point: Vector) -> bool;
}

/// Numbers in place of paper.
pub struct Exact;

impl Pencil for Exact {
    fn mark(&mut self, _: Sheet, point: Vector) -> Vector {
        point
    }

    fn reaches(&self, _: Vector) -> bool {
        true
    }
}

/// A cut line from an outer joint through an inner one to the special point.
struct Leg {
    /// Outer joint: 0 for B, 1 for E.
    outer: usize,
    /// Its unit direction.
    along: Vector,
    /// Outer to inner joint, inner joint to special point, along it.
    lengths: [f64; 2],
    /// Unknowns: the drag link's rate and the closure link's.
    links: [usize; 2],
}

/// Velocities and accelerations as the procedure gives them; `None` where a special point cannot be drawn.
pub fn rates(pins: &Pins, pencil: &mut impl Pencil) -> Option<Rates<f64>> {
    let [b, c, d, e, f, g] = pins.places.map(|p| pencil.mark(Sheet::Scheme, p));
    let mut special = |first: [Vector; 2], second: [Vector; 2]| {
        let [u, w] = [first, second].map(|[from, to]| unit(minus(to, from)));
        let place = crossing(first[0], u, second[0], w);
        pencil.reaches(place).then(|| pencil.mark(Sheet::Scheme, place))
    };
    let s3 = special([b, c], [e, d])?;
    let s5 = special([b, g], [e, f])?;
    let leg = |outer: usize, ends: [Vector; 2], s: Vector, links| {
        let along = unit(minus(ends[1], ends[0]));
        let measured = |from: Vector, to: Vector| dot(minus(to, from), along);
        Leg { outer, along, lengths: [measured(ends[0], ends[1]), measured(ends[1], s)], links }
    };
    let legs = [
        leg(0, [b, c], s3, [0, 1]),
        leg(1, [e, d], s3, [2, 1]),
        leg(0, [b, g], s5, [0, 3]),
        leg(1, [e, f], s5, [2, 3]),
    ];
    let mut matrix = Matrix4::zeros();
    for (row, leg) in legs.iter().enumerate() {
        for (link, length) in leg.links.into_iter().zip(leg.lengths) {
            matrix[(row, link)] = length;
        }
    }
    let factors = matrix.lu();
    let mut solve = |sheet: Sheet, starts: [Vector; 4]| -> Option<[f64; 4]> {
        let mut segments = Vector4::zeros();
        for pair in [[0, 1], [2, 3]] {
            let rays = pair.map(|leg| turned(legs[leg].along));
            let image = crossing(starts[pair[0]], rays[0], starts[pair[1]], rays[1]);
            let image = pencil.mark(sheet, image);
            for (leg, ray) in pair.into_iter().zip(rays) {
                segments[leg] = dot(minus(image, starts[leg]), ray);
            }
        }
        factors.solve(&segments).map(Into::into)
    };
    let [vb, ve] = pins.velocity;
    let omega = solve(Sheet::Velocity, [vb, ve, vb, ve]);
    let omega = omega.unwrap_or([f64::INFINITY; 4]);
    let starts = std::array::from_fn(|row| {
        let leg: &Leg = &legs[row];
        let squares = leg.links.map(|link| omega[link] * omega[link]);
        let normal = squares[0] * leg.lengths[0] + squares[1] * leg.lengths[1];
        minus(pins.acceleration[leg.outer], [normal * leg.along[0], normal * leg.along[1]])
    });
    let alpha = solve(Sheet::Acceleration, starts).unwrap_or([f64::INFINITY; 4]);
    Some(Rates::from_links(pins, [b, c, d, e, f, g], omega, alpha))
}

fn minus([a, b]: Vector, [c, d]: Vector) -> Vector {
    [a - c, b - d]
}

fn dot([a, b]: Vector, [c, d]: Vector) -> f64 {
    a * c + b * d
}

fn cross([a, b]: Vector, [c, d]: Vector) -> f64 {
    a * d - b * c
}

fn turned([x, y]: Vector) -> Vector {
    [-y, x]
}

fn unit([x, y]: Vector) -> Vector {
    let length = f64::sqrt(x * x + y * y);
    [x / length, y / length]
}

/// Where the lines from p along u and from q along w cross.
fn crossing(p: Vector, u: Vector, q: Vector, w: Vector) -> Vector {
    let t = cross(minus(q, p), w) / cross(u, w);
    [p[0] + t * u[0], p[1] + t * u[1]]
}
