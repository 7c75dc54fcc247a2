//! Invariants of a network's strips.

use super::verdict::{deviations, finite};
use crate::network::{Network, Strip, Trace, trace};

pub(super) fn faults(network: &Network, strip: &Strip) -> Vec<String> {
    [point_faults(strip), end_faults(network, strip), number_faults(strip)].concat()
}

fn point_faults(strip: &Strip) -> Vec<String> {
    let points = &strip.points;
    let least = if strip.closed { 3 } else { 2 };
    let repeat = points.windows(2).position(|w| w[0] == w[1]);
    let seam = strip.closed && points.len() > 1 && points.first() == points.last();
    let faults = [
        (points.len() < least).then(|| format!("{} points, at least {least} needed", points.len())),
        (!points.iter().all(finite)).then(|| "a point is not finite".into()),
        // A length that is not a number is reported with the points.
        (strip.length() <= 0.0).then(|| "no length".into()),
        repeat.map(|i| format!("point {i} is repeated")),
        seam.then(|| "closed, and its first point is repeated at the end".into()),
    ];
    faults.into_iter().flatten().collect()
}

fn end_faults(network: &Network, strip: &Strip) -> Vec<String> {
    let mut faults = Vec::new();
    let ends = [("start", strip.start, strip.points.first()), ("end", strip.end, strip.points.last())];
    for (name, node, point) in ends {
        if strip.closed != node.is_none() {
            faults.push(format!("closed is {}, {name} is {node:?}", strip.closed));
        }
        match node.map(|id| (id, network.nodes.get(id as usize))) {
            Some((id, None)) => faults.push(format!("{name} is node {id} of {}", network.nodes.len())),
            Some((id, Some(at))) if point != Some(&at.position) => {
                faults.push(format!("{name} point {point:?} is not on its node {id} at {:?}", at.position));
            }
            _ => {}
        }
    }
    faults
}

fn number_faults(strip: &Strip) -> Vec<String> {
    let Strip { deviation, confidence, sources, sigma, .. } = strip;
    let stuck = sources.windows(2).find(|w| w[0] == w[1]);
    let known = sigma.is_empty() || sigma.len() == strip.points.len();
    let faults = [
        (!known).then(|| format!("{} standard deviations of {} points", sigma.len(), strip.points.len())),
        (!sigma.iter().all(deviations)).then(|| "a standard deviation is no length".into()),
        (!(deviation.is_finite() && *deviation >= 0.0)).then(|| format!("deviation {deviation}")),
        (!(0.0..=1.0).contains(confidence)).then(|| format!("confidence {confidence}")),
        sources.is_empty().then(|| "no source".into()),
        stuck.map(|w| format!("source {} twice in a row", w[0])),
    ];
    faults.into_iter().flatten().collect()
}

/// Repeated strips: the same points from either end, or around a loop from any start.
pub(super) fn twins(network: &Network) -> Vec<String> {
    let mut traces: Vec<(bool, Trace, usize)> =
        network.strips.iter().enumerate().map(|(i, s)| (s.closed, trace(s), i)).collect();
    traces.sort();
    let same = traces.windows(2).filter(|w| (w[0].0, &w[0].1) == (w[1].0, &w[1].1));
    same.map(|w| format!("strips {} and {}: the same points", w[0].2, w[1].2)).collect()
}
