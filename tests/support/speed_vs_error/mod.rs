//! Hard groups of the example `speed_vs_error`, its methods and their truth.

use crate::{groups, planted, random};

pub mod assembled;
mod differences;
pub mod document;
pub mod families;
mod general;
pub mod hand;
pub mod joints;
mod kernel;
pub mod lengths;
mod measure;
pub mod methods;
mod naive;
pub mod routes;
mod single;
pub mod survey;
pub mod truth;
pub mod which;
