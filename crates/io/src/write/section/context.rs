//! Provenance of sections for their outputs.

use crate::unit::Unit;
use crate::write::encode::step::StepProtocol;
use crate::write::network::context::NetworkContext;
use lineament::section::Stack;

/// Provenance and features that a file states beside the curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionContext {
    /// Version of the program.
    pub program_version: String,
    /// The input as it was named.
    pub input_name: String,
    /// SHA-256 of the input's bytes in hexadecimal, if it was computed.
    pub input_sha256: Option<String>,
    /// Rows of the input.
    pub input_points: u64,
    /// The coordinate reference system: `EPSG:` and its code, or its name.
    pub crs: Option<String>,
    /// Its definition in well-known text, if the input holds one.
    pub crs_wkt: Option<String>,
    /// Millimetres of a drawing for one unit of the input; `None` fits the sheet to 200 mm.
    pub millimetres: Option<f64>,
    /// The unit of the coordinates, for the formats that state one; nothing is scaled by it.
    pub unit: Option<Unit>,
    /// The application protocol of STEP.
    pub step: StepProtocol,
    /// The features of the stack of slices; empty if they were not asked for.
    pub stack: Stack,
}

impl SectionContext {
    /// The unit that was given, or that of the reference system where it is known.
    pub fn known_unit(&self) -> Option<Unit> {
        self.unit.or_else(|| Unit::of_stated(self.crs.as_deref(), self.crs_wkt.as_deref()))
    }

    /// The provenance as reports take it.
    pub fn of_page(&self) -> NetworkContext {
        NetworkContext {
            program_version: self.program_version.clone(),
            input_name: self.input_name.clone(),
            input_sha256: self.input_sha256.clone(),
            input_points: self.input_points,
            crs: self.crs.clone(),
            crs_wkt: self.crs_wkt.clone(),
            unit: self.unit,
            ..NetworkContext::default()
        }
    }
}
