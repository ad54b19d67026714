//! Staging folders: where files are until all are complete, how they are renamed into their places, and the signals that end the
//! program meanwhile.

use super::place::Place;
use crate::cli::message::{self, Failure};
use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use tempfile::TempPath;

/// A staging folder. Its files lie in `new`, in the folders in which they will be; what they replace lies in `old`.
pub(super) struct Stage {
    /// The folder in which it is.
    pub base: PathBuf,
    folder: PathBuf,
    /// Held as long as this program runs, where the file system can do that.
    lock: Option<File>,
    units: Vec<Unit>,
}

/// A file, or a new folder with all its files, that is renamed into its place.
struct Unit {
    /// Its path in messages.
    named: PathBuf,
    from: PathBuf,
    to: PathBuf,
    /// Whether it must not replace another file.
    is_first: bool,
    state: State,
}

/// Where a unit is.
enum State {
    Staged,
    /// In its place, where nothing was.
    Added,
    /// In its place or on the way there; the file that it replaces is kept here.
    Replaces(PathBuf),
}

impl Stage {
    /// A new staging folder in the folder `base`.
    pub(super) fn new(base: &Path) -> io::Result<Stage> {
        watch()?;
        let mut known = known();
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).rand_bytes(RANDOM);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
        let folder = builder.tempdir_in(base)?.keep();
        known.folders.push(folder.clone());
        drop(known);
        // Held before there is `old`, without which nobody takes the folder for one that was left.
        let lock = File::create_new(folder.join(LOCK)).ok().filter(|lock| lock.try_lock().is_ok());
        let stage = Stage { base: base.to_owned(), folder, lock, units: Vec::new() };
        for part in ["new", "old"] {
            fs::create_dir(stage.folder.join(part))?;
        }
        stage.remove_others();
        Ok(stage)
    }

    /// Removes what was left beside it: programs that were ended at once, for want of memory or by `kill -9`, no longer hold
    /// theirs. What has replaced files is kept, with them.
    fn remove_others(&self) {
        let base = if self.base == Path::new("") { Path::new(".") } else { &self.base };
        for entry in fs::read_dir(base).into_iter().flatten().flatten() {
            let name = entry.file_name();
            let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
            let folder = entry.path();
            if random.is_none_or(|random| random.len() != RANDOM) || !are_ours([&self.folder, &folder]) {
                continue;
            }
            let has_old = fs::read_dir(folder.join("old")).map_or(true, |mut old| old.next().is_some());
            let is_left = || File::open(folder.join(LOCK)).is_ok_and(|lock| lock.try_lock().is_ok());
            if !has_old && is_left() {
                let _ = fs::remove_dir_all(folder);
            }
        }
    }

    /// Creates a file with the mode of the one that it will replace, and with its owner where that is allowed. `path` is
    /// its name in messages.
    pub(super) fn create(&mut self, path: &Path, place: &Place, is_first: bool) -> io::Result<File> {
        // A new folder is renamed once with all that is in it.
        let top = place.inside.iter().next().map_or(Path::new(""), Path::new);
        let (to, is_file) = (self.base.join(top), top == place.inside);
        // One file under two names is that of the last.
        self.units.retain(|unit| unit.to != to);
        self.units.push(Unit {
            named: if is_file { path.to_owned() } else { to.clone() },
            from: self.folder.join("new").join(top),
            to,
            is_first: is_first && is_file,
            state: State::Staged,
        });
        let path = self.folder.join("new").join(&place.inside);
        // A signal that removes the folder must not find it growing.
        let _known = known();
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        if path.is_file() {
            fs::remove_file(&path)?;
        }
        let file = File::create_new(path)?;
        if let Some(replaced) = &place.replaced {
            keep_owner(&file, replaced);
            file.set_permissions(replaced.permissions())?;
        }
        Ok(file)
    }
}

