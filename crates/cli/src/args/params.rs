//! The command line of `params`.

use clap::Args;

use super::groups::Tuning;

/// Arguments of `params`.
#[derive(Debug, Args)]
pub struct Params {
    #[command(flatten)]
    pub tuning: Tuning,
}
