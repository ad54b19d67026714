//! In: exercises. Out: the bytes of files that learning management systems import: Moodle XML ([`moodle`]), QTI 1.2 for Canvas ([`canvas`]),
//! a SCORM 1.2 package ([`scorm`]). Nothing is read or written here; the same exercises give the same bytes.
//!
//! `question` makes of an exercise its question: what is told and shown, a [`Field`] for each box of the form with the numbers that it
//! accepts, and those that a known mistake gives; `package` writes the files.

mod canvas;
mod moodle;
mod package;
mod question;
mod scorm;

pub use canvas::canvas;
pub use moodle::moodle;
pub use package::CourseError;
pub use question::{Answer, Field, Question};
pub use scorm::scorm;
