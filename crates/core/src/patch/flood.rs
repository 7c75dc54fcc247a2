//! Floods the neighbour graph into components that no strip crosses.

use super::beside::{Beside, Entry};
use super::cross::crosses;
use super::ground::{Ground, NO_PATCH};
use crate::math::union_find::UnionFind;
use crate::math::vec3::{dot, norm, sub};
use crate::parallel;

/// Fewest points of a patch.
const FEWEST_POINTS: u32 = 6;
/// Distance from all strips above which a place is not narrow, units of the place.
const NOT_NARROW: f64 = 0.8;
/// Regions join at a place if one of them is at most this many times as wide as the place.
const WAIST: f64 = 2.0;
/// Multiple of [`NOT_NARROW`] above which widths count as equal.
const WIDTH_CAP: f64 = 4.0;
/// Sine of the angle to the surface above which an edge leaves it.
const OFF_SURFACE: f64 = 0.6;
/// Rounds in which points on the seams join the patch beside them.
const ROUNDS: usize = 8;

/// `(M)` the patch of each point; patches are numbered by their first point.
pub fn flood(ground: &Ground, beside: &Beside) -> Vec<u32> {
    let count = ground.points.len();
    let seam = parallel::map(count, parallel::QUICK, |i| beside.on_seam(i));
    let mut sets = joined(ground, beside, &seam);
    let roots: Vec<u32> = (0..count as u32).map(|i| sets.find(i)).collect();
    let mut size = vec![0u32; count];
    roots.iter().zip(&seam).filter(|(_, s)| !**s).for_each(|(&r, _)| size[r as usize] += 1);
    let mut number = vec![NO_PATCH; count];
    let mut next = 0;
    let mut label = vec![NO_PATCH; count];
    for i in (0..count).filter(|&i| !seam[i] && size[roots[i] as usize] >= FEWEST_POINTS) {
        let slot = &mut number[roots[i] as usize];
        if *slot == NO_PATCH {
            *slot = next;
            next += 1;
        }
        label[i] = *slot;
    }
    spread(ground, beside, &mut label);
    label
}

/// Joins points that no strip separates, from the middle of the faces to the strips. Two regions that are wide on both sides of
/// a narrow place are not joined there: otherwise a single point on the wrong side, at a bend or an end of a strip, would join
/// two faces.
fn joined(ground: &Ground, beside: &Beside, seam: &[bool]) -> UnionFind {
    let count = ground.points.len();
    let units = |i: usize| beside.clearance(i) / ground.scales.unit(i as u32);
    let clear = parallel::map(count, parallel::QUICK, |i| units(i).min(WIDTH_CAP * NOT_NARROW));
    let mut sets = UnionFind::new(count);
    let mut narrow = Vec::new();
    for i in (0..count).filter(|&i| !seam[i]) {
        let own = beside.of(i);
        for &j in ground.graph.of(i).iter().filter(|&&j| j as usize > i && !seam[j as usize]) {
            if through(ground, i, j as usize) || !own.is_empty() && crosses(own, beside.of(j as usize)) {
                continue;
            }
            match clear[i].min(clear[j as usize]) {
                c if c >= NOT_NARROW => _ = sets.union(i as u32, j),
                c => narrow.push((c, i as u32, j)),
            };
        }
    }
    let mut peak = vec![0.0f64; count];
    for i in 0..count {
        let root = sets.find(i as u32) as usize;
        peak[root] = peak[root].max(clear[i]);
    }
    narrow.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    for (c, i, j) in narrow {
        let [a, b] = [i, j].map(|k| peak[sets.find(k) as usize]);
        if a.min(b) <= WAIST * c {
            sets.union(i, j);
            let root = sets.find(i) as usize;
            peak[root] = a.max(b);
        }
    }
    sets
}

/// Whether two points lie on different sheets: the line between them leaves the surface at both.
pub(super) fn through(ground: &Ground, i: usize, j: usize) -> bool {
    let way = sub(ground.points[j], ground.points[i]);
    let off = [i, j].map(|k| dot(ground.normals[k].map(f64::from), way).abs());
    off[0].min(off[1]) - 3.0 * ground.scales.mean.noise > OFF_SURFACE * norm(way)
}

/// Gives each point without a patch that of the neighbour with the nearest tangent plane, from the patches outwards.
fn spread(ground: &Ground, beside: &Beside, label: &mut [u32]) {
    for _ in 0..ROUNDS {
        let taken = parallel::flat_map(label.len(), parallel::QUICK, |i, taken| {
            if label[i] == NO_PATCH {
                taken.extend(best(ground, beside, label, i).map(|l| (i, l)));
            }
        });
        if taken.is_empty() {
            break;
        }
        taken.into_iter().for_each(|(i, l)| label[i] = l);
    }
}

fn best(ground: &Ground, beside: &Beside, label: &[u32], i: usize) -> Option<u32> {
    let offset = |j: u32| {
        let normal = ground.normals[j as usize].map(f64::from);
        dot(normal, sub(ground.points[i], ground.points[j as usize])).abs()
    };
    let own: &[Entry] = if beside.on_seam(i) { &[] } else { beside.of(i) };
    let near = ground.graph.of(i).iter().copied().filter(|&j| label[j as usize] != NO_PATCH);
    near.map(|j| (crosses(own, beside.of(j as usize)), offset(j), label[j as usize]))
        .min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)))
        .map(|(_, _, label)| label)
}
