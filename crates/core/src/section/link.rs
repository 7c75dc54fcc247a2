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

/// Chains of linked nodes, each node in one of them. Short links come first, and leave few nodes to look for long ones.
pub(crate) fn chains(nodes: &[Node]) -> Vec<Chain> {
    let places: Vec<[f64; 2]> = nodes.iter().map(|n| n.at).collect();
    let tree = Tree::new(&places);
    let mut ports = vec![[u32::MAX; 2]; nodes.len()];
    for reach in [0.5 * LINK, LINK] {
        let mut links = candidates(nodes, &tree, &ports, reach);
        links.sort_unstable();
        for Link { a, b, .. } in links {
            if free(&ports, a) && free(&ports, b) {
                ports[a.0 as usize][usize::from(a.1)] = b.0;
                ports[b.0 as usize][usize::from(b.1)] = a.0;
            }
        }
    }
    walk(nodes, &ports)
}

/// A node and one of its two ports: ahead or behind.
type Port = (u32, bool);

fn free(ports: &[[u32; 2]], (node, port): Port) -> bool {
    ports[node as usize][usize::from(port)] == u32::MAX
}

/// A link that may be, in the order they are tried: by cost, then by index.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Link {
    /// The bits of the cost, which is not negative.
    cost: u64,
    a: Port,
    b: Port,
}

fn candidates(nodes: &[Node], tree: &Tree<2>, ports: &[[u32; 2]], reach: f64) -> Vec<Link> {
    let (mut links, mut found) = (Vec::new(), Vec::new());
    let loose = |i: u32| ports[i as usize].contains(&u32::MAX);
    for (a, i) in nodes.iter().zip(0u32..).filter(|(_, i)| loose(*i)) {
        tree.within(a.at, reach * a.spacing, &mut found);
        links.extend(found.iter().filter(|&&j| j > i && loose(j)).filter_map(|&j| {
            let (cost, ahead, behind) = link(a, &nodes[j as usize])?;
            let link = Link { cost: cost.to_bits(), a: (i, ahead), b: (j, behind) };
            (free(ports, link.a) && free(ports, link.b)).then_some(link)
        }));
    }
    links
}

/// The cost of a link, and the ports it takes.
fn link(a: &Node, b: &Node) -> Option<(f64, bool, bool)> {
    let step = sub(b.at, a.at);
    let length = dot(step, step).sqrt();
    let (ca, cb) = (dot(a.tangent, step) / length, -dot(b.tangent, step) / length);
    if a.weak != b.weak || length <= 0.0 || ca.abs() < STRAIGHT || cb.abs() < STRAIGHT {
        return None;
    }
    let spacing = 0.5 * (a.spacing + b.spacing);
    let cost = length / spacing * (1.0 + 3.0 * (2.0 - ca.abs() - cb.abs()));
    Some((cost, ca < 0.0, cb < 0.0))
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
