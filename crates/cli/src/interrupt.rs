//! Ctrl-C: the run ends at once, but a file that is being written is finished first, so that none is left in pieces.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::failure::{Code, Failure, INTERRUPTED, say};

static WRITING: Mutex<()> = Mutex::new(());

/// Takes over Ctrl-C, and has a file beyond the limit on file sizes fail like one on a full disk. Before any thread begins.
pub fn install() -> Result<(), Failure> {
    #[cfg(unix)]
    {
        use nix::sys::signal::{SigSet, Signal};
        // A blocked SIGXFSZ is never delivered; the write that it belongs to gives an error then.
        let _ = SigSet::from(Signal::SIGXFSZ).thread_block();
    }
    let stop = || {
        let _none_is_open = writing();
        say("lineament: interrupted");
        std::process::exit(INTERRUPTED);
    };
    ctrlc::set_handler(stop).map_err(|e| Failure::new(Code::Usage, format!("cannot watch for Ctrl-C: {e}")))
}

/// While the guard lives, an interrupt waits.
pub fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}
