//! Outputs: checked before the long work begins, and written so that an interrupt leaves none in pieces.

mod plan;

use std::path::{Path, PathBuf};

use lineament_io as io;

pub use plan::{filled, plan};

use crate::failure::{Code, Failure};
use crate::interrupt;

/// Refuses outputs that cannot be: an input, one in a folder that cannot be made, or by `known` an extension that no format has.
pub fn check<F, E: Into<Failure>>(
    outputs: &[Vec<PathBuf>],
    inputs: &[PathBuf],
    known: impl Fn(&Path) -> Result<F, E>,
) -> Result<(), Failure> {
    for output in outputs.iter().flatten() {
        known(output).map_err(|e| Failure { code: Code::Usage, ..e.into() })?;
        check_place(output, inputs)?;
    }
    Ok(())
}

/// Refuses an output that is an input, or whose folder is not there and cannot be made, as a file has the name.
pub fn check_place(output: &Path, inputs: &[PathBuf]) -> Result<(), Failure> {
    let Err(error) = io::check_output(output, inputs) else { return Ok(()) };
    let nearest = output.ancestors().skip(1).find(|folder| folder.as_os_str().is_empty() || folder.exists());
    let makeable = nearest.is_none_or(|folder| folder.as_os_str().is_empty() || folder.is_dir());
    match error {
        io::Error::NoFolder { .. } if makeable => Ok(()),
        other => Err(other.into()),
    }
}

/// Makes a folder and those above it.
pub fn make(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|e| Failure::new(Code::Output, format!("{}: cannot make the folder: {e}", folder.display())))
}

/// Writes one output, in a folder that is made if it is not there; an interrupt waits until it is whole. It does not wait for
/// devices and pipes, whose reader may never come.
pub fn write<T, E: Into<Failure>>(path: &Path, write: impl FnOnce() -> Result<T, E>) -> Result<T, Failure> {
    let waits =
        path.as_os_str() == "-" || path.metadata().is_ok_and(|meta| !meta.is_file() && !meta.is_dir());
    let _guard = (!waits).then(interrupt::writing);
    path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists()).map_or(Ok(()), make)?;
    write().map_err(Into::into)
}
