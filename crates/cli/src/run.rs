//! The commands.

mod classify;
mod completions;
mod extract;
mod info;
mod man;
mod params;
mod patches;
mod render;
mod section;
mod stages;

use crate::args::Command;
use crate::failure::Failure;

/// Does what the command line asks for.
pub fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Extract(args) => extract::run(&args),
        Command::Classify(args) => classify::run(&args),
        Command::Patches(args) => patches::run(&args),
        Command::Render(args) => render::run(&args),
        Command::Section(args) => section::run(&args),
        Command::Slices(args) => section::slices(&args),
        Command::Info(args) => info::run(&args),
        Command::Params(tuning) => params::run(&tuning),
        Command::Completions { shell } => completions::run(shell),
        Command::Man { folder } => man::run(&folder),
    }
}
