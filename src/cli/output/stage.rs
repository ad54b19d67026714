//! Staging folders: where files are until all are complete; and the signals that end the program meanwhile.

use super::place::Place;
use crate::cli::message;
use std::fs::{self, File, Metadata};
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

/// A staging folder. Its files lie in `new`, in the folders in which they will be; what they replace lies in `old`.
pub(super) struct Stage {
    /// The folder in which it is.
    pub base: PathBuf,
    pub folder: PathBuf,
    pub units: Vec<Unit>,
}

/// A file, or a new folder with all its files, that is renamed into its place.
pub(super) struct Unit {
    /// Its path in messages.
    pub named: PathBuf,
    pub from: PathBuf,
    pub to: PathBuf,
    /// Whether it must not replace another file.
    pub is_first: bool,
    pub state: State,
}

/// Where a unit is.
pub(super) enum State {
    Staged,
    /// In its place, where nothing was.
    Added,
    /// In its place or on the way there; the file that it replaces is kept here.
    Replaces(PathBuf),
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
        let folder = builder.tempdir_in(base)?.keep();
        known.folders.push(folder.clone());
        drop(known);
        let stage = Stage { base: base.to_owned(), folder, units: Vec::new() };
        for part in ["new", "old"] {
            fs::create_dir(stage.folder.join(part))?;
        }
        Ok(stage)
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

impl Drop for Stage {
    fn drop(&mut self) {
        known().remove(&self.folder);
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

/// What a signal must know and remove.
#[derive(Default)]
pub(super) struct Known {
    pub folders: Vec<PathBuf>,
    /// Whether a set of files has been put into its places.
    pub is_complete: bool,
}

static KNOWN: Mutex<Known> = Mutex::new(Known { folders: Vec::new(), is_complete: false });

/// The staging folders that are there. As long as the guard lives no signal removes them.
pub(super) fn known() -> MutexGuard<'static, Known> {
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Known {
    /// Removes a staging folder, if it is not to be kept.
    pub(super) fn remove(&mut self, folder: &Path) {
        if let Some(at) = self.folders.iter().position(|known| known == folder) {
            let _ = fs::remove_dir_all(self.folders.swap_remove(at));
        }
    }
}

/// Does not return while a signal ends the program: a file that is missing for that reason is no error.
pub(in crate::cli) fn wait_if_stopped() {
    drop(known());
}

/// Lets signals remove the staging folders before they end the program.
pub(super) fn watch() {
    static ONCE: Once = Once::new();
    ONCE.call_once(listen);
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
fn listen() {
    use signal_hook::consts::signal::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};
    let hangup = (!ignores_hangup()).then_some(SIGHUP);
    // Without a handler a signal ends the program at once.
    let signals = [SIGINT, SIGTERM, SIGQUIT, SIGXCPU].into_iter().chain(hangup);
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else {
        return;
    };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // The exit code by which shells report a program that a signal has ended.
            stop(128 + signal);
        }
    });
}

#[cfg(not(unix))]
fn listen() {
    let _ = ctrlc::set_handler(|| stop(130));
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
