//! The command line of `params`.

use clap::Args;

use super::groups::Tuning;

/// The head of the long help.
pub const ABOUT: &str = "\
Print every parameter as a commented TOML file

  lineament params > tuning.toml                 a file to edit, for --params
  lineament params --set penalty.fold_deg=15     the values in effect

The text goes to standard output; no file is written.";

/// Arguments of `params`.
#[derive(Debug, Args)]
pub struct Params {
    #[command(flatten)]
    pub tuning: Tuning,
}
