//! Threads and messages.

use clap::{ArgAction, Args};

/// Threads and messages of a run.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Running")]
pub struct Running {
    /// Number of threads, which does not change the result [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Print errors only
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Print more: values of automatic parameters, and parts of the input that were left out
    #[arg(short, long, action = ArgAction::SetTrue)]
    pub verbose: bool,
}
