//! Networks: one file for each format.

pub(super) mod check;
pub(super) mod context;
mod csv;
pub(super) mod dxf;
mod geojson;
mod glb;
mod gpkg;
pub(super) mod json;
mod obj;
pub(super) mod patch;
mod piece;
mod ply;
mod relation;
pub(super) mod step;
mod svg;
mod vtp;

pub use context::{NetworkContext, Parameter};

use crate::error::Error;
use crate::format::{NetworkFormat, network_format};
use crate::output::Output;
use crate::write::report::{Report, write_report_to};
use lineament::Network;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a network to a file, whole or not at all, in the format of the extension. `path` must be none of
/// `inputs`.
///
/// # Errors
/// Those of [`network_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for a network
/// with dangling indices or non-finite coordinates.
pub fn write_network(
    path: &Path,
    inputs: &[PathBuf],
    network: &Network,
    context: &NetworkContext,
) -> Result<(), Error> {
    let format = network_format(path)?;
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    check::check(network).map_err(inconsistent)?;
    Output::whole(path, inputs, |out| write_network_to(out, format, network, context))
}

/// Writes a network to a stream.
///
/// # Errors
/// Those of the stream.
pub fn write_network_to(
    out: &mut dyn Write,
    format: NetworkFormat,
    network: &Network,
    context: &NetworkContext,
) -> io::Result<()> {
    match format {
        NetworkFormat::Json => json::write(out, network, context),
        NetworkFormat::Obj => obj::write(out, network, context),
        NetworkFormat::Ply => ply::write(out, network, context),
        NetworkFormat::Dxf => dxf::write(out, network, context),
        NetworkFormat::Step => step::write(out, network, context),
        NetworkFormat::Svg => svg::write(out, network, context),
        NetworkFormat::GeoJson => geojson::write(out, network, context),
        NetworkFormat::GeoPackage => gpkg::write(out, network, context),
        NetworkFormat::Glb => glb::write(out, network),
        NetworkFormat::Vtp => vtp::write(out, network),
        NetworkFormat::Csv => csv::write(out, network),
        NetworkFormat::Html => {
            write_report_to(out, &Report { network: Some(network), ..Report::new(context) })
        }
    }
}
