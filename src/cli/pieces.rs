use super::files::{self, Growing};
use super::message::Failure;
use crate::cores::on_all_cores;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// Where something goes that is written piece by piece.
pub(super) enum Out<'a> {
    Stdout,
    File(Growing, &'a Path),
}

impl<'a> Out<'a> {
    /// A file, or stdout for `-`.
    pub(super) fn new(place: &'a Path) -> Result<Self, Failure> {
        if place == Path::new("-") {
            return Ok(Out::Stdout);
        }
        Ok(Out::File(Growing::new(place)?, place))
    }

    /// Writes text; whether anybody wants more.
    pub(super) fn put(&mut self, text: &str) -> Result<bool, Failure> {
        match self {
            Out::Stdout => files::is_printed(text.as_bytes()),
            Out::File(file, place) => match file.write_all(text.as_bytes()) {
                Err(error) => Err(files::unwritable(place, &error)),
                Ok(()) => Ok(true),
            },
        }
    }

    /// Moves a whole file to its place.
    pub(super) fn finish(self) -> Result<(), Failure> {
        match self {
            Out::Stdout => Ok(()),
            Out::File(file, _) => file.finish(),
        }
    }
}

#[cfg(feature = "arrow")]
impl Write for Out<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match self {
            Out::Stdout => std::io::stdout().write(bytes),
            Out::File(file, _) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match self {
            Out::Stdout => std::io::stdout().flush(),
            Out::File(file, _) => file.flush(),
        }
    }
}

/// Much work of one kind, to be done in pieces.
pub(super) struct Pieces {
    /// How many things there are.
    pub count: usize,
    /// How many of them make a piece.
    pub size: usize,
    /// How many pieces for each core are in memory at a time.
    pub ahead: usize,
    /// What the things are called on a terminal, which then sees how far the work has come.
    pub unit: Option<&'static str>,
}

impl Pieces {
    /// Computes the pieces, some at a time on all cores, and hands them on in order while somebody wants more; Ctrl-C ends it.
    pub(super) fn each<P: Send>(
        &self,
        piece: impl Fn(Range<usize>) -> P + Send + Sync,
        mut put: impl FnMut(P) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        static STOPPED: AtomicBool = AtomicBool::new(false);
        // Where a handler cannot be set, Ctrl-C ends the program as it would have without one.
        let _ = ctrlc::set_handler(|| STOPPED.store(true, Ordering::Relaxed));
        let is_stopped = || STOPPED.load(Ordering::Relaxed);
        let things = |first: &usize| *first..(first + self.size).min(self.count);
        let progress = self.progress();
        for start in (0..self.count).step_by(self.size * self.window()) {
            let firsts = (start..self.count).step_by(self.size).take(self.window());
            let firsts: Vec<usize> = firsts.collect();
            for done in on_all_cores(&firsts, |first| (!is_stopped()).then(|| piece(things(first)))) {
                let Some(done) = done.filter(|_| !is_stopped()) else {
                    return Err(Failure::Interrupted);
                };
                if !put(done)? {
                    return Ok(());
                }
                progress.inc(self.size as u64);
            }
        }
        progress.finish_and_clear();
        Ok(())
    }

    /// How many pieces are in memory at a time.
    fn window(&self) -> usize {
        #[cfg(feature = "parallel")]
        let cores = rayon::current_num_threads();
        #[cfg(not(feature = "parallel"))]
        let cores = 1;
        self.ahead * cores
    }

    /// A bar on a terminal's stderr.
    fn progress(&self) -> ProgressBar {
        let unit = self.unit.filter(|_| std::io::stderr().is_terminal());
        let Some(unit) = unit else {
            return ProgressBar::hidden();
        };
        let template = format!("{{wide_bar}} {{percent}}% of {{len}} {unit}, {{eta}} left");
        let style = ProgressStyle::with_template(&template);
        ProgressBar::new(self.count as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    }
}
