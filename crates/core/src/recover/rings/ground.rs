//! What the points say of a circle: whether two faces meet along it all the way round.

use crate::curve::Round;
use crate::math::vec3::{add_scaled, perpendicular};
use crate::neighbors::Index;
use crate::recover::faces::{FACE_POINTS, Fitted, Lengths, Profile, Seen, Sweep, fit};
use crate::resolution::Resolution;
use crate::surface::Scales;
use std::f64::consts::TAU;

/// Shifts of the circle, outwards and along its axis, from which the fit starts, in spacings: a wrong start takes other faces for its own.
const STARTS: [[f64; 2]; 9] = [
    [0.0, 0.0],
    [-1.0, 0.0],
    [1.0, 0.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [-1.0, -1.0],
    [-1.0, 1.0],
    [1.0, -1.0],
    [1.0, 1.0],
];
/// Points of the circle that the fit holds, and at which the spacing is taken.
const HELD: usize = 8;
/// Length of a part of the circle, in spacings, and the fewest parts.
const PART: (f64, usize) = (2.5, 8);
/// Distance from the edge up to which a part is judged, in spacings.
const REACH: f64 = 3.0;
/// Distance from the edge between which a face shows in a part, in spacings: another face that crosses its line farther out is not it.
const CLEAR: f64 = 0.5;
const NEAR: f64 = 2.0;
/// Greatest share of points off both faces, up to this distance, in a part that shows them.
const OTHERS: f64 = 0.3;
/// Standard deviation of points about their face, in spacings, where the noise is less.
const SMOOTH: f64 = 0.07;
/// Greatest spread of the points about the faces, in the noise, and the least noise in spacings.
const LOOSE: f64 = 1.5;
const SHARP: f64 = 0.1;
/// Least radius, in spacings, and what noise adds in its own unit.
const RADIUS: (f64, f64) = (1.2, 4.0);
/// Least sine of the fold: a smooth face that bends a little looks like one of less.
const FOLD_SINE: f64 = 0.42;
/// Deviations of a point that is on a face.
const ON: f64 = 3.0;
/// Least share of the parts that show both faces.
const SUPPORT: f64 = 0.75;
/// Greatest mean square of the parts' mean deviations, in their variances.
const UNEVEN: f64 = 2.0;
/// Least evidence.
const EVIDENCE: f64 = 40.0;
/// Root mean square distance of the points from one straight line across, beyond that from the faces, that two flat faces have which
/// fold by 33 degrees, in spacings: faces that fold by more but bend back are one that is round.
const STRAIGHT: f64 = 0.25;
/// Points that an even plane around a circle's centre would have, times this, are more than any circle's surroundings.
const CROWDED: f64 = 12.0;
/// Length of line over which a cross-section elsewhere pools its points, in spacings: the evidence of a ring is that of as much of it.
const POOLED: f64 = 9.0;

/// The points of a cloud.
pub(super) struct Ground<'a> {
    pub(super) points: &'a [[f64; 3]],
    pub(super) index: &'a Index,
    pub(super) scales: Scales<'a>,
}

/// A circle along which two faces meet all the way round.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    pub(super) round: Round,
    pub(super) profile: Profile,
    pub(super) spacing: f64,
    /// Standard deviation of the points about the faces.
    pub(super) spread: f64,
    /// Mean square of the parts' mean distances from the faces, in their variances: about one where the faces are as fitted.
    pub(super) uneven: f64,
    /// Evidence against one smooth face, in variances, of as many points as a cross-section has.
    pub(super) evidence: f64,
}

impl Ring {
    /// The path of its cross-section.
    pub(super) fn sweep(&self) -> Sweep {
        Sweep::Round { round: self.round, zero: perpendicular(self.round.normal) }
    }
}

/// The points of one part of the circle.
#[derive(Clone, Copy, Debug, Default)]
struct Part {
    /// For each face the points on it, and the sum of their deviations.
    faces: [(f64, f64); 2],
    others: f64,
}

