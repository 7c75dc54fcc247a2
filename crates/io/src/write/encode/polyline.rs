//! Strips as polylines over shared vertices, for OBJ, PLY and their like.

use lineament::{Network, Strip};

/// All vertices of a network and every strip's way through them.
pub(in crate::write) struct Polylines {
    /// The nodes first, by their ids, then the inner points of the strips.
    pub vertices: Vec<[f64; 3]>,
    /// A strip's vertices in order. The first vertex of a closed strip is repeated at its end.
    pub paths: Vec<Vec<usize>>,
}

impl Polylines {
    /// Strips that meet in a node share its vertex, so that the lines are joined and not just touching.
    pub fn of(network: &Network) -> Self {
        let mut vertices: Vec<[f64; 3]> = network.nodes.iter().map(|node| node.position).collect();
        let paths = network.strips.iter().map(|strip| path(strip, &mut vertices)).collect();
        Self { vertices, paths }
    }
}

fn path(strip: &Strip, vertices: &mut Vec<[f64; 3]>) -> Vec<usize> {
    let last = strip.points.len().saturating_sub(1);
    let mut path = Vec::with_capacity(strip.points.len() + 1);
    for (i, &point) in strip.points.iter().enumerate() {
        let node = if i == 0 {
            strip.start
        } else if i == last {
            strip.end
        } else {
            None
        };
        path.push(node.map_or(vertices.len(), |node| node as usize));
        if node.is_none() {
            vertices.push(point);
        }
    }
    if strip.closed && path.len() > 1 {
        path.push(path[0]);
    }
    path
}
