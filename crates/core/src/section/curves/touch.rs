//! The joints at which a contour goes on smoothly, unless the data contradict: pieces there are made tangent.

use super::tangent::{Fitted, solve};
use crate::curve::pieces::noise::Noise;
use crate::math::vec2::dot;

/// Cosine of the greatest turn at a joint that is tried.
const TRIED: f64 = 0.7;
/// Most pieces that are solved together.
const TOGETHER: usize = 40;

/// A joint between a piece and the next, at the place where the data break.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint {
    /// Index of the piece before it.
    pub before: usize,
    /// Index of the piece after it.
    pub after: usize,
    /// About where it is.
    pub at: [f64; 2],
    /// Whether the pieces touch there.
    pub smooth: bool,
}

/// Marks the joints at which the pieces may touch: where it costs less than the parameter that it saves.
pub(super) fn mark(curves: &[Fitted], joints: &mut [Joint], noise: &Noise) {
    for joint in joints.iter_mut() {
        let pair = [curves[joint.before], curves[joint.after]];
        let turn = dot(pair[0].curve.way(joint.at), pair[1].curve.way(joint.at));
        let apart = pair[0].curve.meet(&pair[1].curve, joint.at).is_none();
        joint.smooth = joint.before != joint.after
            && turn > TRIED
            && solve(&pair, &[(0, 1)], noise.sigma)
                .is_some_and(|touching| apart || rise(&pair, &touching, noise) <= noise.log_count);
    }
}

/// By how much the data are described worse.
fn rise(free: &[Fitted], bound: &[Fitted], noise: &Noise) -> f64 {
    let squares = |all: &[Fitted]| all.iter().map(Fitted::squares).sum::<f64>();
    0.5 * (squares(bound) - squares(free)) / (noise.sigma * noise.sigma)
}

/// The curves of least squares that touch at the smooth joints. Joints at which that does not do are smooth no longer.
pub(super) fn touching<'a>(curves: &[Fitted<'a>], joints: &mut [Joint], noise: &Noise) -> Vec<Fitted<'a>> {
    let mut found = curves.to_vec();
    for group in groups(curves.len(), joints) {
        loop {
            let smooth: Vec<usize> = group.iter().copied().filter(|&j| joints[j].smooth).collect();
            if smooth.is_empty() {
                break;
            }
            let mut pieces: Vec<usize> =
                smooth.iter().flat_map(|&j| [joints[j].before, joints[j].after]).collect();
            pieces.sort_unstable();
            pieces.dedup();
            let own: Vec<Fitted> = pieces.iter().map(|&p| curves[p]).collect();
            let place = |p: usize| pieces.binary_search(&p).unwrap_or(0);
            let touch: Vec<(usize, usize)> =
                smooth.iter().map(|&j| (place(joints[j].before), place(joints[j].after))).collect();
            let allowed = noise.log_count * smooth.len() as f64;
            if let Some(bound) = solve(&own, &touch, noise.sigma).filter(|b| rise(&own, b, noise) <= allowed)
            {
                pieces.iter().zip(bound).for_each(|(&p, b)| found[p] = b);
                break;
            }
            release(curves, joints, &smooth, noise);
        }
    }
    found
}

/// Lets go of the joint that the data speak against most.
fn release(curves: &[Fitted], joints: &mut [Joint], smooth: &[usize], noise: &Noise) {
    let cost = |j: usize| {
        let pair = [curves[joints[j].before], curves[joints[j].after]];
        solve(&pair, &[(0, 1)], noise.sigma).map_or(f64::INFINITY, |bound| rise(&pair, &bound, noise))
    };
    let worst = smooth.iter().map(|&j| (cost(j), j)).max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    if let Some((_, j)) = worst {
        joints[j].smooth = false;
    }
}

/// The smooth joints of each run of pieces that touch; a ring of them is one run. Long runs are cut, and are not smooth there.
fn groups(pieces: usize, joints: &mut [Joint]) -> Vec<Vec<usize>> {
    // A ring is begun where it is not smooth.
    let n = joints.len();
    let start = joints.iter().position(|j| !j.smooth).map_or(0, |j| j + 1);
    let closed = n == pieces;
    let mut groups: Vec<Vec<usize>> = vec![Vec::new()];
    for k in 0..n {
        let j = if closed { (start + k) % n } else { k };
        let last = groups.len() - 1;
        if joints[j].smooth && groups[last].len() < TOGETHER {
            groups[last].push(j);
        } else {
            joints[j].smooth = false;
            groups.push(Vec::new());
        }
    }
    groups
}
