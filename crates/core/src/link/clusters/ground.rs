//! Weak ground (robust form): places where two large clusters touch without a candidate between them.
//!
//! A fading fold, or noise at one place, leaves gaps between the small clusters, but the segmentation still shows where the
//! faces meet. Such places become vertices that only the closing step may use.

use super::graph::Clusters;
use crate::detect::segments::Segmentation;
use crate::math::vec3::{add, add_scaled, distance, scale};
use crate::measure::Penalties;
use crate::neighbors::Neighbors;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// Longest edge over weak ground, spacings.
const LONGEST_EDGE: f64 = 2.5;

/// The graph of the clusters with the weak places as further vertices. `cluster_of` is the cluster of each candidate.
pub fn ground(
    clusters: &Clusters,
    cluster_of: &[u32],
    points: &[[f64; 3]],
    graph: &Neighbors,
    penalties: &Penalties,
    segments: &Segmentation,
    resolution: Resolution,
) -> LineGraph {
    let mut all = clusters.lines.clone();
    let mut vertex = vec![u32::MAX; points.len()];
    for (c, &p) in penalties.points.iter().enumerate() {
        vertex[p as usize] = cluster_of[c];
    }
    for (i, vertex) in vertex.iter_mut().enumerate().filter(|(_, v)| **v == u32::MAX) {
        if let Some(place) = between(points, graph, segments, i) {
            *vertex = all.push_vertex(i as u32, place);
        }
    }
    for i in (0..points.len()).filter(|&i| vertex[i] != u32::MAX) {
        for &j in graph.of(i) {
            let (a, b) = (vertex[i], vertex[j as usize]);
            if b == u32::MAX || a == b {
                continue;
            }
            let apart = distance(all.positions[a as usize], all.positions[b as usize]);
            if apart <= LONGEST_EDGE * resolution.spacing {
                all.add_edge(a, b);
            }
        }
    }
    all
}

/// The middle between a point and its neighbours in other large clusters; `None` if it has none.
fn between(points: &[[f64; 3]], graph: &Neighbors, segments: &Segmentation, i: usize) -> Option<[f64; 3]> {
    let own = segments.label[i];
    let large = |c: u32| segments.large[c as usize];
    if !large(own) {
        return None;
    }
    let other: Vec<u32> = graph
        .of(i)
        .iter()
        .copied()
        .filter(|&j| segments.label[j as usize] != own && large(segments.label[j as usize]))
        .collect();
    if other.is_empty() {
        return None;
    }
    let share = 1.0 / other.len() as f64;
    let mean = other.iter().fold([0.0; 3], |sum, &j| add_scaled(sum, points[j as usize], share));
    Some(scale(add(points[i], mean), 0.5))
}

/// Appends the further vertices of `all` to `lines`, without edges.
pub fn take_vertices(lines: &mut LineGraph, all: &LineGraph) {
    for v in lines.edges.len()..all.edges.len() {
        lines.push_vertex(all.points[v], all.positions[v]);
    }
}
