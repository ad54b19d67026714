//! The figure that a scene asks for.

use crate::sheet::{PerSheet, Scales, Sheet};
use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

use super::choice::choice;
use super::schema::without_defaults;
use super::sizes::Sizes;
use super::text::LARGEST;
use super::value::several_forms;
use super::values::ValuesShown;
use super::words::{number, shortened};
use super::write::{write_forms, write_keys};
use super::wrong::Wrong;
use crate::text::Untrusted;

/// What the figure shows, and how large. The scale `mu` of a panel is in units per millimetre of paper; `None` stands
/// for the next round scale at which the panel fits.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields, expecting = r#"a figure as { "panels": ["scheme", "velocity"] }"#)]
#[schemars(rename = "figure", description = "What the figure shows, and how large.", transform = without_defaults)]
pub struct Figure {
    /// The panels, in order; left out: all three.
    #[schemars(length(min = 1), extend("uniqueItems" = true))]
    pub panels: Vec<Sheet>,
    /// Scale of the scheme: units of length per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_l: Option<f64>,
    /// Scale of the velocity plan: units of velocity per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_v: Option<f64>,
    /// Scale of the acceleration plan: units of acceleration per millimetre of paper.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mu_a: Option<f64>,
    /// For which plans scales are chosen that are not given; left out: "position".
    #[schemars(with = "Option<ScalesFor>")]
    pub scales: ScalesFor,
    /// The panel that takes most of the sheet; a plan has the scheme as a small companion. Left out: the panels share the sheet.
    pub focus: Option<Sheet>,
    /// The sheet: "a4", "a3", "letter" or, for the projector, "16x9", with "-portrait" where it does not lie; left out: "a4".
    #[schemars(with = "Option<String>", extend("enum" = Page::NAMES))]
    pub page: Page,
    /// Whether it is a work sheet: with a table of all measured lengths and a ruler to test the printer; left out: false.
    pub worksheet: bool,
    /// How lines and letters look; left out: "paper".
    #[schemars(with = "Option<StyleName>")]
    pub style: StyleName,
    /// How poles, images and parts of accelerations are written; left out: "paper". Names of quantities stay the same.
    #[schemars(with = "Option<NotationName>")]
    pub notation: NotationName,
    /// Language of headings and captions; left out: "en".
    #[schemars(with = "Option<LanguageName>")]
    pub language: LanguageName,
    /// Decimal mark of the numbers on figures and in the text of steps; left out: "point".
    #[schemars(with = "Option<DecimalMark>")]
    pub decimal: DecimalMark,
    /// Text to show in place of a name: { "B'": "B₁" }.
    pub labels: IndexMap<String, Untrusted>,
    /// Whether special points are shown; left out: true.
    pub special_points: bool,
    /// Whether construction lines are shown; "paper": shown, and the plans end where the source paper's end; left out: true.
    #[schemars(with = "Option<ConstructionShown>")]
    pub construction: ConstructionShown,
    /// Whether values stand at vectors and links, in which unit of length; left out: as the style says, "lecture" alone does.
    pub values: Option<ValuesShown>,
    /// The step of the construction up to which the figure is drawn, from 1; left out: finished.
    #[serde(deserialize_with = "count")]
    #[schemars(with = "Option<u16>", range(min = 1))]
    pub step: Option<usize>,
    /// Points of links whose paths over the whole cycle of the drive are drawn in the scheme.
    #[schemars(extend("uniqueItems" = true))]
    pub trace: Vec<String>,
    /// Whether these paths go on, dashed, beyond limits of the drive, in the other assembly modes that the mechanism
    /// reaches there if another link moves it; left out: false.
    pub beyond_limits: bool,
    /// Number of equally spaced positions over that cycle in which the links are drawn pale; left out: none.
    #[serde(deserialize_with = "count")]
    #[schemars(with = "Option<u16>", range(min = 2, max = 72))]
    pub ghosts: Option<usize>,
    /// Whether sheets to be drawn on, work sheets and those of exercises, have markers along their edges by which a
    /// photograph of them is read; left out: true.
    pub markers: bool,
    /// Sizes of letters and signs in place of those of `style`: of a style file, which is no part of the scene.
    #[serde(skip)]
    pub sizes: Option<Sizes>,
    /// Whether a figure that does not say so has values, in place of what `style` says: of a style file likewise.
    #[serde(skip)]
    pub usual_values: Option<bool>,
}

write_keys!(Figure {
    panels, mu_l, mu_v, mu_a, scales, focus, page, worksheet, style, notation, language, decimal, labels, special_points,
    construction, values, step, trace, beyond_limits, ghosts, markers; sizes, usual_values
} unless Figure::default());

/// Steps and positions are read as `u16`: there are never more, and messages can name the range.
fn count<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<usize>, D::Error> {
    Option::<u16>::deserialize(deserializer).map(|count| count.map(usize::from))
}

