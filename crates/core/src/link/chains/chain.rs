//! Edgelets joined to chains.

use crate::detect::edgelets::{Edgelet, knob};
use crate::math::vec3::{cross, dot, norm, sub};
use crate::neighbors::{Found, Index};

/// A chain of places; closed if the last is joined to the first.
pub(in crate::link) struct Chain {
    pub(super) places: Vec<[f64; 3]>,
    pub(super) spacing: f64,
    pub(super) closed: bool,
}

pub(in crate::link) fn chains(kept: &[Edgelet]) -> Vec<Chain> {
    if kept.is_empty() {
        return Vec::new();
    }
    let places: Vec<[f64; 3]> = kept.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut found: Vec<Found> = Vec::new();
    // Best edgelet before and after each one.
    let mut best = vec![[None::<usize>; 2]; kept.len()];
    for (i, e) in kept.iter().enumerate() {
        let h = e.spacing;
        index.within(e.place, 2.4 * h, &mut found);
        let mut least = [f64::INFINITY; 2];
        for f in &found {
            let j = f.index as usize;
            let o = &kept[j];
            let d = sub(o.place, e.place);
            let al = dot(d, e.along);
            let ac = norm(cross(d, e.along));
            if j == i || dot(e.along, o.along).abs() < 0.8 || ac > 0.35 * al.abs() + 0.1 * h || al.abs() < 0.2 * h {
                continue;
            }
            let k = usize::from(al > 0.0);
            let cost = al.abs() + 2.0 * ac;
            if cost < least[k] || (cost == least[k] && best[i][k].is_some_and(|b| j < b)) {
                least[k] = cost;
                best[i][k] = Some(j);
            }
        }
    }
    let mutual = |i: usize, k: usize| best[i][k].filter(|&j| best[j].contains(&Some(i)));
    let mut used = vec![false; kept.len()];
    let mut chains = Vec::new();
    for i in 0..kept.len() {
        if used[i] {
            continue;
        }
        used[i] = true;
        let mut path = std::collections::VecDeque::from([i]);
        let mut closed = false;
        for k in 0..2 {
            let (mut from, mut at) = (i, mutual(i, k));
            while let Some(j) = at {
                if used[j] {
                    closed = j == i && path.len() > 3;
                    break;
                }
                used[j] = true;
                if k == 0 { path.push_front(j) } else { path.push_back(j) }
                let next = [0, 1].into_iter().filter_map(|q| mutual(j, q)).find(|&n| n != from);
                from = j;
                at = next;
            }
            if closed {
                break;
            }
        }
        let places: Vec<[f64; 3]> = path.iter().map(|&j| kept[j].place).collect();
        let length: f64 = places.windows(2).map(|w| norm(sub(w[1], w[0]))).sum();
        let (mut evidence, mut window) = (0.0, 0.0);
        for &j in &path {
            evidence += kept[j].evidence / path.len() as f64;
            window += kept[j].stations / path.len() as f64;
        }
        let total = evidence * (length / (window * kept[i].spacing)).max(1.0);
        if total < knob("TOTAL", 30.0) {
            continue;
        }
        if length >= knob("CHAIN", 5.0) * kept[i].spacing {
            chains.push(Chain { places, closed, spacing: kept[i].spacing });
        }
    }
    chains
}
