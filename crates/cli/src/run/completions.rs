//! `lineament completions`.

use clap::CommandFactory;
use clap_complete::generate;

use crate::args::{Args, Completions};
use crate::failure::Failure;
use crate::source::print;

/// Prints the script that completes commands and options.
pub fn run(args: &Completions) -> Result<(), Failure> {
    let mut script = Vec::new();
    generate(args.shell, &mut Args::command(), "lineament", &mut script);
    print(&String::from_utf8_lossy(&script))
}
