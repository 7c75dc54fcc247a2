//! Which curves and joints the relations would move by more than they are known.
//!
//! A curve may be moved to where its own fit still allows it: within the region that holds 99.9 % of the fits of one true curve (chi squared, by its
//! covariance), and a line may not lose half of its length or more. A joint may be moved by three of its standard deviations.

use super::super::odds::bound;
use super::layout::triple;
use super::rows::System;
use crate::math::vec3::{distance, dot, sub};
use std::collections::BTreeSet;

/// Standard deviations by which a joint may be moved.
const FAR: f64 = 3.0;

/// Share of its length that a line keeps at least.
const KEPT: f64 = 0.5;

/// The features that are moved too far, or that end on a joint that is; those related where there is no solution.
pub(super) fn offenders(system: &System, solved: Option<&[f64]>) -> Vec<usize> {
    let features = &system.found.features;
    let Some(x) = solved else {
        return (0..features.len()).filter(|&i| system.imposed.has(i)).collect();
    };
    let far = |j: usize| {
        let at = system.layout.joint[j];
        distance(triple(x, at), system.found.joints.places[j]) > FAR * system.doubt.joint[j]
    };
    let off = |i: usize| {
        let dimensions = if features[i].round().is_some() { 6 } else { 4 };
        let squares: f64 = system.observed(i, x).iter().map(|row| row.residual.powi(2)).sum();
        // Written so that what is not a number offends too.
        let allowed = squares <= bound(dimensions);
        !system.unseen.contains(&i) && !allowed
    };
    let shrunk = |i: usize| system.imposed.has(i) && shrinks(system, i, x);
    let mut offenders: BTreeSet<usize> = (0..features.len()).filter(|&i| off(i) || shrunk(i)).collect();
    let torn: BTreeSet<usize> = (0..system.found.joints.places.len()).filter(|&j| far(j)).collect();
    let at_torn = |i: usize| system.ends(i).is_some_and(|ends| ends.iter().any(|j| torn.contains(j)));
    offenders.extend(
        (0..features.len()).filter(|&i| at_torn(i) && (system.imposed.has(i) || !system.unseen.contains(&i))),
    );
    offenders.into_iter().collect()
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
