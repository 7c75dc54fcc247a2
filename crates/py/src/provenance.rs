//! Provenance of a network, as the outputs state it.

use lineament::Patches;
use lineament::apply::render::View;
use lineament::section::Stack;
use lineament_io::{NetworkContext, Parameter, SectionContext, Unit};
use pyo3::prelude::*;

use crate::fault::Fault;
use crate::settings::Setting;

/// Provenance as Python's object holds it.
#[derive(FromPyObject)]
pub struct Provenance {
    name: String,
    sha256: Option<String>,
    points: u64,
    method: String,
    parameters: Vec<Setting>,
    spacing: f64,
    noise: Option<f64>,
    crs: Option<String>,
    crs_wkt: Option<String>,
}

/// How a file shows or states lengths: the view of a drawing, its millimetres for one unit, and the unit of the coordinates.
pub type Drawn = (String, Option<f64>, Option<String>);

impl Provenance {
    /// The context of a network, for an output in which drawings look from `view` and have `millimetres` for one unit, and that states
    /// `unit`.
    ///
    /// # Errors
    /// A view or a unit that is none.
    pub fn context(
        self,
        patches: Option<Patches>,
        view: &str,
        millimetres: Option<f64>,
        unit: Option<&str>,
    ) -> Result<NetworkContext, Fault> {
        let parameter = |(key, value)| Parameter { key, value };
        let view = match View::parse(view)? {
            View::Best => None,
            View::From(from) => Some(from.map(|x| -x)),
        };
        Ok(NetworkContext {
            program_version: env!("CARGO_PKG_VERSION").into(),
            input_name: self.name,
            input_sha256: self.sha256,
            input_points: self.points,
            method: self.method,
            parameters: self.parameters.into_iter().map(parameter).collect(),
            spacing: self.spacing,
            noise: self.noise,
            crs: self.crs,
            crs_wkt: self.crs_wkt,
            view,
            millimetres,
            unit: known(unit)?,
            step: Default::default(),
            first_schema: false,
            patches,
            related: Default::default(),
        })
    }

    /// The context of sections, of which a drawing has `millimetres` for one unit, and DXF and STEP state `unit`.
    ///
    /// # Errors
    /// A unit that is none.
    pub fn of_sections(
        self,
        stack: Stack,
        millimetres: Option<f64>,
        unit: Option<&str>,
    ) -> Result<SectionContext, Fault> {
        Ok(SectionContext {
            program_version: env!("CARGO_PKG_VERSION").into(),
            input_name: self.name,
            input_sha256: self.sha256,
            input_points: self.points,
            crs: self.crs,
            crs_wkt: self.crs_wkt,
            millimetres,
            unit: known(unit)?,
            step: Default::default(),
            stack,
        })
    }
}

/// The unit of a sign.
///
/// # Errors
/// A sign of no unit.
pub fn known(sign: Option<&str>) -> Result<Option<Unit>, Fault> {
    let parse = |sign: &str| {
        let units = || Unit::ALL.map(Unit::sign).join(", ");
        Unit::parse(sign).ok_or_else(|| Fault::Argument(format!("unit: `{sign}` is none of {}", units())))
    };
    sign.map(parse).transpose()
}
