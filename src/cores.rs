//! Work on all cores. What works on many items in parallel works on each of them on one core: dividing small work costs
//! more than it saves where all cores have enough to do.

#[cfg(feature = "parallel")]
use std::cell::Cell;
#[cfg(feature = "parallel")]
use std::error::Error;
#[cfg(feature = "parallel")]
use std::sync::LazyLock;

#[cfg(feature = "parallel")]
thread_local! {
    /// Whether this thread works on one of many items.
    static IS_INSIDE: Cell<bool> = const { Cell::new(false) };
}

/// Does work on one core.
#[cfg(feature = "parallel")]
fn on_one_core<P>(work: impl FnOnce() -> P) -> P {
    /// Sets it back, also where the work panics.
    struct Inside(bool);
    impl Drop for Inside {
        fn drop(&mut self) {
            IS_INSIDE.set(self.0);
        }
    }
    let _inside = Inside(IS_INSIDE.replace(true));
    work()
}

/// Whether there are threads for them: where the system gives none, as one that is short of memory, one core does all.
#[cfg(feature = "parallel")]
fn has_threads() -> bool {
    static OF_ALL: LazyLock<bool> = LazyLock::new(|| {
        let made = rayon::ThreadPoolBuilder::new().build_global();
        // The other reason for an error is that somebody has made them.
        made.err().is_none_or(|error| error.source().is_none())
    });
    rayon::current_thread_index().is_some() || *OF_ALL
}

/// How many there are.
#[cfg(all(feature = "parallel", any(feature = "cli", feature = "png")))]
pub(crate) fn cores() -> usize {
    if has_threads() { rayon::current_num_threads() } else { 1 }
}

/// How many are used.
#[cfg(all(not(feature = "parallel"), any(feature = "cli", feature = "png")))]
pub(crate) fn cores() -> usize {
    1
}

/// What `each` makes of the items, in their order.
#[cfg(feature = "parallel")]
pub(crate) fn on_all_cores<T: Sync, P: Send>(items: &[T], each: impl Fn(&T) -> P + Send + Sync) -> Vec<P> {
    use rayon::prelude::*;
    if IS_INSIDE.get() || !has_threads() {
        return items.iter().map(each).collect();
    }
    items.par_iter().map(|item| on_one_core(|| each(item))).collect()
}

/// What `each` makes of the items, in their order, on one core.
#[cfg(not(feature = "parallel"))]
pub(crate) fn on_all_cores<T, P>(items: &[T], each: impl Fn(&T) -> P) -> Vec<P> {
    items.iter().map(each).collect()
}
