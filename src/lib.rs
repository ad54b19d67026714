//! Velocity and acceleration plans of planar mechanisms, with the special (Assur) points of third- and fourth-class groups.
//!
//! A scene goes through one stage after another, each a function from one value to the next:
//!
//! ```
//! use kinegon::{drawing, format, mechanism, motion, plan, position, scene};
//!
//! let text = include_str!("../examples/figure-2.json");
//! let scene = scene::Scene::read(text)?;
//! let mechanism = mechanism::mechanism(&scene)?;
//! let pose = position::pose(&mechanism, &scene.near)?;
//! let motion = motion::motion(&mechanism, &pose, motion::Order::Acceleration)?;
//! let plans = plan::construction(&mechanism, &pose, &motion);
//! let drawing = drawing::figure(&scene, &mechanism, &pose, &plans);
//! let svg = format::svg(&drawing);
//!
//! let link = mechanism.link("4").expect("the scene has a link 4");
//! assert!((motion.body(link).omega - -0.474663754894).abs() < 1e-12);
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), kinegon::Error>(())
//! ```
//!
//! Conventions: x right, y up, counter-clockwise positive; radians inside, degrees in scenes and results. Lengths and times
//! keep the scene's own units all the way.

pub mod accuracy;
pub mod check;
#[cfg(feature = "cli")]
pub mod cli;
pub mod cycle;
pub mod drafting;
pub mod drawing;
pub mod exercise;
pub mod format;
pub mod geometry;
pub mod kernel;
pub mod mechanism;
pub mod motion;
pub mod plan;
pub mod position;
pub mod scene;
pub mod words;

mod cores;
mod error;

pub use error::Error;
