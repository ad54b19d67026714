//! Velocity and acceleration plans of planar mechanisms, with the special (Assur) points of third- and fourth-class groups.
//!
//! ```
//! use kinegon::Scene;
//!
//! let scene = Scene::read(include_str!("../examples/figure-2.json"))?;
//! let solution = kinegon::solve(&scene)?;
//! let svg = solution.figure().svg();
//!
//! let omega = solution.quantity("omega(4)")?;
//! # let kinegon::quantity::Quantity::Number(omega) = omega else { panic!("a number") };
//! # assert!((omega - -0.474663754894).abs() < 1e-12);
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), kinegon::Error>(())
//! ```
//!
//! A scene goes through one stage after another, each a folder: `scene`, `mechanism`, `position`, `motion`, `construction`. [`solve`] takes it through all of
//! them; a [`Solution`] is what figures, results, steps and checks are made from.
//!
//! Conventions: x right, y up, counter-clockwise positive; radians inside, degrees in scenes and results. Lengths and times
//! keep the scene's own units all the way.
//!
//! # What stays
//!
//! What this reference shows keeps to semantic versioning: before 1.0 a breaking change raises the minor version. Enums and results that may grow are
//! `#[non_exhaustive]`. What it does not show (`kernel`, `cli`) is public for the program, benches and tests alone, and may change at any time. Five crates are in
//! signatures: [`nalgebra`] for points and vectors, [`kurbo`] for places on a sheet, [`indexmap`] for what has an order, [`smallvec`] for what has few parts, and
//! [`serde_json`] for schemas and for values of files. They are re-exported, and a new major version of one is a breaking change here; implementations of other
//! crates' traits, as schemars', are for our own files. Files have versions of their own: what a scene, a result, a form or a scheme of marks says today stays readable.
//!
//! # Features
//!
//! With `default-features = false` it is the library alone, which reads no files and builds faster.
#![cfg_attr(feature = "document-features", doc = document_features::document_features!())]
#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod accuracy;
pub mod board;
pub mod centers;
pub mod check;
#[cfg(feature = "cli")]
#[doc(hidden)] // the program
pub mod cli;
pub mod construction;
#[cfg(feature = "courses")]
pub mod course;
pub mod cycle;
pub mod drawing;
pub mod editing;
pub mod exercise;
pub mod forces;
pub mod format;
pub mod geometry;
#[doc(hidden)] // the workings of `mechanism`, `position` and `cycle`
pub mod kernel;
pub mod mechanism;
pub mod motion;
#[cfg(feature = "photo")]
pub mod photo;
pub mod position;
pub mod quantity;
pub mod scene;
pub mod study;
pub mod text;
pub mod words;

mod cores;
mod error;
#[doc(hidden)] // for tests
pub mod fluent;
#[doc(hidden)] // for tests
pub mod message;
mod problem;
mod sheet;
mod solve;

#[doc(no_inline)]
pub use {indexmap, kurbo, nalgebra, serde_json, smallvec};

pub use construction::Solution;
pub use error::Error;
#[doc(inline)]
pub use message::Message;
pub use problem::Problem;
pub use scene::Scene;
pub use sheet::{Order, PerSheet, Scales, Sheet, SheetFacts};
pub use solve::{order_of_figure, posed, solve};

// The Rust of README.md and of the guide is run as it stands there.
#[cfg(doctest)]
mod guide {
    #[doc = include_str!("../README.md")]
    mod readme {}

    #[doc = include_str!("../docs/library.md")]
    mod library {}
}
