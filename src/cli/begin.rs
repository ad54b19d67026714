//! What somebody begins with: the workbench, and starting scenes.

use super::files;
use super::forms::has_ending;
use super::message::{Failure, note, refuse};
use super::output::{FileSet, is_stream};
use crate::Problem;
use crate::format::{OpenScene, workbench};
use crate::scene::Kind;
use clap::Args;
use clap::builder::PossibleValuesParser;
use etcetera::BaseStrategy;
use std::path::{Path, PathBuf};

/// The name of the page's file.
const NAME: &str = "kinegon.html";

const APP_HELP: &str = "\
The workbench is one file and needs no network: it can be copied, sent and put on a course page, and works without this program.

Examples:
  kinegon app                       opens the workbench in the browser
  kinegon app scene.json            opens it with this scene
  kinegon app -o kinegon.html       writes it";

#[derive(Debug, Args)]
#[command(after_help = APP_HELP)]
pub(super) struct App {
    /// Scene file to open it with, `-` for stdin.
    scene: Option<PathBuf>,
    /// Write the page to this file, or into a folder, or to stdout for `-`, and open nothing.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl App {
    pub(super) fn run(&self) -> Result<(), Failure> {
        // A scene that cannot be assembled may be opened: the workbench is where to mend it.
        let page = match &self.scene {
            Some(path) => workbench(Some(OpenScene { text: &files::read_scene(path)?.0.text, step: None })),
            None => workbench(None),
        };
        match &self.output {
            Some(output) if files::is_folder(output) => self.write(&output.join(NAME), &page),
            Some(output) => self.write(output, &page),
            None => {
                let folders = etcetera::choose_base_strategy().map_err(|error| {
                    let hint = format!("write it with -o {NAME}, and open that file in a browser");
                    Failure::misuse(format!("there is no place for the page: {error}"), hint)
                })?;
                // Always the same place, as browsers keep what was last done on a page by its address.
                let path = folders.cache_dir().join("kinegon").join(NAME);
                self.write(&path, &page)?;
                show(&path)
            }
        }
    }

    fn write(&self, path: &Path, page: &str) -> Result<(), Failure> {
        if let Some(scene) = &self.scene {
            files::refuse_overwriting("scene", scene, path)?;
        }
        // Under the name of a scene it would take that scene's place.
        if path.extension().is_some() && !has_ending(path, &["html", "htm"]) && !is_stream(path) {
            return refuse(
                format!("the workbench is a page, and {} is not the name of one", path.display()),
                format!("name a file that ends in `.html`, as {NAME}; a scene to open comes without -o"),
            );
        }
        files::write(path, page.as_bytes())
    }
}

/// Opens a file in the person's browser.
fn show(path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let tried = if has_screen() {
        open::that_detached(path).map_err(|error| error.to_string())
    } else {
        Err("there is no screen".into())
    };
    match tried {
        Ok(()) => {
            note(&format!("the workbench is open in the browser: {shown}"));
            Ok(())
        }
        Err(error) => Err(Failure::Outside(
            Problem::new(format!("no browser can be started: {error}; the workbench is in {shown}"))
                .hint("open that file in a browser, or copy it to a machine that has one"),
        )),
    }
}

/// Whether there is a screen to show something on; systems other than those with X or Wayland always have one.
fn has_screen() -> bool {
    let is_set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let asks_for_one = cfg!(all(unix, not(target_os = "macos")));
    // Within Windows, and where a person has named a browser, there is a way without.
    !asks_for_one || ["DISPLAY", "WAYLAND_DISPLAY", "BROWSER", "WSL_DISTRO_NAME"].into_iter().any(is_set)
}

const NEW_HELP: &str = "\
Examples:
  kinegon new                             lists the kinds
  kinegon new four-bar -o four-bar.json   writes a four-bar linkage
  kinegon new slider-crank | kinegon draw - -o slider-crank.svg";

#[derive(Debug, Args)]
#[command(after_help = NEW_HELP)]
pub(super) struct New {
    /// Kind of mechanism; without one the kinds are listed.
    #[arg(value_parser = PossibleValuesParser::new(Kind::NAMES), hide_possible_values = true)]
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
                return refuse(
                    "which kind of mechanism is to be written?",
                    "name one of those that `kinegon new --list` shows",
                );
            }
            let width = Kind::NAMES.iter().map(|name| name.len()).max().unwrap_or_default();
            let line = |kind: Kind| format!("{:width$}  {}\n", kind.name, kind.title().for_terminal());
            return files::print_text(&Kind::all().map(line).collect::<String>());
        };
        let Kind { name, text } = Kind::named(kind).expect("the command line takes no other name");
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
