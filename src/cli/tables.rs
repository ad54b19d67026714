//! Tables of loads in files beside a scene, as an indicator diagram over a crank's angle: read here, and written into the scene's text.

use super::files::{leads_outside, read_form};
use super::message::{Failure, Source, refuse};
use crate::Problem;
use crate::editing::{lines_of_table, tables_in_files, with_table};
use crate::message::Message;
use std::path::Path;

/// A scene's text with the tables that it leaves to files, whose paths are from its folder.
pub(super) fn with_tables(mut source: Source, scene: &Path) -> Result<Source, Failure> {
    let folder = scene.parent().filter(|_| scene != Path::new("-")).unwrap_or(Path::new(""));
    for given in tables_in_files(&source.text) {
        let path = folder.join(&given.path);
        // Somebody else's scene may name any file: nothing outside of its folder is read.
        if leads_outside(&path, folder) {
            let message = format!("{}, which the scene names as a table, is outside of its folder", path.display());
            return refuse(message, "put the table beside the scene");
        }
        let file = read_form(&path)?;
        let lines =
            lines_of_table(&file.text, given.name.as_deref()).map_err(|problem| in_file(&file.name, problem))?;
        source.text = source.checked(with_table(&source.text, given.load, &lines))?;
    }
    Ok(source)
}

/// What is wrong in a file.
fn in_file(name: &str, Problem { message, hint }: Problem) -> Failure {
    Failure::Misuse(Problem { message: Message::list([name.into(), message], ": "), hint })
}
