//! Provenance of a network for its outputs: shared by `extract` and `patches`.

use lineament::params::ParamValue;
use lineament::{Extraction, Params};
use lineament_io::{NetworkContext, Parameter};

use crate::source::Input;

/// Program, input, method, parameters and reference system that an output names.
pub fn context(input: &Input, params: &Params, found: &Extraction) -> NetworkContext {
    let used = |(key, value): &(String, String)| Parameter { key: key.clone(), value: value.clone() };
    NetworkContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: found.report.read as u64,
        method: params.method.show(),
        parameters: found.report.used.iter().map(used).collect(),
        spacing: found.report.spacing,
        noise: Some(found.report.noise),
        crs: input.reference(),
        crs_wkt: input.wkt.clone(),
        unit: input.unit,
        patches: found.patches.clone(),
        related: found.related.clone(),
        ..NetworkContext::default()
    }
}
