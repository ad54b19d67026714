use kinegon::Sheet;
use kinegon::cycle;
use kinegon::words::Wording;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// What is known of a scene that could be solved.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Opened {
    /// Its title, or the usual one.
    pub title: String,
    /// The scene file as JSON.
    #[cfg_attr(feature = "types", schemars(extend("tsType" = "SceneFile")))]
    pub scene: Map<String, Value>,
    /// Its drives and where they stand.
    pub drives: Vec<Drive>,
    /// The steps of the construction; none of a scene that is too large for them.
    pub steps: Vec<Step>,
    /// Steps that a lecturer shows together: the numbers of the first and the last of each.
    pub passages: Vec<[usize; 2]>,
    /// What is done in each passage.
    pub passage_captions: Vec<String>,
    /// Names of points whose paths can be drawn.
    pub traceable: Vec<String>,
    /// Quantities for curves, tables and values; vectors for hodographs, too.
    pub quantities: Vec<Quantity>,
    /// Those that the scene wants by itself.
    pub wanted: Vec<Quantity>,
    /// The Assur groups in solving order, as `kinegon structure` prints them.
    pub structure: String,
    /// The panels of its figure.
    pub panels: Vec<Sheet>,
    /// Warnings of all stages.
    pub warnings: Vec<String>,
    /// Whether it is a drawn configuration, which cannot be moved.
    pub is_drawn: bool,
}

/// A quantity by its name, and what the name says.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Quantity {
    /// Its whole name, as `v(D).size`.
    pub name: String,
    /// What stands before the parenthesis, as `v`.
    pub head: String,
    /// What stands in it, as `D`.
    pub inside: String,
    /// What stands behind it, as `.size`; mostly nothing.
    pub part: String,
    /// What kind of thing has it, which `inside` names.
    pub of: Owner,
    /// Whether it is a vector.
    pub is_vector: bool,
}

/// A kind of thing that has quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Owner {
    /// A link.
    Link,
    /// A slider.
    Slider,
    /// A point.
    Point,
    /// Several, or a plan.
    Others,
}

/// A drive and where it stands.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Drive {
    /// A driven link, or a slider on a moving link such as 3/2.
    pub name: String,
    /// Whether it turns.
    pub is_angle: bool,
    /// In degrees or units of length.
    pub value: f64,
    /// In words, as `70.0°`.
    pub shown: String,
    /// The least value that it can reach; none where it turns all the way round or slides without end.
    pub low: Option<f64>,
    /// The greatest.
    pub high: Option<f64>,
}

impl Drive {
    /// Sets it to a value. Where other drives move, too, it may go farther than it can alone.
    pub fn stands_at(&mut self, value: f64, drive: &cycle::Drive, words: &Wording) {
        (self.value, self.shown) = (value, drive.shown(value, words));
        self.low = self.low.map(|low| low.min(value));
        self.high = self.high.map(|high| high.max(value));
    }
}

/// How a scene runs: all its drives together, in proportion to their speeds.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Running {
    /// The drive by whose value the others are told: the first that has a speed.
    pub drive: String,
    /// Whether its value falls.
    pub is_backwards: bool,
    /// The least value that it can reach; none where it turns all the way round or slides without end.
    pub low: Option<f64>,
    /// The greatest.
    pub high: Option<f64>,
    /// The turns after which the mechanism is where it began; none where it never is, or goes to and fro.
    pub turns: Option<usize>,
}

/// A step of the construction.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Step {
    /// Counted from 1.
    pub number: usize,
    /// What is done.
    pub caption: String,
    /// Its equation in plain text, or empty.
    pub equation: String,
    /// What it gives besides, in plain text, a line each: sizes and directions, rates, angles of crossings.
    pub values: Vec<String>,
    /// The panel in which it is drawn.
    pub panel: Sheet,
}

