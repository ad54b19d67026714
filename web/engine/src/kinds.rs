use schemars::JsonSchema;
use serde::Serialize;

/// A starting scene.
#[derive(Debug, Serialize, JsonSchema)]
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
    let kind = |(name, text): (&'static str, &str)| {
        let title = kinegon::Scene::read(text).ok().and_then(|scene| scene.title);
        Kind { name, title: title.unwrap_or_default().for_message(), text: text.to_owned() }
    };
    [
        ("four-bar", include_str!("../../../templates/four-bar.json")),
        ("paper-figure-2", include_str!("../../../examples/figure-2.json")),
    ]
    .map(kind)
    .into()
}
