//! The stages of a method: a file for each, and a table of what they hold.

mod clusters;
mod files;
mod graphs;
mod lines;
mod measures;
mod projection;
mod recovery;
mod slices;
mod table;

use crate::error::Error;
use files::Files;
use lineament::section::{SectionParams, Sections, SliceSteps};
use lineament::{Cloud, Extraction};
use std::path::{Path, PathBuf};
use table::Table;

/// Writes into `folder`, which must be there, the stages of the method and `stages.json`, which counts what each PLY file holds.
///
/// Of the method `segments`: `segmentation.ply`, the points with the cluster of each and whether that is a large one; for each
/// graph from `G_all` to `G_smooth` a PLY file of that name with vertices and edges, those of large clusters left out;
/// `border.ply`, the borders that creases may end on; in `stages.json` also seconds, and counts of the whole graphs.
///
/// Of an extraction with [`Extraction::stages`]: the points of `cloud`, in its order, with their `ellipsoids` (of the method
/// `penalty`), `projection` (of the method of that name) and `penalties`; for creases and borders the weighed `edges`, the `spanning` graph, the `pruned` one and in the
/// robust form the `repaired` one; the `splines`; and where creases and corners were recovered the `strip_groups`, the
/// `node_groups` and the `recovered` places. Returns the names written.
///
/// # Errors
/// Those of [`Output::create`](crate::Output::create), and a failed write.
pub fn write_stages(
    folder: &Path,
    inputs: &[PathBuf],
    cloud: &Cloud,
    found: &Extraction,
) -> Result<Vec<PathBuf>, Error> {
    let mut files = Files::new(folder, inputs);
    match &found.stages {
        Some(stages) => lines::write(&mut files, cloud, found, stages)?,
        None => clusters::write(&mut files, cloud, found)?,
    }
    Ok(files.written)
}

/// Writes into `folder`, which must be there, the steps to `sections`, which `params` led to: `slab.ply`, `projection.ply` (the points on
/// the planes), with the outlines `hull` and `voronoi` the feature points that each round added (`hull_00.ply` and on), with the latter
/// `circles.ply`; `outlines.ply`; and `stages.json`, which counts what each holds. Returns the names written.
///
/// # Errors
/// Those of [`Output::create`](crate::Output::create), and a failed write.
pub fn write_section_stages(
    folder: &Path,
    inputs: &[PathBuf],
    cloud: &Cloud,
    (sections, steps): (&Sections, &[SliceSteps]),
    params: &SectionParams,
) -> Result<Vec<PathBuf>, Error> {
    let mut files = Files::new(folder, inputs);
    slices::write(Table::new(&mut files), cloud, sections, steps, params)?;
    Ok(files.written)
}
