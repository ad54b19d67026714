use super::message::Failure;
use crate::scene::MAX_BYTES;
use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

/// The text of a file that was read.
#[derive(Clone, Debug)]
pub(super) struct Source {
    /// The file's name, or `stdin`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

impl Source {
    /// The failure of an error in this text.
    pub(super) fn fail(&self, error: impl Into<crate::Error>) -> Failure {
        Failure::Scene(self.clone(), Box::new(error.into()))
    }
}

/// Reads a scene's text from a file, or from stdin for `-`.
pub(super) fn read(path: &Path) -> Result<Source, Failure> {
    read_text("scene", path)
}

/// Reads a file, or stdin for `-`: its name in messages and its bytes.
fn read_bytes(what: &str, path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "stdin".to_owned() } else { path.display().to_string() };
    let refuse = |error: io::Error| {
        let hint = format!("give the path of a {what} file, or `-` to read one from stdin");
        Failure::Misuse(format!("{name} cannot be read: {error}"), Some(hint))
    };
    let mut bytes = Vec::new();
    // One byte more than is allowed, so that a larger file is refused without reading all of it.
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
    Ok((name, bytes))
}

/// Reads the text of a form, which a spreadsheet may have saved in another encoding than UTF-8.
pub(super) fn read_form(path: &Path) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes("form", path)?;
    let Some(text) = super::decoding::decoded(bytes) else {
        let hint = "save the form as CSV UTF-8 or as JSON";
        return Err(Failure::Misuse(format!("{name} is no text"), Some(hint.into())));
    };
    Ok(Source { name, text })
}

/// Reads a text from a file, or from stdin for `-`; `what` is its name in messages.
pub(super) fn read_text(what: &str, path: &Path) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes(what, path)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::Misuse(
            format!("{name} is not text in UTF-8: byte {at} does not belong"),
            Some(format!("save the {what} as UTF-8 text")),
        )
    })?;
    Ok(Source { name, text })
}

/// Writes bytes to stdout. It is no failure if the reader has closed it.
pub(super) fn print(bytes: &[u8]) -> Result<(), Failure> {
    try_print(bytes).map(drop)
}

/// Writes bytes to stdout; false if the reader has closed it.
pub(super) fn try_print(bytes: &[u8]) -> Result<bool, Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(Failure::Outside(format!("stdout cannot be written: {error}").into())),
    }
}

/// Refuses to write over the file `input` that was read; `what` is its name in messages.
pub(super) fn refuse_overwriting(what: &str, input: &Path, output: &Path) -> Result<(), Failure> {
    if is_same(input, output) {
        let message = format!("{} is the {what} itself and is not overwritten", output.display());
        let hint = "choose another output";
        return Err(Failure::Misuse(message, Some(hint.into())));
    }
    Ok(())
}

/// Whether two paths lead to the same existing file.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(|path| path.canonicalize().ok());
    one.is_some() && one == other
}

/// Whether a path for output is a folder: an existing one, or one whose name ends in `/`.
pub(super) fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with('/')
}

/// The failure to write an output.
pub(super) fn unwritable(place: &Path, error: &io::Error) -> Failure {
    Failure::Outside(format!("{} cannot be written: {error}", place.display()).into())
}
