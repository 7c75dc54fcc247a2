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

use clap::Parser;

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
