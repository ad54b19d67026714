//! In: a scene and a [`HandDrawing`], what a hand did with ruler, set squares, dividers, pencil and calculator, operation by operation.
//! Out: the sheets as they were drawn, and a verdict on each operation, with what was probably done at the first wrong one.
//!
//! In reading order: `file`, `entry`, `direction` and `formula` (the drawing as it is written), `given` and `given_vectors` (what the scene gives, and what every name
//! means; `names`: by itself), `table`, `carried_out` and `equations` (the things made so far, and how one more entry is carried out), `reads` (what an entry uses).
//! `judge` and `others` (scenes like this one), `bench` (entry by entry), `alone`, `free_hand` and `recognised` (what an entry comes to by itself), `blame`
//! (who is to blame), `cause` (the catalogue of mistakes), `slips`, `slip_equations` and `slip_vectors` (what the entry would be without a slip), `centers` (what is probably wrong with lines of instant centres),
//! `polygons`, `force_plan`, `force_lines` and `moments` (force polygons, whose corners have no names of their own, and sums of moments). `told` puts it
//! in words. For pages: `screen`, `references`, `shown` and `numbers` (what is seen), `pictures` (of what a hand has drawn), `snap` (what a press may mean), `hint`, `form` (the drawing as a
//! form of values); `writes` writes Kinegon's own construction as a drawing.
//!
//! # Each operation by itself
//!
//! There are endless right ways to a plan, so no list of them is compared with; and a wrong way may hit by chance, so values alone are not
//! compared either. Each entry is carried out with right inputs in place of the hand's own, in the scene and in others like it with
//! other sizes, angles and rates: a point must be where its name says, a number must be what its name says, a line must go through the
//! point for which it is used. The idea is that of constructions compared as functions (iGeom: D. Isotani, L. Brandão, 2008, equal outputs
//! for moved inputs), but by operation, so that the first wrong one is known and what only follows from it is not blamed.

mod alone;
mod bench;
mod blame;
mod carried_out;
mod cause;
mod centers;
mod direction;
mod entry;
mod equations;
mod file;
mod force_lines;
mod force_plan;
mod form;
mod formula;
mod free_hand;
mod given;
mod given_vectors;
mod hint;
mod judge;
mod moments;
mod names;
mod numbers;
mod others;
mod pictures;
mod polygons;
mod reads;
mod recognised;
mod references;
#[doc(hidden)] // for tests
pub mod says;
mod screen;
mod shown;
mod slip_equations;
mod slip_vectors;
mod slips;
mod snap;
mod table;
mod told;
mod writes;

pub use direction::Direction;
pub use entry::{Compute, Cross, Entry, Join, LayOff, Like, Line, Mark, Measure, Sense, Solve, Undo};
pub use file::{HandDrawing, MOST_ENTRIES, Snap, drawing_schema};
pub use formula::Formula;
pub use given::Given;
pub use hint::{BoardHint, STAGES};
pub use judge::{BoardError, Judge, JudgedDrawing, Verdict, Wrong};
pub use screen::Screen;
pub use shown::{
    Board, BoardEntry, BoardName, BoardNumber, BoardRefused, BoardSheet, BoardThing, FreeNames, Ghost, GhostKind,
    NameKind, Pressed, Snapped, ThingKind,
};
pub use table::{DrawnLine, Made, Table};
pub use told::{DrawingResult, EntryResult, VerdictName};
pub use writes::own_drawing;
