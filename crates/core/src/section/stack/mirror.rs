//! Symmetrical parts (Kyriazis et al., section 1): mirror planes along the axis, through the centroid of the whole stack, at the angles for which the contours lie on
//! their own images.

use super::profile::Profile;
use super::result::Mirror;
use super::slice::Slice;
use crate::math::vec2::{along, distance, dot, left, sub};
use crate::math::vec3;
use crate::parallel;
use crate::section::result::Sections;

/// Number of angles that are tried first, over half a turn.
const ANGLES: usize = 180;
/// Slices that mirrors are sought in at first, most of their contours, taken at even steps, and points of each of these.
const FIRST_LOOK: (usize, usize, usize) = (8, 256, 64);
/// Points of a contour that are mirrored to be sure.
const POINTS: usize = 256;
/// Most mirrors told: a round stack has any number.
const MOST_MIRRORS: usize = 16;

/// A contour with its slice.
type Contour<'a> = (&'a Slice<'a>, &'a Profile);

fn contours<'a>(slice: &'a Slice<'a>) -> impl Iterator<Item = Contour<'a>> {
    slice.profiles.iter().map(move |p| (slice, p))
}

/// The mirrors of a stack of closed contours; none where all are circles about one point. Sought in a few slices, and
/// held against all.
pub(super) fn mirrors(levels: &[Vec<Profile>], sections: &Sections, tolerance: f64) -> Vec<Mirror> {
    let all: Vec<&Profile> = levels.iter().flatten().collect();
    let filled: Vec<Slice> = levels.iter().filter(|l| !l.is_empty()).map(|l| Slice::new(l)).collect();
    let Some(centre) = centroid(&all) else { return Vec::new() };
    if filled.len() < 2 || concentric(&all, tolerance) {
        return Vec::new();
    }
    let enough = 1.5 * tolerance;
    let every: Vec<Contour> = filled.iter().flat_map(contours).collect();
    let few: Vec<Contour> =
        filled.iter().step_by(filled.len().div_ceil(FIRST_LOOK.0)).flat_map(contours).collect();
    let few: Vec<Contour> = few.iter().step_by(few.len().div_ceil(FIRST_LOOK.1)).copied().collect();
    let off = |angle: f64| worst(&few, centre, angle, FIRST_LOOK.2, 20.0 * enough);
    let sure = |angle: f64| {
        let residual = worst(&every, centre, angle, POINTS, enough);
        (residual <= enough).then_some((residual, angle))
    };
    let candidates = candidates(&off, enough);
    let mut found =
        parallel::flat_map(candidates.len(), parallel::TASK, |c, found| found.extend(sure(candidates[c])));
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    found.truncate(MOST_MIRRORS);
    let mirror = |(residual, angle): (f64, f64)| {
        let normal = left([angle.cos(), angle.sin()]);
        Mirror {
            point: sections.frame.vector([centre[0], centre[1], all[0].height]),
            normal: vec3::unit(sections.frame.vector([normal[0], normal[1], 0.0])),
            planes: filled.len(),
            residual,
        }
    };
    found.into_iter().map(mirror).collect()
}

/// The angles at which mirrored contours come nearest, and near enough.
fn candidates(off: &(impl Fn(f64) -> f64 + Sync), enough: f64) -> Vec<f64> {
    let step = std::f64::consts::PI / ANGLES as f64;
    let coarse = parallel::map(ANGLES, parallel::TASK, |k| off(k as f64 * step));
    let lowest = |k: &usize| {
        let (before, after) = (coarse[(k + ANGLES - 1) % ANGLES], coarse[(k + 1) % ANGLES]);
        coarse[*k] < before && coarse[*k] <= after
    };
    let lows: Vec<usize> = (0..ANGLES).filter(lowest).collect();
    let fine = parallel::map(lows.len(), parallel::TASK, |l| least(off, lows[l] as f64 * step, step));
    fine.into_iter().filter(|(_, residual)| *residual <= 1.5 * enough).map(|(angle, _)| angle).collect()
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
    rounds.is_some_and(|c| c.iter().all(|&p| distance(p, c[0]) <= 2.0 * tolerance))
}

/// Mean distance of mirrored points from the contours of the same slice: the greatest over the contours, but for one in
/// ten, as a slice through an edge is drawn by chance. The value so far once too many are beyond `enough`.
fn worst(contours: &[Contour], centre: [f64; 2], angle: f64, points: usize, enough: f64) -> f64 {
    let direction = [angle.cos(), angle.sin()];
    let image = |p: [f64; 2]| {
        let d = sub(p, centre);
        let turned = along([0.0; 2], direction, 2.0 * dot(d, direction));
        along(centre, sub(turned, d), 1.0)
    };
    let spared = contours.len() / 10;
    // The greatest so far, ascending: as many as are spared, and one.
    let mut greatest: Vec<f64> = Vec::new();
    for (slice, profile) in contours {
        let (mut sum, mut count) = (0.0, 0.0);
        for p in profile.some(points) {
            sum += slice.off(profile.hole, image(p));
            count += 1.0;
        }
        let mean: f64 = sum / count;
        greatest.insert(greatest.partition_point(|g| *g < mean), mean);
        if greatest.len() > spared + 1 {
            greatest.remove(0);
        }
        if greatest.len() > spared && greatest[0] > enough {
            break;
        }
    }
    greatest.first().copied().unwrap_or(0.0)
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
