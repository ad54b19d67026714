//! Another name for a point or a link, everywhere.

use super::document::{Document, Word};
use super::names::{Named, Names, joined_like};
use super::quantity_names::Renamer;
use crate::scene::{Meaning, Scene, SceneError, meaning, nearest, pair, why_not};

/// Gives a point or a link another name, in all places where the scene means it.
///
/// # Errors
/// There is none of that name, the new name is no name, is there already or is kept for something.
pub(super) fn rename(document: &mut Document<'_>, what: Named, from: &str, to: &str) -> Result<(), SceneError> {
    let names = Names::of(&document.json());
    check(document, &names, what, from, to)?;
    if from == to {
        return Ok(());
    }
    let was_read = Scene::read(&document.text()).is_ok();
    let renaming = Renaming { names: &names, renamer: Renamer::new(&names, what, from, to), what, from, to };
    document.reword(&|word| renaming.word(word))?;
    match Scene::read(&document.text()) {
        // The name is kept for something. The place is in the new text, which nobody sees.
        Err(error) if was_read => Err(SceneError { place: None, ..error }),
        _ => Ok(()),
    }
}

fn check(document: &Document<'_>, names: &Names, what: Named, from: &str, to: &str) -> Result<(), SceneError> {
    let (noun, all) = match what {
        Named::Point => ("point", names.points()),
        Named::Link => ("link", names.links.keys().cloned().collect()),
    };
    if !all.iter().any(|name| name == from) {
        return Err(no_such(document, noun, from, &all));
    }
    if let Some((message, hint)) = why_not(&format!("a {noun}"), to) {
        return Err(document.error(&[], message, hint.as_deref()));
    }
    if from != to && all.iter().any(|name| name == to) {
        let message = format!("there is a {noun} {to} already");
        return Err(document.error(&[], message, Some("choose another name")));
    }
    Ok(())
}

/// There is no point or link of that name.
pub(super) fn no_such(document: &Document<'_>, noun: &str, name: &str, all: &[String]) -> SceneError {
    let hint = nearest(name, all.iter().map(String::as_str)).map(|name| format!("did you mean `{name}`?"));
    document.error(&[], format!("there is no {noun} {}", crate::text::shown(name)), hint.as_deref())
}

/// A new name, and where the old one is meant.
struct Renaming<'a> {
    names: &'a Names,
    renamer: Renamer<'a>,
    what: Named,
    from: &'a str,
    to: &'a str,
}

impl Renaming<'_> {
    /// The new form of a word of the scene.
    fn word(&self, Word { path, is_key, word }: Word<'_>) -> Option<String> {
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        let is = |name: &str| name == self.from;
        let angle = |link: &str| format!("angle({link})");
        match (meaning(&path, is_key)?, self.what) {
            (Meaning::OfPlan, _) => self.renamer.plan_name(word),
            (Meaning::Quantity, _) => self.renamer.quantity(word),
            (Meaning::PairOfLink, Named::Point) => self.pair(path[1], word),
            (Meaning::PairOfGuide, Named::Point) => self.pair(self.names.carrier(path[1]), word),
            (Meaning::PointOrAngle, Named::Link) => (word == angle(self.from)).then(|| angle(self.to)),
            (Meaning::Point | Meaning::PointOfGuide | Meaning::PointOrAngle, Named::Point) => {
                is(word).then(|| self.to.to_owned())
            }
            (Meaning::Link, Named::Link) => is(word).then(|| self.to.to_owned()),
            _ => None,
        }
    }

    /// The key of two points of a carrier with the new name.
    fn pair(&self, carrier: &str, key: &str) -> Option<String> {
        let points = self.names.of_carrier(carrier);
        let (from, to) = pair(key, points)?;
        let new = |name: &String| if name == self.from { self.to.to_owned() } else { name.clone() };
        let is_named = [&from, &to].iter().any(|name| *name == self.from);
        let points: Vec<String> = points.iter().map(new).collect();
        is_named.then(|| joined_like(key, &new(&from), &new(&to), &points))
    }
}
