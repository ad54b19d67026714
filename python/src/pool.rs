//! The threads for work on all cores. A process that was forked, as `multiprocessing` does on Linux, has none of its parent's threads, and
//! would wait for them for ever; so each process has its own.

use crate::refused::Refused;
use rayon::ThreadPool;
use std::process;
use std::sync::{Arc, Mutex, PoisonError};

static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Does work that goes to all cores.
pub fn on_all_cores<P: Send>(work: impl FnOnce() -> P + Send) -> Result<P, Refused> {
    let pool = own_pool()?;
    Ok(pool.install(work))
}

fn own_pool() -> Result<Arc<ThreadPool>, Refused> {
    let mut kept = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    let own = process::id();
    if let Some((process, pool)) = kept.as_ref().filter(|(process, _)| *process == own) {
        debug_assert_eq!(*process, own);
        return Ok(pool.clone());
    }
    let pool = rayon::ThreadPoolBuilder::new().build();
    let pool = Arc::new(pool.map_err(|error| Refused::new("KinegonError", error.to_string(), None))?);
    // The parent's pool is forgotten: its threads cannot be told to end.
    std::mem::forget(kept.replace((own, pool.clone())));
    Ok(pool)
}
