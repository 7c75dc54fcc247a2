//! Patches: labelled points, loops with surfaces (JSON), loops by layers (DXF), or faces (STEP).

mod dxf;
mod step;

use super::network::{self, NetworkContext, json};
use super::points::{self, PointTable, write_points_to};
use super::report::{Report, write_report_to};
use crate::error::Error;
use crate::format::{PatchFormat, patch_format};
use crate::output::Output;
use lineament::Network;
use std::path::{Path, PathBuf};

/// Writes patches to a file, whole or not at all, in the format of the extension. `table` holds the points with an attribute
/// that numbers the patch of each, and `context` the patches. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`patch_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for a network with dangling
/// indices or columns of different lengths.
pub fn write_patches(
    path: &Path,
    inputs: &[PathBuf],
    network: &Network,
    context: &NetworkContext,
    table: &PointTable,
) -> Result<(), Error> {
    let format = patch_format(path)?;
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    network::check::check(network).map_err(inconsistent)?;
    points::check::check(table).map_err(inconsistent)?;
    Output::whole(path, inputs, |out| match format {
        PatchFormat::Json => json::write(out, network, context),
        PatchFormat::Dxf => dxf::write(out, network, context),
        PatchFormat::Step => step::write(out, network, context),
        PatchFormat::Points(format) => write_points_to(out, format, table),
        PatchFormat::Html => write_report_to(
            out,
            &Report {
                cloud: Some(table.cloud),
                classes: table.classes,
                network: Some(network),
                ..Report::new(context)
            },
        ),
    })
}
