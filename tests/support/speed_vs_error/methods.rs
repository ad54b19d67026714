//! The methods that are compared: velocities and accelerations of a fourth-class group whose position is given.

use super::general::{self, Solver};
use super::groups::Group;
use super::joints::{Given, JointEquations};
use super::measure::{Case, Rates};
use super::single::Single;
use super::{differences, kernel, naive};
use kinegon::Order;
use kinegon::motion::motion;

/// A way to the numbers; by hand is none of them, see `hand`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The source paper's procedure in f64.
    Naive,
    /// The equations of all joints, by triangular factors.
    Lu,
    /// The equations of all joints, by orthogonal factors.
    Qr,
    /// The loop equations on differences, by triangular factors.
    Differences,
    /// The library's `motion`, with condition and error bounds.
    Library,
    /// The library's kernel alone.
    Kernel,
    /// The kernel in f32.
    Single,
}

impl Method {
    pub const ALL: [Method; 7] =
        [Method::Naive, Method::Lu, Method::Qr, Method::Differences, Method::Library, Method::Kernel, Method::Single];

    /// A short name.
    pub fn name(self) -> &'static str {
        match self {
            Method::Naive => "special points, naive",
            Method::Lu => "joint equations, LU",
            Method::Qr => "joint equations, QR",
            Method::Differences => "differences, LU",
            Method::Library => "Kinegon with bounds",
            Method::Kernel => "Kinegon",
            Method::Single => "Kinegon in f32",
        }
    }

    /// What it is, in a sentence.
    pub fn says(self) -> &'static str {
        match self {
            Method::Naive => {
                "the source paper's procedure as one would program it: special points as crossings of unit vectors, rays, \
                 measured segments, four linear equations"
            }
            Method::Lu => {
                "two equations for each joint, twelve unknowns, as general programs for mechanisms set them up; nalgebra's LU"
            }
            Method::Qr => "the same by nalgebra's QR",
            Method::Differences => {
                "four loop equations in four rates on differences of places and motions, as anyone writes them who subtracts first; \
                 nalgebra's LU"
            }
            Method::Library => {
                "`motion::motion`: the loop equations with condition number and a bound of every rate's error"
            }
            Method::Kernel => {
                "the loop equations alone, reduced to two by `geometry::Reduced`, as tables and curves of a cycle use them"
            }
            Method::Single => {
                "the same code with numbers of 24 bits; positions are subtracted in f64. It is no quicker: one group at a time \
                 fills no register, an f32 operation takes as long as an f64 one, and every number is converted"
            }
        }
    }

    /// Its source.
    pub fn source(self) -> &'static str {
        match self {
            Method::Naive => "tests/support/speed_vs_error/naive.rs",
            Method::Lu | Method::Qr => "tests/support/speed_vs_error/general.rs",
            Method::Differences => "tests/support/speed_vs_error/differences.rs",
            Method::Library => "src/motion/solve.rs",
            Method::Kernel => "tests/support/speed_vs_error/kernel.rs",
            Method::Single => "tests/support/speed_vs_error/single.rs",
        }
    }
}

/// A case and what the methods keep from position to position.
pub struct Prepared {
    pub case: Case,
    equations: JointEquations,
    given: Given<f64>,
}

impl Prepared {
    /// `None` where the group is exactly singular.
    pub fn new(group: &Group) -> Option<Prepared> {
        let case = Case::new(group)?;
        let points: Vec<[f64; 2]> = case.pose.points.iter().map(|p| [p.x, p.y]).collect();
        Some(Prepared {
            equations: JointEquations::new(&case.mechanism),
            given: Given::new(&case.mechanism, &points, &[]),
            case,
        })
    }

    /// What a method gives; infinite numbers where it gives none.
    pub fn rates(&self, method: Method) -> Rates<f64> {
        let pins = &self.case.pins;
        let none = [f64::INFINITY; 4];
        let none = || Rates::from_links(pins, pins.places, none, none);
        match method {
            Method::Naive => naive::rates(pins, &mut naive::Exact).unwrap_or_else(none),
            Method::Lu => general::rates(&self.equations, &self.given, pins, Solver::Lu),
            Method::Qr => general::rates(&self.equations, &self.given, pins, Solver::Qr),
            Method::Differences => differences::rates(pins),
            Method::Library => {
                let motion = motion(&self.case.mechanism, &self.case.pose, Order::Acceleration);
                motion.map_or_else(|_| none(), |motion| self.case.rates_of(&motion))
            }
            Method::Kernel => kernel::rates(pins, |x| x),
            Method::Single => kernel::rates(pins, |x| Single(x as f32)).map(|x| f64::from(x.0)),
        }
    }
}
