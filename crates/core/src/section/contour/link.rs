//! Nodes linked into chains.
//!
//! A section of a surface has no junctions: each node has one neighbour ahead and one behind. Links are taken
//! greedily by cost, so that the surest come first and ties fall to the lower index.

use super::chain::{Chain, Vertex};
use super::node::{Node, Nodes};
use crate::math::counting_sort::ascending;
use crate::math::trees::kd::Tree;
use crate::math::vec2::{distance, dot, sub};

/// Least cosine between a link and the tangents at its ends.
const LINK_COSINE: f64 = 0.72;

/// Chains of linked nodes, each node in one of them; links are at most `longest` local spacings long. Short links come first, and leave few nodes to look for long ones.
pub(crate) fn chains(nodes: &Nodes, longest: f64) -> Vec<Chain> {
    let Nodes { all, pairs, .. } = nodes;
    let mut ports = vec![[u32::MAX; 2]; all.len()];
    let near = |&&(a, b): &&(u32, u32)| {
        let (a, b) = (&all[a as usize], &all[b as usize]);
        distance(a.at, b.at) <= 0.5 * longest * a.spacing
    };
    take(all, pairs.iter().filter(near).copied(), &mut ports);
    take(all, far_pairs(all, &ports, longest).into_iter(), &mut ports);
    walk(all, &ports)
}

/// Pairs of nodes with loose ends, at most `longest` spacings apart.
fn far_pairs(nodes: &[Node], ports: &[Ports], longest: f64) -> Vec<(u32, u32)> {
    let loose: Vec<u32> =
        (0..nodes.len() as u32).filter(|&i| ports[i as usize].contains(&u32::MAX)).collect();
    let places: Vec<[f64; 2]> = loose.iter().map(|&i| nodes[i as usize].at).collect();
    let (tree, mut found, mut pairs) = (Tree::new(&places), Vec::new(), Vec::new());
    for (k, &a) in loose.iter().enumerate() {
        let node = &nodes[a as usize];
        tree.within(node.at, longest * node.spacing, &mut found);
        pairs.extend(found.iter().filter(|&&j| j as usize > k).map(|&j| (a, loose[j as usize])));
    }
    pairs
}

/// Takes the links that the pairs allow, the cheapest first, of equal ones the first.
fn take(nodes: &[Node], pairs: impl Iterator<Item = (u32, u32)>, ports: &mut [Ports]) {
    let candidate = |(a, b): (u32, u32)| {
        let (cost, ahead, behind) = link(&nodes[a as usize], &nodes[b as usize])?;
        let both = ((a, ahead), (b, behind));
        (free(ports, both.0) && free(ports, both.1)).then_some((cost, both))
    };
    let (costs, links): (Vec<f64>, Vec<(Port, Port)>) = pairs.filter_map(candidate).unzip();
    for i in ascending(&costs) {
        let (a, b) = links[i as usize];
        if free(ports, a) && free(ports, b) {
            ports[a.0 as usize][usize::from(a.1)] = b.0;
            ports[b.0 as usize][usize::from(b.1)] = a.0;
        }
    }
}

/// The neighbours ahead of a node and behind it; `u32::MAX` for none.
type Ports = [u32; 2];

/// A node and one of its two ports: ahead or behind.
type Port = (u32, bool);

fn free(ports: &[Ports], (node, port): Port) -> bool {
    ports[node as usize][usize::from(port)] == u32::MAX
}

/// The cost of a link, and the ports it takes.
fn link(a: &Node, b: &Node) -> Option<(f64, bool, bool)> {
    let step = sub(b.at, a.at);
    let length = dot(step, step).sqrt();
    let (ca, cb) = (dot(a.tangent, step) / length, -dot(b.tangent, step) / length);
    if a.weak != b.weak || length <= 0.0 || ca.abs() < LINK_COSINE || cb.abs() < LINK_COSINE {
        return None;
    }
    let spacing = 0.5 * (a.spacing + b.spacing);
    let cost = length / spacing * (1.0 + 3.0 * (2.0 - ca.abs() - cb.abs()));
    Some((cost, ca < 0.0, cb < 0.0))
}

fn walk(nodes: &[Node], ports: &[Ports]) -> Vec<Chain> {
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
            let node = &nodes[at];
            chain.vertices.push(Vertex {
                weak: node.weak,
                node: at as u32,
                ..Vertex::new(node.at, node.spacing)
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
