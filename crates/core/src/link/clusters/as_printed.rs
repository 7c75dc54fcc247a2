//! Demarsin's pipeline as printed (Demarsin et al. 2007, Algorithm 1): from the segmentation to `G_closed` and `G_smooth`.

use super::all::all_clusters;
use super::branches::prune_branches;
use super::connect::{connect, neighbors_in_reach};
use super::extend::{extend, longest};
use super::forest::{by_length, forest};
use super::include::{include, leave};
use super::open::remove_open;
use super::smooth::smooth;
use super::stages::{Linked, Recorder};
use crate::detect::segments::Segmentation;
use crate::neighbors::Neighbors;
use crate::params::SegmentParams;
use crate::pattern::{LineGraph, Pattern};

/// Smoothing steps.
const SMOOTHING: usize = 5;

/// Closed lines of the small clusters. `rings` are the one-rings; canonical order, local frame.
pub(crate) fn link_as_printed(
    points: &[[f64; 3]],
    rings: &Neighbors,
    segments: &Segmentation,
    mut border: LineGraph,
    params: &SegmentParams,
) -> Linked {
    let mut recorder = Recorder::new();
    let mut clusters = all_clusters(points, rings, segments);
    recorder.whole("G_all", &clusters);
    let reach = longest(&clusters);
    extend(&mut clusters, reach);
    recorder.whole("G_extended", &clusters);
    let mut lines = forest(&clusters.lines, &by_length(&clusters.lines), None);
    recorder.lines("G_pruned_mst", &lines);
    prune_branches(&mut lines, params.branch);
    recorder.lines("G_pruned_branches", &lines);
    let n = params.connect.or(|| neighbors_in_reach(&lines, reach));
    let own = include(&mut lines, &border);
    connect(&mut lines, n, params.cycle.or(|| 2 * params.branch));
    remove_open(&mut lines);
    recorder.lines("G_closed", &lines);
    smooth(&mut lines, SMOOTHING);
    recorder.lines("G_smooth", &lines);
    leave(&mut lines, &mut border, own);
    Linked { pattern: Pattern { crease: lines, border, ..Pattern::default() }, stages: recorder.stages }
}
