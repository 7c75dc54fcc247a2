//! Nodes: merges junction vertices of the pattern that lie within a few spacings.
//!
//! In a minimum spanning graph three lines meet in two or three neighbouring vertices as often as in one. A strip shorter than
//! the neighbourhood cannot be told from such a link, so it is contracted, and its ends become one node. The default method lays
//! corners where creases meet, on both sides of a thin wall, so that only creases up to a spacing long are contracted; its borders are
//! lines of the spanning graph.

use std::collections::BTreeMap;

use crate::frame::on_grid;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{add_scaled, distance, scale};
use crate::neighbors::Index;
use crate::pattern::{LineGraph, Path};
use crate::surface::Scales;

/// Greatest length of a strip between two junctions or corners that is contracted, spacings: of lines of a spanning graph.
pub(crate) const SPANNING: f64 = 3.0;

/// As [`SPANNING`], of creases that were led on to their corners.
pub(crate) const LED_ON: f64 = 1.0;

/// Greatest distance between a crease's end and a border's node that become one, spacings.
const BESIDE_NODE: f64 = 1.0;

/// One node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cluster {
    /// Local frame.
    pub position: [f64; 3],
    /// The vertex of the pattern that represents it.
    pub vertex: u32,
}

/// The nodes of one pattern and the paths between them.
#[derive(Clone, Debug)]
pub struct Meeting {
    /// The remaining paths, with their ends as indices into the clusters.
    pub paths: Vec<Path>,
    /// The nodes.
    pub clusters: Vec<Cluster>,
    /// Vertices of the pattern where paths end, with the cluster of each.
    members: Vec<(u32, u32)>,
}

/// Contracts strips up to `contracted` spacings long and numbers the nodes.
pub fn meet(lines: &LineGraph, paths: Vec<Path>, scales: Scales, contracted: f64) -> Meeting {
    let mut sets = UnionFind::new(lines.edges.len());
    let short: Vec<bool> = paths.iter().map(|p| is_short(lines, p, scales, contracted)).collect();
    for (path, _) in paths.iter().zip(&short).filter(|(_, s)| **s) {
        if let Some([a, b]) = path.ends {
            sets.union(a, b);
        }
    }
    let mut members: Vec<(u32, u32)> =
        paths.iter().filter_map(|p| p.ends).flatten().map(|v| (sets.find(v), v)).collect();
    members.sort_unstable();
    members.dedup();
    let groups: Vec<&[(u32, u32)]> = members.chunk_by(|a, b| a.0 == b.0).collect();
    let clusters: Vec<Cluster> = groups.iter().map(|g| cluster(lines, g)).collect();
    let mut number = vec![0; lines.edges.len()];
    let mut of_vertex = Vec::with_capacity(members.len());
    for (g, group) in groups.iter().enumerate() {
        for &(_, v) in *group {
            number[v as usize] = g as u32;
            of_vertex.push((v, g as u32));
        }
    }
    let kept = paths
        .into_iter()
        .zip(short)
        .filter(|(_, short)| !short)
        .map(|(p, _)| Path { ends: p.ends.map(|e| e.map(|v| number[v as usize])), ..p })
        .collect();
    Meeting { paths: kept, clusters, members: of_vertex }
}

/// Moves the nodes of creases that end on borders to the contracted nodes of the borders, and leaves out creases that this makes
/// too short, `contracted` spacings.
///
/// A crease that ends on a border has a vertex at the place of one of the border's (`link/repair/dock.rs`), but contraction
/// moves both to different means.
pub fn agree(
    crease: (&LineGraph, &mut Meeting),
    border: (&LineGraph, &Meeting),
    scales: Scales,
    contracted: f64,
) {
    let bits = |lines: &LineGraph, v: u32| lines.positions[v as usize].map(|x| (x + 0.0).to_bits());
    let places: BTreeMap<[u64; 3], [f64; 3]> = border
        .1
        .members
        .iter()
        .map(|&(v, g)| (bits(border.0, v), border.1.clusters[g as usize].position))
        .collect();
    let (lines, meeting) = crease;
    for &(v, g) in &meeting.members {
        if let Some(&place) = places.get(&bits(lines, v)) {
            meeting.clusters[g as usize].position = place;
        }
    }
    land(lines, meeting, border.1, scales);
    let clusters = &meeting.clusters;
    meeting.paths.retain(|path| {
        let Some([a, b]) = path.ends else { return true };
        clusters[a as usize].position != clusters[b as usize].position
            || length(lines, path, scales) > contracted
    });
}

/// Moves the ends of single creases to border nodes near them.
fn land(lines: &LineGraph, crease: &mut Meeting, border: &Meeting, scales: Scales) {
    let places: Vec<[f64; 3]> = border.clusters.iter().map(|c| c.position).collect();
    let index = Index::build(&places);
    let mut found = Vec::new();
    for cluster in crease.clusters.iter_mut().filter(|c| lines.edges[c.vertex as usize].len() == 1) {
        let near = BESIDE_NODE * scales.unit(lines.points[cluster.vertex as usize]);
        index.within(cluster.position, near, &mut found);
        if let Some(nearest) = found.first() {
            cluster.position = places[nearest.index as usize];
        }
    }
}

/// Length of a path, spacings.
fn length(lines: &LineGraph, path: &Path, scales: Scales) -> f64 {
    let edge = |w: &[u32]| {
        let [a, b] = [w[0] as usize, w[1] as usize];
        distance(lines.positions[a], lines.positions[b]) / scales.between(lines.points[a], lines.points[b])
    };
    path.vertices.windows(2).map(edge).sum()
}

/// Whether the strip is too short to be a line and lies between two nodes with other strips.
fn is_short(lines: &LineGraph, path: &Path, scales: Scales, contracted: f64) -> bool {
    let Some([a, b]) = path.ends else { return false };
    let junctions = lines.edges[a as usize].len() > 1 && lines.edges[b as usize].len() > 1;
    junctions && length(lines, path, scales) <= contracted
}

/// The mean of the vertices, in which those without a preferred direction have the greatest weight.
fn cluster(lines: &LineGraph, group: &[(u32, u32)]) -> Cluster {
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    let mut best = group[0].1;
    for &(_, v) in group {
        let weight = 1.02 - f64::from(lines.corner[v as usize].clamp(0.0, 1.0));
        sum = add_scaled(sum, lines.positions[v as usize], weight);
        total += weight;
        if lines.corner[v as usize] < lines.corner[best as usize] {
            best = v;
        }
    }
    // Rounded to a grid, so that crease and border agree on a place to the bit, whatever their weights.
    Cluster { position: scale(sum, 1.0 / total).map(on_grid), vertex: best }
}
