//! Files that are written together: all of them, or none.
//!
//! Each file is written into a *staging folder* beside the place where it is to be, with a name that nobody can guess and
//! open to nobody else. When all are complete and on the disk they are renamed into their places (`stage`). What fails before, and
//! signals, remove the staging folder: nothing new is left, and what was there is unchanged. What remains: files in different places are
//! renamed one after the other, so a power cut between two renames leaves some of the new and some of the old; and what ends the program
//! at once (`kill -9`, want of memory) leaves a staging folder, which the next program that writes there removes.

mod place;
mod stage;

pub(super) use self::stage::{survive_size_limits, wait_if_stopped};

use self::place::{Place, open_special};
use self::stage::{Stage, is_there_already};
use super::message::Failure;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Files that are written together. Nothing is in its place before [`FileSet::finish`].
#[derive(Default)]
pub struct FileSet {
    stages: Vec<Stage>,
    /// What goes to pipes and devices, which cannot be replaced.
    direct: Vec<(PathBuf, Vec<u8>)>,
}

impl FileSet {
    /// Writes a file, in place of the one that is there.
    pub fn add(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        self.write(path, bytes, false)
    }

    /// Writes files, in place of those that are there.
    pub(super) fn add_all(&mut self, files: &[(PathBuf, Vec<u8>)]) -> Result<(), Failure> {
        files.iter().try_for_each(|(path, bytes)| self.add(path, bytes))
    }

    /// Writes a file that does not exist yet; an existing one is refused.
    pub fn add_first(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        if path.symlink_metadata().is_ok() && !is_stream(path) {
            return Err(is_there_already(path));
        }
        self.write(path, bytes, true)
    }

    fn write(&mut self, path: &Path, bytes: &[u8], is_first: bool) -> Result<(), Failure> {
        match place_of(path)? {
            Some(place) => self.open(path, &place, is_first)?.whole(bytes)?,
            None => self.direct.push((path.to_owned(), bytes.to_owned())),
        }
        Ok(())
    }

    /// Begins a file that is written piece by piece, or `-` for stdout; [`Stream::end`] must come before [`FileSet::finish`].
    pub(super) fn begin(&mut self, path: &Path) -> Result<Stream, Failure> {
        if path == Path::new("-") {
            return Ok(Stream::stdout());
        }
        match place_of(path)? {
            Some(place) => self.open(path, &place, false),
            None => Stream::special(path),
        }
    }

    /// Opens a file in the staging folder beside its place.
    fn open(&mut self, path: &Path, place: &Place, is_first: bool) -> Result<Stream, Failure> {
        let stage = match self.stages.iter().position(|stage| stage.base == place.base) {
            Some(stage) => stage,
            None => {
                self.stages.push(Stage::new(&place.base).map_err(|error| nothing_fits(path, &place.base, &error))?);
                self.stages.len() - 1
            }
        };
        let file = self.stages[stage].create(path, place, is_first);
        file.and_then(|file| Stream::file(path, file)).map_err(|error| Failure::unwritable(path, &error))
    }

    /// Puts all files into their places. If that fails, none of them is there.
    pub fn finish(self) -> Result<(), Failure> {
        self.direct.iter().try_for_each(|(path, bytes)| Stream::special(path)?.whole(bytes))?;
        stage::commit(self.stages)
    }
}

/// A file of a set, a pipe, a device or stdout, which is written piece by piece.
pub(super) struct Stream {
    /// Its path as the person wrote it.
    named: PathBuf,
    to: BufWriter<Box<dyn Write + Send>>,
    /// The file itself, if it is one of a set.
    file: Option<File>,
    is_stdout: bool,
}

impl Stream {
    fn file(path: &Path, file: File) -> io::Result<Stream> {
        let to = BufWriter::new(Box::new(file.try_clone()?) as _);
        Ok(Stream { named: path.to_owned(), to, file: Some(file), is_stdout: false })
    }

    fn special(path: &Path) -> Result<Stream, Failure> {
        let to = open_special(path).map_err(|error| Failure::unwritable(path, &error))?;
        Ok(Stream { named: path.to_owned(), to: BufWriter::new(to), file: None, is_stdout: false })
    }

    pub(super) fn stdout() -> Stream {
        Stream { named: "stdout".into(), to: BufWriter::new(Box::new(io::stdout())), file: None, is_stdout: true }
    }

    /// Writes bytes; false if the reader has closed stdout, which is no failure.
    pub(super) fn put(&mut self, bytes: &[u8]) -> Result<bool, Failure> {
        // A reader of stdout sees at once what there is.
        let written = self.to.write_all(bytes).and_then(|()| if self.is_stdout { self.to.flush() } else { Ok(()) });
        match written {
            Ok(()) => Ok(true),
            Err(error) if self.is_stdout && error.kind() == ErrorKind::BrokenPipe => Ok(false),
            Err(error) => Err(Failure::unwritable(&self.named, &error)),
        }
    }

    fn whole(mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.put(bytes)?;
        self.end()
    }

    /// Hands a complete file over to the disk. It is in its place when its set is finished.
    pub(super) fn end(mut self) -> Result<(), Failure> {
        let written = self.to.flush().and_then(|()| self.file.map_or(Ok(()), |file| file.sync_all()));
        written.map_err(|error| Failure::unwritable(&self.named, &error))
    }
}

#[cfg(feature = "arrow")]
impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.to.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// Writes one file, in place of the one that is there.
pub(super) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut files = FileSet::default();
    files.add(path, bytes)?;
    files.finish()
}

fn place_of(path: &Path) -> Result<Option<Place>, Failure> {
    Place::of(path).map_err(|error| Failure::unwritable(path, &error))
}

fn nothing_fits(path: &Path, folder: &Path, error: &io::Error) -> Failure {
    let (path, folder, error) = (path.display(), folder.display(), error.to_string());
    // The name of a staging folder says nothing.
    let error = error.split(" at path ").next().unwrap_or_default();
    Failure::outside(format!("{path} cannot be written: nothing can be put into the folder {folder}: {error}"))
}

/// Whether an output is no file: `-` for stdout, a pipe or a device, as `/dev/stdout`.
pub(super) fn is_stream(path: &Path) -> bool {
    path == Path::new("-") || matches!(Place::of(path), Ok(None))
}