impl Default for Figure {
    /// All three panels with everything on them, on A4 landscape, at scales that fit.
    fn default() -> Self {
        Figure {
            panels: Sheet::ALL.to_vec(),
            mu_l: None,
            mu_v: None,
            mu_a: None,
            scales: ScalesFor::default(),
            focus: None,
            page: Page::default(),
            worksheet: false,
            style: StyleName::default(),
            notation: NotationName::default(),
            language: LanguageName::default(),
            decimal: DecimalMark::default(),
            labels: IndexMap::new(),
            special_points: true,
            construction: ConstructionShown::default(),
            values: None,
            step: None,
            trace: Vec::new(),
            beyond_limits: false,
            ghosts: None,
            markers: true,
            sizes: None,
            usual_values: None,
        }
    }
}

impl Figure {
    /// Whether sheets to be drawn on have markers: not where the scene says so, nor in a projector's proportions.
    #[must_use]
    pub fn has_markers(&self) -> bool {
        self.markers && self.page.size != PageSize::Wide
    }

    /// The panels that are drawn, in order: with a focus the scheme and the plan in focus.
    #[must_use]
    pub fn shown_panels(&self) -> Vec<Sheet> {
        match self.focus {
            None => self.panels.clone(),
            Some(Sheet::Scheme) => vec![Sheet::Scheme],
            Some(plan) => vec![Sheet::Scheme, plan],
        }
    }

    /// The given scale of a panel, in units per millimetre of paper; `None` if the panel is to fit.
    #[must_use]
    pub fn mu(&self, panel: Sheet) -> Option<f64> {
        match panel {
            Sheet::Scheme => self.mu_l,
            Sheet::Velocity => self.mu_v,
            Sheet::Acceleration => self.mu_a,
        }
    }

    /// Sets the scale of a panel; `None` lets it fit.
    pub fn set_mu(&mut self, panel: Sheet, mu: Option<f64>) {
        *match panel {
            Sheet::Scheme => &mut self.mu_l,
            Sheet::Velocity => &mut self.mu_v,
            Sheet::Acceleration => &mut self.mu_a,
        } = mu;
    }

    /// The given scales of all panels.
    #[must_use]
    pub fn given_scales(&self) -> Scales {
        PerSheet::from_fn(|sheet| self.mu(sheet))
    }

    /// Sets the scales of all panels.
    pub fn set_scales(&mut self, scales: Scales) {
        scales.iter().for_each(|(sheet, mu)| self.set_mu(sheet, *mu));
    }

    /// The scale, if it is valid: in units per millimetre of paper, positive, and at most 1e100 as all numbers of
    /// scenes.
    ///
    /// # Errors
    /// The message without its subject.
    pub fn checked_scale(scale: f64) -> Result<f64, String> {
        if scale > LARGEST {
            return Err(format!("{}; numbers are at most {LARGEST:e}", number(scale)));
        }
        if scale > 0.0 {
            return Ok(scale);
        }
        Err(format!("{}; a scale, in units per millimetre of paper, is positive", number(scale)))
    }

    /// Refuses scales, panels and steps that cannot be drawn.
    pub(super) fn check(&self) -> Result<(), Wrong> {
        for (sheet, scale) in self.given_scales().given() {
            if let Err(why) = Figure::checked_scale(scale) {
                let (key, hint) = (sheet.scale_key(), "leave it out for the next scale that fits");
                return Err(Wrong::value(&[key], format!("`{key}` is {why}")).hint(hint));
            }
        }
        if self.panels.is_empty() {
            let hint = r#"name some of "scheme", "velocity", "acceleration", or leave `panels` out"#;
            return Err(Wrong::value(&["panels"], "a figure without panels shows nothing").hint(hint));
        }
        let is_doubled = |&index: &usize| self.panels[..index].contains(&self.panels[index]);
        if let Some(index) = (1..self.panels.len()).find(is_doubled) {
            return Err(Wrong::value(&["panels", &index.to_string()], "this panel stands twice"));
        }
        match self.step {
            Some(0) => {
                let hint = "`kinegon steps` lists them; leave `step` out for the finished figure";
                Err(Wrong::value(&["step"], "steps of the construction are numbered from 1").hint(hint))
            }
            // Only from Rust: the types of the file refuse it before.
            Some(step) if step > u16::MAX.into() => {
                let message = format!("expected a whole number from 1 to 65535, found the number {step}");
                Err(Wrong::value(&["step"], message))
            }
            _ => Ok(()),
        }
    }
}

write_forms! { Sheet { word => word.as_str() } }

choice! {
    /// The plans for which scales are chosen that the scene does not give.
    #[derive(Default)]
    #[schemars(rename = "scalesFor")]
    ScalesFor {
        /// The plans in the scene's own position.
        #[default]
        Position = "position",
        /// Each sheet has the largest scales that fit it: those of a figure, its step sheets and its work sheet may differ.
        Sheet = "sheet",
        /// The largest plans over the range of the first drive: all sheets of the cycle then have one set of scales.
        Cycle = "cycle",
    }
}

choice! {
    /// A drawing style that comes with the program.
    #[derive(Default)]
    #[schemars(rename = "styleName")]
    StyleName {
        /// Black lines with a few dark accents on white.
        #[default]
        Paper = "paper",
        /// Black and grey: kinds of lines are told apart by widths, dashes and heads, in every photocopy.
        Print = "print",
        /// A colour for each link, the same in the scheme and in the plans; told apart with any colour vision.
        Lecture = "lecture",
        /// White and pastel lines on a dark ground.
        Board = "board",
    }
}

