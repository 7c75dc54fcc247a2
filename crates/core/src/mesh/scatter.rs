//! Random points on triangles, uniform by area and in strata: each lies in its own stretch of the sum of areas.

use super::canonical::Surface;
use crate::math::vec3::{add_scaled, sub};
use crate::parallel;

/// Candidates for each point that is to stay (Yuksel, section 4.1, has 5).
pub(super) const FACTOR: usize = 5;

/// A point of the surface.
pub(super) struct Candidate {
    /// Local frame.
    pub position: [f64; 3],
    /// Unit normal of its triangle.
    pub normal: [f32; 3],
}

/// `count` points, in the order of the triangles.
pub(super) fn scatter(surface: &Surface, count: usize) -> Vec<Candidate> {
    let mut sum = 0.0;
    let sums: Vec<f64> = surface
        .areas
        .iter()
        .map(|area| {
            sum += area;
            sum
        })
        .collect();
    let point = |k: usize| {
        let [along, u, v] = [0, 1, 2].map(|which| uniform(3 * k as u64 + which));
        let place = sum * (k as f64 + along) / count as f64;
        let at = sums.partition_point(|&s| s <= place).min(sums.len() - 1);
        let [a, b, c] = surface.corners(&surface.triangles[at]);
        let root = u.sqrt();
        let position = add_scaled(add_scaled(a, sub(b, a), root * (1.0 - v)), sub(c, a), root * v);
        Candidate { position, normal: surface.normals[at].map(|x| x as f32) }
    };
    parallel::map(count, parallel::QUICK, point)
}

/// The number of a counter in `[0, 1)`: splitmix64 (Steele and others, 2014), the same on every machine.
fn uniform(counter: u64) -> f64 {
    let mut word = (counter + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((word ^ (word >> 31)) >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
}
