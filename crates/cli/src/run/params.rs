//! `lineament params`.

use crate::args::Params;
use crate::config::{self, text};
use crate::failure::Failure;
use crate::source::print;

/// Prints the parameters in effect as commented TOML.
pub fn run(args: &Params) -> Result<(), Failure> {
    print(&text::commented(&config::params(&args.tuning)?))
}
