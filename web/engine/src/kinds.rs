use serde::Serialize;

/// A starting scene.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(schemars::JsonSchema))]
pub struct Kind {
    /// Its name, as `kinegon new` has it.
    pub name: &'static str,
    /// Its title.
    pub title: String,
    /// Its text.
    pub text: String,
}

/// All starting scenes.
pub fn kinds() -> Vec<Kind> {
    let kind =
        |kind: kinegon::scene::Kind| Kind { title: kind.title().for_message(), name: kind.name, text: kind.text };
    kinegon::scene::Kind::all().map(kind).collect()
}
