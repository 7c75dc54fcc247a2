//! The commands.

mod apply;
mod classify;
mod clean;
mod completions;
mod context;
mod evaluate;
mod extract;
mod info;
mod man;
mod page;
mod params;
mod patches;
mod render;
mod report;
mod section;
mod slices;
mod slicing;
mod stages;

use crate::args::Command;
use crate::failure::Failure;

/// Runs the command.
pub fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Extract(args) => extract::run(&args),
        Command::Classify(args) => classify::run(&args),
        Command::Clean(args) => clean::run(&args),
        Command::Patches(args) => patches::run(&args),
        Command::Graph(args) => apply::graph::run(&args),
        Command::Enrich(args) => apply::enrich::run(&args),
        Command::Mesh(args) => apply::mesh::run(&args),
        Command::Render(args) => render::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Section(args) => section::run(&args),
        Command::Slices(args) => slices::run(&args),
        Command::Evaluate(args) => evaluate::run(&args),
        Command::Info(args) => info::run(&args),
        Command::Params(args) => params::run(&args),
        Command::Completions(args) => completions::run(&args),
        Command::Man(args) => man::run(&args),
    }
}
