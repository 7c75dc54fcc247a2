//! Which curves and joints the relations would move by more than they are known.
//!
//! A curve may be moved to where its own fit still allows it: within the region that holds 99.9 % of the fits of one true curve (chi squared, by its
//! covariance), and a line may not lose half of its length or more. A joint may be moved by three of its standard deviations.

use super::super::odds::bound;
use super::layout::triple;
use super::rows::System;
use crate::math::vec3::{distance, dot, sub};

/// Standard deviations by which a joint may be moved.
const FAR: f64 = 3.0;

/// Share of its length that a line keeps at least.
const KEPT: f64 = 0.5;

/// The features that are moved too far, or that end on a joint that is, each with how many times too far.
pub(super) fn offenders(system: &System, x: &[f64]) -> Vec<(usize, f64)> {
    let features = &system.found.features;
    let far = |j: usize| {
        let moved = distance(triple(x, system.layout.joint[j]), system.found.joints.places[j]);
        moved / (FAR * system.doubt.joint[j])
    };
    let excess = |i: usize| {
        let (seen, related) = (!system.unseen.contains(&i), system.imposed.has(i));
        let dimensions = if features[i].round().is_some() { 6 } else { 4 };
        let squares: f64 = system.observed(i, x).iter().map(|row| row.residual.powi(2)).sum();
        let off = if seen { (squares / bound(dimensions)).sqrt() } else { 0.0 };
        let torn = system.ends(i).filter(|_| seen || related);
        let torn = torn.into_iter().flatten().map(far).fold(0.0, f64::max);
        let shrunk = if related && shrinks(system, i, x) { f64::INFINITY } else { 0.0 };
        // What is not a number offends too.
        if off.is_nan() { f64::INFINITY } else { off.max(torn).max(shrunk) }
    };
    (0..features.len()).map(|i| (i, excess(i))).filter(|e| e.1 > 1.0).collect()
}

/// Whether a line has lost its length or turned about.
fn shrinks(system: &System, i: usize, x: &[f64]) -> bool {
    let Some(ends) = system.ends(i).filter(|_| system.found.features[i].round().is_none()) else {
        return false;
    };
    let length = |of: &[f64]| {
        let [a, b] = ends.map(|j| triple(of, system.layout.joint[j]));
        dot(sub(b, a), system.found.features[i].direction)
    };
    length(x) < KEPT * length(&system.layout.start)
}
