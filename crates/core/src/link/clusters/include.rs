//! The border as part of the graph to be closed (Demarsin et al. 2007, section 3: for an open cloud "the boundary is included
//! just before the close step").

use crate::pattern::LineGraph;

/// Appends the border to the graph and returns the number of its first vertex there. Crease ends at exactly the position of a
/// border node are merged with it.
pub fn include(lines: &mut LineGraph, border: &LineGraph) -> usize {
    let own = lines.edges.len();
    let ends: Vec<u32> = (0..own as u32).filter(|&v| lines.edges[v as usize].len() == 1).collect();
    for v in 0..border.edges.len() {
        lines.points.push(border.points[v]);
        lines.positions.push(border.positions[v]);
        lines.penalty.push(border.penalty[v]);
        lines.corner.push(border.corner[v]);
        lines.evidence.push(border.evidence[v]);
        lines.edges.push(border.edges[v].iter().map(|w| w + own as u32).collect());
    }
    for end in ends {
        let at = lines.positions[end as usize];
        let node = border.nodes.iter().find(|&&n| border.positions[n as usize] == at);
        if let Some(&node) = node {
            let before = lines.edges[end as usize][0];
            lines.remove_edge(end, before);
            lines.add_edge(before, own as u32 + node);
        }
    }
    own
}

/// Takes the border, whose vertices begin at `own`, out again. Creases that end on it keep their ends, where it gets nodes.
pub fn leave(lines: &mut LineGraph, border: &mut LineGraph, own: usize) {
    let taken = own..own + border.edges.len();
    for v in taken.clone() {
        lines.edges[v].retain(|&w| !taken.contains(&(w as usize)));
        if !lines.edges[v].is_empty() {
            border.nodes.push((v - own) as u32);
        }
    }
    border.nodes.sort_unstable();
    border.nodes.dedup();
}
