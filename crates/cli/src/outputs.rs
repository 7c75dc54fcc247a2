//! Outputs: checked before the long work begins, and written so that an interrupt leaves none in pieces.

mod plan;

use std::path::{Path, PathBuf};

use lineament_io as io;

pub use plan::{filled, make, plan};

use crate::failure::{Code, Failure};
use crate::interrupt;

/// Refuses outputs that cannot be: an input, a folder that is not there, or by `known` an extension that no format has.
pub fn check<F, E: Into<Failure>>(
    outputs: &[Vec<PathBuf>],
    inputs: &[PathBuf],
    known: impl Fn(&Path) -> Result<F, E>,
) -> Result<(), Failure> {
    for output in outputs.iter().flatten() {
        known(output).map_err(|e| Failure { code: Code::Usage, ..e.into() })?;
        if output.as_os_str() != "-" {
            io::check_output(output, inputs)?;
        }
    }
    Ok(())
}

/// Writes one output; an interrupt waits until it is whole. It does not wait for devices and pipes, whose reader may never
/// come.
pub fn write<T, E: Into<Failure>>(path: &Path, write: impl FnOnce() -> Result<T, E>) -> Result<T, Failure> {
    let waits =
        path.as_os_str() == "-" || path.metadata().is_ok_and(|meta| !meta.is_file() && !meta.is_dir());
    let _guard = (!waits).then(interrupt::writing);
    write().map_err(Into::into)
}
