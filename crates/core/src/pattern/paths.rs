//! Crease strips: the maximal paths of a pattern between its nodes, and its closed loops
//! (Gumhold 2001, section 4.1).

use super::line_graph::LineGraph;

/// A strip as a path through the pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Path {
    /// Vertices in order; a loop's first is not repeated.
    pub vertices: Vec<u32>,
    /// The nodes at both ends; `None` for a loop.
    pub ends: Option<[u32; 2]>,
}

impl Path {
    /// The edges along the path; a loop's last leads back to its first vertex.
    pub fn edges(&self) -> Vec<(u32, u32)> {
        let closing = match (self.ends, &self.vertices[..]) {
            (None, [first, .., last]) => Some((*last, *first)),
            _ => None,
        };
        self.vertices.windows(2).map(|w| (w[0], w[1])).chain(closing).collect()
    }

    /// Removes its edges from the graph.
    pub fn remove_from(&self, lines: &mut LineGraph) {
        self.edges().into_iter().for_each(|(a, b)| lines.remove_edge(a, b));
    }
}

/// All strips, each once: open ones from their lesser end vertex, then loops from their least vertex.
pub fn paths(lines: &LineGraph) -> Vec<Path> {
    let is_node = lines.is_node();
    let mut used = vec![false; lines.edges.len()];
    let mut paths = Vec::new();
    for v in 0..lines.edges.len() as u32 {
        if !is_node[v as usize] {
            continue;
        }
        for &next in &lines.edges[v as usize] {
            let vertices = follow(lines, &is_node, v, next);
            let last = vertices[vertices.len() - 1];
            // Each is found from both ends; one that returns to its own node is found in both directions.
            let mirror = (last, vertices[vertices.len() - 2]);
            if (v, next) <= mirror {
                for &w in &vertices {
                    used[w as usize] = true;
                }
                paths.push(Path { vertices, ends: Some([v, last]) });
            }
        }
    }
    for v in 0..lines.edges.len() as u32 {
        if lines.edges[v as usize].len() == 2 && !used[v as usize] {
            let mut vertices = follow(lines, &is_node, v, lines.edges[v as usize][0]);
            vertices.pop();
            for &w in &vertices {
                used[w as usize] = true;
            }
            paths.push(Path { vertices, ends: None });
        }
    }
    paths
}

/// Walks from `v` over `next` to the next node, or back to `v`.
fn follow(lines: &LineGraph, is_node: &[bool], v: u32, next: u32) -> Vec<u32> {
    let mut vertices = vec![v, next];
    let (mut before, mut at) = (v, next);
    while !is_node[at as usize] && at != v {
        let pair = &lines.edges[at as usize];
        let onward = if pair[0] == before { pair[1] } else { pair[0] };
        vertices.push(onward);
        (before, at) = (at, onward);
    }
    vertices
}