impl Ground<'_> {
    /// The ring near a circle, if there is one.
    pub(super) fn confirm(&self, round: Round) -> Option<Ring> {
        let h = self.resolution(&[round.foot(round.centre)]).spacing;
        let shifted = |[x, y]: [f64; 2]| Round {
            centre: add_scaled(round.centre, round.normal, y * h),
            radius: (round.radius + x * h).max(0.5 * h),
            ..round
        };
        STARTS.iter().find_map(|&start| self.confirm_at(shifted(start)))
    }

    fn confirm_at(&self, round: Round) -> Option<Ring> {
        let sweep = Sweep::Round { round, zero: perpendicular(round.normal) };
        let phase = |k: usize| TAU * round.radius * k as f64 / HELD as f64;
        let held: Vec<[f64; 3]> = (0..HELD).map(|k| sweep.point(phase(k))).collect();
        let resolution = self.resolution(&held);
        let lengths = Lengths::of(resolution);
        let near = self.near(&sweep, round, lengths.reach + lengths.spacing, lengths.spacing)?;
        let fitted = fit(&near, &held, sweep, lengths)?;
        let moved = |&p: &[f64; 3]| {
            let [x, y] = fitted.sweep.see(p).at;
            x.hypot(y)
        };
        let stays = held.iter().map(moved).fold(0.0, f64::max) <= lengths.far;
        let known = fitted.counts.iter().all(|&c| c >= FACE_POINTS) && fitted.fold_sine >= FOLD_SINE;
        let Sweep::Round { round, .. } = fitted.sweep else { return None };
        let (least, noisy) = RADIUS;
        let large = round.radius >= least * lengths.spacing + noisy * resolution.noise;
        let tight = fitted.spread <= LOOSE * resolution.noise.max(SHARP * lengths.spacing);
        (large && tight && stays && known).then(|| judged(round, &fitted, &near, resolution)).flatten()
    }

    /// The least spacing at the points nearest to some places.
    fn resolution(&self, places: &[[f64; 3]]) -> Resolution {
        let mut found = Vec::new();
        let nearest = |&p: &[f64; 3]| {
            self.index.nearest(p, 1, &mut found);
            found.first().map(|f| f.index)
        };
        self.scales.finest(&places.iter().filter_map(nearest).collect::<Vec<u32>>())
    }

    /// The points within `reach` of a circle; `None` where it is crowded.
    fn near(&self, sweep: &Sweep, round: Round, reach: f64, h: f64) -> Option<Vec<[f64; 3]>> {
        let far = round.radius + reach;
        let most = CROWDED * std::f64::consts::PI * (far / h).powi(2);
        let mut near = Vec::new();
        let all = self.index.around_at_most(round.centre, far, most as usize, |f| {
            let Seen { at: [x, y], .. } = sweep.see(self.points[f.index as usize]);
            if x.hypot(y) <= reach {
                near.push(f.index);
            }
        });
        near.sort_unstable();
        all.then(|| near.into_iter().map(|i| self.points[i as usize]).collect())
    }
}

/// The points beside a circle, part by part.
struct Parts {
    all: Vec<Part>,
    /// Those on the faces, in the cross-section, and the sum of their squared distances from these.
    on: Vec<[f64; 2]>,
    left: f64,
}

impl Parts {
    fn new(count: usize, fitted: &Fitted, near: &[[f64; 3]], h: f64, sigma: f64, length: f64) -> Parts {
        let mut parts = Parts { all: vec![Part::default(); count], on: Vec::new(), left: 0.0 };
        for seen in near.iter().map(|&p| fitted.sweep.see(p)) {
            let part = &mut parts.all[(seen.phase / length * count as f64) as usize % count];
            let (face, place) = fitted.profile.nearest(seen.at);
            let far = seen.at[0].hypot(seen.at[1]);
            if far > REACH * h || place.along < 0.0 {
                continue;
            }
            if place.off.abs() > ON * sigma {
                part.others += f64::from(u8::from(far <= NEAR * h));
                continue;
            }
            parts.on.push(seen.at);
            parts.left += place.off * place.off;
            if (CLEAR * h..=NEAR * h).contains(&place.along) {
                part.faces[face].0 += 1.0;
                part.faces[face].1 += place.off;
            }
        }
        parts
    }

    /// The share of the parts that show both faces.
    fn support(&self) -> f64 {
        let shows = |p: &&Part| {
            let on = p.faces[0].0 + p.faces[1].0;
            p.faces.iter().all(|f| f.0 > 0.0) && p.others <= OTHERS * (on + p.others)
        };
        self.all.iter().filter(shows).count() as f64 / self.all.len() as f64
    }

    /// Mean square of the parts' mean distances from the faces, in their variances.
    fn uneven(&self, sigma: f64) -> f64 {
        let faces = || self.all.iter().flat_map(|p| p.faces).filter(|f| f.0 > 0.0);
        faces().map(|(n, sum)| sum * sum / n).sum::<f64>() / (sigma * sigma * faces().count() as f64)
    }
}

/// The ring as fitted, where its parts bear it out.
fn judged(round: Round, fitted: &Fitted, near: &[[f64; 3]], resolution: Resolution) -> Option<Ring> {
    let h = resolution.spacing;
    let sigma = resolution.noise.max(SMOOTH * h);
    let length = TAU * round.radius;
    let count = ((length / (PART.0 * h)).ceil() as usize).max(PART.1);
    let parts = Parts::new(count, fitted, near, h, sigma, length);
    let uneven = parts.uneven(sigma);
    let gain = bent(&parts.on) - parts.left;
    let evidence = gain / (sigma * sigma) * (POOLED * h / length).min(1.0);
    let folds = gain >= (STRAIGHT * h).powi(2) * parts.on.len() as f64;
    let holds = parts.support() >= SUPPORT && uneven <= UNEVEN && evidence >= EVIDENCE && folds;
    let Fitted { profile, spread, .. } = *fitted;
    holds.then_some(Ring { round, profile, spacing: h, spread, uneven, evidence })
}

/// Sum of the squared distances of points in a cross-section from one straight line.
fn bent(section: &[[f64; 2]]) -> f64 {
    let n = section.len().max(1) as f64;
    let mean = section.iter().fold([0.0; 2], |m, p| [m[0] + p[0] / n, m[1] + p[1] / n]);
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for [x, y] in section.iter().map(|p| [p[0] - mean[0], p[1] - mean[1]]) {
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
    }
    0.5 * (xx + yy - (xx - yy).hypot(2.0 * xy))
}
