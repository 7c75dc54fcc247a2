//! The `lineament` program: scan files in, feature lines out. `lineament --help` teaches it.

mod args;
mod batch;
mod config;
mod failure;
mod interrupt;
mod network_file;
mod outputs;
mod progress;
mod run;
mod source;
mod summary;
mod work;

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    let args = args::Args::try_parse().unwrap_or_else(|error| args::explained(error).exit());
    match interrupt::install().and_then(|()| run::run(args.command)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell();
            ExitCode::from(failure.code as u8)
        }
    }
}
