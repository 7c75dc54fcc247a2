//! The command line of `info`.

use clap::Args;

use super::groups::Source;

/// The head of the long help.
pub const ABOUT: &str = "\
Describe the content of a scan file

  lineament info part.ply    format, number of points, attributes, bounds, spacing, noise

Everything goes to standard output; no file is written.";

/// Arguments of `info`.
#[derive(Debug, Args)]
pub struct Info {
    #[command(flatten)]
    pub source: Source,
}
