//! Tidies a network: merges nodes at one place, drops repeated strips and stubs, and counts the strips at each node.

use std::collections::{BTreeMap, BTreeSet};

use crate::math::vec3::distance;
use crate::network::{Network, NodeKind, Strip, StripKind, trace};
use crate::surface::Scales;

/// Merges nodes at one place, keeps the first of strips with the same points, drops stubs, creases up to `stub` spacings long,
/// and counts the strips at each node. Crease and border pattern, or contracted junctions, can give the same line twice.
pub fn tidy(network: &mut Network, stub: f64, scales: Scales) {
    unite(network);
    let mut seen = BTreeSet::new();
    network.strips.retain(|strip| seen.insert((strip.closed, trace(strip))));
    count(network);
    loop {
        let before = network.strips.len();
        let Network { nodes, strips, .. } = network;
        strips.retain(|s| !is_stub(s, stub * coarsest(s, scales), |end| nodes[end as usize].degree));
        if network.strips.len() == before {
            break;
        }
        count(network);
    }
}

/// The greatest spacing along a strip.
fn coarsest(strip: &Strip, scales: Scales) -> f64 {
    strip.sources.iter().map(|&i| scales.unit(i)).fold(0.0, f64::max)
}

/// Whether a strip is a stub: short, with one loose end and one end on other strips.
fn is_stub(strip: &Strip, longest: f64, degree: impl Fn(u32) -> u32) -> bool {
    let (Some(start), Some(end)) = (strip.start, strip.end) else { return false };
    let [a, b] = [degree(start), degree(end)];
    let length: f64 = strip.points.windows(2).map(|w| distance(w[0], w[1])).sum();
    strip.kind == StripKind::Crease && a.min(b) == 1 && a.max(b) > 1 && length <= longest
}

/// Drops strips that the rounding of the world frame has shrunk to a point or made equal to another, and nodes without strips;
/// counts the strips at the others. Returns whether each strip stays.
pub fn settle(network: &mut Network) -> Vec<bool> {
    let mut seen = BTreeSet::new();
    let long = |s: &Strip| s.points.len() >= if s.closed { 3 } else { 2 };
    let stay: Vec<bool> =
        network.strips.iter().map(|s| long(s) && seen.insert((s.closed, trace(s)))).collect();
    let mut next = stay.iter();
    network.strips.retain(|_| next.next().is_some_and(|&s| s));
    let mut met = vec![false; network.nodes.len()];
    network.strips.iter().flat_map(|s| [s.start, s.end]).flatten().for_each(|end| met[end as usize] = true);
    let number: Vec<u32> = met
        .iter()
        .scan(0, |kept, &m| {
            *kept += u32::from(m);
            Some(*kept - u32::from(m))
        })
        .collect();
    let mut met = met.into_iter();
    network.nodes.retain(|_| met.next().unwrap_or(false));
    for end in network.strips.iter_mut().flat_map(|s| [&mut s.start, &mut s.end]).flatten() {
        *end = number[*end as usize];
    }
    count(network);
    stay
}

fn unite(network: &mut Network) {
    let mut places: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    let mut kept = Vec::new();
    let mut number = Vec::new();
    for node in std::mem::take(&mut network.nodes) {
        let id = *places.entry(node.position.map(|x| (x + 0.0).to_bits())).or_insert(kept.len() as u32);
        number.push(id);
        if id as usize == kept.len() {
            kept.push(node);
        }
    }
    network.nodes = kept;
    for end in network.strips.iter_mut().flat_map(|s| [&mut s.start, &mut s.end]).flatten() {
        *end = number[*end as usize];
    }
}

fn count(network: &mut Network) {
    network.nodes.iter_mut().for_each(|node| node.degree = 0);
    for end in network.strips.iter().flat_map(|s| [s.start, s.end]).flatten() {
        network.nodes[end as usize].degree += 1;
    }
    for node in &mut network.nodes {
        node.kind = NodeKind::of_degree(node.degree);
    }
}
