//! What is said of the input for outputs that state it.

use clap::Args;
use lineament_io::Unit;

use crate::args::parse;

/// The unit of the input.
#[derive(Clone, Debug, Default, Args)]
pub struct Stated {
    /// Unit of the coordinates, which DXF states; nothing is scaled by it [default: metres in a UTM zone, else none]
    #[arg(long, help_heading = "Output", value_name = "mm|cm|m|in|ft", value_parser = parse::unit)]
    pub unit: Option<Unit>,
}
