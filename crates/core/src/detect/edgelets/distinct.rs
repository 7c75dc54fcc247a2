//! Edgelets that several cross-sections agree on, each at the mean of its like.

use super::Edgelet;
use crate::math::vec3::{add_scaled, dot, norm, sub};
use crate::neighbors::Index;

/// Reach along the edge within which edgelets support each other, and within which they are the same, in spacings.
const ALONG: (f64, f64) = (1.5, 0.6);
/// Greatest distance across the edge of edgelets that support each other, in spacings.
const ACROSS: f64 = 0.5;
/// Least cosine between their directions.
const ALIGNED: f64 = 0.9;
/// Least number of edgelets that agree, the one itself counted.
const LIKE: usize = 3;

/// One edgelet for each place that at least three support.
pub(super) fn distinct(all: &[Edgelet]) -> Vec<Edgelet> {
    let places: Vec<[f64; 3]> = all.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| all[b].weight.total_cmp(&all[a].weight).then(a.cmp(&b)));
    let mut gone = vec![false; all.len()];
    let mut kept = Vec::new();
    let mut near: Vec<u32> = Vec::new();
    for k in order {
        if gone[k] {
            continue;
        }
        gone[k] = true;
        let e = &all[k];
        near.clear();
        index.around(e.place, ALONG.0.hypot(ACROSS) * e.spacing, |f| near.push(f.index));
        near.sort_unstable();
        let (mut sum, mut weight, mut like, mut evidence) = ([0.0; 3], 0.0, 0, 0.0);
        for &j in &near {
            let o = &all[j as usize];
            let d = sub(o.place, e.place);
            let along = dot(d, e.along);
            let across = add_scaled(d, e.along, -along);
            if norm(across) >= ACROSS * e.spacing || dot(e.along, o.along).abs() < ALIGNED {
                continue;
            }
            sum = add_scaled(sum, across, o.weight);
            weight += o.weight;
            evidence += o.weight * o.evidence;
            like += 1;
            if along.abs() < ALONG.1 * e.spacing {
                gone[j as usize] = true;
            }
        }
        if like >= super::knob("LIKE", LIKE as f64) as usize {
            kept.push(Edgelet { place: add_scaled(e.place, sum, 1.0 / weight), evidence: evidence / weight, weight, ..*e });
        }
    }
    kept
}
