//! The threads that work: a pool for each process, since a forked process has the pool of its parent without its threads.

use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::fault::Fault;

/// Bytes of stack of each thread: as much as the main thread of a program has.
pub const STACK: usize = 8 << 20;

static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The pool of this process, of `RAYON_NUM_THREADS` threads or else one for each core.
pub fn pool() -> Result<Arc<ThreadPool>, Fault> {
    let own = std::process::id();
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, pool)) = held.as_ref().filter(|(process, _)| *process == own) {
        return Ok(pool.clone());
    }
    let built = ThreadPoolBuilder::new().stack_size(STACK).build();
    let pool = Arc::new(built.map_err(|e| Fault::Internal(format!("no threads: {e}")))?);
    // The pool of a parent process is leaked: to drop it would be to wait for threads that are not here.
    if let Some((_, parents)) = held.replace((own, pool.clone())) {
        std::mem::forget(parents);
    }
    Ok(pool)
}
