//! Files that are written together: all of them, or none.
//!
//! Each file is written into a *staging folder* beside the place where it is to be, with a name that nobody can guess and
//! open to nobody else. When all are complete and on the disk they are renamed into their places (`commit`). What fails
//! before, and signals, remove the staging folder (`stage`, `signals`): nothing new is left, and what was there is
//! unchanged. What remains: files in different places are renamed one after the other, so a power cut between two
//! renames leaves some of the new and some of the old; and what ends the program at once (`kill -9`) leaves a staging folder.

mod commit;
mod place;
mod signals;
mod stage;

pub(super) use self::signals::{survive_size_limits, wait_if_stopped};

use self::commit::Unit;
use self::place::Place;
use self::stage::Stage;
use super::files::unwritable;
use super::message::Failure;
use std::fs::{File, Metadata};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Files that are written together. Nothing is in its place before [`FileSet::finish`].
#[derive(Default)]
pub struct FileSet {
    stages: Vec<Stage>,
    files: Vec<Staged>,
    /// What goes to pipes and devices, which cannot be replaced.
    direct: Vec<(PathBuf, Vec<u8>)>,
}

/// A file in a staging folder.
struct Staged {
    /// Its path as the person wrote it.
    named: PathBuf,
    /// Index of its staging folder.
    stage: usize,
    /// Its path from the folder in which the staging folder is.
    inside: PathBuf,
    /// Whether it must not replace another file.
    is_first: bool,
}

/// A file of a set that is written piece by piece, or a pipe or a device.
pub(super) struct Stream {
    named: PathBuf,
    sink: BufWriter<Sink>,
}

enum Sink {
    File(File),
    Direct(Box<dyn Write + Send>),
}

impl FileSet {
    /// Writes a file, in place of the one that is there.
    pub fn add(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        let place = Place::of(path).map_err(|error| unwritable(path, &error))?;
        self.write(path, place, bytes, false)
    }

    /// Writes files, in place of those that are there.
    pub(super) fn add_all(&mut self, files: &[(PathBuf, Vec<u8>)]) -> Result<(), Failure> {
        files.iter().try_for_each(|(path, bytes)| self.add(path, bytes))
    }

    /// Writes a file that does not exist yet; an existing one is refused.
    pub fn add_first(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        if path.symlink_metadata().is_ok() && !is_special(path) {
            return Err(is_there_already(path));
        }
        let place = Place::of(path).map_err(|error| unwritable(path, &error))?;
        self.write(path, place, bytes, true)
    }

    fn write(&mut self, path: &Path, place: Place, bytes: &[u8], is_first: bool) -> Result<(), Failure> {
        match place {
            Place::Special => self.direct.push((path.to_owned(), bytes.to_owned())),
            Place::File { base, inside, replaced } => {
                let mut stream = self.open(path, &base, &inside, replaced.as_deref(), is_first)?;
                stream.write_all(bytes).map_err(|error| unwritable(path, &error))?;
                stream.end()?;
            }
        }
        Ok(())
    }

    /// Begins a file that is written piece by piece; [`Stream::end`] must come before [`FileSet::finish`].
    pub(super) fn begin(&mut self, path: &Path) -> Result<Stream, Failure> {
        match Place::of(path).map_err(|error| unwritable(path, &error))? {
            Place::Special => Stream::direct(path),
            Place::File { base, inside, replaced } => self.open(path, &base, &inside, replaced.as_deref(), false),
        }
    }

    /// Opens a file in the staging folder of `base`, with the mode of the file that it will replace.
    fn open(
        &mut self,
        path: &Path,
        base: &Path,
        inside: &Path,
        replaced: Option<&Metadata>,
        is_first: bool,
    ) -> Result<Stream, Failure> {
        let stage = match self.stages.iter().position(|stage| stage.base() == base) {
            Some(stage) => stage,
            None => {
                let stage = Stage::new(base).map_err(|error| nothing_fits(path, base, &error))?;
                self.stages.push(stage);
                self.stages.len() - 1
            }
        };
        // One file under two names is that of the last.
        self.files.retain(|file| file.stage != stage || file.inside != inside);
        let file = self.stages[stage].create(inside, replaced).map_err(|error| unwritable(path, &error))?;
        self.files.push(Staged { named: path.to_owned(), stage, inside: inside.to_owned(), is_first });
        Ok(Stream { named: path.to_owned(), sink: BufWriter::new(Sink::File(file)) })
    }

    /// Puts all files into their places. If that fails, none of them is there.
    pub fn finish(self) -> Result<(), Failure> {
        for (path, bytes) in &self.direct {
            let mut stream = Stream::direct(path)?;
            stream.write_all(bytes).map_err(|error| unwritable(path, &error))?;
            stream.end()?;
        }
        let mut units: Vec<Unit> = Vec::new();
        for file in &self.files {
            let unit = Unit::of(file, &self.stages[file.stage]);
            // A new folder is renamed once with all that is in it.
            if !units.iter().any(|other| other.to == unit.to) {
                units.push(unit);
            }
        }
        commit::commit(self.stages, &units)
    }
}

impl Stream {
    fn direct(path: &Path) -> Result<Stream, Failure> {
        let sink = place::open_special(path).map_err(|error| unwritable(path, &error))?;
        Ok(Stream { named: path.to_owned(), sink: BufWriter::new(Sink::Direct(sink)) })
    }

    /// The path as the person wrote it.
    pub(super) fn path(&self) -> &Path {
        &self.named
    }

    /// Hands the complete file over to the disk.
    pub(super) fn end(self) -> Result<(), Failure> {
        let written = self.sink.into_inner().map_err(io::IntoInnerError::into_error).and_then(|sink| match sink {
            Sink::File(file) => file.sync_all(),
            Sink::Direct(mut direct) => direct.flush(),
        });
        written.map_err(|error| unwritable(&self.named, &error))
    }
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sink.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Sink::File(file) => file.write(bytes),
            Sink::Direct(direct) => direct.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Sink::File(file) => file.flush(),
            Sink::Direct(direct) => direct.flush(),
        }
    }
}

fn nothing_fits(path: &Path, folder: &Path, error: &io::Error) -> Failure {
    let (path, folder, error) = (path.display(), folder.display(), error.to_string());
    // The name of a staging folder says nothing.
    let error = error.split(" at path ").next().unwrap_or_default();
    Failure::outside(format!("{path} cannot be written: nothing can be put into the folder {folder}: {error}"))
}

/// Whether a path for output is a pipe or a device, as `/dev/stdout`.
pub(super) fn is_special(path: &Path) -> bool {
    matches!(Place::of(path), Ok(Place::Special))
}

fn is_there_already(path: &Path) -> Failure {
    Failure::misuse(
        format!("{} is there already and is not overwritten", path.display()),
        "choose another name, or remove the file",
    )
}