/// How a scene is shown besides what its `figure` says.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct View {
    /// The step after which it is shown, from 1; none for the finished figure.
    pub step: Option<usize>,
    /// Whether steps are the passages.
    pub coarse: bool,
    /// Whether all other assembly modes are drawn pale.
    pub modes: bool,
    /// The panels that are shown in place of the figure's: a student's link shows the scheme alone. What is no panel is passed over.
    #[serde(default)]
    #[cfg_attr(feature = "types", schemars(with = "Option<Vec<Sheet>>", skip_serializing_if = "Option::is_none"))]
    pub panels: Option<Vec<String>>,
    /// The part of the screen for which it is laid out; none for the figure's paper, as in its file.
    #[serde(default)]
    #[cfg_attr(feature = "types", schemars(skip_serializing_if = "Option::is_none"))]
    pub pane: Option<Pane>,
    /// The panel that has most of a part of the screen; none where all share it.
    #[serde(default)]
    #[cfg_attr(feature = "types", schemars(skip_serializing_if = "Option::is_none"))]
    pub focus: Option<Sheet>,
    /// Points whose paths are drawn in the scheme besides those of the figure. What has no path is passed over.
    #[serde(default)]
    #[cfg_attr(feature = "types", schemars(skip_serializing_if = "Vec::is_empty"))]
    pub trace: Vec<String>,
    /// How far the layout has gone from that of the last gesture to its own, from 0 to 1; none where it is there.
    #[serde(default)]
    #[cfg_attr(feature = "types", schemars(skip_serializing_if = "Option::is_none"))]
    pub eased: Option<f64>,
}

/// A part of the screen, in pixels.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Pane {
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
    /// Height of the em of its letters.
    pub letters: f64,
    /// Whether the words of steps stand on it.
    pub words: bool,
}

impl From<Pane> for kinegon::drawing::Pane {
    fn from(Pane { width, height, letters, words }: Pane) -> Self {
        kinegon::drawing::Pane { width: width.max(1.0), height: height.max(1.0), letters: letters.max(1.0), words }
    }
}

impl View {
    /// Whether a sheet for this view has the layout of one for another.
    pub fn is_laid_out_as(&self, other: &View) -> bool {
        let step = |view: &View| view.step.map(|_| 1);
        let same = |view: &View| View {
            step: step(view),
            coarse: view.coarse && view.step.is_some(),
            eased: None,
            ..view.clone()
        };
        same(self) == same(other)
    }
}

/// A picture of the scene in one position.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Picture {
    /// The sheet.
    pub svg: String,
    /// Width of the sheet in mm.
    pub width: f64,
    /// Height of the sheet in mm.
    pub height: f64,
    /// Its panels.
    pub panels: Vec<Panel>,
    /// What can be taken hold of: the points of the mechanism.
    pub handles: Vec<Handle>,
    /// The drives and where they stand.
    pub drives: Vec<Drive>,
    /// What is to be told: a limit that stops the drive, a panel that is cut.
    pub notes: Vec<String>,
}

/// A panel of a picture.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "PicturePanel"))]
pub struct Panel {
    /// Its name in words.
    pub name: String,
    /// Which panel it is.
    pub key: Sheet,
    /// [x, y, width, height] in mm.
    #[serde(rename = "box")]
    pub area: [f64; 4],
    /// Whether something is cut off at its edge.
    pub is_cut: bool,
}

/// A place that can be taken hold of.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Handle {
    /// The point's name.
    pub name: String,
    /// The panel in which it is.
    pub panel: Sheet,
    /// On the sheet, in mm from its upper left corner.
    pub at: [f64; 2],
    /// Whether it never moves: a point of the ground, or a pole.
    pub is_fixed: bool,
}

/// A value of the scene's own position.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "Value"))]
pub struct ValueRow {
    /// Its name, as `v(D).size`.
    pub name: String,
    /// The quantity.
    pub quantity: Quantity,
    /// As letters with scripts: HTML of `<i>`, `<sub>`, `<sup>` and text alone.
    pub label: String,
    /// Those digits that are certain.
    pub value: String,
    /// Its unit.
    pub unit: String,
    /// How far the value can be from the true one, in the same unit; none where that is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
}
