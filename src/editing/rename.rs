//! Another name for a point or a link, everywhere.

use super::Named;
use super::document::{Document, Word};
use super::names::{Names, joined_like};
use super::quantity_names::Renamer;
use crate::scene::{Scene, SceneError, nearest, pair, why_not};

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
        match (path.as_slice(), is_key) {
            (["figure", "labels"], true) => return self.renamer.plan_name(word),
            (["want", _], false) => return self.renamer.quantity(word),
            _ => {}
        }
        match self.what {
            Named::Point => self.in_place_of_point(&path, is_key, word),
            Named::Link => self.in_place_of_link(&path, is_key, word),
        }
    }

    fn in_place_of_point(&self, path: &[&str], is_key: bool, word: &str) -> Option<String> {
        let is_name = match (path, is_key) {
            (["ground" | "points" | "known" | "near"] | ["links", _, "shape"], true) => true,
            (["ground", _] | ["links", _, _] | ["links", _, "points", _], false) => true,
            (["links", _, "motion", "at"] | ["sliders", _, "at" | "pin" | "through"], false) => true,
            (["figure", "trace", _], false) => true,
            (["links", link, "lengths"], true) => return self.pair(link, word),
            (["sliders", slider, "along"], false) => return self.pair(self.names.carrier(slider), word),
            _ => false,
        };
        (is_name && word == self.from).then(|| self.to.to_owned())
    }

    fn in_place_of_link(&self, path: &[&str], is_key: bool, word: &str) -> Option<String> {
        let is_name = match (path, is_key) {
            (["links"], true) | (["sliders", _, "link" | "on"], false) => true,
            (["near"], true) => {
                let is_angle = word.strip_prefix("angle(").and_then(|rest| rest.strip_suffix(')')) == Some(self.from);
                return is_angle.then(|| format!("angle({})", self.to));
            }
            _ => false,
        };
        (is_name && word == self.from).then(|| self.to.to_owned())
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
