//! Mirror planes along the axis: through the centroid of the whole stack, at the angles for which the contours lie on
//! their own images.

use super::super::result::Sections;
use super::super::tree::Tree;
use super::super::vec2::{along, dot, left, onto, sub};
use super::Mirror;
use super::profile::Profile;
use crate::math::vec3;

/// Angles looked at first, over half a turn.
const ANGLES: usize = 180;
/// Points of a contour that are mirrored.
const POINTS: usize = 96;
/// Most mirrors told: a round stack has any number.
const MOST: usize = 16;

/// The mirrors of a stack of closed contours; none where all are circles about one point.
pub(super) fn mirrors(levels: &[Vec<Profile>], sections: &Sections, tolerance: f64) -> Vec<Mirror> {
    let all: Vec<&Profile> = levels.iter().flatten().collect();
    let planes = levels.iter().filter(|l| !l.is_empty()).count();
    let Some(centre) = centroid(&all) else { return Vec::new() };
    if planes < 2 || concentric(&all, tolerance) {
        return Vec::new();
    }
    let trees: Vec<Tree<2>> = all.iter().map(|p| Tree::new(&p.points)).collect();
    let off = |angle: f64| levels_off(&all, &trees, centre, angle, 1.5 * tolerance);
    let step = std::f64::consts::PI / ANGLES as f64;
    let coarse: Vec<f64> = (0..ANGLES).map(|k| off(k as f64 * step)).collect();
    let mut found = Vec::new();
    for k in 0..ANGLES {
        let (before, after) = (coarse[(k + ANGLES - 1) % ANGLES], coarse[(k + 1) % ANGLES]);
        if coarse[k] < before && coarse[k] <= after {
            let (angle, residual) = least(&off, k as f64 * step, step);
            if residual <= 1.5 * tolerance {
                found.push((residual, angle));
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    found.truncate(MOST);
    let mirror = |(residual, angle): (f64, f64)| {
        let normal = left([angle.cos(), angle.sin()]);
        Mirror {
            point: sections.frame.vector([centre[0], centre[1], all[0].height]),
            normal: vec3::unit(sections.frame.vector([normal[0], normal[1], 0.0])),
            planes,
            residual,
        }
    };
    found.into_iter().map(mirror).collect()
}

/// Centroid of the area of all slices, holes taken off: a mirror must hold it.
fn centroid(all: &[&Profile]) -> Option<[f64; 2]> {
    let area: f64 = all.iter().map(|p| p.signed_area).sum();
    let origin = all.first()?.centroid;
    let sum = all.iter().fold([0.0; 2], |s, p| along(s, sub(p.centroid, origin), p.signed_area));
    (area > 0.0).then(|| along(origin, sum, 1.0 / area))
}

fn concentric(all: &[&Profile], tolerance: f64) -> bool {
    let rounds: Option<Vec<_>> = all.iter().map(|p| p.round.map(|r| r.centre)).collect();
    rounds.is_some_and(|c| c.iter().all(|&p| super::super::vec2::distance(p, c[0]) <= 2.0 * tolerance))
}

/// Greatest over the contours of the mean distance of mirrored points from the contours of the same slice.
fn levels_off(all: &[&Profile], trees: &[Tree<2>], centre: [f64; 2], angle: f64, enough: f64) -> f64 {
    let direction = [angle.cos(), angle.sin()];
    let mut worst = 0.0f64;
    for profile in all {
        let step = profile.points.len().div_ceil(POINTS).max(1);
        let images = profile.points.iter().step_by(step).map(|&p| {
            let d = sub(p, centre);
            let turned = along([0.0; 2], direction, 2.0 * dot(d, direction));
            along(centre, sub(turned, d), 1.0)
        });
        let (mut sum, mut count) = (0.0, 0.0);
        for image in images {
            sum += nearest(all, trees, profile, image);
            count += 1.0;
        }
        worst = worst.max(sum / count);
        if worst > 20.0 * enough {
            break;
        }
    }
    worst
}

fn nearest(all: &[&Profile], trees: &[Tree<2>], of: &Profile, p: [f64; 2]) -> f64 {
    let mut best = f64::INFINITY;
    let mut found = Vec::new();
    let same = all.iter().zip(trees).filter(|(o, _)| o.id.0 == of.id.0 && o.hole == of.hole);
    for (other, tree) in same {
        tree.nearest(p, 1, &mut found);
        let Some(&(_, k)) = found.first() else { continue };
        let (n, k) = (other.points.len(), k as usize);
        let at = |k: usize| other.points[k % n];
        best = best.min(onto(at(k + n - 1), at(k), p).1).min(onto(at(k), at(k + 1), p).1);
    }
    best
}

/// The angle of least residual near one, by golden section.
fn least(off: &impl Fn(f64) -> f64, angle: f64, step: f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut low, mut high) = (angle - step, angle + step);
    for _ in 0..14 {
        let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if off(a) <= off(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let best = 0.5 * (low + high);
    (best, off(best))
}
