//! Signals that end the program while files are being written.

use crate::cli::message;
use std::fs;
use std::path::PathBuf;
use std::process;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

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
    pub(super) fn remove(&mut self) {
        for folder in self.folders.drain(..) {
            let _ = fs::remove_dir_all(folder);
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
    known.remove();
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
