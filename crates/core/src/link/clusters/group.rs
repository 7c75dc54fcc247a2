//! Small clusters of the robust form: candidates whose feet on the line coincide.
//!
//! The paper's small clusters lie where single normals happen to differ, up to a spacing beside the edge. Here the crease
//! candidates are used, each at its foot on the line, and those within a fraction of a spacing form one cluster at the foot of
//! the best of them. This gives a row of vertices along the line instead of a band.

use super::graph::Clusters;
use crate::detect::segments::Segmentation;
use crate::link::spanning::Candidate;
use crate::math::vec3::distance;
use crate::measure::{Evidence, Penalties};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::resolution::Resolution;

/// Radius of a cluster around the foot of its first candidate, spacings.
const TOGETHER: f64 = 0.3;
/// Longest edge of `G_all` between feet, spacings.
const LONGEST_EDGE: f64 = 3.0;

/// Groups the candidates, the least penalty first, and joins groups by `edges` between their candidates. Also returns the
/// cluster of each candidate.
pub fn group(
    graph: &Neighbors,
    penalties: &Penalties,
    edges: &[Candidate],
    segments: &Segmentation,
    resolution: Resolution,
) -> (Clusters, Vec<u32>) {
    let groups = groups(graph, penalties, TOGETHER * resolution.spacing);
    let mut of_candidate = vec![0u32; penalties.len()];
    for (g, members) in groups.iter().enumerate() {
        members.iter().for_each(|&c| of_candidate[c as usize] = g as u32);
    }
    let mut clusters = Clusters { large_count: segments.large_count(), ..Default::default() };
    for members in &groups {
        push(&mut clusters, graph, penalties, segments, members);
    }
    for edge in edges {
        let (a, b) = (of_candidate[edge.a as usize], of_candidate[edge.b as usize]);
        let positions = &clusters.lines.positions;
        let apart = distance(positions[a as usize], positions[b as usize]) / resolution.spacing;
        if a != b && apart <= LONGEST_EDGE {
            clusters.lines.add_edge(a, b);
            clusters.weights.push(Candidate { weight: edge.weight, a: a.min(b), b: a.max(b) });
        }
    }
    (clusters, of_candidate)
}

/// Candidates of each group, beginning with the one from which it grew; groups in the order of their first candidates.
fn groups(graph: &Neighbors, penalties: &Penalties, radius: f64) -> Vec<Vec<u32>> {
    let mut order: Vec<u32> = (0..penalties.len() as u32).collect();
    order.sort_by(|&a, &b| {
        penalties.scalar[a as usize].total_cmp(&penalties.scalar[b as usize]).then(a.cmp(&b))
    });
    let mut taken = vec![false; penalties.len()];
    let mut scratch = Scratch::default();
    let mut groups = Vec::new();
    for first in order {
        if std::mem::replace(&mut taken[first as usize], true) {
            continue;
        }
        let mut members = vec![first];
        let foot = penalties.foot[first as usize];
        for j in graph.hops(penalties.points[first as usize] as usize, 2, &mut scratch) {
            let Ok(c) = penalties.points.binary_search(j) else { continue };
            if !taken[c] && distance(penalties.foot[c], foot) <= radius {
                taken[c] = true;
                members.push(c as u32);
            }
        }
        groups.push(members);
    }
    groups.sort_unstable_by_key(|members| members[0]);
    groups
}

/// Adds one cluster for the given candidates.
fn push(
    clusters: &mut Clusters,
    graph: &Neighbors,
    penalties: &Penalties,
    segments: &Segmentation,
    members: &[u32],
) {
    let first = members[0] as usize;
    let lines = &mut clusters.lines;
    lines.points.push(penalties.points[first]);
    lines.positions.push(penalties.foot[first]);
    let sum = members.iter().map(|&c| f64::from(penalties.scalar[c as usize])).sum::<f64>();
    lines.penalty.push(Some((sum * (1.0 / members.len() as f64)) as f32));
    lines.corner.push(members.iter().map(|&c| penalties.corner[c as usize]).fold(1.0, f32::min));
    lines.evidence.push(together(penalties, members));
    lines.edges.push(Vec::new());
    let mut large: Vec<u32> = members
        .iter()
        .map(|&c| penalties.points[c as usize])
        .flat_map(|p| graph.of(p as usize).iter().copied().chain([p]))
        .map(|p| segments.label[p as usize])
        .filter(|&label| segments.large[label as usize])
        .collect();
    large.sort_unstable();
    large.dedup();
    clusters.large.push(large);
}

/// The evidence of all members: sums, with the mean fold. `None` where no cross-section was taken.
fn together(penalties: &Penalties, members: &[u32]) -> Option<Evidence> {
    let shown = || members.iter().map(|&c| penalties.evidence[c as usize]);
    if shown().all(|e| e.is_none()) {
        return None;
    }
    let sum = |of: fn(Evidence) -> f32| shown().map(|e| f64::from(e.map_or(0.0, of))).sum::<f64>();
    Some(Evidence {
        sharp: sum(|e| e.sharp) as f32,
        expected: sum(|e| e.expected) as f32,
        fold: (sum(|e| e.fold) * (1.0 / members.len() as f64)) as f32,
    })
}
