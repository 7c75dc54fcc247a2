//! Parameters.

use std::path::PathBuf;

use clap::{Args, ValueHint};

use crate::args::parse;

/// Parameters of the extraction; none needs to be set.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Parameters")]
pub struct Tuning {
    /// Method: auto (the default), or one paper's: penalty (or gumhold), projection (tran), segments (demarsin); as --set method=M
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    #[command(flatten)]
    pub settings: Settings,
}

/// Parameters by their keys.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Parameters")]
pub struct Settings {
    /// File of parameters: TOML in the form that `lineament params` prints, or JSON that `lineament extract` wrote, for the
    /// parameters that were used there
    #[arg(long, value_name = "FILE.toml", value_hint = ValueHint::FilePath)]
    pub params: Option<PathBuf>,
    /// Set one parameter, such as `penalty.gamma=0.4`; may be given several times, and takes precedence over the file
    #[arg(long, value_name = "KEY=VALUE", value_parser = parse::setting)]
    pub set: Vec<(String, String)>,
}
