//! Demarsin's pipeline in the robust form, for noise, blunt folds and borders (Demarsin et al. 2007, Algorithm 1).
//!
//! Departures from the paper, and their reasons:
//! * **Small clusters** are the crease candidates of the penalties at their feet (see `group`), as one-ring normals at 8
//!   degrees break into small clusters everywhere from a noise of a tenth of the spacing on.
//! * **Spanning forest**: edges that close a long and open cycle stay, so that loops need no closing.
//! * **Branches** are measured in spacings, not edges, and strips that turn out round are dropped.
//! * **Connect**: ends are joined by direction as well as distance, which the paper itself proposes (section 3, an ellipsoid
//!   in place of the sphere), then through clusters that the pruning left out.
//! * **Borders** are those of the default method, whose bridges close them: they are put in before the creases are closed,
//!   and creases end on them.

use super::borders::borders;
use super::connect::connect_within;
use super::extend::extend;
use super::forest::forest;
use super::graph::Clusters;
use super::ground::{ground, take_vertices};
use super::group::group;
use super::include::{include, leave};
use super::open::remove_open;
use super::smooth::smooth;
use super::stages::{Linked, Recorder};
use crate::detect::segments::Segmentation;
use crate::link::repair::{bridge, corners, dock, judge, remove_rungs, reroute};
use crate::link::spanning::{Candidate, CycleRule, Walker, candidate_edges, prune, sort};
use crate::math::vec3::distance;
use crate::measure::Measure;
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::Params;
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

/// Extra weight of the edges that `G_extended` adds to `G_all`.
const ADDED: f64 = 2.0;
/// Gaps that the last rounds close by the shortest link in any direction, spacings.
const LAST_LINKS: [f64; 3] = [3.0, 6.0, 10.0];
/// Smoothing steps.
const SMOOTHING: usize = 2;

/// The input of all steps: points in canonical order, local frame.
pub(crate) struct Segments<'a> {
    pub(crate) points: &'a [[f64; 3]],
    pub(crate) graph: &'a Neighbors,
    pub(crate) measure: &'a Measure,
    pub(crate) segments: &'a Segmentation,
    pub(crate) resolution: Resolution,
    pub(crate) rule: CycleRule<'a>,
    pub(crate) params: &'a Params,
}

/// Closed lines of a measure with candidates of both kinds.
pub(crate) fn link_robust(cloud: &Segments) -> Linked {
    let &Segments { graph, measure, resolution, rule, params, .. } = cloud;
    let border = borders(graph, measure, resolution, rule, &params.repair);
    let mut recorder = Recorder::new();
    let (mut lines, all) = open_lines(cloud, &mut recorder);
    take_vertices(&mut lines, &all);
    let mut pattern = Pattern { crease: lines, border, ..Pattern::default() };
    dock(&mut pattern, resolution.into());
    close(cloud, &mut pattern, &all, &mut recorder);
    corners(&mut pattern.crease, StripKind::Crease, resolution.into(), &params.repair);
    Linked { pattern, stages: recorder.stages }
}

/// `G_pruned_branches`, and the graph with the weak ground that the closing step may use.
fn open_lines(cloud: &Segments, recorder: &mut Recorder) -> (LineGraph, LineGraph) {
    let &Segments { points, graph, measure, segments, resolution, rule, params } = cloud;
    let penalties = &measure.crease;
    let edges = candidate_edges(graph, &measure.density, penalties, resolution.into(), 1.0, 1);
    let (mut clusters, cluster_of) = group(graph, penalties, &edges, segments, resolution);
    recorder.whole("G_all", &clusters);
    add_edges(&mut clusters, resolution, params.segments.extend_spacings);
    recorder.whole("G_extended", &clusters);
    let mut lines = forest(&clusters.lines, &clusters.weights, Some((resolution, rule)));
    recorder.lines("G_pruned_mst", &lines);
    prune(&mut lines, rule);
    remove_rungs(&mut lines, resolution.into(), &params.repair);
    judge(&mut lines, resolution.into(), &params.repair);
    recorder.lines("G_pruned_branches", &lines);
    let all = ground(&clusters, &cluster_of, points, graph, penalties, segments, resolution);
    (lines, all)
}

/// Adds the edges of `G_extended`, up to `reach` spacings long. They weigh more than those of `G_all`, and more the longer
/// they are.
fn add_edges(clusters: &mut Clusters, resolution: Resolution, reach: f64) {
    for (a, b) in extend(clusters, reach * resolution.spacing) {
        let positions = &clusters.lines.positions;
        let length = distance(positions[a as usize], positions[b as usize]) / resolution.spacing;
        clusters.weights.push(Candidate { weight: ADDED + length * length, a, b });
    }
    sort(&mut clusters.weights);
}

/// `G_closed` and `G_smooth`: closes the creases together with the borders on which they end.
fn close(cloud: &Segments, pattern: &mut Pattern, all: &LineGraph, recorder: &mut Recorder) {
    let &Segments { resolution, rule, params, .. } = cloud;
    let Pattern { crease: lines, border, .. } = pattern;
    let own = include(lines, border);
    bridge(lines, StripKind::Crease, resolution.into(), &params.repair);
    reroute(lines, all, resolution, rule.metric);
    let mut walker = Walker::new(lines.edges.len(), rule.metric);
    for gap in LAST_LINKS {
        connect_within(lines, gap * resolution.spacing, &mut walker, resolution.spacing);
    }
    remove_open(lines);
    remove_rungs(lines, resolution.into(), &params.repair);
    recorder.lines("G_closed", lines);
    smooth(lines, SMOOTHING);
    recorder.lines("G_smooth", lines);
    leave(lines, border, own);
}
