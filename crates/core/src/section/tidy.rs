//! Vertices that turn a chain back on itself, left out.

use super::link::{Chain, Vertex};
use super::vec2::{dot, sub};

/// Leaves out every vertex, but corners, at which the chain turns by more than a right angle: a step of a spacing
/// along a curve never does, while a stray sample or an overshoot at a corner does.
pub(crate) fn tidy(chain: Chain) -> Chain {
    let closed = chain.closed;
    let mut vertices = chain.vertices;
    for _ in 0..8 {
        let before = vertices.len();
        vertices = pass(&vertices, closed);
        if vertices.len() == before {
            break;
        }
    }
    Chain { closed: closed && vertices.len() >= 3, vertices }
}

fn pass(vertices: &[Vertex], closed: bool) -> Vec<Vertex> {
    let n = vertices.len();
    if n < 4 {
        return vertices.to_vec();
    }
    let mut kept: Vec<Vertex> = Vec::with_capacity(n);
    for (i, v) in vertices.iter().enumerate() {
        let inner = closed || (i > 0 && i + 1 < n);
        let before = kept.last().unwrap_or(&vertices[n - 1]);
        let after = &vertices[(i + 1) % n];
        if !inner || v.corner || dot(sub(before.at, v.at), sub(after.at, v.at)) <= 0.0 {
            kept.push(*v);
        }
    }
    if kept.len() < 3 { vertices.to_vec() } else { kept }
}
