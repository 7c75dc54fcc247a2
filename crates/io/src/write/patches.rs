//! Patches to files: labelled points, loops and surfaces, or loops by layers.

use super::{NetworkContext, PointFormat, PointTable, check, dxf, json};
use crate::error::Error;
use crate::output::Output;
use lineament::patch::Loop;
use lineament::{Network, Patches};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What patches are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PatchFormat {
    /// The schema `lineament-network/1` with loops, sides and surfaces.
    Json,
    /// The loops as 3D polylines, a layer a patch.
    Dxf,
    /// The points with the patch of each.
    Points(PointFormat),
}

/// The format of an output of patches by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn patch_format(path: &Path) -> Result<PatchFormat, Error> {
    let points = super::POINT_FORMATS.iter().filter(|f| f.0 != PointFormat::Npy);
    let known: Vec<(PatchFormat, &str)> = [(PatchFormat::Json, "json"), (PatchFormat::Dxf, "dxf")]
        .into_iter()
        .chain(points.map(|&(format, name)| (PatchFormat::Points(format), name)))
        .collect();
    super::by_extension(path, "patches", PatchFormat::Json, &known)
}

/// Writes patches to a file, whole or not at all, in the format of the extension. `table` holds the points with an attribute
/// that says which patch each belongs to, and `context` the patches. `path` must be none of `inputs`.
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
    check::network(network).map_err(inconsistent)?;
    check::points(table).map_err(inconsistent)?;
    let mut output = Output::create(path, inputs)?;
    let out: &mut dyn Write = &mut output;
    let none = Patches::default();
    let patches = context.patches.as_ref().unwrap_or(&none);
    match format {
        PatchFormat::Json => json::write(out, network, context),
        PatchFormat::Dxf => loops(out, network, patches),
        PatchFormat::Points(format) => super::write_points_to(out, format, table),
    }
    .map_err(|source| output.failed(source))?;
    output.finish()
}

/// Each loop as one 3D POLYLINE on the layer of its patch.
fn loops(out: &mut dyn Write, network: &Network, patches: &Patches) -> io::Result<()> {
    dxf::header(out, network)?;
    let layers: Vec<(String, u8)> =
        (0..patches.patches.len()).map(|p| (layer(p), (p % 6 + 1) as u8)).collect();
    dxf::tables(out, &layers)?;
    write!(out, "0\nSECTION\n2\nENTITIES\n")?;
    for (p, patch) in patches.patches.iter().enumerate() {
        for boundary in &patch.loops {
            dxf::polyline_on(out, &layer(p), &points(network, boundary), boundary.closed)?;
        }
    }
    write!(out, "0\nENDSEC\n0\nEOF\n")
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
