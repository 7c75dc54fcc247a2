//! From networks and classified points to files.

mod check;
mod csv;
mod dxf;
mod geojson;
mod glb;
mod gpkg;
mod json;
mod network_obj;
mod network_ply;
mod npy;
mod npz;
mod parquet;
mod patches;
mod point_rows;
mod points_las;
mod points_pcd;
mod points_ply;
mod points_text;
mod polyline;
mod section;
mod sqlite;
mod stages;
mod svg;
mod vtp;

pub use patches::{PatchFormat, patch_format, write_patches};
pub use section::{
    SectionContext, SectionFormat, section_format, write_sections, write_sections_to, write_slice_picture,
};
pub use stages::write_stages;

use crate::error::Error;
use crate::output::Output;
use crate::read::LasFrame;
use lineament::{Cloud, Network, Patches};
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a file says of a network beside the network itself.
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
    /// The patches between the strips, if they were looked for.
    pub patches: Option<Patches>,
}

/// A parameter and its value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameter {
    /// The full key, such as `penalty.rho`.
    pub key: String,
    /// The value. Numbers, `true` and `false` are written as such, all else as text.
    pub value: String,
}

/// Points with what was found of them.
#[derive(Clone, Copy, Debug)]
pub struct PointTable<'a> {
    /// The points as they were read.
    pub cloud: &'a Cloud,
    /// `(N)` 0 smooth, 1 crease, 2 border, 3 corner.
    pub classes: &'a [u8],
    /// `(N)` scores of the detector, or nothing.
    pub scores: &'a [f32],
    /// How a LAS input stored its coordinates, for LAS outputs: `Scan::las`.
    pub las: Option<&'a LasFrame>,
}

/// A format that networks are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NetworkFormat {
    /// The documented schema `lineament-network/1`.
    Json,
    /// Wavefront lines.
    Obj,
    /// Vertices and edges, binary.
    Ply,
    /// 3D polylines, release 12.
    Dxf,
    /// A drawing in millimetres.
    Svg,
    /// Lines and points in the frame of the input.
    GeoJson,
    /// The same as a database of two layers.
    GeoPackage,
    /// Binary glTF lines.
    Glb,
    /// VTK polygonal data.
    Vtp,
    /// A row a point.
    Csv,
}

/// A format that classified points are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PointFormat {
    /// The classes as an array of bytes.
    Npy,
    /// Positions, class, score and the attributes of the input, an array each.
    Npz,
    /// The same as columns of Apache Parquet.
    Parquet,
    /// Positions, class, score and the attributes of the input, binary.
    Ply,
    /// The same as PCD, binary.
    Pcd,
    /// The same as text with blanks.
    Xyz,
    /// The same as text with commas.
    Csv,
    /// The same as LAS 1.4.
    Las,
    /// The same as LAZ 1.4.
    Laz,
}

const NETWORK_FORMATS: [(NetworkFormat, &str); 10] = [
    (NetworkFormat::Json, "json"),
    (NetworkFormat::Obj, "obj"),
    (NetworkFormat::Ply, "ply"),
    (NetworkFormat::Dxf, "dxf"),
    (NetworkFormat::Svg, "svg"),
    (NetworkFormat::GeoJson, "geojson"),
    (NetworkFormat::GeoPackage, "gpkg"),
    (NetworkFormat::Glb, "glb"),
    (NetworkFormat::Vtp, "vtp"),
    (NetworkFormat::Csv, "csv"),
];

const POINT_FORMATS: [(PointFormat, &str); 9] = [
    (PointFormat::Npy, "npy"),
    (PointFormat::Npz, "npz"),
    (PointFormat::Parquet, "parquet"),
    (PointFormat::Ply, "ply"),
    (PointFormat::Pcd, "pcd"),
    (PointFormat::Xyz, "xyz"),
    (PointFormat::Csv, "csv"),
    (PointFormat::Las, "las"),
    (PointFormat::Laz, "laz"),
];

