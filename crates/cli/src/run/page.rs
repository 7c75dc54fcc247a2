//! HTML reports among the outputs of a command.

use std::path::{Path, PathBuf};

use lineament::{Class, Extraction};
use lineament_io::{Error, NetworkContext, NetworkFormat, Report, network_format, write_report};

use crate::source::Input;

/// Whether an output is a report by its extension, which is the same for every command.
pub fn is_page(path: &Path) -> bool {
    network_format(path).is_ok_and(|format| format == NetworkFormat::Html)
}

/// Whether one of the outputs states the SHA-256 of the input: JSON and reports do.
pub fn states_hash(outputs: &[PathBuf]) -> bool {
    let states = |path: &PathBuf| {
        network_format(path).is_ok_and(|f| matches!(f, NetworkFormat::Json | NetworkFormat::Html))
    };
    outputs.iter().any(states)
}

/// Writes what was extracted, with the points by class, and by patch if these were looked for.
pub fn extracted(
    path: &Path,
    inputs: &[PathBuf],
    input: &Input,
    found: &Extraction,
    context: &NetworkContext,
) -> Result<(), Error> {
    let labels = if found.patches.is_some() { found.patch_labels() } else { Vec::new() };
    let report = Report {
        cloud: Some(&input.cloud),
        classes: &numbers(&found.classes()),
        labels: &labels,
        network: Some(&found.network),
        up: input.up(),
        ..Report::new(context)
    };
    write_report(path, inputs, &report)
}

/// The axis of that name, which points up; of `auto` that of the format of the input.
pub fn up(name: &str, of_input: Option<[f64; 3]>) -> [f64; 3] {
    match name {
        "x" => [1.0, 0.0, 0.0],
        "y" => [0.0, 1.0, 0.0],
        "auto" => of_input.unwrap_or([0.0, 0.0, 1.0]),
        _ => [0.0, 0.0, 1.0],
    }
}

/// The numbers of classes in files.
pub fn numbers(classes: &[Class]) -> Vec<u8> {
    classes.iter().map(|&class| class as u8).collect()
}

/// Program, input and reference system of a report without an extraction.
pub fn provenance(input: &Input) -> NetworkContext {
    NetworkContext {
        program_version: env!("CARGO_PKG_VERSION").into(),
        input_name: input.name.clone(),
        input_sha256: input.sha256.clone(),
        input_points: input.cloud.len() as u64,
        crs: input.reference(),
        crs_wkt: input.wkt.clone(),
        unit: input.unit,
        ..NetworkContext::default()
    }
}
