//! The command line of `info`.

use clap::Args;

use super::groups::Source;
use super::parse;

/// Arguments of `info`.
#[derive(Debug, Args)]
pub struct Info {
    #[command(flatten)]
    pub source: Source,
    /// Read only every N-th point
    #[arg(long, help_heading = "Reading", value_name = "N", conflicts_with = "sample", value_parser = parse::count)]
    pub every: Option<usize>,
}
