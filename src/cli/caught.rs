//! Work on something that others have written, of which a defect of the program must not end all other work.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{self, AssertUnwindSafe, Location, PanicHookInfo};
use std::sync::Once;

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
        panic::set_hook(Box::new(move |info| note_place(info, &*usual)));
    });
    let before = IS_CAUGHT.replace(true);
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CAUGHT.set(before);
    done.map_err(|panic| {
        let place = PLACE.take().map_or_else(String::new, |place| format!(" at {place}"));
        format!("the program itself fails on it{place}: {} (please report that, with the file)", text(&*panic))
    })
}

/// Keeps the place of a panic that is caught; any other is shown as usual.
fn note_place(info: &PanicHookInfo<'_>, usual: &dyn Fn(&PanicHookInfo<'_>)) {
    if !IS_CAUGHT.get() {
        return usual(info);
    }
    PLACE.set(info.location().map(Location::to_string));
}

fn text(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("no reason is known")
}
