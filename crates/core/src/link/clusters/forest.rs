//! `G_pruned_mst` (Demarsin et al. 2007, section 2.5): the minimum spanning tree without its edges to large clusters.

use crate::link::spanning::{Candidate, CycleRule, Web, enters, sort};
use crate::math::union_find::UnionFind;
use crate::math::vec3::distance;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// All edges by length, which is the paper's weight, ties by index.
pub fn by_length(lines: &LineGraph) -> Vec<Candidate> {
    let mut edges: Vec<Candidate> = Vec::with_capacity(lines.edge_count());
    for (a, list) in lines.edges.iter().enumerate() {
        for &b in list.iter().filter(|&&b| b as usize > a) {
            let weight = distance(lines.positions[a], lines.positions[b as usize]);
            edges.push(Candidate { weight, a: a as u32, b });
        }
    }
    sort(&mut edges);
    edges
}

/// The minimum spanning forest over `edges` in their order.
///
/// With `keep`, an edge that closes a long, open cycle stays (Gumhold 2001, section 3.2). The paper's tree cuts every loop
/// at an arbitrary place, and a loop cut close to a junction is pruned before it can be closed again.
pub fn forest(lines: &LineGraph, edges: &[Candidate], keep: Option<(Resolution, CycleRule)>) -> LineGraph {
    let mut tree = LineGraph { edges: vec![Vec::new(); lines.edges.len()], ..lines.clone() };
    let mut sets = UnionFind::new(lines.edges.len());
    let mut web = Web::new(lines.edges.len());
    for edge in edges {
        if tree.edges[edge.a as usize].contains(&edge.b) {
            continue;
        }
        let wanted = match keep {
            Some((resolution, rule)) => enters(&tree, &mut web, edge, resolution.into(), rule),
            None => sets.union(edge.a, edge.b),
        };
        if wanted {
            tree.add_edge(edge.a, edge.b);
        }
    }
    tree
}
