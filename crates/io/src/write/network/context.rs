//! Provenance and settings of a network for its outputs.

use crate::unit::Unit;
use crate::write::encode::step::StepProtocol;
use lineament::patch::Sides;
use lineament::{Patches, Related, Strip};

/// Provenance, settings and patches that a file states beside the network itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NetworkContext {
    /// Version of the program that made the network.
    pub program_version: String,
    /// The input as it was named.
    pub input_name: String,
    /// SHA-256 of the input's bytes in hexadecimal, if it was computed.
    pub input_sha256: Option<String>,
    /// Rows of the input, non-finite ones and duplicates included: source indices count these, from 0.
    pub input_points: u64,
    /// The method by its name on the command line.
    pub method: String,
    /// All parameters as they were used.
    pub parameters: Vec<Parameter>,
    /// Mean spacing of the cloud, in the unit of the input.
    pub spacing: f64,
    /// Estimated noise (standard deviation across the surface), in the unit of the input.
    pub noise: Option<f64>,
    /// The coordinate reference system, as `Scan::crs` gives it.
    pub crs: Option<String>,
    /// Its definition in well-known text, if the input holds one.
    pub crs_wkt: Option<String>,
    /// The direction in which drawings look; `None` for the best one.
    pub view: Option<[f64; 3]>,
    /// Millimetres of a drawing for one unit of the input; `None` fits the drawing to 200 mm.
    pub millimetres: Option<f64>,
    /// The unit of the coordinates, for the formats that state one; nothing is scaled by it.
    pub unit: Option<Unit>,
    /// The application protocol of STEP.
    pub step: StepProtocol,
    /// Whether JSON is written in the schema `lineament-network/1`, which knows no typed curves, instead of `/2`.
    pub first_schema: bool,
    /// The patches between the strips, if they were looked for.
    pub patches: Option<Patches>,
    /// The relations between the typed curves.
    pub related: Related,
}

/// A parameter and its value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameter {
    /// The full key, such as `penalty.rho`.
    pub key: String,
    /// The value. Numbers, `true` and `false` are written as such, all else as text.
    pub value: String,
}

impl NetworkContext {
    /// The unit that was given, or that of the reference system where it is known.
    pub fn known_unit(&self) -> Option<Unit> {
        self.unit.or_else(|| Unit::of_stated(self.crs.as_deref(), self.crs_wkt.as_deref()))
    }

    /// What lies beside a strip, where patches were looked for.
    pub(in crate::write) fn sides(&self, strip: usize) -> Option<&Sides> {
        self.patches.as_ref().and_then(|patches| patches.sides.get(strip))
    }
}

/// The angle of the fold along a strip, between its patches or as the detector measured it; NaN where neither is known.
pub(in crate::write) fn fold_deg(strip: &Strip, sides: Option<&Sides>) -> f64 {
    sides.and_then(|sides| sides.fold_deg).or(strip.fold_deg).unwrap_or(f64::NAN)
}
