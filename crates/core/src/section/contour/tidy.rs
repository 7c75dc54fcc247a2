//! Vertices that turn a chain back on itself, or crowd a corner, left out.

use super::chain::{Chain, Vertex};
use crate::math::vec2::{distance, dot, sub};

/// Vertices this close to a corner, in spacings, are left to it: samples of both sides meet there.
const CROWDED: f64 = 0.5;

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
        let crowds = |o: &Vertex| o.corner && distance(o.at, v.at) < CROWDED * v.spacing;
        let back = dot(sub(before.at, v.at), sub(after.at, v.at)) > 0.0;
        if !inner || v.corner || !(back || crowds(before) || crowds(after)) {
            kept.push(*v);
        }
    }
    if kept.len() < 3 { vertices.to_vec() } else { kept }
}
