//! Parameters.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use crate::args::parse;

/// What the extraction may be told; nothing needs to be.
#[derive(Clone, Debug, Default, Args)]
pub struct Tuning {
    /// The detection method: same as --set method=M
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Read parameters from a TOML file, such as `lineament params` prints
    #[arg(long, value_name = "FILE.toml", value_hint = ValueHint::FilePath)]
    pub params: Option<PathBuf>,
    /// Set one parameter, such as `penalty.gamma=0.4`; may be given several times and goes over the file
    #[arg(long, value_name = "KEY=VALUE", value_parser = parse::setting)]
    pub set: Vec<(String, String)>,
}
