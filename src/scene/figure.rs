//! What a scene asks of its figure.

use super::text::LARGEST;
use super::words::number;
use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::Deserialize;

/// What the figure shows, and how large.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The panels, in order; at least one, none twice.
    pub panels: Vec<Panel>,
    /// Scale of the scheme, in units of length per millimetre of paper, positive; `None`: whichever fits.
    pub mu_l: Option<f64>,
    /// Scale of the velocity plan, in units of velocity per millimetre of paper, positive; `None`: whichever fits.
    pub mu_v: Option<f64>,
    /// Scale of the acceleration plan, in units of acceleration per millimetre of paper, positive; `None`: whichever fits.
    pub mu_a: Option<f64>,
    /// The sheet.
    pub page: Page,
    /// Whether it is a work sheet: with a table of all measured lengths and a ruler that shows whether it was printed at 100 %.
    pub worksheet: bool,
    /// How lines and letters look.
    pub style: StyleName,
    /// How poles, images and parts of accelerations are written.
    pub notation: NotationName,
    /// The language of headings and captions.
    pub language: LanguageName,
    /// What stands before the decimals of numbers.
    pub decimal: DecimalMark,
    /// Text to show for a joint, a link or a plan point, in place of the standard one, by its name.
    pub labels: IndexMap<String, String>,
    /// Whether special points are shown.
    pub special_points: bool,
    /// Whether construction lines are shown.
    pub construction: bool,
    /// The step of the construction up to which the figure is drawn, from 1; `None`: finished.
    pub step: Option<usize>,
}

impl Default for Figure {
    /// All three panels with everything on them, on A4 landscape, at scales that fit.
    fn default() -> Self {
        Figure {
            panels: vec![Panel::Scheme, Panel::Velocity, Panel::Acceleration],
            mu_l: None,
            mu_v: None,
            mu_a: None,
            page: Page::default(),
            worksheet: false,
            style: StyleName::default(),
            notation: NotationName::default(),
            language: LanguageName::default(),
            decimal: DecimalMark::default(),
            labels: IndexMap::new(),
            special_points: true,
            construction: true,
            step: None,
        }
    }
}

impl Figure {
    /// The scale that is given for a panel, in units per millimetre of paper.
    #[must_use]
    pub fn mu(&self, panel: Panel) -> Option<f64> {
        match panel {
            Panel::Scheme => self.mu_l,
            Panel::Velocity => self.mu_v,
            Panel::Acceleration => self.mu_a,
        }
    }

    /// The scale itself, if it is one: a positive number of units per millimetre of paper, at most 1e100 as all numbers of scenes.
    ///
    /// # Errors
    /// Says in words what is wrong with it.
    pub fn checked_scale(scale: f64) -> Result<f64, String> {
        if scale > LARGEST {
            return Err(format!("{}; numbers are at most {LARGEST:e}", number(scale)));
        }
        if scale > 0.0 {
            return Ok(scale);
        }
        Err(format!("{}; a scale, in units per millimetre of paper, is positive", number(scale)))
    }
}

/// A part of the figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Panel {
    /// The mechanism itself.
    Scheme,
    /// The velocity plan.
    Velocity,
    /// The acceleration plan.
    Acceleration,
}

impl Panel {
    /// The panel as a scene file writes it: `"scheme"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Panel::Scheme => "scheme",
            Panel::Velocity => "velocity",
            Panel::Acceleration => "acceleration",
        }
    }
}

/// A drawing style that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "styleName")]
pub enum StyleName {
    /// Black lines with a few dark accents on white.
    #[default]
    Paper,
    /// Black and grey: kinds of lines are told apart by widths, dashes and heads, in every photocopy.
    Print,
    /// A colour for each link, the same in the scheme and in the plans; told apart with any colour vision.
    Lecture,
    /// White and pastel lines on a dark ground.
    Board,
}

impl StyleName {
    /// All of them.
    pub const ALL: [StyleName; 4] = [StyleName::Paper, StyleName::Print, StyleName::Lecture, StyleName::Board];

    /// The style as a scene file writes it: `"paper"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            StyleName::Paper => "paper",
            StyleName::Print => "print",
            StyleName::Lecture => "lecture",
            StyleName::Board => "board",
        }
    }
}

