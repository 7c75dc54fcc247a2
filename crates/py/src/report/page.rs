//! HTML reports among the outputs: as the program writes them, with the points.

use std::path::{Path, PathBuf};

use lineament::Cloud;
use lineament_io::{NetworkContext, NetworkFormat, Report, network_format, write_report};
use pyo3::prelude::*;

use crate::fault::Fault;

/// Whether an output is a report by its extension, which is the same for every result.
pub fn is_page(path: &Path) -> bool {
    network_format(path).is_ok_and(|format| format == NetworkFormat::Html)
}

/// A scan for its report.
pub struct Scanned {
    /// The points, world frame.
    pub cloud: Cloud,
    /// The files that it was read from.
    pub files: Vec<PathBuf>,
    /// Program, input and reference system.
    pub provenance: NetworkContext,
    /// The world direction that points up on the screen.
    pub up: [f64; 3],
}

impl Scanned {
    /// The report of the points alone.
    pub fn report(&self) -> Report<'_> {
        Report { cloud: Some(&self.cloud), up: self.up, ..Report::new(&self.provenance) }
    }

    /// Writes a report of this scan, whole or not at all.
    ///
    /// # Errors
    /// Those of [`write_report`].
    pub fn write(&self, py: Python<'_>, path: &Path, report: &Report) -> PyResult<()> {
        Ok(py.detach(|| write_report(path, &self.files, report)).map_err(Fault::from)?)
    }
}
