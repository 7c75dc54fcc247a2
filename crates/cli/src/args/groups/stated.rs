//! What is said for outputs of CAD.

use clap::Args;
use lineament_io::{StepProtocol, Unit};

use crate::args::parse;

/// The unit of the input.
#[derive(Clone, Debug, Default, Args)]
pub struct Stated {
    /// Unit of the coordinates, which DXF and STEP state; nothing is scaled by it [default: that of the reference system, metres of
    /// E57, else none in DXF and millimetres in STEP, which must have one]
    #[arg(long, help_heading = "Output", value_name = "mm|cm|m|in|ft|us-ft", value_parser = parse::unit)]
    pub unit: Option<Unit>,
}

/// The unit of the input, and the form of STEP.
#[derive(Clone, Debug, Default, Args)]
pub struct Cad {
    #[command(flatten)]
    pub stated: Stated,
    /// Application protocol of STEP: ap242, or ap214 for older programs
    #[arg(long, help_heading = "Output", value_name = "ap242|ap214", default_value = "ap242")]
    #[arg(value_parser = parse::protocol)]
    pub step_protocol: StepProtocol,
}
