//! Removal of the branches that stay open (Demarsin et al. 2007, section 2.7): in the end no vertex has exactly one edge.

use crate::pattern::LineGraph;

/// Removes branches with an open end that are shorter than `least`, in the unit of the positions.
pub fn remove_short(lines: &mut LineGraph, least: f64) {
    for end in 0..lines.edges.len() as u32 {
        if lines.edges[end as usize].len() != 1 || lines.strip_length(end) >= least {
            continue;
        }
        let mut at = end;
        while let [next] = *lines.edges[at as usize].as_slice() {
            lines.remove_edge(at, next);
            at = next;
        }
    }
}

/// Removes all branches with an open end.
pub fn remove_open(lines: &mut LineGraph) {
    let mut ends: Vec<u32> = (0..lines.edges.len() as u32).collect();
    while let Some(v) = ends.pop() {
        if let [next] = *lines.edges[v as usize].as_slice() {
            lines.remove_edge(v, next);
            ends.push(next);
        }
    }
}
