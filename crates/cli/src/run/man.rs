//! `lineament man`, which `cargo xtask man` runs.

use clap::CommandFactory;

use crate::args::{Args, Man};
use crate::failure::{Code, Failure};

/// Writes a page for the program and one for each command.
pub fn run(args: &Man) -> Result<(), Failure> {
    let failed = |e| {
        Failure::new(Code::Output, format!("{}: cannot write the manual pages: {e}", args.folder.display()))
    };
    clap_mangen::generate_to(Args::command(), &args.folder).map_err(failed)
}
