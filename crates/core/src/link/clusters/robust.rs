//! The same steps on steadier ground: how noise, blunt folds and borders are met.
//!
//! Where it departs from Demarsin et al. 2007, and why:
//! * **Small clusters** are the crease candidates of the penalties at their feet (see `group`), as one-ring normals at 8
//!   degrees break into small clusters everywhere from a noise of a tenth of the spacing on.
//! * **Spanning forest**: edges that close a long and open cycle stay, so that loops need no closing.
//! * **Branches** are measured in spacings, not edges, and strips that turn out round are dropped.
//! * **Connect**: ends are joined by direction as well as distance, which the paper itself proposes (section 3, an ellipsoid
//!   in place of the sphere), then through clusters that the pruning left out.
//! * **Borders** are those of the default method, whose bridges close them: they are put in before the creases are closed,
//!   and creases end on them.

use super::connect::connect_within;
use super::extend::extend;
use super::forest::sort;
use super::ground::{ground, take_vertices};
use super::group::group;
use super::include::{include, leave};
use super::open::{remove_open, remove_short};
use super::reroute::reroute;
use super::smooth::smooth;
use super::{Linked, Recorder, forest};
use crate::detect::segments::Segmentation;
use crate::link::walk::Walker;
use crate::link::{
    Candidate, Reach, bridge, candidate_edges, corners, dock, judge, lines_of, prune, remove_rungs,
};
use crate::math::vec3::distance;
use crate::measure::{Measure, Penalties};
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

/// Gaps between clusters of one pair of faces that are closed at once, spacings.
const EXTEND: f64 = 2.5;
/// What an edge of `G_extended` weighs more than one of `G_all`.
const ADDED: f64 = 2.0;
/// Gaps closed at last by the shortest link whatever its direction, spacings.
const LAST_LINKS: [f64; 3] = [3.0, 6.0, 10.0];
/// Open borders shorter than this, spacings, are none.
const OPEN_BORDER: f64 = 20.0;
/// Steps of smoothing.
const SMOOTHING: usize = 2;
/// Closed lines of a measure with candidates of both kinds.
pub fn link_robust(
    points: &[[f64; 3]],
    graph: &Neighbors,
    measure: &Measure,
    segments: &Segmentation,
    resolution: Resolution,
    reach: Reach,
) -> Linked {
    let cloud = Context { points, graph, measure, segments, resolution, reach };
    let border = border(graph, measure, &measure.border, resolution, reach);
    let mut recorder = Recorder::new();
    let pattern = close(&cloud, &measure.crease, border, &mut recorder);
    Linked { pattern, stages: recorder.stages }
}

/// The borders of the default method. A short piece that stays open is no end of a surface; of a long one the rest was not found.
pub fn border(
    graph: &Neighbors,
    measure: &Measure,
    penalties: &Penalties,
    resolution: Resolution,
    reach: Reach,
) -> LineGraph {
    let mut border = lines_of(graph, measure, penalties, resolution, 1.0, reach, StripKind::Border);
    remove_short(&mut border, OPEN_BORDER * resolution.unit());
    border.nodes.retain(|&v| !border.edges[v as usize].is_empty());
    border
}

/// What all steps look at.
struct Context<'a> {
    points: &'a [[f64; 3]],
    graph: &'a Neighbors,
    measure: &'a Measure,
    segments: &'a Segmentation,
    resolution: Resolution,
    reach: Reach,
}

/// The closed creases, and the borders that they end on.
fn close(cloud: &Context, penalties: &Penalties, border: LineGraph, recorder: &mut Recorder) -> Pattern {
    let &Context { points, graph, measure, segments, resolution, reach } = cloud;
    let (mut clusters, cluster_of) = group(
        graph,
        penalties,
        &candidate_edges(graph, measure, penalties, resolution, 1.0, 1),
        segments,
        resolution,
    );
    recorder.whole("G_all", &clusters);
    for (a, b) in extend(&mut clusters, EXTEND * resolution.spacing) {
        let positions = &clusters.lines.positions;
        let length = distance(positions[a as usize], positions[b as usize]) / resolution.spacing;
        clusters.weights.push(Candidate { weight: ADDED + length * length, a, b });
    }
    sort(&mut clusters.weights);
    recorder.whole("G_extended", &clusters);
    let mut lines = forest(&clusters.lines, &clusters.weights, Some((resolution, reach)));
    recorder.lines("G_pruned_mst", &lines);
    prune(&mut lines, resolution, reach);
    remove_rungs(&mut lines, resolution);
    judge(&mut lines, resolution, reach);
    recorder.lines("G_pruned_branches", &lines);
    let all = ground(&clusters, &cluster_of, points, graph, penalties, segments, resolution);
    take_vertices(&mut lines, &all);
    let mut pattern = Pattern { crease: lines, border };
    dock(&mut pattern, resolution);
    let Pattern { crease: mut lines, mut border } = pattern;
    let own = include(&mut lines, &border);
    bridge(&mut lines, StripKind::Crease, resolution);
    reroute(&mut lines, &all, resolution, reach);
    let mut walker = Walker::new(lines.edges.len(), resolution, reach);
    for gap in LAST_LINKS {
        connect_within(&mut lines, gap * resolution.spacing, &mut walker, resolution.spacing);
    }
    remove_open(&mut lines);
    remove_rungs(&mut lines, resolution);
    recorder.lines("G_closed", &lines);
    smooth(&mut lines, SMOOTHING);
    recorder.lines("G_smooth", &lines);
    leave(&mut lines, &mut border, own);
    corners(&mut lines, StripKind::Crease, resolution);
    Pattern { crease: lines, border }
}
