//! Styles: the look of each pen. In: a style file (`templates/styles`, or the user's). Out: a [`Style`], which gives
//! the look of a mark. Content and places of marks are no part of it.

mod file;
mod paint;

use super::look::{Colour, Dash, Look, Pen};
use crate::scene::{FileKind, SceneError, Sizes, StyleName, read_as, schema};
use file::{StyleFile, StyleValues};
use paint::{Dashes, Paint};
use std::sync::{Arc, LazyLock};

/// Share of the background's colour in pale shades of links.
const PALE: f64 = 0.6;

/// Additional width of lines in the accent colour, in mm.
const BOLDER: f64 = 0.15;
/// Share of the background's colour in the marks of earlier steps.
const CALM: f64 = 0.45;
/// Share of the background's colour in a tint of the accent colour.
const TINT: f64 = 0.8;

const STYLE: FileKind = FileKind { what: crate::scene::says::style, key: "kinegon_style", version: 1 };

/// The looks of a drawing's marks. Copies share one set of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Style(Arc<StyleValues>);

impl Default for Style {
    fn default() -> Self {
        Style::named(StyleName::default())
    }
}

impl Style {
    /// A style that comes with the program.
    #[must_use]
    pub fn named(name: StyleName) -> Style {
        static STYLES: [LazyLock<Style>; 4] = [
            LazyLock::new(|| base_style(include_str!("../../../templates/styles/paper.json"))),
            LazyLock::new(|| derived_style(bundled_file(include_str!("../../../templates/styles/print.json")))),
            LazyLock::new(|| derived_style(bundled_file(include_str!("../../../templates/styles/lecture.json")))),
            LazyLock::new(|| derived_style(bundled_file(include_str!("../../../templates/styles/board.json")))),
        ];
        (*STYLES[name as usize]).clone()
    }

    /// The style that the text of a style file describes, or the first thing that is wrong with it.
    ///
    /// Values that the file leaves out are those of the style that it is based on, by default `paper`.
    ///
    /// ```
    /// use kinegon::drawing::Style;
    /// let style = Style::read(r##"{ "kinegon_style": 1, "based_on": "board", "background": "#000000" }"##)?;
    /// assert_eq!(style.background().to_string(), "#000000");
    ///
    /// let error = Style::read(r#"{ "kinegon_style": 1, "pens": { "rays": { "width": 0.3 } } }"#).unwrap_err();
    /// assert_eq!(error.to_string(), "1:33: pens.rays: unknown key `rays`; hint: did you mean `ray`?");
    /// # Ok::<(), kinegon::scene::SceneError>(())
    /// ```
    pub fn read(text: &str) -> Result<Style, SceneError> {
        read_as(text, &STYLE).map(derived_style)
    }

    /// The JSON Schema (draft 2020-12) of the style file, with descriptions, for editors.
    #[must_use]
    pub fn schema() -> serde_json::Value {
        schema!("style", StyleFile, "Kinegon drawing style, version 1")
    }

    /// The look of a mark with this pen that belongs to the link or curve with this number, or to none.
    #[must_use]
    pub fn look(&self, pen: Pen, number: Option<usize>) -> Look {
        if let Some(colour) = pen.fixed() {
            return Look::area(colour);
        }
        let pen = &self.0.pens[pen as usize];
        let paint = |paint: Option<Paint>| paint.and_then(|paint| self.colour(paint, number));
        let stroke = paint(pen.stroke);
        let ink = paint(pen.ink).or(stroke).unwrap_or(self.0.ink);
        Look {
            stroke,
            width: pen.width.map_or(0.0, |width| width.0),
            dash: match &pen.dash {
                Some(Dashes::Of(dash)) => dash.clone(),
                Some(Dashes::OfCurve) => self.curve_dash(number.unwrap_or(0)),
                None => Dash::new(),
            },
            fill: paint(pen.fill),
            cap: pen.cap.unwrap_or_default(),
            ink,
            halo: pen.halo.map_or(0.0, |halo| halo.0),
        }
    }

