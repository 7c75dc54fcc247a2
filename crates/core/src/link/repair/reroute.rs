//! Closes gaps over weak ground (robust form): from an open end along clusters that the pruning removed.
//!
//! The paper links an endpoint by one straight edge. Where a fold fades for longer than that, the small clusters still show
//! the way: the shortest path through `G_extended` that leads back to the lines without closing a small cycle.

use crate::link::spanning::{Metric, Walker};
use crate::math::vec3::distance;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Longest way through weak clusters in each round, spacings: short ways first, as they may make long ones needless. No way is
/// longer than the strip that leads up to it.
const LONGEST_WAY: [f64; 3] = [4.0, 10.0, 20.0];
/// A way closes a small cycle if a path within the lines is no longer than so many times the way plus so many spacings.
const DETOUR: (f64, f64) = (2.0, 4.0);

/// Lengths in millionths of a spacing, so that they have a total order and equal ones go by index.
type Length = u64;

/// Closes the open ends that it can. `all` is `G_extended` on the same vertices; `lines` may have further ones after them.
pub(crate) fn reroute(lines: &mut LineGraph, all: &LineGraph, resolution: Resolution, metric: Metric) {
    let mut walker = Walker::new(lines.edges.len(), metric);
    for longest in LONGEST_WAY {
        let ends: Vec<u32> =
            (0..all.edges.len() as u32).filter(|&v| lines.edges[v as usize].len() == 1).collect();
        for end in ends {
            if lines.edges[end as usize].len() != 1 {
                continue;
            }
            let lead = lines.strip_length(end) / resolution.spacing;
            if let Some(path) = way(lines, all, end, resolution, longest.min(lead), &mut walker) {
                for pair in path.windows(2) {
                    lines.add_edge(pair[0], pair[1]);
                }
            }
        }
    }
}

/// The shortest way from `end` over free vertices to one of the lines.
fn way(
    lines: &LineGraph,
    all: &LineGraph,
    end: u32,
    resolution: Resolution,
    longest: f64,
    walker: &mut Walker,
) -> Option<Vec<u32>> {
    let mut heap: BinaryHeap<(Reverse<Length>, Reverse<u32>)> =
        BinaryHeap::from([(Reverse(0), Reverse(end))]);
    let mut known: Vec<(u32, Length, u32)> = vec![(end, 0, end)];
    while let Some((Reverse(length), Reverse(v))) = heap.pop() {
        let entry = known.iter().find(|k| k.0 == v).copied()?;
        if length > entry.1 {
            continue;
        }
        if v != end && !lines.edges[v as usize].is_empty() {
            let least = DETOUR.0 * length as f64 * 1e-6 + DETOUR.1;
            if walker.path(lines, end, v, least).is_none() {
                return Some(trace(&known, end, v));
            }
            continue;
        }
        for &next in &all.edges[v as usize] {
            let step = distance(all.positions[v as usize], all.positions[next as usize]) / resolution.spacing;
            // Two short steps rather than one long: the way keeps to the clusters.
            let total = length + ((step * step).max(0.3 * step) * 1e6) as Length;
            if total as f64 > longest * 1e6 {
                continue;
            }
            match known.iter_mut().find(|k| k.0 == next) {
                Some(k) if k.1 <= total => continue,
                Some(k) => (k.1, k.2) = (total, v),
                None => known.push((next, total, v)),
            }
            heap.push((Reverse(total), Reverse(next)));
        }
    }
    None
}

/// The vertices from `end` to `v`.
fn trace(known: &[(u32, Length, u32)], end: u32, mut v: u32) -> Vec<u32> {
    let mut path = vec![v];
    while v != end {
        let Some(k) = known.iter().find(|k| k.0 == v) else { break };
        v = k.2;
        path.push(v);
    }
    path
}
