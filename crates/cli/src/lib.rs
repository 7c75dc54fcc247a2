//! The `lineament` program: scan files in, feature lines out. `lineament --help` teaches it.
//!
//! A library, so that the Python package can be the same program.

mod args;
mod batch;
mod config;
mod failure;
mod interrupt;
mod memory;
mod network_file;
mod outputs;
mod progress;
mod run;
mod source;
mod summary;
mod work;

use std::ffi::OsString;
use std::path::Path;

use clap::Parser;

/// The parameters that a file names, TOML or the JSON of a result: keys and values as text, in the order of the file.
///
/// # Errors
/// What is wrong with the file, or with a parameter, with its line.
pub fn parameters_of(path: &Path) -> Result<Vec<(String, String)>, String> {
    config::of_file(path).map_err(|failure| failure.message)
}

/// Runs the program with a command line, of which the first word is the name of the program. The exit code.
///
/// Takes over Ctrl-C, and ends the process where the command line asks for help or makes no sense.
pub fn run(words: impl IntoIterator<Item = OsString>) -> u8 {
    memory::give_back();
    let args = args::Args::try_parse_from(words).unwrap_or_else(|error| args::explained(error).exit());
    match interrupt::install().and_then(|()| run::run(args.command)) {
        Ok(()) => 0,
        Err(failure) => {
            failure.tell();
            failure.code as u8
        }
    }
}
