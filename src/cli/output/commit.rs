//! Renames complete files into their places, all or none.

use super::is_there_already;
use super::stage::{Stage, State, Unit, known};
use crate::cli::message::Failure;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use tempfile::TempPath;

/// Puts the files of all stages into their places, and on the disk. If one cannot be put there, what was there before is
/// put back.
pub(super) fn commit(mut stages: Vec<Stage>) -> Result<(), Failure> {
    // No signal comes between.
    let mut known = known();
    let Err((path, error)) = put_all(&mut stages) else {
        known.is_complete = true;
        // The guard is needed to remove the staging folders.
        drop(known);
        return Ok(());
    };
    let mut lost = String::new();
    for stage in stages.iter().rev() {
        for unit in stage.units.iter().rev() {
            let undone = match &unit.state {
                State::Staged => Ok(()),
                State::Added => fs::rename(&unit.to, &unit.from),
                State::Replaces(old) => fs::rename(old, &unit.to),
            };
            if undone.is_err() {
                known.folders.retain(|folder| *folder != stage.folder);
                let (named, kept) = (unit.named.display(), stage.folder.display());
                lost += &format!("; {named} could not be put back (see {kept})");
            }
        }
    }
    drop(known);
    let has_first = stages.iter().flat_map(|stage| &stage.units).any(|unit| unit.is_first);
    if has_first && error.kind() == ErrorKind::AlreadyExists {
        return Err(is_there_already(&path));
    }
    Err(Failure::outside(format!("{} cannot be written: {error}{lost}", path.display())))
}

/// Renames all units, until one fails: its path in messages, and why.
fn put_all(stages: &mut [Stage]) -> Result<(), (PathBuf, io::Error)> {
    let last = stages.last().and_then(|stage| stage.units.last()).map(|unit| unit.named.clone()).unwrap_or_default();
    let unsynced = |error| (last.clone(), error);
    stages.iter().try_for_each(|stage| sync_folders(&stage.folder.join("new"))).map_err(unsynced)?;
    for stage in &mut *stages {
        for (number, unit) in stage.units.iter_mut().enumerate() {
            let old = stage.folder.join("old").join(number.to_string());
            put(unit, old).map_err(|error| (unit.named.clone(), error))?;
        }
    }
    stages.iter().try_for_each(|stage| sync(&stage.base)).map_err(unsynced)
}

/// Renames one unit into its place; what is there is kept as `old`.
fn put(unit: &mut Unit, old: PathBuf) -> io::Result<()> {
    if unit.is_first || !unit.to.is_file() {
        if unit.is_first {
            TempPath::try_from_path(&unit.from)?.persist_noclobber(&unit.to).map_err(|error| error.error)?;
        } else {
            fs::rename(&unit.from, &unit.to)?;
        }
        unit.state = State::Added;
        return Ok(());
    }
    // A second name for the old file, so that there is never none; not every file system can do that.
    if fs::hard_link(&unit.to, &old).is_err() {
        fs::rename(&unit.to, &old)?;
    }
    unit.state = State::Replaces(old);
    fs::rename(&unit.from, &unit.to)
}

/// Hands the names in a folder, and in the folders in it, over to the disk.
fn sync_folders(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sync_folders(&path)?;
            sync(&path)?;
        }
    }
    Ok(())
}

/// Hands the names in a folder over to the disk, where a system can do that.
fn sync(folder: &Path) -> io::Result<()> {
    if cfg!(not(unix)) {
        return Ok(());
    }
    match fs::File::open(folder).and_then(|folder| folder.sync_all()) {
        // A folder that may be written but not read, and file systems without it.
        Err(error)
            if [ErrorKind::PermissionDenied, ErrorKind::InvalidInput, ErrorKind::Unsupported]
                .contains(&error.kind()) =>
        {
            Ok(())
        }
        done => done,
    }
}
