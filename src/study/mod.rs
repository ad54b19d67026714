//! In: the text of a study and the scene that it is about. Out: rows, one for each of many mechanisms: its varied numbers, how far it
//! goes through the cycle, and figures of quantities over the cycle. Any rows can be asked for in any order and anywhere: a row hangs on
//! the study and its own index alone.

mod alone;
mod draws;
mod error;
mod figures;
mod file;
mod member;
mod number;
mod peak;
mod plan;
mod rows;
mod samples;
mod together;
mod vary;

pub use error::StudyError;
pub use figures::Figure;
pub use file::{SceneGiven, StudyFile};
pub use plan::Study;
pub use rows::{Column, Content, Status};
