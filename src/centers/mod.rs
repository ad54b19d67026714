//! In: a mechanism and the motions of two of its links. Out: their instant centre, the point that has one velocity on both ([`Center`]); of one link's motion the
//! poles of velocities, of accelerations and of inflections ([`Moved`]). Nothing here is drawn, and nothing is computed unless somebody asks for it.
//!
//! # A centre is a point of the projective plane
//!
//! Link i has the velocity v_i at a place q of the mechanism, and ω_i. The centre of i and j has the homogeneous coordinates, counted from q,
//! (J(v_j − v_i) : ω_j − ω_i). Without relative rotation it lies at infinity, normal to the relative velocity; where nothing of it is left the links rest on one
//! another, and only a joint says where they would turn ([`Permanent`]). Rates have bounds, so a centre is at infinity where the bound of ω_j − ω_i holds
//! zero: then all that is certain is how far away it is at least.
//!
//! With one drive all centres belong to the position. With several ones the [`Permanent`] centres do, and all others follow from the rates that the scene gives.

mod center;
mod pair;
mod permanent;
mod poles;

pub use center::Center;
pub(crate) use center::{TrueCenter, to_the_right};
pub use pair::{LinkPair, link_in_index};
pub use permanent::Permanent;
pub use poles::Moved;
