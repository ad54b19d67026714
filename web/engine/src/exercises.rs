use crate::checks::SheetPicture;
use crate::refused::Refused;
use kinegon::Scene;
use kinegon::drawing::Drawing;
use kinegon::exercise::{Exercise as Found, ExerciseError, Exercises, says};
use kinegon::format::{self, Text, html_text, svg_with};
use kinegon::scene::{DecimalMark, Figure, LanguageName, NotationName, Page, SizeLimit};
use serde::{Deserialize, Serialize};

/// Most exercises of a seed, as the program has it.
const MOST: usize = 1000;

/// How exercises are written, as the options of `kinegon exercise`; what is not given is the scene's.
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct ExerciseOptions {
    /// The sheet, as `a4-landscape`; none for A4, or A3 where few variants can be drawn well on A4.
    pub page: Option<String>,
    /// Language, as `es`.
    pub language: Option<String>,
    /// Notation.
    pub notation: Option<String>,
    /// Decimal mark.
    pub decimal: Option<String>,
}

/// An exercise with its files.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Exercise {
    /// Its scene: scene.json.
    pub text: String,
    /// Its name: that of its folder.
    pub name: String,
    /// What is given and what is to be drawn, at which scales: the sheet's sentences, in HTML of `<i>`, `<sub>`, `<sup>` and text alone.
    pub given: Vec<String>,
    /// The student's sheets, as `sheet.pdf` has them: what is given, then those for the plans.
    pub sheets: Vec<SheetPicture>,
    /// The teacher's key: key.svg.
    pub key: SheetPicture,
    /// The empty form: form.json.
    pub form: String,
    /// The same as a table: form.csv.
    pub form_csv: String,
    /// The values of the key: key.json.
    pub key_values: String,
}

/// The exercises of a scene that have been asked for; the next one is looked for from the last.
pub struct Series {
    text: String,
    seed: u64,
    options: ExerciseOptions,
    more: Exercises,
    found: Vec<Found>,
}

impl Series {
    /// The exercises of a scene.
    pub fn new(text: &str, seed: u64, options: &ExerciseOptions) -> Result<Series, Refused> {
        let mut scene = Scene::read(text).map_err(|error| Refused::of(text, error))?;
        options.put_into(&mut scene.figure);
        SizeLimit::HAND.check(&scene).map_err(|error| Refused::of(text, error))?;
        let solution = kinegon::solve(&scene).map_err(|error| Refused::of(text, error))?;
        solution.check_form().map_err(|error| Refused::of(text, error))?;
        let page = options.page.as_ref().map(|_| solution.scene.figure.page);
        let more = Exercises::new(&solution, page, seed).map_err(refused)?;
        Ok(Series { text: text.to_owned(), seed, options: options.clone(), more, found: Vec::new() })
    }

    /// Whether these are the exercises of that scene.
    pub fn is_of(&self, text: &str, seed: u64, options: &ExerciseOptions) -> bool {
        self.text == text && self.seed == seed && self.options == *options
    }

    /// The exercise of a number, counted from 1.
    pub fn exercise(&mut self, number: usize) -> Result<&Found, Refused> {
        if !(1..=MOST).contains(&number) {
            return Err(Refused::whole(says::numbered(MOST)));
        }
        while self.found.len() < number {
            let next = self.more.next().map_err(refused)?;
            self.found.push(next);
        }
        self.found.get(number - 1).ok_or_else(|| Refused::whole(says::no_such()))
    }
}

impl ExerciseOptions {
    fn put_into(&self, figure: &mut Figure) {
        let known = |given: &Option<String>, name: &str| given.as_deref() == Some(name);
        if let Some((name, page)) = self.page.as_ref().and_then(|name| Some((name, Page::from_name(name)?))) {
            figure.page.size = page.size;
            figure.page.landscape = if name.contains('-') { page.landscape } else { figure.page.landscape };
        }
        let language = LanguageName::ALL.into_iter().find(|l| known(&self.language, l.as_str()));
        let notation = NotationName::ALL.into_iter().find(|n| known(&self.notation, n.as_str()));
        let decimal = DecimalMark::ALL.into_iter().find(|d| known(&self.decimal, d.as_str()));
        figure.language = language.unwrap_or(figure.language);
        figure.notation = notation.unwrap_or(figure.notation);
        figure.decimal = decimal.unwrap_or(figure.decimal);
    }
}

impl Exercise {
    /// The files of an exercise with that name; what is given is told in a language, if one is chosen.
    pub fn of(found: &Found, name: String, language: Option<LanguageName>) -> Exercise {
        let picture = |drawing: &Drawing| SheetPicture {
            svg: svg_with(drawing, Text::Letters),
            width: drawing.width,
            height: drawing.height,
        };
        let form = found.form(&name);
        let mut told = found.clone();
        told.solution.scene.figure.language = language.unwrap_or(found.solution.scene.figure.language);
        let given = told.given();
        Exercise {
            text: found.text.clone(),
            given: given.iter().map(html_text).collect(),
            sheets: found.sheets(&name).iter().map(picture).collect(),
            key: picture(&found.key_sheet()),
            form: form.json(&found.solution),
            form_csv: form.csv(&found.solution),
            key_values: format::json(&found.key()),
            name,
        }
    }
}

fn refused(error: ExerciseError) -> Refused {
    Refused::whole(error.message())
}
