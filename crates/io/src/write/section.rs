//! Sections: one file for each format.

mod context;
mod dxf;
mod geojson;
mod gpkg;
mod json;
mod obj;
mod ply;
mod ring;
mod step;
mod svg;

pub use context::SectionContext;

use crate::error::Error;
use crate::format::{SectionFormat, section_format};
use crate::output::Output;
use crate::write::report::{Report, write_report_to};
use lineament::section::Sections;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

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
    Output::whole(path, inputs, |out| write_sections_to(out, format, sections, context))
}

/// Writes sections to a stream.
///
/// # Errors
/// Those of the stream.
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
        SectionFormat::Dxf => dxf::write(out, sections, context),
        SectionFormat::Step => step::write(out, sections, context),
        SectionFormat::Svg => svg::write(out, sections, context.millimetres),
        SectionFormat::GeoJson => geojson::write(out, sections, context.crs.as_deref()),
        SectionFormat::GeoPackage => gpkg::write(out, sections, context),
        SectionFormat::Html => page(out, sections, context),
    }
}

/// A report of the sections alone.
fn page(out: &mut dyn Write, sections: &Sections, context: &SectionContext) -> io::Result<()> {
    let context_of_page = context.of_page();
    let report = Report { sections: Some((sections, &context.stack)), ..Report::new(&context_of_page) };
    write_report_to(out, &report)
}

/// Writes one section as a picture, with so many millimetres for a unit of the input; `None` fits it to 200 mm.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_slice_picture(
    path: &Path,
    inputs: &[PathBuf],
    sections: &Sections,
    plane: usize,
    millimetres: Option<f64>,
) -> Result<(), Error> {
    Output::whole(path, inputs, |out| svg::write_one(out, sections, plane, millimetres))
}
