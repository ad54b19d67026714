//! Staging folders: where files are until all are complete.

use super::signals::{Known, known, watch};
use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A staging folder. Its files lie in `new`, in the folders in which they will be; what they replace lies in `old`.
pub(super) struct Stage {
    base: PathBuf,
    folder: Option<TempDir>,
}

impl Stage {
    /// A new staging folder in the folder `base`.
    pub(super) fn new(base: &Path) -> io::Result<Stage> {
        watch();
        let mut known = known();
        let mut builder = tempfile::Builder::new();
        builder.prefix(".kinegon-").rand_bytes(12);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
        let folder = builder.tempdir_in(base)?;
        known.folders.push(folder.path().to_owned());
        drop(known);
        let stage = Stage { base: base.to_owned(), folder: Some(folder) };
        for part in ["new", "old"] {
            fs::create_dir(stage.path().join(part))?;
        }
        Ok(stage)
    }

    /// The folder in which the staging folder is.
    pub(super) fn base(&self) -> &Path {
        &self.base
    }

    fn path(&self) -> &Path {
        self.folder.as_ref().map_or(Path::new(""), TempDir::path)
    }

    /// Where a new file or folder is until it is moved.
    pub(super) fn new_path(&self, inside: &Path) -> PathBuf {
        self.path().join("new").join(inside)
    }

    /// Where the file that the unit of this number replaces is kept meanwhile.
    pub(super) fn old_path(&self, number: usize) -> PathBuf {
        self.path().join("old").join(number.to_string())
    }

    /// Creates a file with the mode of the one that it will replace, and with its owner where that is allowed.
    pub(super) fn create(&self, inside: &Path, replaced: Option<&Metadata>) -> io::Result<File> {
        let path = self.new_path(inside);
        // A signal that removes the folder must not find it growing.
        let _known = known();
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        if path.is_file() {
            fs::remove_file(&path)?;
        }
        let file = File::create_new(path)?;
        if let Some(replaced) = replaced {
            keep_owner(&file, replaced);
            file.set_permissions(replaced.permissions())?;
        }
        Ok(file)
    }

    /// Leaves the folder where it is, with what could not be put back.
    pub(super) fn keep(&mut self, known: &mut Known) -> PathBuf {
        let path = self.path().to_owned();
        known.folders.retain(|folder| *folder != path);
        self.folder.take().map_or(path, TempDir::keep)
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        let mut known = known();
        let path = self.path().to_owned();
        drop(self.folder.take());
        known.folders.retain(|folder| *folder != path);
    }
}

#[cfg(unix)]
fn keep_owner(file: &File, replaced: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let of = |found: &Metadata| (found.uid(), found.gid());
    if file.metadata().is_ok_and(|own| of(&own) != of(replaced)) {
        // Only some may give files away.
        let _ = fchown(file, Some(replaced.uid()), Some(replaced.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}
