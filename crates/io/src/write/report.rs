//! Reports: one HTML file with points, lines, patches and sections, which a browser shows without a network.
//!
//! The page (`page`) holds a picture for readers without WebGL (`picture`), the data in the schema `lineament-report/1` (`data`,
//! described in `docs/report.md`) and the viewer (`viewer.js`, `viewer.css`), which `cargo xtask web` bundles from `web/`.

mod data;
mod lines;
mod page;
mod patches;
mod picture;
mod points;
mod slices;
#[cfg(test)]
mod tests;

use super::network::check;
use super::network::context::NetworkContext;
use crate::error::Error;
use crate::output::Output;
use lineament::section::{Sections, Stack};
use lineament::{Cloud, Network};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The contents of a report. Whatever is `None` or empty is left out of it.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The points, world frame.
    pub cloud: Option<&'a Cloud>,
    /// `(N)` class of each point: 0 smooth, 1 crease, 2 border, 3 corner, 4 clutter.
    pub classes: &'a [u8],
    /// `(N)` patch of each point, `NO_PATCH` for none.
    pub labels: &'a [u32],
    /// The lines, world frame.
    pub network: Option<&'a Network>,
    /// Provenance, and the patches.
    pub context: &'a NetworkContext,
    /// The sections, and the features of their stack.
    pub sections: Option<(&'a Sections, &'a Stack)>,
    /// The world direction that points up on the screen: an axis.
    pub up: [f64; 3],
}

impl<'a> Report<'a> {
    /// A report of nothing yet but its provenance; z is up.
    pub fn new(context: &'a NetworkContext) -> Self {
        Self {
            cloud: None,
            classes: &[],
            labels: &[],
            network: None,
            context,
            sections: None,
            up: [0.0, 0.0, 1.0],
        }
    }

    /// Columns have a value for each point, and the network holds together.
    fn check(&self) -> Result<(), String> {
        let count = self.cloud.map_or(0, Cloud::len);
        for (what, length) in [("classes", self.classes.len()), ("labels", self.labels.len())] {
            if length != 0 && length != count {
                return Err(format!("{length} {what} for {count} points"));
            }
        }
        self.network.map_or(Ok(()), check::check)
    }
}

/// Writes a report to a file, whole or not at all. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`Output::create`], a failed write, and [`Error::Inconsistent`] for columns of different lengths, or a network with
/// dangling indices or non-finite coordinates.
pub fn write_report(path: &Path, inputs: &[PathBuf], report: &Report) -> Result<(), Error> {
    let inconsistent = |what| Error::Inconsistent { name: path.display().to_string(), what };
    report.check().map_err(inconsistent)?;
    Output::whole(path, inputs, |out| write_report_to(out, report))
}

/// Writes a report to a stream.
///
/// # Errors
/// Those of the stream, and those of [`lineament::Frame::localise`].
pub fn write_report_to(out: &mut dyn Write, report: &Report) -> io::Result<()> {
    let lines = data::lines(report)?;
    let room = page::room(lines.len());
    let chosen = points::choose(report, room).map_err(io::Error::other)?;
    let picture = picture::draw(report, &chosen)?;
    page::write(out, report, &picture, &|out| {
        out.write_all(&lines)?;
        points::write(out, report, &chosen)
    })
}
