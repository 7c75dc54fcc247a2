//! Arguments of every command that extracts.

use clap::Args;

use super::running::Running;
use super::source::Source;
use super::tuning::Tuning;
use crate::args::parse;

/// Arguments shared by the commands that extract.
#[derive(Clone, Debug, Args)]
pub struct Work {
    #[command(flatten)]
    pub source: Source,
    /// Read only every N-th point
    #[arg(long, help_heading = "Reading", value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub every: Option<usize>,
    #[command(flatten)]
    pub tuning: Tuning,
    #[command(flatten)]
    pub running: Running,
}
