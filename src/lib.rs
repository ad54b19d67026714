//! Kinegon
pub mod drawing;
pub mod format;
pub mod geometry;
pub mod mechanism;
pub mod motion;
pub mod plan;
pub mod position;
pub mod scene;
