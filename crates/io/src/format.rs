//! File formats: one table (`format/table.rs`) from which reading, writing, messages and help texts draw.

mod kinds;
mod table;

pub use kinds::{
    FileFormat, Format, GraphFormat, MeshFormat, NetworkFormat, PatchFormat, PointFormat, SectionFormat,
    Written,
};
pub use table::FORMATS;

use crate::error::Error;
use std::fmt;
use std::path::Path;

impl Format {
    /// The format that an extension (without its dot, in any case) or a name stands for.
    pub fn parse(text: &str) -> Option<Format> {
        let is = |f: &&FileFormat| {
            let mut names = f.extensions.iter().chain([&f.name]);
            f.read.is_some() && names.any(|name| name.eq_ignore_ascii_case(text))
        };
        FORMATS.iter().find(is)?.read
    }

    /// All formats that are read.
    pub fn all() -> Vec<Format> {
        let mut all = Vec::new();
        for format in FORMATS.iter().filter_map(|f| f.read) {
            if !all.contains(&format) {
                all.push(format);
            }
        }
        all
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(FORMATS.iter().find(|row| row.read == Some(*self)).map_or("?", |row| row.name))
    }
}

macro_rules! shown_by_extension {
    ($($format:ty, $written:ident;)*) => {$(
        impl fmt::Display for $format {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let is = |row: &&FileFormat| row.$written.is_some_and(|(format, _)| format == *self);
                f.write_str(FORMATS.iter().find(is).and_then(|row| row.extensions.first()).unwrap_or(&"?"))
            }
        }
    )*};
}

shown_by_extension! {
    NetworkFormat, network;
    PointFormat, points;
    SectionFormat, section;
}

/// The format of a network output by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn network_format(path: &Path) -> Result<NetworkFormat, Error> {
    by_extension(path, "networks", NetworkFormat::Json, |f| f.network)
}

/// The format of a point output by its extension; `-`, standard output, is NPY.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn point_format(path: &Path) -> Result<PointFormat, Error> {
    by_extension(path, "points", PointFormat::Npy, |f| f.points)
}

/// The format of an output of patches by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn patch_format(path: &Path) -> Result<PatchFormat, Error> {
    by_extension(path, "patches", PatchFormat::Json, |f| f.patches)
}

/// The format of a section output by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn section_format(path: &Path) -> Result<SectionFormat, Error> {
    by_extension(path, "sections", SectionFormat::Json, |f| f.section)
}

/// The format of an output of a neighbour graph by its extension; `-`, standard output, is JSON.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn graph_format(path: &Path) -> Result<GraphFormat, Error> {
    by_extension(path, "graphs", GraphFormat::Json, |f| f.graph)
}

/// The format of an output of a mesh by its extension; `-`, standard output, is PLY.
///
/// # Errors
/// [`Error::UnknownOutput`] with the extensions that are known.
pub fn mesh_format(path: &Path) -> Result<MeshFormat, Error> {
    by_extension(path, "meshes", MeshFormat::Ply, |f| f.mesh)
}

fn by_extension<T: Copy>(
    path: &Path,
    kind: &'static str,
    standard: T,
    written: fn(&FileFormat) -> Written<T>,
) -> Result<T, Error> {
    if path.as_os_str() == "-" {
        return Ok(standard);
    }
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let named = |f: &&FileFormat| f.extensions.iter().any(|e| e.eq_ignore_ascii_case(extension));
    let found = FORMATS.iter().filter(named).find_map(written);
    found.map(|(format, _)| format).ok_or_else(|| {
        let known = listed(written).into_iter().map(|(extension, _)| format!(".{extension}"));
        let known = known.collect::<Vec<String>>().join(", ");
        Error::UnknownOutput { name: path.display().to_string(), kind, known }
    })
}

/// The usual extension and the help line of each format with this use.
fn listed<T>(written: fn(&FileFormat) -> Written<T>) -> Vec<(&'static str, &'static str)> {
    FORMATS.iter().filter_map(|f| Some((*f.extensions.first()?, written(f)?.1))).collect()
}

/// Longest list of extensions that its help stands beside; that of a longer one stands below.
const WIDEST: usize = 12;

/// The formats with this use for a help text: extensions and content, formats of one content on one line.
///
/// ```
/// let help = lineament_io::format_help(|format| format.network);
/// assert!(help.contains("  .geojson  line strings and points"));
/// ```
pub fn format_help<T>(written: fn(&FileFormat) -> Written<T>) -> String {
    let mut lines: Vec<(String, &str)> = Vec::new();
    for (extension, help) in listed(written) {
        match lines.iter_mut().find(|(_, line)| *line == help) {
            Some((extensions, _)) => *extensions += &format!(" .{extension}"),
            None => lines.push((format!(".{extension}"), help)),
        }
    }
    let widths = lines.iter().map(|(extensions, _)| extensions.len());
    let width = widths.filter(|&width| width <= WIDEST).max().unwrap_or(0);
    let shown = lines.iter().map(|(extensions, help)| match extensions.len() > width {
        true => format!("  {extensions}\n  {:width$}  {help}", ""),
        false => format!("  {extensions:width$}  {help}"),
    });
    shown.collect::<Vec<String>>().join("\n")
}