/// Whose way of writing poles, images and parts of accelerations. Names of quantities stay the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "notation")]
pub enum NotationName {
    /// The source paper's: poles p and π, images b, parts n, t, c.
    #[default]
    Paper,
    /// Poles o and o′, images b and, in the acceleration plan, b′, parts n, t, c.
    English,
    /// Poles p and π, images b, parts n, τ, k.
    Russian,
    /// Poles P_v and P_a, images b, parts n, t, c.
    German,
}

impl NotationName {
    /// All of them.
    pub const ALL: [NotationName; 4] =
        [NotationName::Paper, NotationName::English, NotationName::Russian, NotationName::German];

    /// The notation as a scene file writes it: `"paper"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            NotationName::Paper => "paper",
            NotationName::English => "english",
            NotationName::Russian => "russian",
            NotationName::German => "german",
        }
    }
}

/// A language of headings and captions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[schemars(rename = "language")]
pub enum LanguageName {
    /// English.
    #[default]
    #[serde(rename = "en")]
    English,
    /// Spanish.
    #[serde(rename = "es")]
    Spanish,
}

impl LanguageName {
    /// All of them.
    pub const ALL: [LanguageName; 2] = [LanguageName::English, LanguageName::Spanish];

    /// The language as a scene file writes it: `"en"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            LanguageName::English => "en",
            LanguageName::Spanish => "es",
        }
    }
}

/// What stands before the decimals of numbers on figures and in the text of steps; results always have points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(rename = "decimal")]
pub enum DecimalMark {
    /// 2.5
    #[default]
    Point,
    /// 2,5
    Comma,
}

impl DecimalMark {
    /// All of them.
    pub const ALL: [DecimalMark; 2] = [DecimalMark::Point, DecimalMark::Comma];

    /// The mark as a scene file names it: `"point"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            DecimalMark::Point => "point",
            DecimalMark::Comma => "comma",
        }
    }
}

/// A sheet of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Page {
    /// Its size.
    pub size: PageSize,
    /// Whether its longer side lies horizontally.
    pub landscape: bool,
}

/// A standard size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PageSize {
    /// 210 mm × 297 mm
    A4,
    /// 297 mm × 420 mm
    A3,
    /// 8.5 in × 11 in
    Letter,
}

impl PageSize {
    /// All of them.
    pub const ALL: [PageSize; 3] = [PageSize::A4, PageSize::A3, PageSize::Letter];

    /// The size as a scene file writes it: `"a4"`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            PageSize::A4 => "a4",
            PageSize::A3 => "a3",
            PageSize::Letter => "letter",
        }
    }
}

impl Default for Page {
    /// A4 landscape.
    fn default() -> Self {
        Page { size: PageSize::A4, landscape: true }
    }
}

impl Page {
    /// Every way to write a page in a scene file.
    pub(super) const NAMES: [&str; 9] = [
        "a4",
        "a4-landscape",
        "a4-portrait",
        "a3",
        "a3-landscape",
        "a3-portrait",
        "letter",
        "letter-landscape",
        "letter-portrait",
    ];

    /// The page of this name, or `None` if there is none; without a suffix it is landscape.
    pub(super) fn from_name(name: &str) -> Option<Page> {
        let (size, landscape) = match name.split_once('-') {
            None => (name, true),
            Some((size, "landscape")) => (size, true),
            Some((size, "portrait")) => (size, false),
            Some(_) => return None,
        };
        let mut sizes = PageSize::ALL.into_iter();
        let size = sizes.find(|known| known.as_str() == size)?;
        Some(Page { size, landscape })
    }

    /// The page as a scene file writes it: `"a4"`, `"a4-portrait"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        let names = Page::NAMES.into_iter();
        let mut names = names.filter(|name| Page::from_name(name) == Some(self));
        names.next().expect("every page has a name")
    }

    /// Width and height, in millimetres.
    pub fn size_mm(self) -> [f64; 2] {
        let [short, long] = match self.size {
            PageSize::A4 => [210.0, 297.0],
            PageSize::A3 => [297.0, 420.0],
            PageSize::Letter => [215.9, 279.4],
        };
        if self.landscape { [long, short] } else { [short, long] }
    }
}
