//! Numbers of a construction, and how a calculator makes them from others.

use super::cut::SpecialId;
use super::kennedy::CenterId;
use crate::mechanism::{BodyId, JointId, Mechanism, PointId, SliderId};
use crate::sheet::Order;
use smallvec::SmallVec;

/// Index of a number: given, measured or computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NumberId(pub usize);

/// A product of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// Its meaning.
    pub kind: ProductKind,
    /// A constant, often a sign.
    pub factor: f64,
    /// The numbers multiplied.
    pub of: SmallVec<[NumberId; 3]>,
}

/// Meaning of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProductKind {
    /// A number as it is.
    Plain,
    /// A rate of rotation times a length: a relative velocity, a tangential acceleration.
    Turning,
    /// ω² times a length: a normal acceleration.
    Normal,
    /// Coriolis acceleration 2 ω v_r.
    Coriolis,
    /// A slide rate, along its guide.
    Sliding,
    /// A force times its arm.
    Moment,
}

/// An equation for rates: Σ coefficient · unknown = Σ right.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// Indices of unknowns with their coefficients.
    pub left: Vec<(usize, Product)>,
    /// The right side.
    pub right: Vec<Product>,
}

/// Kind of a number.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum NumberKind {
    /// The distance of two points of the scheme.
    Length([End; 2]),
    /// A segment of the plan of velocities or accelerations, with the names of its ends.
    Segment(Order, [String; 2]),
    /// A rate: given, or solved for.
    Rate(Rate),
    /// The angular velocity of a link, found by distances of instant centres.
    RateByCenters(BodyId),
    /// The velocity of a point, by the distance from an instant centre.
    SpeedByCenters(PointId),
    /// The signed size of a vector that is laid off.
    Size,
    /// The signed size of a force.
    Force,
    /// The signed arm of a force about a point.
    Arm,
    /// A couple, counter-clockwise positive.
    Moment,
    /// A measurement that no later operation uses, with the name of its quantity.
    Reading(String),
}

/// An end of a length on the scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A joint.
    Joint(PointId),
    /// A special point.
    Special(SpecialId),
    /// The pitch point of a mesh.
    Pitch(JointId),
    /// An instant centre.
    Center(CenterId),
}

/// A rate of a link or a slider, in the scene's units, angles in rad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// The angular velocity or acceleration of a link.
    Angular(Order, BodyId),
    /// The velocity or acceleration of a slider along its guide.
    Slide(Order, SliderId),
}

impl Rate {
    /// Whether it is found from velocities or from accelerations.
    #[must_use]
    pub fn order(self) -> Order {
        match self {
            Rate::Angular(order, _) | Rate::Slide(order, _) => order,
        }
    }

    /// The link of an angular rate.
    pub(super) fn link(self) -> Option<BodyId> {
        match self {
            Rate::Angular(_, link) => Some(link),
            Rate::Slide(..) => None,
        }
    }

    /// The name of its quantity, as in `omega(2)`.
    #[must_use]
    pub fn name(self, mechanism: &Mechanism) -> String {
        match self {
            Rate::Angular(order, link) => format!("{}({})", ["omega", "alpha"][order], mechanism.body(link).name),
            Rate::Slide(order, slider) => format!("{}_r({})", order.vector(), mechanism.slider_name(slider)),
        }
    }
}

impl Product {
    /// A constant times numbers.
    #[must_use]
    pub fn new(kind: ProductKind, factor: f64, of: &[NumberId]) -> Product {
        Product { kind, factor, of: SmallVec::from_slice(of) }
    }

    /// A number as it is.
    #[must_use]
    pub fn plain(number: NumberId) -> Product {
        Product::new(ProductKind::Plain, 1.0, &[number])
    }

    /// The product times `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Product {
        Product { factor: self.factor * factor, ..self.clone() }
    }
}
