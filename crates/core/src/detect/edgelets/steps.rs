//! Steps of a cross-section: where one smooth piece ends and another, parallel to it, begins at another height.
//!
//! The face between the two is often too narrow, or too steep for the scanner, to be a piece itself: a plinth, a window's frame,
//! a flange. Then both ends are corners, and no link leads from one to the other.

use super::Weighted;
use super::pieces::{Piece, Pieces, variance};
use super::section::{CENTRE, Section};
use crate::math::vec3::add_scaled;
use crate::measure::Edgelet;

/// Least cosine between two pieces that a step joins.
const PARALLEL: f64 = 0.87;
/// Height of a step: the least in spacings, what a spacing of noise adds to it, and the greatest in spacings.
const HEIGHT: (f64, f64, f64) = (0.5, 3.0, 2.5);
/// Greatest overlap of the pieces and greatest gap between them, in spacings, what a spacing of height adds to the gap, and what a
/// spacing of noise adds to either. Rows along a step leave a gap as wide as they are apart.
const OVERLAP: f64 = 0.5;
const GAP: (f64, f64) = (0.7, 0.5);
const NOISY: f64 = 1.0;
/// Greatest distance of the farther end from the seed, in spacings; the nearer one is near the centre.
const FAR: f64 = 3.5;
/// Least length of a piece, in spacings.
const LENGTH: f64 = 1.2;
/// Reach before and beyond the end of a piece within which its points are counted, in spacings, and what is left out beyond.
const REACH: (f64, f64) = (1.5, 0.3);
/// Distance from a piece within which a point continues it, in spacings, and what a spacing of noise adds.
const SAME: (f64, f64) = (0.25, 2.0);
/// Least number of points before an end, and greatest share of them beyond it.
const ENDS: (f64, f64) = (6.0, 0.2);
/// Standard deviation of the place of an end, in spacings: scanner's rows may run along the step.
const DEVIATION: f64 = 0.2;

/// The end of a piece: its place in the section and the unit direction outwards.
#[derive(Clone, Copy)]
struct End {
    piece: u32,
    place: [f64; 2],
    out: [f64; 2],
}

impl End {
    /// Distance from the seed, in spacings.
    fn distance(&self) -> f64 {
        self.place[0].hypot(self.place[1])
    }
}

/// Appends both corners of every step near the seed.
pub(super) fn steps(section: &Section, pieces: &Pieces, out: &mut Vec<Weighted>) {
    let ends = ends(section, pieces);
    for (k, a) in ends.iter().enumerate() {
        for b in &ends[k + 1..] {
            if is_step(section, a, b) {
                let evidence = pieces.loss((a.piece.min(b.piece), a.piece.max(b.piece)), variance(section));
                out.extend([corner(section, a, b, evidence), corner(section, b, a, evidence)]);
            }
        }
    }
}

/// The ends of pieces near the seed beyond which the pieces do not go on.
fn ends(section: &Section, pieces: &Pieces) -> Vec<End> {
    let mut ends = Vec::new();
    for (piece, p) in (0..).zip(&pieces.all) {
        let Some(p) = p.filter(|p| p.length() >= LENGTH) else { continue };
        for (u, sign) in [(p.extent[0], -1.0), (p.extent[1], 1.0)] {
            let end = end(&p, piece, u, sign);
            if end.distance() <= FAR && stops(section, &p, u, sign) {
                ends.push(end);
            }
        }
    }
    ends
}

fn end(p: &Piece, piece: u32, u: f64, sign: f64) -> End {
    let [a, b] = p.curve.axis;
    let v = p.curve.c[0] + u * (p.curve.c[1] + u * p.curve.c[2]);
    let slope = p.curve.c[1] + 2.0 * p.curve.c[2] * u;
    let scale = sign / 1.0_f64.hypot(slope);
    let out = [scale * (a - b * slope), scale * (b + a * slope)];
    End { piece, place: [a * u - b * v, b * u + a * v], out }
}

/// Whether a piece with enough points before its end has hardly any beyond it.
fn stops(section: &Section, p: &Piece, end: f64, sign: f64) -> bool {
    let ((reach, left), (near, noisy)) = (REACH, SAME);
    let near = near + noisy * section.noise;
    let (mut before, mut beyond) = (0.0, 0.0);
    for q in &section.points {
        let (off, gradient, u) = p.curve.value(q.raw);
        let ahead = sign * (u - end);
        if off.abs() <= near * gradient[0].hypot(gradient[1]) && ahead.abs() <= reach {
            before += f64::from(u8::from(ahead <= 0.0));
            beyond += f64::from(u8::from(ahead > left));
        }
    }
    before >= ENDS.0 && beyond <= ENDS.1 * before
}

/// Whether one piece ends where the other begins, at another height.
fn is_step(section: &Section, a: &End, b: &End) -> bool {
    let step = [b.place[0] - a.place[0], b.place[1] - a.place[1]];
    let towards = a.out[0] * b.out[0] + a.out[1] * b.out[1];
    let along = |e: &End| e.out[0] * step[0] + e.out[1] * step[1];
    let gap = 0.5 * (along(a) - along(b));
    let height = (0.5 * (a.out[0] - b.out[0]) * step[1] - 0.5 * (a.out[1] - b.out[1]) * step[0]).abs();
    let more = NOISY * section.noise;
    a.distance().min(b.distance()) <= CENTRE
        && towards <= -PARALLEL
        && (-OVERLAP - more..=GAP.0 + GAP.1 * height + more).contains(&gap)
        && (HEIGHT.0 + HEIGHT.1 * section.noise..=HEIGHT.2).contains(&height)
}

/// The corner at the end `a`, which the step leads to `b`.
fn corner(section: &Section, a: &End, b: &End, evidence: f64) -> Weighted {
    let step = [b.place[0] - a.place[0], b.place[1] - a.place[1]];
    // The face between is upright, so that both faces end in the middle of the gap.
    let half = 0.25 * ((a.out[0] - b.out[0]) * step[0] + (a.out[1] - b.out[1]) * step[1]).max(0.0);
    let place = [a.place[0] + half * a.out[0], a.place[1] + half * a.out[1]];
    let side = [-a.out[1], a.out[0]];
    let sign = (side[0] * step[0] + side[1] * step[1]).signum();
    let arms = [a.out.map(|x| -x), side.map(|x| sign * x)].map(|arm| section.in_space(arm));
    let edgelet = Edgelet {
        place: add_scaled(section.origin, section.in_space(place), section.unit),
        point: section.seed,
        along: section.axes[0],
        arms,
        spacing: section.unit,
        deviation: DEVIATION * section.unit,
        evidence,
        reach: section.stations as f64 * section.unit,
        radius: 0.0,
    };
    Weighted { edgelet, weight: 1.0 / (DEVIATION * DEVIATION) }
}