choice! {
    /// Notation of poles, images and parts of accelerations. Names of quantities stay the same.
    #[derive(Default)]
    #[schemars(rename = "notation")]
    NotationName {
        /// The source paper's: poles p and π, images b, parts n, t, c.
        #[default]
        Paper = "paper",
        /// Poles o and o′, images b and, in the acceleration plan, b′, parts n, t, c.
        English = "english",
        /// Poles p and π, images b, parts n, τ, k.
        Russian = "russian",
        /// Poles P_v and P_a, images b, parts n, t, c.
        German = "german",
    }
}

choice! {
    /// A language of headings and captions.
    #[derive(Default)]
    #[schemars(rename = "language")]
    LanguageName {
        /// English.
        #[default]
        English = "en",
        /// Spanish.
        Spanish = "es",
    }
}

choice! {
    /// Decimal mark of the numbers on figures and in the text of steps; results always have points.
    #[derive(Default)]
    #[schemars(rename = "decimal")]
    DecimalMark {
        /// 2.5
        #[default]
        Point = "point",
        /// 2,5
        Comma = "comma",
    }
}

/// How much of the construction a figure shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ConstructionShown {
    /// Images and vectors alone, without the lines that lead to them.
    Hidden,
    /// Everything: every point of every link has its image.
    #[default]
    Whole,
    /// As in the source paper (Quintero et al., 2011): after the rates are known, the acceleration plan goes on to no
    /// further joint, and neither plan to points that no joint needs.
    Paper,
}

impl ConstructionShown {
    /// Whether construction lines are shown.
    #[must_use]
    pub fn has_lines(self) -> bool {
        self != ConstructionShown::Hidden
    }
}

write_forms! { ConstructionShown {
    ConstructionShown::Hidden => &false, ConstructionShown::Whole => &true, ConstructionShown::Paper => "paper"
} }

several_forms!(ConstructionShown, "construction", Shown, _generator => {
    "description": "Whether construction lines are shown; \"paper\": shown, and the plans end where the source paper's end",
    "anyOf": [{ "type": "boolean" }, { "const": "paper" }]
});

/// Reads [`ConstructionShown`].
struct Shown;

impl Visitor<'_> for Shown {
    type Value = ConstructionShown;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("true, false or \"paper\"")
    }

    fn visit_bool<E: Error>(self, shown: bool) -> Result<ConstructionShown, E> {
        Ok(if shown { ConstructionShown::Whole } else { ConstructionShown::Hidden })
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<ConstructionShown, E> {
        match name {
            "paper" => Ok(ConstructionShown::Paper),
            _ => Err(E::invalid_value(Unexpected::Str(name), &self)),
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

choice! {
    /// A standard size of paper.
    PageSize {
        /// 210 mm × 297 mm
        A4 = "a4",
        /// 297 mm × 420 mm
        A3 = "a3",
        /// 8.5 in × 11 in
        Letter = "letter",
        /// 180 mm × 320 mm, in the proportions of a projector
        Wide = "16x9",
    }
}

impl Default for Page {
    /// A4 landscape.
    fn default() -> Self {
        Page { size: PageSize::A4, landscape: true }
    }
}

impl Page {
    /// All names of pages in a scene file.
    pub const NAMES: [&str; 12] = [
        "a4",
        "a4-landscape",
        "a4-portrait",
        "a3",
        "a3-landscape",
        "a3-portrait",
        "letter",
        "letter-landscape",
        "letter-portrait",
        "16x9",
        "16x9-landscape",
        "16x9-portrait",
    ];

    /// The page of this name; `None` if there is none. Without a suffix it is landscape.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Page> {
        let (size, landscape) = match name.split_once('-') {
            None => (name, true),
            Some((size, "landscape")) => (size, true),
            Some((size, "portrait")) => (size, false),
            Some(_) => return None,
        };
        let size = PageSize::ALL.into_iter().find(|known| known.as_str() == size)?;
        Some(Page { size, landscape })
    }

    /// Its name in a scene file: `"a4"`, `"a4-portrait"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        let names = |name: &&str| Page::from_name(name) == Some(self);
        Page::NAMES.into_iter().find(names).expect("every page has a name")
    }

    /// Width and height, in millimetres.
    pub fn size_mm(self) -> [f64; 2] {
        let [short, long] = match self.size {
            PageSize::A4 => [210.0, 297.0],
            PageSize::A3 => [297.0, 420.0],
            PageSize::Letter => [215.9, 279.4],
            PageSize::Wide => [180.0, 320.0],
        };
        if self.landscape { [long, short] } else { [short, long] }
    }
}

write_forms! { Page { page => page.name() } }

impl<'de> Deserialize<'de> for Page {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Page, D::Error> {
        let name = String::deserialize(deserializer)?;
        Page::from_name(&name).ok_or_else(|| D::Error::custom(format!("there is no page \"{}\"", shortened(&name))))
    }
}
