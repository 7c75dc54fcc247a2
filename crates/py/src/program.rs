//! The program `lineament`.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the program with these words after its name. The exit code.
///
/// Takes over Ctrl-C of the process, and ends it where the words ask for help or make no sense.
#[pyfunction]
pub fn main(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| lineament_cli::run(std::iter::once("lineament".into()).chain(words)))
}
