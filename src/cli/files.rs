use super::message::Failure;
use crate::scene::MAX_BYTES;
use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// The text of a scene, or of another file that is read, and where it came from.
#[derive(Clone, Debug)]
pub(super) struct Source {
    /// The file's name, or `stdin`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Reads a scene's text from a file, or from stdin for `-`.
pub(super) fn read(path: &Path) -> Result<Source, Failure> {
    read_text("scene", path)
}

/// Reads the text of what is called `what` from a file, or from stdin for `-`.
pub(super) fn read_text(what: &str, path: &Path) -> Result<Source, Failure> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "stdin".to_owned() } else { path.display().to_string() };
    let refuse = |error: io::Error| {
        let hint = format!("give the path of a {what} file, or `-` to read one from stdin");
        Failure::Misuse(format!("{name} cannot be read: {error}"), Some(hint))
    };
    let mut bytes = Vec::new();
    // One byte more than is allowed, so that a larger file is seen without reading it all.
    let limit = MAX_BYTES as u64 + 1;
    if from_stdin {
        io::stdin().take(limit).read_to_end(&mut bytes)
    } else {
        fs::File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    }
    .map_err(refuse)?;
    if bytes.len() > MAX_BYTES {
        return Err(Failure::Misuse(
            format!("{name} is larger than {} MB, which no {what} is", MAX_BYTES >> 20),
            Some("is this the right file?".into()),
        ));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::Misuse(
            format!("{name} is not text in UTF-8: byte {at} does not belong"),
            Some(format!("save the {what} as UTF-8 text")),
        )
    })?;
    Ok(Source { name, text })
}

/// Writes bytes to stdout; a reader that has gone away is no failure.
pub(super) fn print(bytes: &[u8]) -> Result<(), Failure> {
    is_printed(bytes).map(drop)
}

/// Writes bytes to stdout, and says whether anybody still reads them.
pub(super) fn is_printed(bytes: &[u8]) -> Result<bool, Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(Failure::Outside(format!("stdout cannot be written: {error}"))),
    }
}

/// Refuses to write over what was read.
pub(super) fn keep_input(what: &str, input: &Path, output: &Path) -> Result<(), Failure> {
    let canonical = |path: &Path| path.canonicalize().ok();
    if canonical(input).is_some_and(|input| canonical(output) == Some(input)) {
        let message = format!("{} is the {what} itself and is not overwritten", output.display());
        let hint = "choose another output";
        return Err(Failure::Misuse(message, Some(hint.into())));
    }
    Ok(())
}

/// A file that is written piece by piece: beside its place first, moved there when it is whole, gone when it is not.
pub(super) struct Growing {
    place: PathBuf,
    beside: PathBuf,
    file: Option<BufWriter<fs::File>>,
}

impl Growing {
    pub(super) fn new(place: &Path) -> Result<Growing, Failure> {
        let failed = |error| unwritable(place, &error);
        if place.is_dir() {
            return Err(failed(io::ErrorKind::IsADirectory.into()));
        }
        if let Some(folder) = place.parent() {
            fs::create_dir_all(folder).map_err(failed)?;
        }
        // A device or a pipe must not be replaced by a file.
        let special = fs::metadata(place).is_ok_and(|found| !found.is_file());
        let beside = if special { place.to_owned() } else { beside(place) };
        let file = fs::File::create(&beside).map_err(failed)?;
        Ok(Growing { place: place.to_owned(), beside, file: Some(BufWriter::new(file)) })
    }

    /// Moves the whole file to its place.
    pub(super) fn finish(mut self) -> Result<(), Failure> {
        let written = self.file.take().map_or(Ok(()), |mut file| file.flush());
        let moved = written.and_then(|()| match self.beside == self.place {
            true => Ok(()),
            false => fs::rename(&self.beside, &self.place),
        });
        moved.map_err(|error| unwritable(&self.place, &error))
    }
}

impl Write for Growing {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.as_mut().map_or(Ok(0), |file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_mut().map_or(Ok(()), |file| file.flush())
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        // After it has been moved there is nothing left here.
        if self.beside != self.place {
            let _ = fs::remove_file(&self.beside);
        }
    }
}

/// Where a file stands until it is whole.
fn beside(place: &Path) -> PathBuf {
    let mut beside = place.to_owned().into_os_string();
    beside.push(format!(".{}.part", std::process::id()));
    beside.into()
}

pub(super) fn unwritable(place: &Path, error: &io::Error) -> Failure {
    Failure::Outside(format!("{} cannot be written: {error}", place.display()))
}

/// Writes files, each whole or not at all: beside its place first, then moved there.
pub(super) fn write(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Failure> {
    for (path, bytes) in files {
        let mut file = Growing::new(path)?;
        let written = file.write_all(bytes);
        written.map_err(|error| unwritable(path, &error))?;
        file.finish()?;
    }
    Ok(())
}

/// Writes a file that is not there yet; one that is there stays as it is.
pub(super) fn write_new(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error: io::Error| match error.kind() {
        io::ErrorKind::AlreadyExists => Failure::Misuse(
            format!("{} is there already and is not overwritten", path.display()),
            Some("choose another name, or remove the file".into()),
        ),
        _ => unwritable(path, &error),
    };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(failed)?;
    }
    let mut file = fs::File::create_new(path).map_err(failed)?;
    file.write_all(bytes).map_err(|error| {
        let _ = fs::remove_file(path);
        failed(error)
    })
}
