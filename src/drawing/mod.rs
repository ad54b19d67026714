//! Drawing: the marks on the sheet, in millimetres of paper, y down.
//!
//! Input is the geometry of a figure already brought to scale; output is a [`Drawing`], a flat list of marks in drawing
//! order with every text measured and every label placed. The formats write that list and decide nothing.

// In reading order: `figure` lists `panel`s and `item`s, `compose` makes a sheet of them with a `layout`; `scheme` and
// `plan_panel` draw on a `canvas`. `exercise`, `plan_sheets`, `correction` and `curves` compose other sheets; `markers` stand
// on those to be drawn on. Then the display list:
// `sheet`, `shape`, `arrow`, the `look` of its marks from a `style`, its `text`, the places of its `labels` off all
// `obstacles`, which a `grid` finds.
mod arrow;
mod blank;
mod canvas;
mod clip;
mod compose;
mod correction;
mod curves;
mod dims;
mod exercise;
mod figure;
mod fonts;
mod grid;
mod held;
mod inset;
mod key_table;
mod labels;
mod layout;
mod legend;
mod lines;
mod look;
pub mod markers;
mod markup;
mod names;
mod obstacles;
mod over_photo;
mod overlay;
mod panel;
mod passages;
mod pen;
mod plan_panel;
mod plan_sheets;
mod scales;
mod scheme;
mod shape;
mod sheet;
mod sheet_notes;
mod stage;
mod stages;
mod style;
mod table;
mod text;
mod values;
mod view;
mod words;
mod worksheet;

pub use arrow::arrow_head;
pub use blank::SheetLabels;
pub use correction::{overlay, overlay_words};
pub use curves::{CurvesError, curves, drive_ends, hodographs, paths};
pub use exercise::{drawing_sheets, exercise_scale, exercise_sheet, key_scales, key_sheet, shows_special_points};
pub use figure::Steps;
pub use fonts::{ITALIC, REGULAR};
pub use key_table::KeyRow;
pub use labels::{LabelRequest, Obstacles, PlacedLabel, place};
pub use look::{Cap, Colour, Dash, Look};
pub use markup::{Run, Script};
pub use over_photo::{SeenPoint, over_photo};
pub use overlay::{Overlay, OwnKind, OwnLine, OwnPoint, OwnValue, WrongStep};
pub use pen::Pen;
pub use shape::Shape;
pub use sheet::{Drawing, Emphasis, Mark};
pub use stage::{Handle, Stage, StagePanel};
pub use style::Style;
pub use text::{Anchor, PlacedRun, PlacedText, RichText};
pub use view::{Extent, View, fitting_scale, next_scale};

/// A point of the sheet: millimetres from its upper left corner, y down.
pub use kurbo::Point;
/// A box on the sheet, in millimetres, sides parallel to the sheet's.
pub use kurbo::Rect;
/// A displacement on the sheet, in millimetres, y down.
pub use kurbo::Vec2;
/// A path of lines and curves, and one of its parts.
pub use kurbo::{BezPath as Outline, PathEl as OutlinePart};
