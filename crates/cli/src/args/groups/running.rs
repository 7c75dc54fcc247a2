//! Threads and messages.

use clap::{ArgAction, Args};

/// How the run goes.
#[derive(Clone, Debug, Default, Args)]
pub struct Running {
    /// Number of threads [default: one a core]; the result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Say nothing but errors
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Say more: the values chosen for automatic parameters, what was passed over in the input
    #[arg(short, long, action = ArgAction::SetTrue)]
    pub verbose: bool,
}
