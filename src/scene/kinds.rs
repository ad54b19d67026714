//! The starting scenes: one for each kind of mechanism.

use super::Scene;
use crate::text::Untrusted;

/// A kind of mechanism with its starting scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Its name, as `four-bar`.
    pub name: &'static str,
    /// The text of its scene, without the line `$schema`, whose relative path is right only in this repository.
    pub text: String,
}

/// Kinds of mechanisms with the texts of their starting scenes.
macro_rules! templates {
    ($($name:literal in $folder:literal as $file:literal,)*) => {
        [$(($name, include_str!(concat!("../../", $folder, "/", $file, ".json")))),*]
    };
}

/// The starting scenes by kind, in the order in which they are listed.
const TEMPLATES: [(&str, &str); 19] = templates! {
    "four-bar" in "templates" as "four-bar",
    "slider-crank" in "templates" as "slider-crank",
    "slotted-lever" in "templates" as "slotted-lever",
    "whitworth" in "templates" as "whitworth",
    "toggle-press" in "templates" as "toggle-press",
    "hydraulic-boom" in "templates" as "hydraulic-boom",
    "watt-1" in "templates" as "watt-1",
    "stephenson-3" in "templates" as "stephenson-3",
    "five-bar" in "templates" as "five-bar",
    "third-class" in "templates" as "third-class",
    "fourth-class" in "templates" as "fourth-class",
    "platform-3rrr" in "templates" as "platform-3rrr",
    "dyad-rrr" in "templates" as "dyad-rrr",
    "dyad-rrp" in "templates" as "dyad-rrp",
    "dyad-rpr" in "templates" as "dyad-rpr",
    "dyad-prp" in "templates" as "dyad-prp",
    "dyad-rpp" in "templates" as "dyad-rpp",
    "paper-figure-1" in "examples" as "figure-1",
    "paper-figure-2" in "examples" as "figure-2",
};

impl Kind {
    /// The names of all kinds, in the order in which they are listed.
    pub const NAMES: [&str; TEMPLATES.len()] = {
        let mut names = [""; TEMPLATES.len()];
        let mut index = 0;
        while index < names.len() {
            names[index] = TEMPLATES[index].0;
            index += 1;
        }
        names
    };

    /// All kinds, in the order in which they are listed.
    pub fn all() -> impl Iterator<Item = Kind> {
        TEMPLATES.into_iter().map(Kind::of)
    }

    /// The kind of that name; `None` if there is no such kind.
    #[must_use]
    pub fn named(name: &str) -> Option<Kind> {
        TEMPLATES.into_iter().find(|(known, _)| *known == name).map(Kind::of)
    }

    /// The kind whose name is most similar.
    #[must_use]
    pub fn nearest(name: &str) -> &'static str {
        let names = Kind::NAMES.into_iter();
        names.min_by_key(|known| strsim::damerau_levenshtein(known, name)).unwrap_or_default()
    }

    /// The title of its scene.
    #[must_use]
    pub fn title(&self) -> Untrusted {
        Scene::read(&self.text).ok().and_then(|scene| scene.title).unwrap_or_default()
    }

    fn of((name, text): (&'static str, &str)) -> Kind {
        let is_schema = |line: &&str| line.trim_start().starts_with("\"$schema\"");
        Kind { name, text: text.split_inclusive('\n').filter(|line| !is_schema(line)).collect() }
    }
}
