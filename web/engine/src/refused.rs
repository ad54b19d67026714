use kinegon::scene::SceneError;
use kinegon::words::Language;
use kinegon::{Error, Message, Problem};
use serde::Serialize;

/// Why a text is not understood or a scene gives no result, before it is told in a language.
#[derive(Debug)]
pub struct Refused {
    problem: Problem,
    place: Placed,
}

/// Where in a text something is refused.
#[derive(Debug, Default)]
struct Placed {
    path: String,
    from: Option<u32>,
    to: Option<u32>,
    line: Option<u32>,
    column: Option<u32>,
}

/// Why a text is not understood or a scene gives no result.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema), schemars(rename = "Refused"))]
pub struct Told {
    /// What is wrong.
    pub message: String,
    /// What to try.
    pub hint: Option<String>,
    /// The JSON path, as `links.4.lengths.GD`; empty for the text as a whole.
    pub path: String,
    /// Where it begins in the text, in UTF-16 units as JavaScript counts; none for the text as a whole.
    pub from: Option<u32>,
    /// Where it ends.
    pub to: Option<u32>,
    /// Line, counted from 1.
    pub line: Option<u32>,
    /// Column in characters, counted from 1.
    pub column: Option<u32>,
}

impl Refused {
    /// About the text as a whole.
    pub fn whole(problem: impl Into<Problem>) -> Refused {
        Refused { problem: problem.into(), place: Placed::default() }
    }

    /// Why a scene with this text gives no result.
    pub fn of(text: &str, error: impl Into<Error>) -> Refused {
        let error = error.into();
        error.in_scene().map_or_else(|| Refused::whole(error.problem()), |error| Refused::at(text, error))
    }

    fn at(text: &str, error: &SceneError) -> Refused {
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        let units = |byte: usize| number(text.get(..byte).map_or(0, |before| before.encode_utf16().count()));
        let place = error.place.as_ref();
        let place = Placed {
            path: error.path.clone(),
            from: place.map(|place| units(place.span.start)),
            to: place.map(|place| units(place.span.end)),
            line: place.map(|place| number(place.line)),
            column: place.map(|place| number(place.column)),
        };
        Refused { problem: error.problem(), place }
    }

    /// What is wrong.
    pub fn message(&self) -> &Message {
        &self.problem.message
    }

    /// It in the words of a language.
    pub fn told(self, language: &Language) -> Told {
        let Placed { path, from, to, line, column } = self.place;
        let Problem { message, hint } = self.problem;
        Told {
            message: language.says(&message),
            hint: hint.map(|hint| language.says(&hint)),
            path,
            from,
            to,
            line,
            column,
        }
    }
}
