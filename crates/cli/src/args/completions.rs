//! The command line of `completions`.

use clap::Args;
use clap_complete::Shell;

/// The head of the long help.
pub const ABOUT: &str = "\
Print a completion script for a shell

  lineament completions bash > ~/.local/share/bash-completion/completions/lineament

The script goes to standard output; no file is written.";

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub struct Completions {
    /// Shell that the script is for
    pub shell: Shell,
}
