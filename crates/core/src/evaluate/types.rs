//! Whether curves have the right type, and circles the right radius.
//!
//! Of the known curves of at least six spacings that part counts which lies within one spacing of a found curve. Where several found
//! curves are nearest, as they meet there, it is enough that one of them has the type.

use super::figures::quantile;
use super::lines::{Lines, TypedCurve};
use super::sides::length;
use crate::shapes::{Tree, densify};

/// Length from which on a known curve counts, spacings.
const SHORTEST: f64 = 6.0;
/// Found curves that end in one place and are told apart there, and how much farther than the nearest one they may be, spacings.
const MOST_TIED: usize = 8;
const TIED: f64 = 1e-6;
/// Pieces of a spacing that curves are cut into.
const PIECES: f64 = 4.0;

/// Types and radii of curves that were met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Types {
    /// Share of the length met whose nearest found curve has the type of the known one.
    pub right: f64,
    /// Median relative error of the radius along the circles of the right type; NaN without any.
    pub radius_error: f64,
    /// Samples along the known curves by their type (the first index) and the type found there (the second), in the order of
    /// `CurveKind::ALL`.
    pub lengths: [[usize; 4]; 4],
}

impl Types {
    pub(super) fn of(found: &Lines, known: &Lines, spacing: f64) -> Option<Self> {
        let step = spacing / PIECES;
        let (mut points, mut owner) = (Vec::new(), Vec::new());
        for curve in found.curves.iter().filter(|c| c.points.len() > 1) {
            points.extend(densify(&curve.points, false, step));
            owner.resize(points.len(), curve);
        }
        let asked = |c: &&TypedCurve| c.points.len() > 1 && length(&c.points) >= SHORTEST * spacing;
        let asked: Vec<&TypedCurve> = known.curves.iter().filter(asked).collect();
        if points.is_empty() || asked.is_empty() {
            return None;
        }
        let tree = Tree::new(&points);
        let (mut lengths, mut errors) = ([[0; 4]; 4], Vec::new());
        for curve in asked {
            for p in densify(&curve.points, false, step) {
                let near = tree.k_nearest(p, MOST_TIED);
                let Some(least) = near.first().map(|n| n.0.sqrt()).filter(|&d| d <= spacing) else {
                    continue;
                };
                let tied = near.iter().take_while(|n| n.0.sqrt() <= least + TIED * spacing);
                let mut tied = tied.map(|n| owner[n.1 as usize]);
                let first = tied.clone().next().unwrap_or(owner[0]);
                let met = tied.find(|met| met.kind == curve.kind).unwrap_or(first);
                lengths[curve.kind as usize][met.kind as usize] += 1;
                let radii = curve.radius.zip(met.radius).filter(|_| curve.kind == met.kind);
                errors.extend(radii.map(|(known, found)| (found - known).abs() / known));
            }
        }
        let met: usize = lengths.iter().flatten().sum();
        let right: usize = (0..4).map(|k| lengths[k][k]).sum();
        errors.sort_by(f64::total_cmp);
        let radius_error = quantile(&errors, 0.5);
        Some(Self { right: right as f64 / met.max(1) as f64, radius_error, lengths })
    }
}
