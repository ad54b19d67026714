//! Random mechanisms, and how they truly stand and move.

pub mod carried;
pub mod grow;
pub mod truth;
