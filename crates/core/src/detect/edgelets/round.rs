//! Round places: cross-sections of a pipe or a rod, in which one circle passes through the seed and through all that lies around.

use super::Weighted;
use super::pieces::{Pieces, variance};
use super::section::{Across, Section};
use crate::curve::circle::Circle;
use crate::math::vec3::distance;
use std::f64::consts::TAU;

/// Radii of pipes, in spacings: smaller ones are sheets or wires, greater ones have smooth sections of their own.
const RADIUS: std::ops::RangeInclusive<f64> = 0.8..=6.0;
/// Greatest distance from the circle of a point on it, in standard deviations, and the greatest mean square over the variance.
const ON: f64 = 4.0;
const MEAN: f64 = 2.0;
/// Distance from the seed within which there is no corner and every point lies on the circle, in spacings, but for this share.
const CLEAR: f64 = 1.8;
const OFF: f64 = 0.05;
/// Least share of the circle that has points, in as many parts: a rounded edge between two faces turns by less.
const COVERED: f64 = 0.36;
const PARTS: usize = 36;

/// Whether a section with its corners shows that the seed lies on a round pipe.
pub(super) fn is_round(section: &Section, pieces: &Pieces, corners: &[Weighted]) -> bool {
    let far = |c: &Weighted| distance(c.edgelet.place, section.origin) > CLEAR * section.unit;
    if !corners.iter().all(far) {
        return false;
    }
    let own = pieces.all.iter().zip(0_u32..).filter_map(|(p, k)| Some((p.as_ref()?.offset([0.0; 2]), k)));
    let Some((_, own)) = own.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
    (0..pieces.all.len() as u32).any(|other| {
        let of = |&(p, label): &(&Across, &u32)| (*label == own || *label == other).then_some(p.raw);
        let both: Vec<[f64; 2]> = section.points.iter().zip(&pieces.label).filter_map(|p| of(&p)).collect();
        Circle::fit(&both).is_some_and(|circle| holds(section, circle))
    })
}

/// Whether the circle, fitted anew to all points on it, is that of a pipe through the seed.
fn holds(section: &Section, circle: Circle) -> bool {
    let variance = variance(section);
    let limit = ON * variance.sqrt();
    let on = |circle: Circle| -> Vec<[f64; 2]> {
        section.points.iter().map(|p| p.raw).filter(|&p| circle.off(p) <= limit).collect()
    };
    let Some(circle) = Circle::fit(&on(circle)) else { return false };
    let points = on(circle);
    let square = points.iter().map(|&p| circle.off(p).powi(2)).sum::<f64>() / points.len() as f64;
    let near = || section.points.iter().filter(|p| p.raw[0].hypot(p.raw[1]) <= CLEAR);
    let off = near().filter(|p| circle.off(p.raw) > limit).count() as f64;
    RADIUS.contains(&circle.radius)
        && square <= MEAN * variance
        && off <= OFF * near().count() as f64
        && covered(circle, &points) >= COVERED
}

/// The share of the circle that has points beside it.
fn covered(circle: Circle, points: &[[f64; 2]]) -> f64 {
    let mut parts = [false; PARTS];
    for p in points {
        let turn = (p[1] - circle.centre[1]).atan2(p[0] - circle.centre[0]) / TAU + 0.5;
        parts[((turn * PARTS as f64) as usize).min(PARTS - 1)] = true;
    }
    parts.iter().filter(|&&part| part).count() as f64 / PARTS as f64
}
