//! Random mechanisms, and how they truly stand and move.

pub mod grow;
pub mod truth;
