//! `G_extended`: closes gaps between small clusters on the same sharp edge (Demarsin et al. 2007, section 2.4).

use super::graph::Clusters;
use crate::math::vec3::distance;
use crate::neighbors::Index;

/// Joins small clusters that touch the same two large ones and are no farther apart than `reach`; returns the pairs added.
///
/// The paper's `reach` is the longest edge of `G_all` between small clusters, see `longest`.
pub fn extend(clusters: &mut Clusters, reach: f64) -> Vec<(u32, u32)> {
    let Clusters { lines, large, .. } = clusters;
    if lines.positions.is_empty() || reach <= 0.0 {
        return Vec::new();
    }
    let mut added = Vec::new();
    let index = Index::build(&lines.positions);
    let mut found = Vec::new();
    for a in 0..lines.positions.len() {
        if large[a].len() < 2 {
            continue;
        }
        index.within(lines.positions[a], reach, &mut found);
        for b in found.iter().map(|f| f.index as usize).filter(|&b| b > a) {
            if shared(&large[a], &large[b]) >= 2 && !lines.edges[a].contains(&(b as u32)) {
                lines.add_edge(a as u32, b as u32);
                added.push((a as u32, b as u32));
            }
        }
    }
    added
}

/// The longest edge; zero without any.
pub fn longest(clusters: &Clusters) -> f64 {
    let lines = &clusters.lines;
    let mut longest = 0.0_f64;
    for (a, list) in lines.edges.iter().enumerate() {
        for &b in list {
            longest = longest.max(distance(lines.positions[a], lines.positions[b as usize]));
        }
    }
    longest
}

/// The number of entries that two ascending lists share.
fn shared(a: &[u32], b: &[u32]) -> usize {
    a.iter().filter(|x| b.binary_search(x).is_ok()).count()
}
