//! Work on many items: in pieces on all cores, and so that a defect of the program in one of them does not end all other work.

use super::message::Failure;
use crate::cores::{cores, on_all_cores};
use indicatif::{ProgressBar, ProgressStyle};
use std::any::Any;
use std::cell::{Cell, RefCell};
use std::io::IsTerminal;
use std::ops::Range;
use std::panic::{self, AssertUnwindSafe, Location};
use std::sync::Once;

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
        let at_a_time = self.per_core * cores();
        let items = |first: &usize| *first..(first + self.size).min(self.count);
        let progress = progress(self.count as u64, self.unit);
        for start in (0..self.count).step_by(self.size * at_a_time) {
            let firsts: Vec<usize> = (start..self.count).step_by(self.size).take(at_a_time).collect();
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
}

/// A progress bar on stderr over so many items of that name, if that is a terminal; hidden without a name.
pub(super) fn progress(count: u64, unit: Option<&str>) -> ProgressBar {
    let Some(unit) = unit.filter(|_| std::io::stderr().is_terminal()) else {
        return ProgressBar::hidden();
    };
    let template = format!("{{wide_bar}} {{percent}}% of {{len}} {unit}, {{eta}} left");
    let style = ProgressStyle::with_template(&template);
    ProgressBar::new(count).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

thread_local! {
    /// Whether this thread does such work.
    static IS_CAUGHT: Cell<bool> = const { Cell::new(false) };
    /// Where it went wrong.
    static PLACE: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Does work; a panic in it becomes a message. What the work has changed must not be used after that.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let usual = panic::take_hook();
        // A panic that is caught leaves its place; any other is shown as usual.
        panic::set_hook(Box::new(move |info| match IS_CAUGHT.get() {
            true => PLACE.set(info.location().map(Location::to_string)),
            false => usual(info),
        }));
    });
    let before = IS_CAUGHT.replace(true);
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CAUGHT.set(before);
    done.map_err(|panic| {
        let place = PLACE.take().map_or_else(String::new, |place| format!(" at {place}"));
        format!("the program itself fails on it{place}: {} (please report that, with the file)", text(&*panic))
    })
}

fn text(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no reason is known")
}
