use super::files;
use super::message::{Failure, print};
use super::output::FileSet;
use crate::scene::Scene;
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::path::{Path, PathBuf};

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

/// Write a starting scene.
#[derive(Debug, Args)]
pub(super) struct New {
    /// Kind of mechanism; without one the kinds are listed.
    #[arg(value_parser = PossibleValuesParser::new(TEMPLATES.map(|(name, _)| name)), hide_possible_values = true)]
    kind: Option<String>,
    /// File to write, or a folder for KIND.json, or `-` for stdout; a file that is there already is never written over.
    #[arg(short, long, default_value = "-")]
    output: PathBuf,
    /// List the kinds.
    #[arg(long, conflicts_with_all = ["kind", "output"])]
    list: bool,
}

impl New {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let Some(kind) = &self.kind else {
            if self.output != Path::new("-") {
                return Err(Failure::Misuse(
                    "which kind of mechanism is to be written?".into(),
                    Some("name one of those that `kinegon new --list` shows".into()),
                ));
            }
            return print(&list());
        };
        let (name, text) =
            TEMPLATES.into_iter().find(|(name, _)| name == kind).expect("the command line takes no other name");
        let text = without_schema(text);
        if self.output == Path::new("-") {
            return files::print(text.as_bytes());
        }
        let is_folder = files::is_folder(&self.output);
        let path = if is_folder { self.output.join(format!("{name}.json")) } else { self.output.clone() };
        let mut files = FileSet::default();
        files.add_first(&path, text.as_bytes())?;
        files.finish()
    }
}

/// The starting scene of a kind; `None` if there is no such kind.
pub(super) fn starting_scene(kind: &str) -> Option<String> {
    TEMPLATES.into_iter().find(|(name, _)| *name == kind).map(|(_, text)| without_schema(text))
}

/// The kind whose name is most similar.
pub(super) fn nearest(name: &str) -> &'static str {
    let kinds = TEMPLATES.into_iter().map(|(kind, _)| kind);
    kinds.min_by_key(|kind| strsim::damerau_levenshtein(kind, name)).unwrap_or_default()
}

/// The kinds with the titles of their scenes, a line each.
fn list() -> String {
    let width = TEMPLATES.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
    let line = |(name, text): (&str, &str)| {
        let title = Scene::read(text).ok().and_then(|scene| scene.title);
        format!("{name:width$}  {}\n", title.unwrap_or_default().for_terminal())
    };
    TEMPLATES.into_iter().map(line).collect()
}

/// The scene without its line `$schema`, whose relative path is right only beside the template.
fn without_schema(text: &str) -> String {
    let is_schema = |line: &&str| line.trim_start().starts_with("\"$schema\"");
    text.split_inclusive('\n').filter(|line| !is_schema(line)).collect()
}
