//! Edgelets that several cross-sections agree on, each at the mean of its like.

use super::Weighted;
use crate::math::vec3::{add, add_scaled, dot, norm, scale, sub};
use crate::measure::Edgelet;
use crate::neighbors::Index;

/// Reach along the crease within which edgelets support each other, and within which they are the same, in spacings.
const ALONG: (f64, f64) = (1.5, 0.6);
/// Greatest distance across the crease of edgelets that support each other, in spacings.
const ACROSS: f64 = 0.5;
/// Least cosine between their directions.
const ALIGNED: f64 = 0.9;

/// One edgelet for each place that at least `agree` of them support, the best first where they compete. `cloud` is the index of the
/// points.
pub(super) fn distinct(all: &[Weighted], cloud: &Index, agree: usize) -> Vec<Edgelet> {
    let places: Vec<[f64; 3]> = all.iter().map(|w| w.edgelet.place).collect();
    let index = Index::build(&places);
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| all[b].weight.total_cmp(&all[a].weight).then(a.cmp(&b)));
    let mut gone = vec![false; all.len()];
    let (mut kept, mut like, mut nearest) = (Vec::new(), Vec::new(), Vec::new());
    for k in order {
        if gone[k] {
            continue;
        }
        gone[k] = true;
        likes(all, &index, &all[k].edgelet, &mut like);
        let same = like.iter().filter(|(_, along, _)| along.abs() < ALONG.1 * all[k].edgelet.spacing);
        same.for_each(|&(j, ..)| gone[j as usize] = true);
        if like.len() < agree {
            continue;
        }
        let mut edgelet = mean(all, &all[k].edgelet, &like);
        cloud.nearest(edgelet.place, 1, &mut nearest);
        edgelet.point = nearest.first().map_or(edgelet.point, |f| f.index);
        kept.push(edgelet);
    }
    kept
}

/// The edgelets that support `e`, itself among them, with their offsets along and across it.
fn likes(all: &[Weighted], index: &Index, e: &Edgelet, out: &mut Vec<(u32, f64, [f64; 3])>) {
    out.clear();
    index.around(e.place, ALONG.0.hypot(ACROSS) * e.spacing, |f| {
        let o = &all[f.index as usize].edgelet;
        let offset = sub(o.place, e.place);
        let along = dot(offset, e.along);
        let across = add_scaled(offset, e.along, -along);
        if norm(across) < ACROSS * e.spacing && dot(e.along, o.along).abs() >= ALIGNED {
            out.push((f.index, along, across));
        }
    });
    out.sort_unstable_by_key(|o| o.0);
}

/// `e` moved across to the weighted mean of its like, with the mean of their evidence and radius.
fn mean(all: &[Weighted], e: &Edgelet, like: &[(u32, f64, [f64; 3])]) -> Edgelet {
    let (mut offset, mut evidence, mut radius, mut weights) = ([0.0; 3], 0.0, 0.0, 0.0);
    for &(j, _, across) in like {
        let Weighted { edgelet, weight } = &all[j as usize];
        offset = add_scaled(offset, across, *weight);
        evidence += weight * edgelet.evidence;
        radius += weight * edgelet.radius;
        weights += weight;
    }
    Edgelet {
        place: add(e.place, scale(offset, 1.0 / weights)),
        evidence: evidence / weights,
        radius: radius / weights,
        ..*e
    }
}
