//! From sections to files.

mod dxf;
mod geojson;
mod json;
mod obj;
mod ply;
mod svg;

use super::by_extension;
use crate::error::Error;
use crate::output::Output;
use lineament::section::{Contour, Sections, Stack};
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a file says of sections beside the curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionContext {
    /// Version of the program.
    pub program_version: String,
    /// The input as it was named.
    pub input_name: String,
    /// SHA-256 of the input's bytes in hexadecimal, if it was computed.
    pub input_sha256: Option<String>,
    /// Rows of the input.
    pub input_points: u64,
    /// What the stack of slices says; empty if it was not asked.
    pub stack: Stack,
}

/// A format that sections are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SectionFormat {
    /// The documented schema `lineament-section/1`.
    Json,
    /// Wavefront lines, a group a slice.
    Obj,
    /// Vertices and edges, binary.
    Ply,
    /// Lines, arcs, circles and polylines, release 12, a layer a slice; names of the runs as texts.
    Dxf,
    /// A sheet with all slices side by side.
    Svg,
    /// Polygons with their holes, and lines.
    GeoJson,
}

const FORMATS: [(SectionFormat, &str); 6] = [
    (SectionFormat::Json, "json"),
    (SectionFormat::Obj, "obj"),
    (SectionFormat::Ply, "ply"),
    (SectionFormat::Dxf, "dxf"),
    (SectionFormat::Svg, "svg"),
    (SectionFormat::GeoJson, "geojson"),
];

impl fmt::Display for SectionFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(FORMATS.iter().find(|(format, _)| format == self).map_or("?", |(_, name)| name))
    }
}

/// The format of a section output by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn section_format(path: &Path) -> Result<SectionFormat, Error> {
    by_extension(path, "sections", SectionFormat::Json, &FORMATS)
}

/// Writes sections to a file, whole or not at all, in the format of the extension. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`section_format`] and [`Output::create`], and a failed write.
pub fn write_sections(
    path: &Path,
    inputs: &[PathBuf],
    sections: &Sections,
    context: &SectionContext,
) -> Result<(), Error> {
    let format = section_format(path)?;
    let mut output = Output::create(path, inputs)?;
    write_sections_to(&mut output, format, sections, context).map_err(|source| output.failed(source))?;
    output.finish()
}

/// Writes sections to a stream.
///
/// # Errors
/// What the stream says.
pub fn write_sections_to(
    out: &mut dyn Write,
    format: SectionFormat,
    sections: &Sections,
    context: &SectionContext,
) -> io::Result<()> {
    match format {
        SectionFormat::Json => json::write(out, sections, context),
        SectionFormat::Obj => obj::write(out, sections),
        SectionFormat::Ply => ply::write(out, sections),
        SectionFormat::Dxf => dxf::write(out, sections, &context.stack),
        SectionFormat::Svg => svg::write(out, sections),
        SectionFormat::GeoJson => geojson::write(out, sections),
    }
}

/// Writes one section as a picture.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_slice_picture(
    path: &Path,
    inputs: &[PathBuf],
    sections: &Sections,
    plane: usize,
) -> Result<(), Error> {
    let mut output = Output::create(path, inputs)?;
    svg::write_one(&mut output, sections, plane).map_err(|source| output.failed(source))?;
    output.finish()
}

/// Vertex indices of a contour in order, the first again at the end of a closed one; `first` is its first vertex.
fn ring(contour: &Contour, first: usize) -> impl Iterator<Item = usize> {
    let n = contour.points.len();
    (first..first + n).chain(contour.closed.then_some(first))
}
