//! Provenance of a network for its outputs: shared by `extract` and `patches`.

use lineament::{Extraction, Params};
use lineament_io::{LasFrame, NetworkContext, Parameter};

use crate::config::text;
use crate::source::Input;

/// Program, input, method, parameters and reference system that an output names.
pub fn context(input: &Input, params: &Params, found: &Extraction) -> NetworkContext {
    let entries = params.entries();
    let parameters = entries.iter().map(|e| Parameter { key: e.key.clone(), value: text::value(&e.value) });
    let method = entries.iter().find(|e| e.key == "method").map(|e| e.value.clone());
    NetworkContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: found.report.read as u64,
        method: method.unwrap_or_default(),
        parameters: parameters.collect(),
        spacing: found.report.spacing,
        noise: Some(found.report.noise),
        crs: input.reference(),
        crs_wkt: input.las.as_ref().and_then(LasFrame::wkt),
        patches: found.patches.clone(),
        ..NetworkContext::default()
    }
}
