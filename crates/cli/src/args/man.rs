//! The command line of `man`, which `cargo xtask man` runs.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `man`.
#[derive(Debug, Args)]
pub struct Man {
    /// An existing folder
    pub folder: PathBuf,
}
