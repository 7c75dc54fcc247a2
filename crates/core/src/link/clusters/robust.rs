//! The same steps on steadier ground: how noise, blunt folds and borders are met.
//!
//! Where it departs from Demarsin et al. 2007, and why:
//! * **Small clusters** are the crease candidates of the penalties at their feet (see `group`), as one-ring normals at 8
//!   degrees break into small clusters everywhere from a noise of a tenth of the spacing on.
//! * **Spanning forest**: edges that close a long and open cycle stay, so that loops need no closing.
//! * **Branches** are measured in spacings, not edges, and strips that turn out round are dropped.
//! * **Connect**: ends are joined by direction as well as distance, which the paper itself proposes (section 3, an ellipsoid
//!   in place of the sphere), then through clusters that the pruning left out.
//! * **Borders** go through the same steps before the creases are closed, and creases end on them.

use super::connect::connect_within;
use super::extend::extend;
use super::forest::sort;
use super::ground::{ground, take_vertices};
use super::group::group;
use super::open::remove_open;
use super::reroute::reroute;
use super::smooth::smooth;
use super::{Linked, Recorder, forest};
use crate::detect::segments::Segmentation;
use crate::link::walk::Walker;
use crate::link::{Candidate, Reach, bridge, candidate_edges, judge, prune};
use crate::math::vec3::{distance, dot, sub, unit};
use crate::measure::{Measure, Penalties};
use crate::neighbors::{Index, Neighbors};
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

/// Gaps between clusters of one pair of faces that are closed at once, spacings.
const EXTEND: f64 = 2.5;
/// What an edge of `G_extended` weighs more than one of `G_all`.
const ADDED: f64 = 2.0;
/// Gaps closed at last by the shortest link whatever its direction, spacings.
const LAST_LINKS: [f64; 3] = [3.0, 6.0, 10.0];
/// Steps of smoothing.
const SMOOTHING: usize = 2;
/// How near to a border a crease must come to end on it, spacings, and how far aside the border may lie, degrees.
const ON_BORDER: [(f64, f64); 2] = [(1.5, 180.0), (4.0, 50.0)];

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
    let border = close(&cloud, &measure.border, None, &mut Recorder::new());
    let mut recorder = Recorder::new();
    let crease = close(&cloud, &measure.crease, Some(&border), &mut recorder);
    Linked { pattern: Pattern { crease, border }, stages: recorder.stages }
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

/// The closed lines of one kind.
fn close(
    cloud: &Context,
    penalties: &Penalties,
    border: Option<&LineGraph>,
    recorder: &mut Recorder,
) -> LineGraph {
    let &Context { points, graph, measure, segments, resolution, reach } = cloud;
    let hops = if border.is_some() { 1 } else { reach.border_hops };
    let (mut clusters, cluster_of) = group(
        graph,
        penalties,
        &candidate_edges(graph, measure, penalties, resolution, 1.0, hops),
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
    judge(&mut lines, resolution, reach);
    recorder.lines("G_pruned_branches", &lines);
    let all = match border {
        Some(_) => ground(&clusters, &cluster_of, points, graph, penalties, segments, resolution),
        None => clusters.lines,
    };
    take_vertices(&mut lines, &all);
    let mut anchored = border.map(|b| anchor(&mut lines, b, resolution)).unwrap_or_default();
    bridge(&mut lines, crate::network::StripKind::Crease, resolution);
    let mut fixed = vec![false; lines.edges.len()];
    anchored.iter().for_each(|&v| fixed[v as usize] = true);
    reroute(&mut lines, &all, &fixed, resolution, reach);
    let mut walker = Walker::new(lines.edges.len(), resolution, reach);
    for gap in LAST_LINKS {
        connect_within(&mut lines, &fixed, gap * resolution.spacing, &mut walker, resolution.spacing);
    }
    if let Some(border) = border {
        anchored.extend(anchor(&mut lines, border, resolution));
    }
    remove_open(&mut lines, &anchored);
    recorder.lines("G_closed", &lines);
    smooth(&mut lines, SMOOTHING);
    recorder.lines("G_smooth", &lines);
    lines
}

/// Leads crease ends that come near a border on to it; the vertices added there.
fn anchor(lines: &mut LineGraph, border: &LineGraph, resolution: Resolution) -> Vec<u32> {
    let on: Vec<u32> =
        (0..border.edges.len() as u32).filter(|&v| !border.edges[v as usize].is_empty()).collect();
    let positions: Vec<[f64; 3]> = on.iter().map(|&v| border.positions[v as usize]).collect();
    let mut anchored = Vec::new();
    if positions.is_empty() {
        return anchored;
    }
    let index = Index::build(&positions);
    let mut found = Vec::new();
    let ends: Vec<u32> =
        (0..lines.edges.len() as u32).filter(|&v| lines.edges[v as usize].len() == 1).collect();
    for end in ends {
        let at = lines.positions[end as usize];
        let tangent = unit(sub(at, lines.positions[behind(lines, end) as usize]));
        let target = ON_BORDER.iter().find_map(|&(reach, angle)| {
            index.within(at, reach * resolution.spacing, &mut found);
            let ahead = |f: u32| {
                let gap = sub(positions[f as usize], at);
                dot(tangent, unit(gap)) >= angle.to_radians().cos()
            };
            found
                .iter()
                .filter(|f| ahead(f.index))
                .min_by(|a, b| a.distance2.total_cmp(&b.distance2).then(a.index.cmp(&b.index)))
                .map(|f| f.index)
        });
        if let Some(target) = target {
            let vertex = lines.add_vertex(end, positions[target as usize]);
            lines.points[vertex as usize] = border.points[on[target as usize] as usize];
            lines.add_edge(end, vertex);
            anchored.push(vertex);
        }
    }
    anchored
}

/// The vertex a few edges behind an end.
fn behind(lines: &LineGraph, end: u32) -> u32 {
    let (mut before, mut at) = (end, lines.edges[end as usize][0]);
    for _ in 0..4 {
        let next = &lines.edges[at as usize];
        if next.len() != 2 || distance(lines.positions[at as usize], lines.positions[end as usize]) == 0.0 {
            break;
        }
        (before, at) = (at, if next[0] == before { next[1] } else { next[0] });
    }
    at
}
