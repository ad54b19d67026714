use super::message::{Failure, Source};
use crate::scene::MAX_BYTES;
use crate::text;
use encoding_rs::{Encoding, UTF_16BE, UTF_16LE, WINDOWS_1252};
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

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
        Failure::misuse(format!("{name} cannot be read: {error}"), hint)
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
        return Err(Failure::misuse(
            format!("{name} is larger than {} MB, which no {what} is", MAX_BYTES >> 20),
            "is this the right file?",
        ));
    }
    Ok((name, bytes))
}

/// Reads the text of a form, which a spreadsheet may have saved in another encoding than UTF-8.
pub(super) fn read_form(path: &Path) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes("form", path)?;
    let Some(text) = decoded(bytes) else {
        let hint = "save the form as CSV UTF-8 or as JSON";
        return Err(Failure::misuse(format!("{name} is no text"), hint));
    };
    Ok(Source { name, text })
}

/// Part of the bytes at which it is seen whether every other one is zero.
const LOOKED_AT: usize = 4096;

/// The text of these bytes: in the encoding that a byte order mark at their start names, else UTF-8, UTF-16 by its
/// zeros, or else Windows-1252, which spreadsheets in Western Europe and America write. `None` for bytes of no text.
fn decoded(bytes: Vec<u8>) -> Option<String> {
    let marked = Encoding::for_bom(&bytes).map(|(encoding, _)| encoding);
    let text = match marked.or_else(|| by_zeros(&bytes)) {
        Some(encoding) => encoding.decode(&bytes).0.into_owned(),
        None => match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => WINDOWS_1252.decode(error.as_bytes()).0.into_owned(),
        },
    };
    let is_text = !text.contains(|c: char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{b}' | '\u{c}'));
    is_text.then_some(text)
}

/// UTF-16 without a mark: its Latin letters and digits leave every other byte zero.
fn by_zeros(bytes: &[u8]) -> Option<&'static Encoding> {
    let bytes = &bytes[..bytes.len().min(LOOKED_AT)];
    let zeros = |first: usize| bytes.iter().skip(first).step_by(2).filter(|&&byte| byte == 0).count();
    let [even, odd] = [zeros(0), zeros(1)];
    match bytes.len() / 2 {
        half if half > 1 && odd > half / 2 && even == 0 => Some(UTF_16LE),
        half if half > 1 && even > half / 2 && odd == 0 => Some(UTF_16BE),
        _ => None,
    }
}

/// Reads a text from a file, or from stdin for `-`; `what` is its name in messages.
pub(super) fn read_text(what: &str, path: &Path) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes(what, path)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::misuse(
            format!("{name} is not text in UTF-8: byte {at} does not belong"),
            format!("save the {what} as UTF-8 text"),
        )
    })?;
    Ok(Source { name, text })
}

/// Prints text for people on stdout, without anything in it that a terminal obeys.
pub(super) fn print_text(text: &str) -> Result<(), Failure> {
    print(text::on_a_terminal(text).as_bytes())
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
        Err(error) => Err(Failure::outside(format!("stdout cannot be written: {error}"))),
    }
}

/// The paths of what is in a folder.
pub(super) fn entries(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error| Failure::unclear(format!("{} cannot be listed: {error}", folder.display()));
    let entries = fs::read_dir(folder).map_err(failed)?;
    entries.map(|entry| Ok(entry.map_err(failed)?.path())).collect()
}

/// Refuses to write over the file `input` that was read; `what` is its name in messages.
pub(super) fn refuse_overwriting(what: &str, input: &Path, output: &Path) -> Result<(), Failure> {
    if is_same(input, output) {
        let message = format!("{} is the {what} itself and is not overwritten", output.display());
        let hint = "choose another output";
        return Err(Failure::misuse(message, hint));
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
    Failure::outside(format!("{} cannot be written: {error}", place.display()))
}
