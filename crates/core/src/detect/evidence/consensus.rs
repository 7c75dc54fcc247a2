//! The tangent plane at a point by consensus: the plane in which most of its neighbours lie.
//!
//! The correlation ellipsoid (Gumhold 2001, section 3.1) blends the surfaces that meet in a neighbourhood: the two faces at a
//! crease, the two sides of a thin sheet. Consensus chooses between them: of several candidate planes through the point it takes
//! the one to which the greatest weight of neighbours is close, and refines it by weighted least squares. Candidates are the
//! ellipsoid of the nearest few, that of all, and the planes chosen at the neighbours. Where two of them have nearly the same
//! weight, as between the sides of a sheet, the next ring of neighbours decides.

use crate::math::eigen3::eigen3;
use crate::math::tensor::{add_product, centred, ellipsoid};
use crate::math::vec3::{dot, sub};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Neighbours of the small ellipsoid: with the point itself, the fewest that give a plane in spite of noise.
const NEAREST: usize = 6;
/// Steps of weighted least squares.
const REFINEMENTS: usize = 2;

/// Share of the neighbours below which a plane may have won by chance over another of nearly the same weight, so that a wider
/// neighbourhood decides.
const CLEAR_MAJORITY: f64 = 0.7;
/// Share of the best plane's weight above which another plane is its rival.
const RIVAL: f64 = 0.7;
/// Least angle between rival planes.
const OTHER_PLANE_DEG: f64 = 20.0;

/// Weight of second-ring neighbours.
const SECOND_RING_WEIGHT: f64 = 0.375;

/// Exponent of the bell curve above which a weight counts as zero.
pub(super) const NEGLIGIBLE: f64 = 8.0;

/// A bell curve like `exp(-x)` near zero, without its cost: `(1 + x / 4)^-4`.
#[inline]
pub(super) fn bell(x: f64) -> f64 {
    let y = 1.0 / (1.0 + 0.25 * x);
    (y * y) * (y * y)
}

/// Scale of the bell curve that weighs a neighbour by its distance from a plane, local frame.
pub fn tolerance(scale: Resolution) -> f64 {
    0.1 * scale.spacing + 1.5 * scale.noise
}

/// `(N, 3)` unit normals without orientation, from neighbourhoods of graph distance `hops`.
pub fn consensus_normals(
    points: &[[f64; 3]],
    graph: &Neighbors,
    hops: impl Fn(usize) -> usize + Sync,
    scales: Scales,
) -> Vec<[f32; 3]> {
    let rate = |i: usize| 0.5 / tolerance(scales.at(i)).powi(2);
    let own = parallel::map_with(points.len(), parallel::QUICK, |scratch: &mut Scratch, i| {
        let near = graph.of(i);
        let (all, rate) = (graph.hops(i, hops(i), scratch), rate(i));
        let candidates =
            [&near[..near.len().min(NEAREST)], all].map(|set| ellipsoid(points, i, set).axes.vectors[0]);
        best(candidates.map(|n| (n, weight(points, i, all, rate, n))).into_iter()).0.map(|x| x as f32)
    });
    parallel::map_with(points.len(), parallel::QUICK, |(scratch, planes): &mut (Scratch, Vec<Plane>), i| {
        let (hops, rate) = (hops(i), rate(i));
        let all = graph.hops(i, hops, scratch);
        let near = all.len();
        planes.clear();
        planes.extend([i as u32].iter().chain(graph.of(i)).map(|&j| {
            let normal = own[j as usize].map(f64::from);
            (normal, weight(points, i, all, rate, normal))
        }));
        let mut normal = best(planes.iter().copied()).0;
        if let Some(rivals) = rivals(planes, near) {
            let ring = &graph.hops(i, hops + 1, scratch)[near..];
            normal = best(
                rivals
                    .map(|(n, w)| (n, w + SECOND_RING_WEIGHT * weight(points, i, ring, rate, n)))
                    .into_iter(),
            )
            .0;
        }
        let all = graph.hops(i, hops, scratch);
        for _ in 0..REFINEMENTS {
            normal = refined(points, i, all, rate, normal);
        }
        normal.map(|x| x as f32)
    })
}

