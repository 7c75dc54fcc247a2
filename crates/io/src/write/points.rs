//! Classified points: one file for each format.

pub(super) mod check;
mod clean;
mod las;
pub(super) mod npy;
mod npz;
mod parquet;
mod pcd;
pub(super) mod ply;
pub(super) mod rows;
mod table;
mod text;

pub use clean::{label_clutter, write_cleaned};
pub use table::PointTable;

use crate::error::Error;
use crate::format::{PointFormat, point_format};
use crate::output::Output;
use crate::write::network::context::NetworkContext;
use crate::write::report::{Report, write_report_to};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes points with class and score to a file, whole or not at all, in the format of the extension. `path`
/// must be none of `inputs`.
///
/// # Errors
/// Those of [`point_format`] and [`Output::create`], a failed write, and [`Error::Inconsistent`] for columns of
/// different lengths.
pub fn write_points(path: &Path, inputs: &[PathBuf], table: &PointTable) -> Result<(), Error> {
    let format = point_format(path)?;
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    check::check(table).map_err(inconsistent)?;
    Output::whole(path, inputs, |out| write_points_to(out, format, table))
}

/// The version, 1.2 to 1.4, behind its point, that LAS and LAZ outputs of these points have: that of a LAS input unless the points
/// carry what only 1.4 can hold, such as a column of classes beside those of LAS. `None` if LAS cannot hold the points.
pub fn las_version(table: &PointTable) -> Option<u8> {
    las::written_version(table)
}

/// Writes points with class and score to a stream.
///
/// # Errors
/// Those of the stream.
pub fn write_points_to(out: &mut dyn Write, format: PointFormat, table: &PointTable) -> io::Result<()> {
    match format {
        PointFormat::Npy => npy::write(out, table),
        PointFormat::Npz => npz::write(out, table),
        PointFormat::Parquet => parquet::write(out, table),
        PointFormat::Ply => ply::write(out, table),
        PointFormat::Pcd => pcd::write(out, table),
        PointFormat::Xyz => text::write(out, table, ' '),
        PointFormat::Csv => text::write(out, table, ','),
        PointFormat::Las => las::write(out, table, false),
        PointFormat::Laz => las::write(out, table, true),
        PointFormat::Html => page(out, table),
    }
}

/// A report of the points by class.
fn page(out: &mut dyn Write, table: &PointTable) -> io::Result<()> {
    let context = NetworkContext { input_points: table.cloud.len() as u64, ..NetworkContext::default() };
    let report = Report { cloud: Some(table.cloud), classes: table.classes, ..Report::new(&context) };
    write_report_to(out, &report)
}
