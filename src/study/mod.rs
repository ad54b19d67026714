//! In: the text of a study and the scene that it is about. Out: rows, one for each of many mechanisms: its varied numbers, how far it
//! goes through the cycle, and figures of quantities over the cycle. Any rows can be asked for in any order and anywhere: a row depends
//! on the study and its own index alone.
//!
//! Mechanisms are assembled (`cycle/alike.rs`) and moved (`together`) side by side as long as that is sure; of the others each is followed by
//! itself (`member`). To make one mechanism of a scene, to compile and to assemble it takes longer than to move it through a turn beside
//! others, so that is done once, with the study's scene; rows only have other numbers (`mechanism/build.rs`, `kernel/lengths.rs`).

mod file;
mod member;
mod plan;
mod samples;
mod task;
mod together;
mod vary;

pub use file::{SceneGiven, StudyFile};
pub use member::StudyError;
pub use plan::Study;
pub use task::{Column, Content, Figure, Status};
