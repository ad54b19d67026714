use super::message::{Failure, Source, refuse};
use super::output::{Stream, write_file};
use super::tables::put_tables;
use crate::scene::{MAX_BYTES, Scene};
use crate::text;
use encoding_rs::{Encoding, UTF_16BE, UTF_16LE, WINDOWS_1252};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Reads a scene's text from a file, or from stdin for `-`.
pub(super) fn read(path: &Path) -> Result<Source, Failure> {
    put_tables(read_text("scene", path)?, path)
}

/// Reads a scene from a file, or from stdin for `-`.
pub(super) fn read_scene(path: &Path) -> Result<(Source, Scene), Failure> {
    let source = read(path)?;
    let scene = source.checked(Scene::read(&source.text))?;
    Ok((source, scene))
}

/// Most bytes of a text.
pub(super) const MOST: u64 = MAX_BYTES as u64;

/// Why a file that no argument names is not read. Displayed as what is said of the file: `is a folder`.
#[derive(Debug, thiserror::Error)]
pub(super) enum Unread {
    #[error("is outside of its folder")]
    Outside,
    #[error("is a folder")]
    Folder,
    #[error("is a pipe or a device, and no file")]
    Special,
    #[error("is larger than {} MB", .0 >> 20)]
    Large(u64),
    #[error("cannot be read: {0}")]
    Failed(#[from] io::Error),
}

/// The bytes of a file that no argument names: another file names it, or it was found in a folder. Such a path may lead anywhere, and
/// was written by somebody else. So `-` is a file's name and not stdin; what is no regular file is not opened, for that could block or
/// never end; the file has `most` bytes at most; and `below` is the folder in which it must lie, after all links, if there is one.
pub(super) fn read_unnamed(path: &Path, below: Option<&Path>, most: u64) -> Result<Vec<u8>, Unread> {
    if below.is_some_and(|folder| leads_outside(path, folder)) {
        return Err(Unread::Outside);
    }
    if regular(path)?.len() > most {
        return Err(Unread::Large(most));
    }
    let mut bytes = Vec::new();
    // Somebody may write to it in the meantime.
    fs::File::open(path)?.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(Unread::Large(most)) } else { Ok(bytes) }
}

/// What is known of a file that no argument names, before it is opened; refuses what is no regular file.
pub(super) fn regular(path: &Path) -> Result<fs::Metadata, Unread> {
    let found = fs::metadata(path)?;
    match found.is_file() {
        true => Ok(found),
        false => Err(if found.is_dir() { Unread::Folder } else { Unread::Special }),
    }
}

/// Reads a file, or stdin for `-`: its name in messages and its bytes.
fn read_bytes(what: &str, path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "stdin".to_owned() } else { path.display().to_string() };
    let mut bytes = Vec::new();
    // One byte more than is allowed, so that a larger file is refused without reading all of it.
    let limit = MOST + 1;
    let read = match from_stdin {
        true => io::stdin().take(limit).read_to_end(&mut bytes),
        false => fs::File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes)),
    };
    if let Err(error) = read {
        let hint = format!("give the path of a {what} file, or `-` to read one from stdin");
        return refuse(format!("{name} cannot be read: {error}"), hint);
    }
    if bytes.len() > MAX_BYTES {
        let message = format!("{name} is larger than {} MB, which no {what} is", MAX_BYTES >> 20);
        return refuse(message, "is this the right file?");
    }
    Ok((name, bytes))
}

/// Reads the text of a form, which a spreadsheet may have saved in another encoding than UTF-8.
pub(super) fn read_form(path: &Path) -> Result<Source, Failure> {
    let (name, bytes) = read_bytes("form", path)?;
    match decoded(bytes) {
        Some(text) => Ok(Source::new(name, text)),
        None => refuse(format!("{name} is no text"), "save the form as CSV UTF-8 or as JSON"),
    }
}

/// Part of the bytes at which it is seen whether every other one is zero.
const LOOKED_AT: usize = 4096;

/// The text of these bytes: in the encoding that a byte order mark at their start names, else UTF-8, UTF-16 by its
/// zeros, or else Windows-1252, which spreadsheets in Western Europe and America write. `None` for bytes of no text.
pub(super) fn decoded(bytes: Vec<u8>) -> Option<String> {
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
    utf8(what, name, bytes)
}

/// The text of a file of this name whose bytes were read.
pub(super) fn utf8(what: &str, name: String, bytes: Vec<u8>) -> Result<Source, Failure> {
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let message = format!("{name} is not text in UTF-8: byte {at} does not belong");
            refuse(message, format!("save the {what} as UTF-8 text"))
        }
    }
}

/// Prints text for people on stdout, without anything in it that a terminal obeys.
pub(super) fn print_text(text: &str) -> Result<(), Failure> {
    print(text::on_a_terminal(text).as_bytes())
}

/// Writes bytes to stdout. It is no failure if the reader has closed it.
pub(super) fn print(bytes: &[u8]) -> Result<(), Failure> {
    Stream::stdout().put(bytes).map(drop)
}

/// Writes a file, or to stdout for `-`.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if path == Path::new("-") { print(bytes) } else { write_file(path, bytes) }
}

/// The paths of what is in a folder.
pub(super) fn entries(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error| Failure::unclear(format!("{} cannot be listed: {error}", folder.display()));
    let entries = fs::read_dir(folder).map_err(failed)?;
    entries.map(|entry| Ok(entry.map_err(failed)?.path())).collect()
}

/// Refuses to write over the file `input` that was read; `what` is its name in messages.
pub(super) fn refuse_overwriting(what: &str, input: &Path, output: &Path) -> Result<(), Failure> {
    if !is_same(input, output) {
        return Ok(());
    }
    refuse(format!("{} is the {what} itself and is not overwritten", output.display()), "choose another output")
}

/// Whether two paths lead to the same existing file.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(|path| path.canonicalize().ok());
    one.is_some() && one == other
}

/// Whether an existing file is in a folder or in one below it; the empty path is the folder in which the program runs.
pub(super) fn is_below(file: &Path, folder: &Path) -> bool {
    let folder = if folder == Path::new("") { Path::new(".") } else { folder };
    let [file, folder] = [file, folder].map(|path| path.canonicalize().ok());
    file.zip(folder).is_some_and(|(file, folder)| file.starts_with(folder))
}

/// Whether a path in somebody else's folder is a link that leads out of it: what stands there is not read.
pub(super) fn leads_outside(path: &Path, folder: &Path) -> bool {
    path.exists() && !is_below(path, folder)
}

/// Whether a path for output is a folder: an existing one, or one whose name ends in `/`.
pub(super) fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with('/')
}