/// Removes the folder, if it is not to be kept.
impl Drop for Stage {
    fn drop(&mut self) {
        let mut known = known();
        // Some systems remove no file that is open.
        self.lock = None;
        if let Some(at) = known.folders.iter().position(|folder| *folder == self.folder) {
            let _ = fs::remove_dir_all(known.folders.swap_remove(at));
        }
    }
}

/// Whether paths lead to folders of the same person, and not to links.
fn are_ours(folders: [&Path; 2]) -> bool {
    let found = folders.map(|folder| folder.symlink_metadata().ok().filter(Metadata::is_dir));
    #[cfg(unix)]
    let found = found.map(|found| found.map(|found| std::os::unix::fs::MetadataExt::uid(&found)));
    #[cfg(not(unix))]
    let found = found.map(|found| found.map(drop));
    found[0].is_some() && found[0] == found[1]
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

pub(super) fn is_there_already(path: &Path) -> Failure {
    Failure::misuse(
        format!("{} is there already and is not overwritten", path.display()),
        "choose another name, or remove the file",
    )
}

/// Names of staging folders begin with this, and end with so many letters by chance.
const PREFIX: &str = ".kinegon-";
const RANDOM: usize = 12;
/// The file in a staging folder that its program holds.
const LOCK: &str = "lock";

/// What a signal must know and remove.
#[derive(Default)]
struct Known {
    folders: Vec<PathBuf>,
    /// Whether a set of files has been put into its places.
    is_complete: bool,
}

static KNOWN: Mutex<Known> = Mutex::new(Known { folders: Vec::new(), is_complete: false });

/// The staging folders that are there. As long as the guard lives no signal removes them.
fn known() -> MutexGuard<'static, Known> {
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Does not return while a signal ends the program: a file that is missing for that reason is no error.
pub(in crate::cli) fn wait_if_stopped() {
    drop(known());
}

/// Lets signals remove the staging folders before they end the program.
fn watch() -> io::Result<()> {
    static LISTENS: OnceLock<Result<(), (ErrorKind, String)>> = OnceLock::new();
    let listens = LISTENS.get_or_init(|| listen().map_err(|error| (error.kind(), error.to_string())));
    listens.clone().map_err(|(kind, told)| io::Error::new(kind, told))
}

/// Removes what is not complete and ends the program with this exit code.
fn stop(exit_code: i32) -> ! {
    // The guard lives until the end: the work that goes on meanwhile can stage no more files, and none are renamed.
    let mut known = known();
    for folder in known.folders.drain(..) {
        let _ = fs::remove_dir_all(folder);
    }
    message::stopped(known.is_complete);
    process::exit(exit_code)
}

#[cfg(unix)]
fn listen() -> io::Result<()> {
    use signal_hook::consts::signal::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};
    let hangup = (!ignores_hangup()).then_some(SIGHUP);
    // Without a handler a signal ends the program at once.
    let signals = [SIGINT, SIGTERM, SIGQUIT, SIGXCPU].into_iter().chain(hangup);
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else {
        return Ok(());
    };
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            // The exit code by which shells report a program that a signal has ended.
            stop(128 + signal);
        }
    };
    let no_thread =
        |error: io::Error| io::Error::new(error.kind(), "the system is short of memory, and gives no thread");
    std::thread::Builder::new().spawn(wait).map(drop).map_err(no_thread)
}

#[cfg(not(unix))]
fn listen() -> io::Result<()> {
    let _ = ctrlc::set_handler(|| stop(130));
    Ok(())
}

/// Whether the program was started so that it goes on when its terminal is closed, as by `nohup`. Only Linux tells.
#[cfg(unix)]
fn ignores_hangup() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_some_and(|mask| mask >> (signal_hook::consts::SIGHUP - 1) & 1 == 1)
}

/// Lets a limit on the size of files be an error like a full disk, in place of a signal that ends the program.
pub(in crate::cli) fn survive_size_limits() {
    #[cfg(unix)]
    {
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
    }
}
