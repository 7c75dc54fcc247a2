//! Edgelets joined to chains.

use super::knobs;
use super::pieces::Edgelet;
use crate::math::vec3::{add_scaled, cross, dot, norm, sub};
use crate::neighbors::{Found, Index};

/// A chain of places; closed if the last is joined to the first.
pub(super) struct Chain {
    pub(super) places: Vec<[f64; 3]>,
    pub(super) closed: bool,
}

/// Edgelets without those that say the same; each at the mean of its like.
pub(super) fn distinct(all: &[Edgelet], h: f64) -> Vec<Edgelet> {
    if all.is_empty() {
        return Vec::new();
    }
    let places: Vec<[f64; 3]> = all.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut found: Vec<Found> = Vec::new();
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| all[b].weight.total_cmp(&all[a].weight).then(a.cmp(&b)));
    let mut gone = vec![false; all.len()];
    let mut kept = Vec::new();
    let apart = |e: &Edgelet, o: &Edgelet| {
        let d = sub(o.place, e.place);
        let al = dot(d, e.along);
        (al.abs(), norm(add_scaled(d, e.along, -al)), dot(e.along, o.along).abs())
    };
    for k in order {
        if gone[k] {
            continue;
        }
        let e = all[k];
        index.within(e.place, 1.6 * h, &mut found);
        let mut near: Vec<u32> = found.iter().map(|f| f.index).collect();
        near.sort_unstable();
        let (mut sum, mut weight, mut like) = ([0.0; 3], 0.0, 0);
        for j in near {
            let o = &all[j as usize];
            let (al, ac, cosine) = apart(&e, o);
            if ac < 0.5 * h && cosine > 0.9 {
                let d = sub(o.place, e.place);
                sum = add_scaled(sum, add_scaled(d, e.along, -dot(d, e.along)), o.weight);
                weight += o.weight;
                like += 1;
                if al < 0.6 * h {
                    gone[j as usize] = true;
                }
            }
        }
        gone[k] = true;
        if like >= knobs().like as i32 {
            kept.push(Edgelet { place: add_scaled(e.place, sum, 1.0 / weight), weight, ..e });
        }
    }
    kept
}

pub(super) fn chains(kept: &[Edgelet], h: f64) -> Vec<Chain> {
    if kept.is_empty() {
        return Vec::new();
    }
    let places: Vec<[f64; 3]> = kept.iter().map(|e| e.place).collect();
    let index = Index::build(&places);
    let mut found: Vec<Found> = Vec::new();
    // Best edgelet before and after each one.
    let mut best = vec![[None::<usize>; 2]; kept.len()];
    for (i, e) in kept.iter().enumerate() {
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
        if length >= knobs().chain * h {
            chains.push(Chain { places, closed });
        }
    }
    chains
}
