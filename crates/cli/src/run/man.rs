//! `lineament man`, which `cargo xtask man` runs.

use std::path::Path;

use clap::CommandFactory;

use crate::args::Args;
use crate::failure::{Code, Failure};

/// Writes a page for the program and one for each command.
pub fn run(folder: &Path) -> Result<(), Failure> {
    let failed =
        |e| Failure::new(Code::Output, format!("{}: cannot write the manual pages: {e}", folder.display()));
    clap_mangen::generate_to(Args::command(), folder).map_err(failed)
}
