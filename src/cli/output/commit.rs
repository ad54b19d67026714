//! Renames complete files into their places, all or none.

use super::signals::known;
use super::stage::Stage;
use super::{Staged, is_there_already};
use crate::cli::files::unwritable;
use crate::cli::message::Failure;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use tempfile::TempPath;

/// A file, or a new folder with all its files, that is renamed into its place.
pub(super) struct Unit {
    /// Its path in messages.
    named: PathBuf,
    /// Index of its staging folder.
    stage: usize,
    from: PathBuf,
    pub to: PathBuf,
    /// Whether it must not replace another file.
    is_first: bool,
}

impl Unit {
    /// The unit to which a file belongs.
    pub(super) fn of(file: &Staged, stage: &Stage) -> Unit {
        let first = file.inside.iter().next().map_or(Path::new(""), Path::new);
        let (to, is_file) = (stage.base().join(first), first == file.inside);
        Unit {
            named: if is_file { file.named.clone() } else { to.clone() },
            stage: file.stage,
            from: stage.new_path(first),
            to,
            is_first: file.is_first && is_file,
        }
    }
}

/// What takes a unit out of its place again.
enum Undo {
    /// Nothing was there.
    Remove,
    /// This file was there.
    Restore(PathBuf),
}

/// Puts all units into their places, and on the disk. If one cannot be put there, what was there before is put back.
pub(super) fn commit(mut stages: Vec<Stage>, units: &[Unit]) -> Result<(), Failure> {
    // No signal comes between.
    let mut known = known();
    let mut undos: Vec<(&Unit, Undo)> = Vec::new();
    let Err((path, error)) = put_all(&stages, units, &mut undos) else {
        known.is_complete = true;
        // The guard is needed to remove the staging folders.
        drop(known);
        drop(stages);
        return Ok(());
    };
    let mut lost = Vec::new();
    for (unit, undo) in undos.into_iter().rev() {
        let undone = match undo {
            Undo::Remove => fs::rename(&unit.to, &unit.from),
            Undo::Restore(old) => fs::rename(old, &unit.to),
        };
        if undone.is_err() {
            let kept = stages[unit.stage].keep(&mut known);
            lost.push(format!("{} could not be put back (see {})", unit.named.display(), kept.display()));
        }
    }
    drop(known);
    let failure = match units.iter().any(|unit| unit.is_first) && error.kind() == ErrorKind::AlreadyExists {
        true => is_there_already(&path),
        false => unwritable(&path, &error),
    };
    match (lost.is_empty(), failure) {
        (false, Failure::Outside(problem)) => {
            Err(Failure::outside(format!("{}; {}", problem.message, lost.join("; "))))
        }
        (_, failure) => Err(failure),
    }
}

/// Renames all units, until one fails; `undos` is what must be undone then.
fn put_all<'u>(
    stages: &[Stage],
    units: &'u [Unit],
    undos: &mut Vec<(&'u Unit, Undo)>,
) -> Result<(), (PathBuf, io::Error)> {
    let Some(last) = units.last() else {
        return Ok(());
    };
    let failed = |unit: &Unit, error| (unit.named.clone(), error);
    for stage in stages {
        sync_folders(&stage.new_path(Path::new(""))).map_err(|error| failed(last, error))?;
    }
    for (number, unit) in units.iter().enumerate() {
        let old = stages[unit.stage].old_path(number);
        put(unit, old, undos).map_err(|error| failed(unit, error))?;
    }
    for stage in stages {
        sync(stage.base()).map_err(|error| failed(last, error))?;
    }
    Ok(())
}

/// Renames one unit into its place; what is there is kept as `old`.
fn put<'u>(unit: &'u Unit, old: PathBuf, undos: &mut Vec<(&'u Unit, Undo)>) -> io::Result<()> {
    if unit.is_first {
        TempPath::try_from_path(&unit.from)?.persist_noclobber(&unit.to).map_err(|error| error.error)?;
        undos.push((unit, Undo::Remove));
        return Ok(());
    }
    if !unit.to.is_file() {
        fs::rename(&unit.from, &unit.to)?;
        undos.push((unit, Undo::Remove));
        return Ok(());
    }
    // A second name for the old file, so that there is never none; not every file system can do that.
    if fs::hard_link(&unit.to, &old).is_err() {
        fs::rename(&unit.to, &old)?;
    }
    undos.push((unit, Undo::Restore(old)));
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