impl fmt::Display for NetworkFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(NETWORK_FORMATS.iter().find(|(format, _)| format == self).map_or("?", |(_, name)| name))
    }
}

impl fmt::Display for PointFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(POINT_FORMATS.iter().find(|(format, _)| format == self).map_or("?", |(_, name)| name))
    }
}

/// The format of a network output by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn network_format(path: &Path) -> Result<NetworkFormat, Error> {
    by_extension(path, "networks", NetworkFormat::Json, &NETWORK_FORMATS)
}

/// The format of a point output by its extension; `-`, standard output, is NPY.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn point_format(path: &Path) -> Result<PointFormat, Error> {
    by_extension(path, "points", PointFormat::Npy, &POINT_FORMATS)
}

fn by_extension<T: Copy>(
    path: &Path,
    kind: &'static str,
    standard: T,
    known: &[(T, &str)],
) -> Result<T, Error> {
    if path.as_os_str() == "-" {
        return Ok(standard);
    }
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let found = known.iter().find(|(_, name)| name.eq_ignore_ascii_case(extension));
    found.map(|entry| entry.0).ok_or_else(|| {
        let known: Vec<String> = known.iter().map(|(_, name)| format!(".{name}")).collect();
        Error::UnknownOutput { name: path.display().to_string(), kind, known: known.join(", ") }
    })
}

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
    check::network(network).map_err(inconsistent)?;
    let mut output = Output::create(path, inputs)?;
    write_network_to(&mut output, format, network, context).map_err(|source| output.failed(source))?;
    output.finish()
}

/// Writes a network to a stream.
///
/// # Errors
/// What the stream says.
pub fn write_network_to(
    out: &mut dyn Write,
    format: NetworkFormat,
    network: &Network,
    context: &NetworkContext,
) -> io::Result<()> {
    match format {
        NetworkFormat::Json => json::write(out, network, context),
        NetworkFormat::Obj => network_obj::write(out, network, context),
        NetworkFormat::Ply => network_ply::write(out, network, context),
        NetworkFormat::Dxf => dxf::write(out, network),
        NetworkFormat::Svg => svg::write(out, network, context),
        NetworkFormat::GeoJson => geojson::write(out, network, context),
        NetworkFormat::GeoPackage => gpkg::write(out, network, context),
        NetworkFormat::Glb => glb::write(out, network),
        NetworkFormat::Vtp => vtp::write(out, network),
        NetworkFormat::Csv => csv::write(out, network),
    }
}

/// Writes points with class and score to a file, whole or not at all, in the format of the extension. `path`
/// must be none of `inputs`.
///
/// # Errors
/// Those of [`point_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for columns of
/// different lengths.
pub fn write_points(path: &Path, inputs: &[PathBuf], table: &PointTable) -> Result<(), Error> {
    let format = point_format(path)?;
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    check::points(table).map_err(inconsistent)?;
    let mut output = Output::create(path, inputs)?;
    write_points_to(&mut output, format, table).map_err(|source| output.failed(source))?;
    output.finish()
}

/// Writes points with class and score to a stream.
///
/// # Errors
/// What the stream says.
pub fn write_points_to(out: &mut dyn Write, format: PointFormat, table: &PointTable) -> io::Result<()> {
    match format {
        PointFormat::Npy => npy::write_classes(out, table.classes),
        PointFormat::Npz => npz::write(out, table),
        PointFormat::Parquet => parquet::write(out, table),
        PointFormat::Ply => points_ply::write(out, table),
        PointFormat::Pcd => points_pcd::write(out, table),
        PointFormat::Xyz => points_text::write(out, table, ' '),
        PointFormat::Csv => points_text::write(out, table, ','),
        PointFormat::Las => points_las::write(out, table, false),
        PointFormat::Laz => points_las::write(out, table, true),
    }
}
