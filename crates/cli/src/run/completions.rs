//! `lineament completions`.

use clap::CommandFactory;
use clap_complete::{Shell, generate};

use crate::args::Args;
use crate::failure::Failure;
use crate::source::print;

/// Prints the script that completes commands and options in `shell`.
pub fn run(shell: Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    generate(shell, &mut Args::command(), "lineament", &mut script);
    print(&String::from_utf8_lossy(&script))
}
