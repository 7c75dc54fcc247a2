//! Nodes linked into chains.
//!
//! A section of a surface has no junctions: each node has one neighbour ahead and one behind. Links are taken
//! greedily by cost, so that the surest come first and ties fall to the lower index.

use super::chain::{Chain, Vertex};
use super::node::Node;
use super::tree::Tree;
use super::vec2::{dot, sub};

/// Greatest length of a link between nodes, in local spacings.
const LINK: f64 = 2.4;
/// Least cosine between a link and the tangents at its ends.
const STRAIGHT: f64 = 0.72;

/// Chains of linked nodes, each node in one of them.
pub(crate) fn chains(nodes: &[Node]) -> Vec<Chain> {
    let mut links = candidates(nodes);
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut ports = vec![[u32::MAX; 2]; nodes.len()];
    for &(_, i, j, pi, pj) in &links {
        let free = ports[i as usize][pi] == u32::MAX && ports[j as usize][pj] == u32::MAX;
        if free {
            ports[i as usize][pi] = j;
            ports[j as usize][pj] = i;
        }
    }
    walk(nodes, &ports)
}

type Link = (f64, u32, u32, usize, usize);

fn candidates(nodes: &[Node]) -> Vec<Link> {
    let places: Vec<[f64; 2]> = nodes.iter().map(|n| n.at).collect();
    let tree = Tree::new(&places);
    let (mut links, mut found) = (Vec::new(), Vec::new());
    for (i, a) in nodes.iter().enumerate() {
        tree.within(a.at, LINK * a.spacing, &mut found);
        for &j in found.iter().filter(|&&j| j as usize > i) {
            let b = &nodes[j as usize];
            let step = sub(b.at, a.at);
            let length = dot(step, step).sqrt();
            let (ca, cb) = (dot(a.tangent, step) / length, -dot(b.tangent, step) / length);
            if a.weak != b.weak || length <= 0.0 || ca.abs() < STRAIGHT || cb.abs() < STRAIGHT {
                continue;
            }
            let spacing = 0.5 * (a.spacing + b.spacing);
            let cost = length / spacing * (1.0 + 3.0 * (2.0 - ca.abs() - cb.abs()));
            links.push((cost, i as u32, j, usize::from(ca < 0.0), usize::from(cb < 0.0)));
        }
    }
    links
}

fn walk(nodes: &[Node], ports: &[[u32; 2]]) -> Vec<Chain> {
    let mut seen = vec![false; nodes.len()];
    let mut chains = Vec::new();
    let loose = |i: &usize| ports[*i].contains(&u32::MAX);
    let starts = (0..nodes.len()).filter(loose).chain(0..nodes.len());
    for start in starts.collect::<Vec<_>>() {
        if seen[start] {
            continue;
        }
        let closed = !loose(&start);
        let mut chain = Chain { vertices: Vec::new(), closed };
        let (mut from, mut at) = (u32::MAX, start);
        loop {
            seen[at] = true;
            chain.vertices.push(Vertex {
                at: nodes[at].at,
                spacing: nodes[at].spacing,
                corner: false,
                weak: nodes[at].weak,
            });
            let next = if ports[at][0] == from { ports[at][1] } else { ports[at][0] };
            let next =
                if from == u32::MAX && next == u32::MAX { ports[at][0].min(ports[at][1]) } else { next };
            if next == u32::MAX || seen[next as usize] {
                break;
            }
            (from, at) = (at as u32, next as usize);
        }
        chains.push(chain);
    }
    chains
}
