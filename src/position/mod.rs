//! In: a mechanism. Out: a [`Pose`]: where every point is and how every guide points.
//! A drawn configuration is taken as it stands; from lengths every real assembly mode is found and the nearest chosen.
//! No velocity is known here.

mod assemble;
mod closing;
mod drawn;
mod error;
mod frames;
mod legs;
mod levers;
mod modes;
mod platform;
mod pose;
mod roots;
mod rough;
mod search;

pub use assemble::{pose, poses};
pub use error::AssemblyError;
pub use pose::{Assembly, Pose};
