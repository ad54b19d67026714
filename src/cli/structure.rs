use super::files;
use super::message::{Failure, print, warn};
use crate::format;
use crate::mechanism::mechanism;
use crate::position::{counted_poses, with_nearest_sides};
use crate::scene::Scene;
use crate::words::Wording;
use clap::Args;
use std::path::PathBuf;

/// Print the structure of a scene.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  kinegon structure scene.json
  kinegon new fourth-class | kinegon structure -")]
pub(super) struct Structure {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
}

impl Structure {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let text = || -> Result<String, crate::Error> {
            let scene = Scene::read(&source.text)?;
            Ok(format::structure(&mechanism(&scene)?, &Wording::of(&scene.figure)))
        };
        let text = text().map_err(|error| source.fail(error))?;
        print(&text)
    }
}

/// Print the assembly modes of a scene.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  kinegon modes scene.json                          lists them
  kinegon draw scene.json --mode 2 -o mode-2.svg    draws the second")]
pub(super) struct Modes {
    /// Scene file, `-` for stdin.
    scene: PathBuf,
}

impl Modes {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let source = files::read(&self.scene)?;
        let stages = || -> Result<_, crate::Error> {
            let scene = Scene::read(&source.text)?;
            let mechanism = with_nearest_sides(&scene, mechanism(&scene)?);
            let listed = counted_poses(&mechanism, &scene.near)?;
            Ok((format::listed_modes(&scene, &mechanism, &listed), mechanism.warnings))
        };
        let (text, warnings) = stages().map_err(|error| source.fail(error))?;
        warnings.iter().for_each(|w| warn(w));
        print(&text)
    }
}
