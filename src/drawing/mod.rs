//! Drawing: the marks on a sheet, in millimetres of paper, y down.
//!
//! In: a solved scene. Out: a [`Drawing`], a flat list of marks in drawing order with every text measured and every label
//! placed. The formats write that list and decide nothing.
//!
//! - `context` is what every layer asks: the solution with its `facts`, looked up once, the surface (page, sizes of letters,
//!   scales) and what the sheet is for. It is made once and passed on; only a `Surface` knows the page.
//! - `figure` decides the scales once for all sheets of a figure and lays each out once, which a `laid_out` says how; `held_layout` holds panels and
//!   scales while a mechanism moves, with plans that are larger `at_rest`, a canvas where names were in the picture before.
//! - A sheet is put together of `panel`s with their layers and `scale_bar`s, a `table` beside them, `remarks` and `words`
//!   below; `compose` makes a sheet of it with a `layout`, for which `division` finds cuts and scales. `exercise`, `correction` and `curves` are other sheets;
//!   a plan whose names crowd has further sheets with `parts` of it.
//! - `scheme` and `plan` draw in a view on a `canvas`, which keeps what is drawn as obstacles for the labels; so does `draft`, which
//!   draws what is known of a scene that is not complete yet.
//! - Below that is the display list, which knows nothing of mechanisms: `sheet`, `shape`, the `look` of its marks from a
//!   `style`, its `text`, the places of its `labels` off all obstacles, which a `grid` finds.
//!
//! # A sheet is a list
//!
//! A `Panel` says how much room it wants, has a frame and a stack of `Layer`s, each of which draws on the panel's
//! canvas: hints, the scheme or a plan, the axes and the curve of a hodograph; and a student's drawing may lie over them.
//! An `Item` stands beside or below the panels: a table, the scales, lines of words. `Composition` asks all
//! of them for their room, divides the paper (`layout`) and has them drawn. Figure, work sheet, exercise, key and
//! correction differ only in what is on the list.
//!
//! # A sheet has the size of its letters
//!
//! It is laid out in units in which letters have one size, and then enlarged (`dims`): a style with larger letters is
//! a smaller sheet, and all that has no size of its own is in proportion.
//!
//! # Contents are as large as the sheet allows
//!
//! A room is cut where the weighted sum of the logarithms of the scales is least (`division`): enlarging one content must
//! not reduce another by a larger factor. Scales are those that a ruler reads, those of a hand, or any (`view`). All
//! sheets of a scene have the same where that costs none of them much; values never change them without a word.
//!
//! # Values are a layer
//!
//! `construction/sentence.rs` names a plan's vectors by the symbols of the steps' equations; `values` makes one list
//! of them, of rates and of given lengths. Scheme and plans ask for labels from that list, which are left out where
//! they would be crossed; the results also stand in an item beside the panels, and in the table of a work sheet.
//!
//! # What is near is looked up
//!
//! A panel's marks and labels lie in a grid (`grid`), so that drawing grows with the scene and not with its square.
//! The search for labels' places counts what it looks at and ends after so much work, never after so much time:
//! output is the same to the byte (`labels/search.rs`). Names without a place by then are left out and told.
//!
//! # One figure holds all its steps
//!
//! Every mark says with which step it comes (`Mark::since`), and a shared name which step replaces it
//! (`Mark::until`); `construction/passage.rs` joins the steps that are shown together by what they reach;
//! `Solution::stepwise_figure` adds a layer of hints and the words, which are there in one step alone;
//! `Drawing::after_step` leaves out what comes later. So nothing moves from sheet to sheet, and layers of an SVG are
//! the same marks in groups. `HeldLayout` keeps layout and scales while a mechanism moves, with panels large enough
//! for the whole cycle (`cycle::Animation`): any position is drawn on it in a millisecond, and a `Film` draws all. What
//! leaves a panel is cut off at its edge (`clip`); places too close for their names are drawn again, larger, in a circle
//! (`inset`).

mod at_rest;
mod by_hand;
mod canvas;
mod centers;
#[doc(hidden)] // for tests
pub mod clip;
mod compose;
mod context;
mod correction;
#[doc(hidden)] // for tests
pub mod curves;
mod dims;
mod division;
mod draft;
mod exercise;
mod facts;
mod figure;
mod film;
mod fonts;
mod forces;
#[doc(hidden)] // for tests
pub mod grid;
mod held_layout;
mod inset;
mod labels;
mod laid_out;
mod layout;

mod lever;
mod lines;
mod look;
pub mod markers;
mod markup;
#[doc(hidden)] // for tests
pub mod overlay;
mod panel;
mod parts;
mod passages;
mod plan;
mod remarks;
#[doc(hidden)] // for tests
pub mod says;
mod scale_bar;
mod scheme;
mod shape;
mod sheet;
mod sheet_notes;
mod speeds;
mod steady;
mod style;
mod table;
mod text;
mod values;
mod view;
mod willis;
mod words;
mod worksheet;

pub use by_hand::{HandLine, HandLook, HandPaper, HandPoint, HandSheet, HandVector, hand_sheet, hand_sheets};
pub use correction::{SeenPoint, over_photo, overlay, overlay_words};
#[doc(inline)]
pub use curves::{CurvesError, curves, drive_ends, hodograph_ways, hodographs, path_ways, paths};
pub use draft::{DraftView, draft};
pub use exercise::{
    drawing_sheets, exercise_scale, exercise_sheet, key_scales, key_sheet, shows_centers, shows_special_points,
};
pub use facts::Steps;
pub use figure::FigureSheets;
pub use film::{Film, Timing};
pub use fonts::{ITALIC, REGULAR};
#[doc(hidden)] // for tests
pub use grid::Obstacles;
pub use held_layout::{Handle, HeldLayout, HeldPanel, Pane, Positions};
#[doc(hidden)] // for tests
pub use labels::{LabelRequest, PlacedLabel, place};
pub use look::{Cap, Colour, Dash, Look, Pen};
pub use markup::{Run, Script};
#[doc(inline)]
pub use overlay::{Overlay, OwnKind, OwnLine, OwnPoint, OwnValue, WrongStep};
pub use shape::Shape;
pub use sheet::{Drawing, Emphasis, Mark, Unlabelled, UnlabelledName};
pub use sheet_notes::SheetLabels;
pub use style::Style;
pub use text::{Anchor, PlacedRun, PlacedText, RichText};
pub use view::{Extent, View, fitting_scale, next_scale};
pub(crate) use words::drawn_vector;
pub use worksheet::KeyRow;

/// A point of the sheet: millimetres from its upper left corner, y down.
pub use kurbo::Point;
/// A box on the sheet, in millimetres, sides parallel to the sheet's.
pub use kurbo::Rect;
/// A displacement on the sheet, in millimetres, y down.
pub use kurbo::Vec2;
/// A path of lines and curves, and one of its parts.
pub use kurbo::{BezPath as Outline, PathEl as OutlinePart};
