//! Patches: labelled points, loops with surfaces (JSON), or loops by layers (DXF).

use super::encode::dxf;
use super::network::dxf::extent;
use super::network::{self, NetworkContext, json};
use super::points::{self, PointTable, write_points_to};
use super::report::{Report, write_report_to};
use crate::error::Error;
use crate::format::{PatchFormat, patch_format};
use crate::output::Output;
use lineament::patch::Loop;
use lineament::{Network, Patches};
use std::io::{self, Write};
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
    let none = Patches::default();
    let patches = context.patches.as_ref().unwrap_or(&none);
    Output::whole(path, inputs, |out| match format {
        PatchFormat::Json => json::write(out, network, context),
        PatchFormat::Dxf => loops(out, network, patches),
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

/// Each loop as one 3D POLYLINE on the layer of its patch.
fn loops(out: &mut dyn Write, network: &Network, patches: &Patches) -> io::Result<()> {
    let layers: Vec<dxf::Layer> = (0..patches.patches.len()).map(|p| (layer(p), (p % 6 + 1) as u8)).collect();
    dxf::begin(out, extent(network), &layers)?;
    for (p, patch) in patches.patches.iter().enumerate() {
        for boundary in &patch.loops {
            let points = points(network, boundary);
            if points.len() > 1 {
                dxf::polyline(out, &layer(p), &points, boundary.closed)?;
            }
        }
    }
    dxf::end(out)
}

fn layer(patch: usize) -> String {
    format!("PATCH_{patch:04}")
}

/// The points of a loop in order, where strips meet once; the first is not repeated.
fn points(network: &Network, boundary: &Loop) -> Vec<[f64; 3]> {
    let mut points: Vec<[f64; 3]> = Vec::new();
    for c in &boundary.coedges {
        let strip = network.strips[c.strip as usize].points.iter().copied();
        if c.forward { points.extend(strip) } else { points.extend(strip.rev()) }
    }
    points.dedup();
    if boundary.closed && points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}
