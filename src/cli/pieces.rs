use super::files;
use super::message::Failure;
use super::output::{FileSet, Stream};
use crate::cores::on_all_cores;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::Path;

/// A file or stdout that is written piece by piece.
pub(super) enum Output {
    Stdout,
    File(Stream),
}

impl Output {
    /// A file of a set, or stdout for `-`.
    pub(super) fn new(files: &mut FileSet, place: &Path) -> Result<Output, Failure> {
        if place == Path::new("-") {
            return Ok(Output::Stdout);
        }
        Ok(Output::File(files.begin(place)?))
    }

    /// Writes text; false if the reader has closed stdout.
    pub(super) fn put(&mut self, text: &str) -> Result<bool, Failure> {
        match self {
            Output::Stdout => files::try_print(text.as_bytes()),
            Output::File(file) => match file.write_all(text.as_bytes()) {
                Err(error) => Err(files::unwritable(file.path(), &error)),
                Ok(()) => Ok(true),
            },
        }
    }

    /// Hands a complete file over to the disk. It is in its place when its set is finished.
    pub(super) fn end(self) -> Result<(), Failure> {
        match self {
            Output::Stdout => Ok(()),
            Output::File(file) => file.end(),
        }
    }
}

#[cfg(feature = "arrow")]
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match self {
            Output::Stdout => std::io::stdout().write(bytes),
            Output::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match self {
            Output::Stdout => std::io::stdout().flush(),
            Output::File(file) => file.flush(),
        }
    }
}

/// A number of items that are computed in pieces.
pub(super) struct Pieces {
    /// Number of items.
    pub count: usize,
    /// Items in a piece.
    pub size: usize,
    /// Pieces in memory at a time, for each core.
    pub per_core: usize,
    /// Name of the items in the progress bar; `None` for no bar.
    pub unit: Option<&'static str>,
}

impl Pieces {
    /// Computes the pieces on all cores and passes them to `put` in order, until `put` returns false.
    pub(super) fn each<P: Send>(
        &self,
        piece: impl Fn(Range<usize>) -> P + Send + Sync,
        mut put: impl FnMut(P) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let items = |first: &usize| *first..(first + self.size).min(self.count);
        let progress = self.progress();
        for start in (0..self.count).step_by(self.size * self.window()) {
            let firsts: Vec<usize> = (start..self.count).step_by(self.size).take(self.window()).collect();
            for done in on_all_cores(&firsts, |first| piece(items(first))) {
                if !put(done)? {
                    return Ok(());
                }
                progress.inc(self.size as u64);
            }
        }
        progress.finish_and_clear();
        Ok(())
    }

    /// Number of pieces in memory at a time.
    fn window(&self) -> usize {
        #[cfg(feature = "parallel")]
        let cores = rayon::current_num_threads();
        #[cfg(not(feature = "parallel"))]
        let cores = 1;
        self.per_core * cores
    }

    /// A progress bar on stderr, if that is a terminal.
    fn progress(&self) -> ProgressBar {
        let Some(unit) = self.unit.filter(|_| std::io::stderr().is_terminal()) else {
            return ProgressBar::hidden();
        };
        let template = format!("{{wide_bar}} {{percent}}% of {{len}} {unit}, {{eta}} left");
        let style = ProgressStyle::with_template(&template);
        ProgressBar::new(self.count as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    }
}
