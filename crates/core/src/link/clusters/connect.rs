//! The connect algorithm (Demarsin et al. 2007, section 2.7).

use crate::link::Reach;
use crate::link::walk::Walker;
use crate::neighbors::{Index, all_nearest};
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// Bounds of `n` where it follows from the graph.
const NEIGHBORS: [usize; 2] = [6, 32];

/// Links each endpoint: to the closest endpoint among its `n` nearest vertices (case 1), or, where there is none, to the
/// closest vertex with more than one edge (case 2), if no path of up to `d` edges joins them already.
///
/// A path shorter than `d` is looked for from the shortest on, which finds one exactly if the paper's depth-first search of
/// restricted depth does.
pub fn connect(lines: &mut LineGraph, resolution: Resolution, n: usize, d: usize) {
    let members: Vec<u32> = (0..lines.edges.len() as u32).filter(|&v| degree(lines, v) > 0).collect();
    let positions: Vec<[f64; 3]> = members.iter().map(|&v| lines.positions[v as usize]).collect();
    let nearest = all_nearest(&positions, n);
    let reach = Reach { rho: d as f64, in_edges: true, openness: 0.0 };
    let mut walker = Walker::new(lines.edges.len(), resolution, reach);
    for (i, &end) in members.iter().enumerate() {
        if degree(lines, end) != 1 {
            continue;
        }
        let around: Vec<u32> = nearest.of(i).iter().map(|&m| members[m as usize]).collect();
        let to_end = around.iter().any(|&v| degree(lines, v) == 1);
        let target = around
            .iter()
            .copied()
            .filter(|&v| if to_end { degree(lines, v) == 1 } else { degree(lines, v) > 1 })
            .find(|&v| walker.path(lines, end, v, d as f64).is_none());
        if let Some(target) = target {
            lines.add_edge(end, target);
        }
    }
}

/// `n` from the graph: as many vertices as an endpoint has within `reach`, the longest gap that the segmentation itself has
/// bridged; the median over the endpoints.
pub fn neighbors_in_reach(lines: &LineGraph, reach: f64) -> usize {
    let members: Vec<u32> = (0..lines.edges.len() as u32).filter(|&v| degree(lines, v) > 0).collect();
    let positions: Vec<[f64; 3]> = members.iter().map(|&v| lines.positions[v as usize]).collect();
    if positions.is_empty() {
        return NEIGHBORS[0];
    }
    let index = Index::build(&positions);
    let mut found = Vec::new();
    let mut counts: Vec<usize> = members
        .iter()
        .filter(|&&v| degree(lines, v) == 1)
        .map(|&v| {
            index.within(lines.positions[v as usize], reach, &mut found);
            found.len()
        })
        .collect();
    counts.sort_unstable();
    counts.get(counts.len() / 2).copied().unwrap_or(NEIGHBORS[0]).clamp(NEIGHBORS[0], NEIGHBORS[1])
}

fn degree(lines: &LineGraph, v: u32) -> usize {
    lines.edges[v as usize].len()
}
