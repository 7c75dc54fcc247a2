//! The simplified wedge fitting problem in two dimensions (Gumhold 2001, section 4.1, figure 9 b and c): the split line through the
//! zenith that leaves the least residual of two least-squares lines through it.

use crate::math::eigen2::{Symmetric2, residual};
use std::f64::consts::PI;

/// The best grouping of `points`, relative to the zenith, by a split line: whether each lies to the left of it.
///
/// The split line turns from the x axis by half a turn; at each step one point changes from one group to the other, and with
/// it its product `q q^t` (the paper's matrices `m_j`). Of equal residuals the first counts. `None` where one group is always empty or
/// too small to speak for a line.
pub(in crate::recover) fn split(points: &[[f64; 2]], fewest: usize) -> Option<Vec<bool>> {
    let mut left: Vec<bool> = points.iter().map(|&[x, y]| y > 0.0 || (y == 0.0 && x > 0.0)).collect();
    let mut order: Vec<(f64, usize)> = points.iter().enumerate().map(|(i, q)| (turn(*q), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut groups = [[0.0; 3]; 2];
    let mut sizes = [0usize; 2];
    for (&q, &l) in points.iter().zip(&left) {
        add(&mut groups[usize::from(l)], q, 1.0);
        sizes[usize::from(l)] += 1;
    }
    let mut best: Option<(f64, usize)> = None;
    for step in 0..order.len() {
        let sum = residual(groups[0]) + residual(groups[1]);
        let enough = sizes[0] >= fewest && sizes[1] >= fewest;
        if enough && best.is_none_or(|(least, _)| sum < least) {
            best = Some((sum, step));
        }
        let i = order[step].1;
        let from = usize::from(left[i]);
        add(&mut groups[from], points[i], -1.0);
        add(&mut groups[1 - from], points[i], 1.0);
        sizes[from] -= 1;
        sizes[1 - from] += 1;
        left[i] = !left[i];
    }
    // After half a turn all points have changed sides.
    left.iter_mut().for_each(|l| *l = !*l);
    let (_, steps) = best?;
    order[..steps].iter().for_each(|&(_, i)| left[i] = !left[i]);
    Some(left)
}

/// The angle of the split line through a point, from 0 to half a turn.
fn turn([x, y]: [f64; 2]) -> f64 {
    let angle = y.atan2(x).rem_euclid(PI);
    // Rounding can bring a tiny negative angle to the whole half turn.
    if angle < PI { angle } else { 0.0 }
}

/// Adds `weight q q^t`.
fn add(m: &mut Symmetric2, [x, y]: [f64; 2], weight: f64) {
    m[0] += weight * x * x;
    m[1] += weight * x * y;
    m[2] += weight * y * y;
}

#[cfg(test)]
mod tests {
    use super::split;
    use crate::shapes::Rng;

    /// Points of two rays from the origin at these angles, with noise.
    fn wedge(angles: [f64; 2], noise: f64, seed: u64) -> (Vec<[f64; 2]>, Vec<bool>) {
        let mut rng = Rng::new(seed);
        let mut points = Vec::new();
        let mut first = Vec::new();
        for i in 0..60 {
            let (sin, cos) = angles[i % 2].to_radians().sin_cos();
            let r = rng.between(0.5, 4.0);
            points.push([r * cos + noise * rng.gaussian(), r * sin + noise * rng.gaussian()]);
            first.push(i % 2 == 0);
        }
        (points, first)
    }

    #[test]
    fn two_rays_fall_into_their_groups_whatever_their_angles() {
        for angles in [[0.0, 90.0], [10.0, 130.0], [200.0, 310.0], [45.0, 225.0 - 20.0], [-80.0, 60.0]] {
            for seed in 0..20 {
                let (points, first) = wedge(angles, 0.0, seed);
                let left = split(&points, 3).unwrap();
                let same = left.iter().zip(&first).filter(|(a, b)| a == b).count();
                assert!(same == 0 || same == points.len(), "{angles:?}: {same}");
            }
        }
    }

    #[test]
    fn noise_leaves_nearly_all_points_in_their_group() {
        let mut wrong = 0;
        for seed in 0..50 {
            let (points, first) = wedge([20.0, 120.0], 0.15, seed);
            let left = split(&points, 3).unwrap();
            let same = left.iter().zip(&first).filter(|(a, b)| a == b).count();
            wrong += same.min(points.len() - same);
        }
        assert!(wrong <= 60, "{wrong} of 3000");
    }

    #[test]
    fn too_few_points_have_no_grouping() {
        assert_eq!(split(&[[1.0, 0.0], [0.0, 1.0]], 2), None);
        assert_eq!(split(&[], 1), None);
    }
}
