//! `lineament params`.

use crate::args::Tuning;
use crate::config::{self, text};
use crate::failure::Failure;
use crate::source::print;

/// Prints the parameters in effect as commented TOML.
pub fn run(tuning: &Tuning) -> Result<(), Failure> {
    print(&text::commented(&config::params(tuning)?))
}
