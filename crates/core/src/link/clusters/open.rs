//! Removal of what stays open (Demarsin et al. 2007, section 2.7): in the end no vertex has exactly one edge.

use crate::pattern::LineGraph;

/// Takes away all branches that end in a vertex of degree one, but for the vertices in `anchored`: ends that lie on a border.
pub fn remove_open(lines: &mut LineGraph, anchored: &[u32]) {
    let mut fixed = vec![false; lines.edges.len()];
    for &v in anchored {
        fixed[v as usize] = true;
    }
    let mut ends: Vec<u32> = (0..lines.edges.len() as u32).collect();
    while let Some(v) = ends.pop() {
        if lines.edges[v as usize].len() == 1 && !fixed[v as usize] {
            let next = lines.edges[v as usize][0];
            lines.remove_edge(v, next);
            ends.push(next);
        }
    }
}
