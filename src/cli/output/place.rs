//! Where an output leads: through links, into folders that are not there yet, to pipes and devices.

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Write};
use std::path::{Component, MAIN_SEPARATOR, Path, PathBuf};

/// Where a file is to be.
pub(super) struct Place {
    /// A folder that is there.
    pub base: PathBuf,
    /// The path from it: folders that are not there yet, and the file's name.
    pub inside: PathBuf,
    /// The file that is there now.
    pub replaced: Option<Metadata>,
}

/// Most links on the way to a file, as Linux has it.
const LINKS: usize = 40;

impl Place {
    /// Where a path leads; the links in it are followed, so that what they show is replaced and not they. `None` for a pipe
    /// or a device: it must not be replaced by a file, so it is written directly.
    ///
    /// # Errors
    /// A folder is there, or a file in place of a folder, or a file that is write-protected.
    pub(super) fn of(path: &Path) -> io::Result<Option<Place>> {
        let (last, is_descriptor) = follow(path);
        if is_descriptor {
            return Ok(None);
        }
        // The system itself follows the links here: it may refuse those that others have planted.
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
            Ok(found) if !found.is_file() => Ok(None),
            Ok(found) if found.permissions().readonly() => {
                Err(io::Error::new(ErrorKind::PermissionDenied, "it is there already and write-protected"))
            }
            Ok(found) => {
                let file = path.canonicalize()?;
                let (Some(base), Some(name)) = (file.parent(), file.file_name()) else {
                    return Err(ErrorKind::InvalidInput.into());
                };
                Ok(Some(Place { base: base.to_owned(), inside: name.into(), replaced: Some(found) }))
            }
            Err(error) => match path.ancestors().skip(1).find(|folder| folder.is_file()) {
                Some(file) => Err(no_folder(file)),
                None if error.kind() == ErrorKind::NotFound => new_place(&last).map(Some),
                None => Err(error),
            },
        }
    }
}

fn no_folder(path: &Path) -> io::Error {
    io::Error::new(ErrorKind::NotADirectory, format!("{} is no folder", path.display()))
}

/// The place of a file that is not there.
fn new_place(path: &Path) -> io::Result<Place> {
    let is_folder = path.as_os_str().to_string_lossy().ends_with(['/', MAIN_SEPARATOR]);
    let Some(name) = path.file_name().filter(|_| !is_folder) else {
        return Err(ErrorKind::IsADirectory.into());
    };
    let (mut base, mut inside) = (PathBuf::new(), PathBuf::new());
    for part in path.parent().unwrap_or(Path::new("")).components() {
        match part {
            // Out of a folder that is not there.
            Component::ParentDir if inside.pop() => {}
            Component::Normal(folder) if inside.as_os_str().is_empty() && base.join(folder).is_dir() => {
                base.push(folder);
            }
            Component::Normal(folder) => inside.push(folder),
            other => base.push(other),
        }
    }
    if base.as_os_str().is_empty() {
        base.push(".");
    }
    if let Some(first) = inside.iter().next().map(|first| base.join(first))
        && first.symlink_metadata().is_ok()
    {
        return Err(no_folder(&first));
    }
    Ok(Place { base, inside: inside.join(name), replaced: None })
}

/// The end of the links that begin at a path, and whether they lead to an open file of this process, as `/dev/stdout`.
fn follow(path: &Path) -> (PathBuf, bool) {
    let mut at = path.to_owned();
    for _ in 0..LINKS {
        if is_descriptor(&at) {
            return (at, true);
        }
        let Ok(to) = fs::read_link(&at) else {
            break;
        };
        at = at.parent().map_or_else(|| to.clone(), |folder| folder.join(&to));
    }
    (at, false)
}

/// Whether a path is that of an open file of this process. It may be an ordinary file, and is not replaced all the same.
fn is_descriptor(path: &Path) -> bool {
    let in_process = || path.parent().and_then(|f| f.canonicalize().ok()).is_some_and(|f| f.starts_with("/proc"));
    cfg!(unix)
        && (STDOUT.iter().any(|name| path == Path::new(name))
            || path == Path::new("/dev/stderr")
            || path.starts_with("/dev/fd")
            || in_process())
}

/// Names of this process's stdout.
const STDOUT: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// Opens a pipe or a device to write into it.
pub(super) fn open_special(path: &Path) -> io::Result<Box<dyn Write + Send>> {
    // Opened anew, a file behind stdout would be written from its start.
    if STDOUT.iter().any(|name| follow(path).0 == Path::new(name)) {
        return Ok(Box::new(io::stdout()));
    }
    Ok(Box::new(File::options().append(true).open(path)?))
}
