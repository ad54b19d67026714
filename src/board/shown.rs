//! What a board shows of a drawing, as pages get it: sheets, things, numbers, names, entries; a press on a sheet, and what it may mean. Places are in millimetres of a sheet from its
//! upper left corner, y down.

use crate::sheet::Sheet;
use crate::words::NumberStyle;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json};

/// How numbers beside the sheets are written.
pub(super) const NUMBERS: NumberStyle = NumberStyle::significant(4).trimmed();

/// A drawing on a board.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Board {
    /// The drawing's text; of no text that of an empty drawing.
    pub drawing: String,
    /// What the scene gives.
    pub given: Vec<BoardNumber>,
    /// The sheets.
    pub sheets: Vec<BoardSheet>,
    /// All that can be pointed at.
    pub things: Vec<BoardThing>,
    /// What a formula may use: what is given, what has been found, what may be measured.
    pub numbers: Vec<BoardNumber>,
    /// The names that mean something, in the order of the construction.
    pub names: Vec<BoardName>,
    /// The next free names of one's own.
    pub free: FreeNames,
    /// What is said of the hand where it is free: how near it has to be; none where what it draws is exact.
    pub hand: Option<String>,
    /// The entries of the drawing, in order.
    pub did: Vec<BoardEntry>,
    /// The first entry that cannot be carried out; none where all can.
    pub refused: Option<BoardRefused>,
}

/// A sheet of a board.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardSheet {
    /// Which sheet.
    pub sheet: Sheet,
    /// Width in mm.
    pub width: f64,
    /// Height in mm.
    pub height: f64,
    /// Where the pole stands; none on the scheme.
    pub pole: Option<[f64; 2]>,
    /// Its scale in words.
    pub scale: String,
}

/// Something that can be pointed at.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardThing {
    /// On which sheet.
    pub sheet: Sheet,
    /// What it is.
    pub kind: ThingKind,
    /// Its name, as entries call it.
    pub name: String,
    /// As the sheet writes it, in HTML.
    pub label: String,
    /// It in words, as `link 2`.
    pub words: String,
    /// Its outline, as the path of an SVG; empty for a point.
    pub path: String,
    /// A place of it.
    pub at: [f64; 2],
    /// The entry that made it; none for what is given.
    pub entry: Option<usize>,
}

/// What can be pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum ThingKind {
    /// A point.
    Point,
    /// A line that was drawn.
    Line,
    /// A link, or two points of one.
    Link,
    /// A guide.
    Guide,
}

/// A number beside the sheets.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardNumber {
    /// Its name in formulas.
    pub name: String,
    /// As the sheets write it, in HTML.
    pub label: String,
    /// Its value in figures.
    pub value: String,
    /// Its unit.
    pub unit: String,
    /// The entry that made it; none for what is given or can be measured.
    pub entry: Option<usize>,
}

/// A name that means something.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardName {
    /// On which sheet; none of a number.
    pub sheet: Option<Sheet>,
    /// Of a point or of a number.
    pub kind: NameKind,
    /// The name.
    pub name: String,
    /// As the sheets write it, in HTML.
    pub label: String,
    /// Whether it is there already.
    pub is_made: bool,
    /// Whether it is the rate of a link, which turns in one sense or the other.
    pub is_turning: bool,
}

/// What a name is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum NameKind {
    /// A point.
    Point,
    /// A number.
    Number,
}

/// Names of one's own that are free.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct FreeNames {
    /// For a line.
    pub line: String,
    /// For an auxiliary point.
    pub point: String,
    /// For a number.
    pub number: String,
}

/// An entry on a board.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardEntry {
    /// What it does, with what came out.
    pub words: String,
    /// On which sheet; none for a computation.
    pub sheet: Option<Sheet>,
    /// Whether it has not been taken back.
    pub stands: bool,
    /// The entries whose results it uses.
    pub needs: Vec<usize>,
}

/// An entry that cannot be carried out.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct BoardRefused {
    /// Its index.
    pub entry: usize,
    /// Why.
    pub message: String,
}

/// A press on a sheet.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Pressed {
    /// The entry that is being written, with what is missing left out or empty.
    #[cfg_attr(feature = "schemas", schemars(with = "Json"))]
    pub has: Map<String, Json>,
    /// On which sheet.
    pub sheet: Sheet,
    /// Where, in mm from the upper left corner, y down.
    pub at: [f64; 2],
    /// How far around, in mm.
    pub reach: f64,
}

/// What a press may mean.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Snapped {
    /// The entry with what the press adds.
    #[cfg_attr(feature = "schemas", schemars(with = "Json"))]
    pub entry: Map<String, Json>,
    /// Whether no more than a name may be missing.
    pub is_whole: bool,
    /// What is caught, in words.
    pub words: String,
    /// Where.
    pub at: [f64; 2],
    /// What would be drawn.
    pub ghost: Vec<Ghost>,
    /// The direction that it gives, in degrees from +x; none of what gives none.
    pub direction: Option<f64>,
}

/// Something that is not drawn yet.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
pub struct Ghost {
    /// What it is.
    pub kind: GhostKind,
    /// Its outline, as the path of an SVG in mm.
    pub path: String,
}

/// What is not drawn yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum GhostKind {
    /// A line.
    Line,
    /// The set square on what gives its direction.
    Square,
    /// A vector.
    Arrow,
    /// A point.
    Point,
}