/// A unit normal and the weight of the neighbours in its plane.
type Plane = ([f64; 3], f64);

/// The weight of neighbours in the plane through point `i`.
fn weight(points: &[[f64; 3]], i: usize, neighbors: &[u32], rate: f64, normal: [f64; 3]) -> f64 {
    let weigh = |&j: &u32| {
        let offset = dot(normal, sub(points[j as usize], points[i]));
        // A Cauchy weight orders planes like a Gaussian at the cost of one division.
        1.0 / (1.0 + offset * offset * rate * 2.0)
    };
    neighbors.iter().map(weigh).sum()
}

/// The plane with the greatest weight, the first among equals.
fn best(planes: impl Iterator<Item = Plane>) -> Plane {
    planes.fold(([0.0, 0.0, 1.0], -1.0), |best, plane| if plane.1 > best.1 { plane } else { best })
}

/// The best plane and the best of the planes at an angle to it, if chance may have decided between them.
fn rivals(planes: &[Plane], neighbors: usize) -> Option<[Plane; 2]> {
    let first = best(planes.iter().copied());
    if first.1 >= CLEAR_MAJORITY * neighbors as f64 {
        return None;
    }
    let cosine = OTHER_PLANE_DEG.to_radians().cos();
    let second = best(planes.iter().copied().filter(|p| dot(p.0, first.0).abs() < cosine));
    (second.1 > RIVAL * first.1).then_some([first, second])
}

/// One step of weighted least squares from `normal`; the plane need not pass through the point.
fn refined(points: &[[f64; 3]], i: usize, neighbors: &[u32], rate: f64, normal: [f64; 3]) -> [f64; 3] {
    let (mut sum, mut products, mut total) = ([0.0; 3], [0.0; 6], 1.0);
    for &j in neighbors {
        let d = sub(points[j as usize], points[i]);
        let offset = dot(normal, d);
        let exponent = offset * offset * rate;
        if exponent < NEGLIGIBLE {
            let weight = bell(exponent);
            for c in 0..3 {
                sum[c] += weight * d[c];
            }
            add_product(&mut products, d, weight);
            total += weight;
        }
    }
    eigen3(&centred(sum, products, total).1).vectors[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbors::{all_nearest, riemannian};

    /// Two parallel sheets 1.2 spacings apart: every neighbourhood of twelve holds both.
    #[test]
    fn both_sides_of_a_thin_sheet_keep_their_normal() {
        let mut points = Vec::new();
        for i in 0..30 {
            for j in 0..30 {
                let jitter = |a: usize, b: usize| ((a * 7919 + b * 104729) % 97) as f64 / 97.0 * 0.3;
                points.push([i as f64 + jitter(i, j), j as f64 + jitter(j, i), 0.0]);
                points.push([i as f64 + jitter(i + 3, j), j as f64 + jitter(j, i + 5), 1.2]);
            }
        }
        let graph = riemannian::graph(&points, &all_nearest(&points, 12));
        let scale = Resolution { spacing: 1.0, noise: 0.02 };
        let normals = consensus_normals(&points, &graph, |_| 1, scale.into());
        let inner = |p: &[f64; 3]| p[0] > 2.0 && p[0] < 27.0 && p[1] > 2.0 && p[1] < 27.0;
        let (mut right, mut all) = (0, 0);
        for (p, n) in points.iter().zip(&normals).filter(|(p, _)| inner(p)) {
            all += 1;
            right += usize::from(n[2].abs() > 0.98);
            assert!(p[0].is_finite());
        }
        assert!(right as f64 > 0.97 * all as f64, "{right} of {all}");
    }
}
