//! Work on all cores.

/// What `each` makes of the items, in their order.
#[cfg(feature = "parallel")]
pub(crate) fn on_all_cores<T: Sync, P: Send>(items: &[T], each: impl Fn(&T) -> P + Send + Sync) -> Vec<P> {
    use rayon::prelude::*;
    items.par_iter().map(each).collect()
}

/// What `each` makes of the items, in their order, on one core.
#[cfg(not(feature = "parallel"))]
pub(crate) fn on_all_cores<T, P>(items: &[T], each: impl Fn(&T) -> P) -> Vec<P> {
    items.iter().map(each).collect()
}

/// Does something with each item.
#[cfg(feature = "parallel")]
pub(crate) fn on_each_core<T: Send>(items: &mut [T], each: impl Fn(&mut T) + Send + Sync) {
    use rayon::prelude::*;
    items.par_iter_mut().for_each(each);
}

/// Does something with each item, on one core.
#[cfg(not(feature = "parallel"))]
pub(crate) fn on_each_core<T>(items: &mut [T], each: impl Fn(&mut T)) {
    items.iter_mut().for_each(each);
}
