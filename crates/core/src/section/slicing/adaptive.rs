//! Slabs of adaptive thickness (Kyriazis et al., section 2): equal parts of the cloud's extent at first, then rounds of splitting and
//! merging; each slab starts where the one before ends.
//!
//! Departure: a section is drawn from the points near the middle of its slab, as far as carrying them along the surface
//! is sure, and not from all of a thick one. The slab is what the section stands for: over it, nothing changes.
//!
//! The criteria: a slab with too few points to describe a curve, or whose section is like its neighbour's, is merged
//! with it; a slab whose section differs from a neighbour's may hold features that a thick slab would tangle, and is
//! split, down to slabs as thick as the local spacing lets a curve be described.

use crate::curve::polyline::Polyline;
use crate::section::result::{Contour, FEWEST_POINTS, Section};

/// Rounds at most: each halves what it splits.
const ROUNDS: usize = 12;

/// A slab between two heights with the section at its middle.
#[derive(Clone, Debug)]
struct Slab {
    low: f64,
    high: f64,
    /// `None` until it is cut.
    section: Option<Section>,
}

/// Bounds of the adaptation; lengths in the unit of the heights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Parts at first.
    pub start: usize,
    /// Most slabs.
    pub most: usize,
    /// No slab gets thinner.
    pub thinnest: f64,
    /// Distance of neighbouring points of the cloud, in the unit of the contours.
    pub step: f64,
    /// Sections closer than this on average are alike, in the unit of the contours.
    pub alike: f64,
}

/// The slabs of an extent as (low, high), ascending; `cut` gives the sections at some heights, in their order.
pub(crate) fn slabs(
    (low, high): (f64, f64),
    limits: Limits,
    mut cut: impl FnMut(&[f64]) -> Vec<Section>,
) -> Vec<(f64, f64)> {
    let n = limits.start.max(1);
    let edge = |k: usize| low + (high - low) * k as f64 / n as f64;
    let mut slabs: Vec<Slab> =
        (0..n).map(|k| Slab { low: edge(k), high: edge(k + 1), section: None }).collect();
    for _ in 0..ROUNDS {
        fill(&mut slabs, &mut cut);
        let before = slabs.len();
        let parts = split(&slabs, limits);
        if parts.len() == before {
            break;
        }
        slabs = parts;
    }
    fill(&mut slabs, &mut cut);
    merge(slabs, limits).into_iter().map(|s| (s.low, s.high)).collect()
}

fn fill(slabs: &mut [Slab], cut: &mut impl FnMut(&[f64]) -> Vec<Section>) {
    let open: Vec<usize> = (0..slabs.len()).filter(|&k| slabs[k].section.is_none()).collect();
    let heights: Vec<f64> = open.iter().map(|&k| 0.5 * (slabs[k].low + slabs[k].high)).collect();
    for (k, section) in open.into_iter().zip(cut(&heights)) {
        slabs[k].section = Some(section);
    }
}

fn split(slabs: &[Slab], limits: Limits) -> Vec<Slab> {
    let differs = |k: usize| {
        let beside = [k.checked_sub(1), (k + 1 < slabs.len()).then_some(k + 1)];
        beside.into_iter().flatten().any(|j| !alike(&slabs[k], &slabs[j], limits))
    };
    let mut room = limits.most.saturating_sub(slabs.len());
    let mut parts = Vec::with_capacity(slabs.len());
    for (k, slab) in slabs.iter().enumerate() {
        let thick = slab.high - slab.low >= 2.0 * limits.thinnest;
        if room == 0 || !thick || slabs.len() < 2 || !differs(k) {
            parts.push(slab.clone());
            continue;
        }
        room -= 1;
        let middle = 0.5 * (slab.low + slab.high);
        parts.push(Slab { low: slab.low, high: middle, section: None });
        parts.push(Slab { low: middle, high: slab.high, section: None });
    }
    parts
}

/// Each merged slab keeps the section of its first part to compare with, so that slow changes do add up.
fn merge(slabs: Vec<Slab>, limits: Limits) -> Vec<Slab> {
    let mut merged: Vec<Slab> = Vec::new();
    for slab in slabs {
        match merged.last_mut() {
            Some(last) if bare(&slab) || bare(last) || alike(last, &slab, limits) => {
                last.high = slab.high;
                if bare(last) {
                    last.section = slab.section;
                }
            }
            _ => merged.push(slab),
        }
    }
    merged
}

/// Whether a slab has too few points for a curve.
fn bare(slab: &Slab) -> bool {
    slab.section.as_ref().is_none_or(|s| s.points < FEWEST_POINTS)
}

/// Whether two sections have as many closed and open contours, holes among them, and lie on each other.
fn alike(a: &Slab, b: &Slab, limits: Limits) -> bool {
    let (Some(a), Some(b)) = (&a.section, &b.section) else { return false };
    let kinds = |s: &Section| {
        let count = |hole: usize| s.contours.iter().filter(|c| c.closed && c.depth % 2 == hole).count();
        (count(0), count(1), s.contours.iter().filter(|c| !c.closed).count())
    };
    kinds(a) == kinds(b)
        && apart(a, b, limits.step) <= limits.alike
        && apart(b, a, limits.step) <= limits.alike
}

/// Greatest over the contours of one section of the mean distance from the nearest contour of the other.
fn apart(a: &Section, b: &Section, step: f64) -> f64 {
    let flat = |c: &Contour| c.points.iter().map(|p| [p[0], p[1]]).collect::<Vec<[f64; 2]>>();
    let others: Vec<Polyline> = b.contours.iter().map(|c| Polyline::new(&flat(c), c.closed, step)).collect();
    let from = |points: Vec<[f64; 2]>| {
        others.iter().map(|o| o.mean_off(points.iter().copied())).fold(f64::INFINITY, f64::min)
    };
    a.contours.iter().map(|c| from(flat(c))).fold(0.0, f64::max)
}
