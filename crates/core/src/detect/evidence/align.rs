//! Aligns the feet of candidates, so that a band of candidates is a line before it is linked.
//!
//! Each candidate moves across its own direction to the mean of the feet beside it: one step of mean shift. Otherwise the
//! minimum spanning graph zigzags through the band, and its branches grow too long to be pruned.

use crate::math::vec3::{add_scaled, dot, norm, scale, sub};
use crate::measure::Penalties;
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::surface::Scales;

/// Certainty of direction below which a point is near a corner and has no direction of its own.
pub(crate) const NO_DIRECTION: f64 = 0.5;

/// Aligns the feet of creases: they form a band that is as wide as the noise.
pub(crate) fn align_creases(
    graph: &Neighbors,
    creases: &mut Penalties,
    scales: Scales,
    hops: impl Fn(usize) -> usize + Sync,
) {
    let blur = |i: usize| (4.0 * scales.mean.noise).min(2.0 * scales.at(i).unit());
    align(graph, creases, |i| hops(i).max(2), blur);
}

/// Aligns the feet of borders: the outermost row of points is ragged even without noise.
pub(crate) fn align_borders(graph: &Neighbors, borders: &mut Penalties, scales: Scales) {
    align(graph, borders, |_| 2, |i| 2.0 * scales.at(i).unit());
}

/// Moves every candidate across its line to the mean of the candidates up to `hops` away in the graph whose feet lie
/// within `reach` of its own along the line and beside it.
fn align(
    graph: &Neighbors,
    penalties: &mut Penalties,
    hops: impl Fn(usize) -> usize + Sync,
    reach: impl Fn(usize) -> f64 + Sync,
) {
    penalties.foot = parallel::map_with(penalties.len(), parallel::SLOW, |scratch: &mut Scratch, c| {
        let i = penalties.points[c] as usize;
        aligned(penalties, graph.hops(i, hops(i), scratch), c, reach(i))
    });
}

fn aligned(penalties: &Penalties, near: &[u32], c: usize, reach: f64) -> [f64; 3] {
    let vector = penalties.vector[c].map(f64::from);
    let certainty = norm(vector);
    let foot = penalties.foot[c];
    if certainty < NO_DIRECTION {
        return foot;
    }
    let direction = scale(vector, 1.0 / certainty);
    let (mut sum, mut count) = ([0.0; 3], 1.0);
    for other in near.iter().filter_map(|j| penalties.points.binary_search(j).ok()) {
        let d = sub(penalties.foot[other], foot);
        let t = dot(d, direction);
        let aside = add_scaled(d, direction, -t);
        if t.abs() <= reach && norm(aside) <= reach {
            sum = add_scaled(sum, aside, 1.0);
            count += 1.0;
        }
    }
    add_scaled(foot, sum, 1.0 / count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Row;

    #[test]
    fn a_zigzag_becomes_a_line_and_a_corner_stays() {
        let mut penalties = Penalties::default();
        let offsets: Vec<u64> = (0..=20).map(|i| i * 20).collect();
        let indices: Vec<u32> = (0..20).flat_map(|_| 0..20).collect();
        let graph = Neighbors { offsets, indices };
        for i in 0..20 {
            let certainty = if i == 10 { 0.2 } else { 1.0 };
            let foot = [0.5 * f64::from(i), if i % 2 == 0 { 0.4 } else { -0.4 }, 0.0];
            let row = Row { scalar: 0.0, vector: [certainty, 0.0, 0.0], corner: 1.0, foot, evidence: None };
            penalties.push(i as u32, row);
        }
        align(&graph, &mut penalties, |_| 1, |_| 2.0);
        assert!(penalties.foot.iter().enumerate().all(|(i, f)| i == 10 || f[1].abs() < 0.2));
        assert_eq!(penalties.foot[10], [5.0, 0.4, 0.0]);
    }
}
