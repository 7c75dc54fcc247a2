//! Arguments of every command that extracts.

use clap::Args;

use super::running::Running;
use super::source::Source;
use super::tuning::Tuning;

/// Arguments shared by the commands that extract.
#[derive(Clone, Debug, Args)]
pub struct Work {
    #[command(flatten)]
    pub source: Source,
    #[command(flatten)]
    pub tuning: Tuning,
    #[command(flatten)]
    pub running: Running,
}
