//! The connect algorithm (Demarsin et al. 2007, section 2.7).

use crate::link::spanning::{Metric, Walker};
use crate::neighbors::{Index, all_nearest};
use crate::pattern::LineGraph;

/// Bounds of `n` where it is derived from the graph.
const N_BOUNDS: [usize; 2] = [6, 32];

/// A link closes a small cycle if the rest of the cycle is no longer than so many gaps plus so many spacings (robust form).
const SMALL_CYCLE: (f64, f64) = (2.0, 4.0);

/// A gap is closed if the strip that leads up to it is longer than so many gaps plus so many spacings (robust form).
const LEAD: (f64, f64) = (1.5, 4.0);

/// Links each endpoint to the closest endpoint among its `n` nearest vertices (case 1) or, if none of them is an endpoint, to
/// the closest vertex with more than one edge (case 2), unless a path of up to `d` edges joins the two already.
///
/// The path is searched breadth first; it finds one exactly when the paper's depth-first search of restricted depth does.
pub fn connect(lines: &mut LineGraph, n: usize, d: usize) {
    let members: Vec<u32> = (0..lines.edges.len() as u32).filter(|&v| degree(lines, v) > 0).collect();
    let positions: Vec<[f64; 3]> = members.iter().map(|&v| lines.positions[v as usize]).collect();
    let nearest = all_nearest(&positions, n);
    let mut walker = Walker::new(lines.edges.len(), Metric::Edges);
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

/// Links what is still open in the robust form: each endpoint to the closest endpoint within `reach`, else to the closest
/// other vertex, if the strip that leads up to the gap is longer than the gap and no short path joins the two already.
pub fn connect_within(lines: &mut LineGraph, reach: f64, walker: &mut Walker, spacing: f64) {
    let members: Vec<u32> = (0..lines.edges.len() as u32).filter(|&v| degree(lines, v) > 0).collect();
    let positions: Vec<[f64; 3]> = members.iter().map(|&v| lines.positions[v as usize]).collect();
    if positions.is_empty() {
        return;
    }
    let index = Index::build(&positions);
    let mut found = Vec::new();
    let mut links: Vec<(bool, f64, u32, u32)> = Vec::new();
    for &end in members.iter().filter(|&&v| degree(lines, v) == 1) {
        let reach = reach.min((lines.strip_length(end) - LEAD.1 * spacing) / LEAD.0);
        if reach <= 0.0 {
            continue;
        }
        index.within(lines.positions[end as usize], reach, &mut found);
        for f in &found {
            let v = members[f.index as usize];
            if v != end {
                links.push((degree(lines, v) > 1, f.distance2.sqrt(), end, v));
            }
        }
    }
    links.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then((a.2, a.3).cmp(&(b.2, b.3))));
    for (_, gap, end, v) in links {
        if degree(lines, end) == 1
            && degree(lines, v) > 0
            && walker.path(lines, end, v, SMALL_CYCLE.0 * gap / spacing + SMALL_CYCLE.1).is_none()
        {
            lines.add_edge(end, v);
        }
    }
}

/// Derives `n` from the graph: the median over all endpoints of the number of vertices within `reach`, the longest edge of
/// `G_all`.
pub fn neighbors_in_reach(lines: &LineGraph, reach: f64) -> usize {
    let members: Vec<u32> = (0..lines.edges.len() as u32).filter(|&v| degree(lines, v) > 0).collect();
    let positions: Vec<[f64; 3]> = members.iter().map(|&v| lines.positions[v as usize]).collect();
    if positions.is_empty() {
        return N_BOUNDS[0];
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
    counts.get(counts.len() / 2).copied().unwrap_or(N_BOUNDS[0]).clamp(N_BOUNDS[0], N_BOUNDS[1])
}

fn degree(lines: &LineGraph, v: u32) -> usize {
    lines.edges[v as usize].len()
}
