//! Invariants of a network's strips.

use super::finite;
use crate::network::{Network, Strip};

/// The points in one direction from one start, as bits, so that they order and compare.
type Trace = Vec<[u64; 3]>;

pub(super) fn faults(network: &Network, strip: &Strip) -> Vec<String> {
    let mut faults = Vec::new();
    let mut claim = |holds: bool, fault: &dyn Fn() -> String| {
        if !holds {
            faults.push(fault());
        }
    };
    let points = &strip.points;
    let least = if strip.closed { 3 } else { 2 };
    claim(points.len() >= least, &|| format!("{} points, at least {least} needed", points.len()));
    claim(points.iter().all(finite), &|| "a point is not finite".into());
    claim(strip.length() > 0.0, &|| format!("length {}", strip.length()));
    let repeat = points.windows(2).position(|w| w[0] == w[1]);
    claim(repeat.is_none(), &|| format!("point {} is repeated", repeat.unwrap_or(0)));
    let seam = strip.closed && points.len() > 1 && points.first() == points.last();
    claim(!seam, &|| "closed, and its first point is repeated at the end".into());

    let ends = [("start", strip.start, points.first()), ("end", strip.end, points.last())];
    for (name, node, point) in ends {
        claim(strip.closed == node.is_none(), &|| format!("closed is {}, {name} is {node:?}", strip.closed));
        let Some(id) = node else { continue };
        let Some(at) = network.nodes.get(id as usize) else {
            claim(false, &|| format!("{name} is node {id} of {}", network.nodes.len()));
            continue;
        };
        claim(point == Some(&at.position), &|| {
            format!("{name} point {point:?} is not on its node {id} at {:?}", at.position)
        });
    }

    let deviation = strip.deviation;
    claim(deviation.is_finite() && deviation >= 0.0, &|| format!("deviation {deviation}"));
    claim((0.0..=1.0).contains(&strip.confidence), &|| format!("confidence {}", strip.confidence));
    claim(!strip.sources.is_empty(), &|| "no source".into());
    let stuck = strip.sources.windows(2).find(|w| w[0] == w[1]);
    claim(stuck.is_none(), &|| format!("source {} twice in a row", stuck.map_or(0, |w| w[0])));
    faults
}

/// Strips that are another strip once more: the same points from either end, or around a loop from any start.
pub(super) fn twins(network: &Network) -> Vec<String> {
    let mut traces: Vec<(bool, Trace, usize)> =
        network.strips.iter().enumerate().map(|(i, s)| (s.closed, canonical(s), i)).collect();
    traces.sort();
    let same = traces.windows(2).filter(|w| (w[0].0, &w[0].1) == (w[1].0, &w[1].1));
    same.map(|w| format!("strips {} and {}: the same points", w[0].2, w[1].2)).collect()
}

/// The least of the traces that say the same line.
fn canonical(strip: &Strip) -> Trace {
    let mut forwards: Trace = strip.points.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    if strip.closed {
        let least = (0..forwards.len()).min_by_key(|&i| forwards[i]).unwrap_or(0);
        forwards.rotate_left(least);
    }
    let mut backwards = forwards.clone();
    backwards.reverse();
    if strip.closed {
        backwards.rotate_right(1.min(forwards.len()));
    }
    forwards.min(backwards)
}
