//! Parameters: the table as Python lists it, and the values that a call sets.

use std::path::PathBuf;

use lineament::Params;
use pyo3::prelude::*;

use crate::fault::Fault;

/// A value set by its key, both as text in the form of `--set`.
pub type Setting = (String, String);

/// The defaults, under `settings` in their order.
///
/// # Errors
/// The first that is unknown or out of range.
pub fn params(settings: &[Setting]) -> Result<Params, Fault> {
    let mut params = Params::default();
    settings.iter().try_for_each(|(key, text)| params.set(key, text))?;
    params.check()?;
    Ok(params)
}

/// The parameters that a file names, TOML or the JSON of a result.
#[pyfunction]
pub fn parameters_of(path: PathBuf) -> PyResult<Vec<Setting>> {
    Ok(lineament_cli::parameters_of(&path).map_err(Fault::Argument)?)
}

/// One parameter of the table.
#[derive(IntoPyObject)]
pub struct Parameter {
    key: String,
    default: String,
    unit: &'static str,
    accepts: String,
    doc: &'static str,
}

/// Every parameter, in the order of the pipeline.
#[pyfunction]
pub fn parameters() -> Vec<Parameter> {
    let entries = Params::default().entries().into_iter();
    entries
        .map(|e| Parameter { key: e.key, default: e.default, unit: e.unit, accepts: e.accepts, doc: e.doc })
        .collect()
}
