//! Ctrl-C: the run ends at once, but a file that is being written is finished first, so that none is left in pieces.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::failure::{Code, Failure, INTERRUPTED};

static WRITING: Mutex<()> = Mutex::new(());

/// Takes over Ctrl-C.
pub fn install() -> Result<(), Failure> {
    let stop = || {
        let _none_is_open = writing();
        eprintln!("lineament: interrupted");
        std::process::exit(INTERRUPTED);
    };
    ctrlc::set_handler(stop).map_err(|e| Failure::new(Code::Usage, format!("cannot watch for Ctrl-C: {e}")))
}

/// While the guard lives, an interrupt waits.
pub fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}
