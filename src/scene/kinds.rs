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

/// The names of all kinds, and the texts of their starting scenes, in the order in which they are listed.
macro_rules! templates {
    ($($name:literal in $folder:literal as $file:literal,)*) => {
        impl Kind {
            /// The names of all kinds, in the order in which they are listed.
            pub const NAMES: [&str; [$($name),*].len()] = [$($name),*];
        }

        const TEXTS: [&str; Kind::NAMES.len()] = [$(include_str!(concat!("../../", $folder, "/", $file, ".json"))),*];
    };
}

templates! {
    "four-bar" in "templates" as "four-bar",
    "slider-crank" in "templates" as "slider-crank",
    "slotted-lever" in "templates" as "slotted-lever",
    "whitworth" in "templates" as "whitworth",
    "toggle-press" in "templates" as "toggle-press",
    "hydraulic-boom" in "templates" as "hydraulic-boom",
    "watt-1" in "templates" as "watt-1",
    "stephenson-3" in "templates" as "stephenson-3",
    "five-bar" in "templates" as "five-bar",
    "gear-train" in "templates" as "gear-train",
    "planetary" in "templates" as "planetary",
    "planetary-sun-fixed" in "templates" as "planetary-sun-fixed",
    "planetary-carrier-fixed" in "templates" as "planetary-carrier-fixed",
    "differential" in "templates" as "differential",
    "reverted-train" in "templates" as "reverted-train",
    "geared-five-bar" in "templates" as "geared-five-bar",
    "sun-and-planet" in "templates" as "sun-and-planet",
    "rack-and-pinion" in "templates" as "rack-and-pinion",
    "geneva" in "templates" as "geneva",
    "eccentric-cam" in "templates" as "eccentric-cam",
    "flat-follower" in "templates" as "flat-follower",
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
}

impl Kind {
    /// All kinds, in the order in which they are listed.
    pub fn all() -> impl Iterator<Item = Kind> {
        let is_schema = |line: &&str| line.trim_start().starts_with("\"$schema\"");
        let without_schema = move |text: &str| text.split_inclusive('\n').filter(|line| !is_schema(line)).collect();
        Kind::NAMES.into_iter().zip(TEXTS).map(move |(name, text)| Kind { name, text: without_schema(text) })
    }

    /// The kind of that name; `None` if there is no such kind.
    #[must_use]
    pub fn named(name: &str) -> Option<Kind> {
        Kind::all().find(|kind| kind.name == name)
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
}
