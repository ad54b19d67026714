use super::files;
use super::message::{Failure, refuse};
use crate::drawing::{Drawing, Style};
use crate::scene::{Figure, StyleName};
use std::path::Path;

/// A drawing style in place of the scene's.
pub(super) enum GivenStyle {
    /// The scene's own.
    Scene,
    /// One that comes with the program.
    Named(StyleName),
    /// That of a file.
    File(Style),
}

impl GivenStyle {
    /// The style of `--style`, if that is given.
    pub(super) fn read(asked: Option<&str>) -> Result<GivenStyle, Failure> {
        let Some(asked) = asked else {
            return Ok(GivenStyle::Scene);
        };
        if let Some(name) = StyleName::ALL.into_iter().find(|name| name.as_str() == asked) {
            return Ok(GivenStyle::Named(name));
        }
        if !asked.contains(['.', '/', '\\']) && asked != "-" && !Path::new(asked).exists() {
            let known = StyleName::ALL.map(StyleName::as_str).join(", ");
            let hint = format!("known styles: {known}; or the path of a style file");
            return refuse(format!("there is no style `{asked}`"), hint);
        }
        let source = files::read_text("style", Path::new(asked))?;
        source.checked(Style::read(&source.text).map(GivenStyle::File))
    }

    /// Puts the style into a scene's figure; of a style file its sizes only, which must be known before anything is drawn. Its looks
    /// are put on the finished drawing.
    pub(super) fn put_into(&self, figure: &mut Figure) {
        match self {
            GivenStyle::Scene => {}
            GivenStyle::Named(name) => (figure.style, figure.sizes, figure.usual_values) = (*name, None, None),
            GivenStyle::File(style) => {
                (figure.sizes, figure.usual_values) = (Some(style.sizes()), Some(style.shows_values()));
            }
        }
    }

    /// Gives drawings the looks of a style file.
    pub(super) fn put_on<'a>(&self, drawings: impl IntoIterator<Item = &'a mut Drawing>) {
        if let GivenStyle::File(style) = self {
            drawings.into_iter().for_each(|drawing| drawing.style = style.clone());
        }
    }
}