    /// Sizes of letters and signs, for [`Figure::sizes`](crate::scene::Figure::sizes): they must be known before a sheet
    /// is laid out.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        Sizes { lines: self.look(Pen::Link, None).width, ..self.0.sizes }
    }

    /// Whether figures show values where the scene does not say so.
    #[must_use]
    pub fn shows_values(&self) -> bool {
        self.0.values
    }

    /// Colour of the paper, and of the halos of letters.
    #[must_use]
    pub fn background(&self) -> Colour {
        self.0.background
    }

    /// The colour of marks that appear with a step.
    #[must_use]
    pub fn accent(&self) -> Colour {
        self.0.accent
    }

    /// Whether it draws on a dark background.
    #[must_use]
    pub fn is_dark(&self) -> bool {
        let Colour { red, green, blue } = self.background();
        u16::from(red) + u16::from(green) + u16::from(blue) < 3 * 128
    }

    /// Colours of the links in turn; empty if links have no colours of their own.
    #[must_use]
    pub fn links(&self) -> &[Colour] {
        &self.0.links
    }

    /// The look in the accent colour, with slightly wider lines.
    pub(super) fn accented(&self, look: Look) -> Look {
        let (accent, background) = (self.0.accent, self.background());
        let is_tint = self.is_tint(&look);
        let solid = |fill: Colour| match look.stroke.is_some() && fill == background {
            true => fill,
            false => accent,
        };
        Look {
            stroke: look.stroke.map(|_| accent),
            width: look.width + BOLDER,
            // Areas without outline stay tints: letters on them must be legible.
            fill: look.fill.map(|fill| match is_tint {
                true => accent.towards(background, TINT),
                false => solid(fill),
            }),
            ink: accent,
            ..look
        }
    }

    /// The look in paler colours.
    pub(super) fn calmed(&self, look: Look) -> Look {
        let background = self.background();
        let pale = |colour: Colour| colour.towards(background, CALM);
        let is_tint = self.is_tint(&look);
        Look {
            stroke: look.stroke.map(pale),
            fill: look.fill.map(|fill| if is_tint { fill } else { pale(fill) }),
            ink: look.ink.towards(background, 0.5 * CALM),
            ..look
        }
    }

    /// Whether it is an area without outline whose colour is nearer to the background than to the ink.
    fn is_tint(&self, look: &Look) -> bool {
        let sum = |c: Colour| i32::from(c.red) + i32::from(c.green) + i32::from(c.blue);
        let from = |fill: Colour, to: Colour| (sum(fill) - sum(to)).abs();
        look.stroke.is_none() && look.fill.is_some_and(|fill| from(fill, self.background()) < from(fill, self.0.ink))
    }

    fn colour(&self, paint: Paint, number: Option<usize>) -> Option<Colour> {
        let all = &self.0;
        let of = |list: &[Colour]| {
            let number = number.filter(|_| !list.is_empty())?;
            Some(list[number % list.len()])
        };
        match paint {
            Paint::None => None,
            Paint::Of(colour) => Some(colour),
            Paint::Ink => Some(all.ink),
            Paint::Background => Some(all.background),
            Paint::Link => of(&all.links).or(Some(all.ink)),
            Paint::Tint => of(&all.tints),
            Paint::Pale => Some(of(&all.links).unwrap_or(all.ink).towards(all.background, PALE)),
            Paint::Curve => of(&all.curves).or(Some(all.ink)),
        }
    }

    /// The dash of a curve: all colours come first with the first dash, then with the second, and so on.
    fn curve_dash(&self, number: usize) -> Dash {
        let dashes = &self.0.curve_dashes;
        let round = number / self.0.curves.len().max(1);
        match dashes.len() {
            0 => Dash::new(),
            count => dashes[round % count].clone(),
        }
    }
}

/// The style on which all others are based.
fn base_style(text: &str) -> Style {
    Style(Arc::new(bundled_file(text).over(StyleValues::default())))
}

/// A style that is based on another.
fn derived_style(file: StyleFile) -> Style {
    let base = Style::named(file.based_on.unwrap_or_default());
    Style(Arc::new(file.over((*base.0).clone())))
}

/// A style file of the program. It is not checked at run time: a test reads it strictly.
fn bundled_file(text: &str) -> StyleFile {
    serde_json::from_str(text).expect("the styles of the program are sound")
}
