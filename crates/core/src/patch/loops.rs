//! The boundary loops of each patch.
//!
//! A strip between two patches gives each of them a half-edge with the patch on its left, seen from outside. The next half-edge
//! begins in the node where the last one ends: among several, the first one clockwise from the way back, so that the region
//! between lies to the left.

use super::sides::Sides;
use crate::math::vec3::{add, add_scaled, cross, dot, norm, scale, sub, unit};
use crate::network::{Network, Strip};

/// A strip as part of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Coedge {
    /// The strip.
    pub strip: u32,
    /// Whether the loop runs along it from its first point to its last.
    pub forward: bool,
}

/// A boundary loop of a patch, which lies to its left as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Loop {
    /// The strips in order.
    pub coedges: Vec<Coedge>,
    /// Whether the last one ends where the first begins.
    pub closed: bool,
    /// Whether it is the outer boundary rather than that of a hole. A surface that closes on itself, such as the side of a
    /// cylinder, has no outer boundary by nature; its longest loop counts as outer.
    pub outer: bool,
}

/// The loops of all patches, the outer loop of each first. `normals` point outwards.
pub fn loops(
    network: &Network,
    sides: &[Sides],
    members: &[Vec<u32>],
    normals: &[[f64; 3]],
) -> Vec<Vec<Loop>> {
    let mut coedges = vec![Vec::new(); members.len()];
    for (s, side) in sides.iter().enumerate() {
        for (patch, forward) in [(side.left, true), (side.right, false)] {
            if let Some(p) = patch {
                coedges[p as usize].push(Coedge { strip: s as u32, forward });
            }
        }
    }
    let up = |p: usize| {
        let sum = members[p].iter().fold([0.0; 3], |sum, &i| add(sum, normals[i as usize]));
        scale(sum, 1.0 / members[p].len().max(1) as f64)
    };
    coedges.into_iter().enumerate().map(|(p, coedges)| of(network, coedges, up(p))).collect()
}

/// The loops formed by half-edges.
fn of(network: &Network, coedges: Vec<Coedge>, up: [f64; 3]) -> Vec<Loop> {
    let mut free = vec![true; coedges.len()];
    let mut loops = Vec::new();
    // Half-edges without a predecessor come first, so that an open chain is walked from its start.
    let starts = |c: &Coedge| ends(network, *c).map(|e| e[0]);
    let stops = |c: &Coedge| ends(network, *c).map(|e| e[1]);
    let fed = |c: &Coedge| starts(c).is_none_or(|v| coedges.iter().any(|d| stops(d) == Some(v)));
    let (mut order, rest): (Vec<usize>, Vec<usize>) = (0..coedges.len()).partition(|&c| !fed(&coedges[c]));
    order.extend(rest);
    for first in order {
        if !free[first] {
            continue;
        }
        let mut found = Loop { closed: starts(&coedges[first]).is_none(), ..Loop::default() };
        let mut at = Some(first);
        while let Some(c) = at {
            free[c] = false;
            found.coedges.push(coedges[c]);
            let Some(node) = stops(&coedges[c]) else { break };
            let onward: Vec<usize> = (0..coedges.len())
                .filter(|&d| (free[d] || d == first) && starts(&coedges[d]) == Some(node))
                .collect();
            at = next(network, &coedges, c, &onward, up);
            if at == Some(first) {
                found.closed = true;
                break;
            }
        }
        loops.push(found);
    }
    outer_first(network, &mut loops, up);
    loops
}

/// The nodes at the start and the end of a half-edge; `None` for a closed strip.
fn ends(network: &Network, c: Coedge) -> Option<[u32; 2]> {
    let strip = &network.strips[c.strip as usize];
    let [a, b] = [strip.start?, strip.end?];
    Some(if c.forward { [a, b] } else { [b, a] })
}

/// The first of `onward` clockwise from the way back along `c`.
fn next(network: &Network, all: &[Coedge], c: usize, onward: &[usize], up: [f64; 3]) -> Option<usize> {
    if onward.len() < 2 {
        return onward.first().copied();
    }
    let back = leaving(network, Coedge { forward: !all[c].forward, ..all[c] });
    let turn = |d: &usize| {
        let out = leaving(network, all[*d]);
        let (x, y) = (dot(back, out), dot(up, cross(out, back)));
        let angle = y.atan2(x);
        // The way back itself is the last choice, not the first.
        if angle > 1e-9 { angle } else { angle + std::f64::consts::TAU }
    };
    onward.iter().copied().min_by(|a, b| turn(a).total_cmp(&turn(b)).then(a.cmp(b)))
}

/// Number of points that give the direction of a strip at a node.
const AHEAD: usize = 6;

/// Unit direction in which a half-edge leaves its first node.
fn leaving(network: &Network, c: Coedge) -> [f64; 3] {
    let points = &network.strips[c.strip as usize].points;
    let last = points.len() - 1;
    let ahead = AHEAD.min(last);
    if c.forward {
        unit(sub(points[ahead], points[0]))
    } else {
        unit(sub(points[last - ahead], points[last]))
    }
}

/// Puts the outer loop first and marks it: the loop with the greatest area to its left, seen against `up`, or else the longest.
fn outer_first(network: &Network, loops: &mut [Loop], up: [f64; 3]) {
    let flat = norm(up) > 0.5;
    let size = |l: &Loop| {
        let area = if flat && l.closed { dot(area(network, l), up) } else { 0.0 };
        (area.max(0.0), l.coedges.iter().map(|c| network.strips[c.strip as usize].length()).sum::<f64>())
    };
    let sizes: Vec<(f64, f64)> = loops.iter().map(size).collect();
    let best = (0..loops.len()).max_by(|&a, &b| {
        let (x, y) = (sizes[a], sizes[b]);
        x.0.total_cmp(&y.0).then(x.1.total_cmp(&y.1)).then(b.cmp(&a))
    });
    if let Some(best) = best {
        loops[best].outer = true;
        loops[..=best].rotate_right(1);
    }
}

/// The vector area that a loop encloses.
fn area(network: &Network, found: &Loop) -> [f64; 3] {
    let origin = network.strips[found.coedges[0].strip as usize].points[0];
    let mut sum = [0.0; 3];
    for c in &found.coedges {
        let sign = if c.forward { 0.5 } else { -0.5 };
        for [a, b] in segments(&network.strips[c.strip as usize]) {
            sum = add_scaled(sum, cross(sub(a, origin), sub(b, origin)), sign);
        }
    }
    sum
}

fn segments(strip: &Strip) -> impl Iterator<Item = [[f64; 3]; 2]> + '_ {
    let closing = if strip.closed { strip.points.last().zip(strip.points.first()) } else { None };
    strip.points.windows(2).map(|w| [w[0], w[1]]).chain(closing.map(|(a, b)| [*a, *b]))
}
