//! The observations of the joint least squares, linearised.
//!
//! A curve is observed as it was fitted: a line in the shifts of its middle and its end, an arc or a circle in centre, radius and axis, whitened by
//! their covariance. A joint is observed where it was.

use super::super::find::Found;
use super::doubts::Doubts;
use super::imposed::Imposed;
use super::layout::{Layout, triple};
use super::row::Row;
use crate::math::vec3::{dot, scale, sub, unit};
use std::collections::BTreeSet;

/// The least squares of a network.
pub(super) struct System<'a> {
    pub found: &'a Found,
    pub imposed: &'a Imposed,
    pub layout: &'a Layout,
    pub doubt: &'a Doubts,
    /// Features that count as not observed.
    pub unseen: &'a BTreeSet<usize>,
}

/// Length between a line's joints, in halves of what was seen of it, below which it is not observed.
const SHORT: f64 = 0.4;

/// Slopes of a value with three unknowns in a row.
pub(super) fn slopes(at: usize, slope: [f64; 3]) -> [(usize, f64); 3] {
    [0, 1, 2].map(|k| (at + k, slope[k]))
}

impl System<'_> {
    /// The greatest extent of the joints and centres.
    pub(super) fn size(&self) -> f64 {
        let start = &self.layout.start;
        let centres = self.layout.centre.iter().flatten();
        let places = self.layout.joint.iter().chain(centres).map(|&at| triple(start, at));
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in places {
            (0..3).for_each(|k| (least[k], most[k]) = (least[k].min(p[k]), most[k].max(p[k])));
        }
        let radii = self.layout.radius.iter().flatten().map(|&at| start[at]).fold(0.0, f64::max);
        (0..3).map(|k| most[k] - least[k]).fold(radii, f64::max)
    }

    /// Directions are unit vectors again after a step.
    pub(super) fn settle(&self, x: &mut [f64]) {
        for &at in &self.layout.directions {
            let direction = unit(triple(x, at));
            x[at..at + 3].copy_from_slice(&direction);
        }
    }

    /// The joints at the ends of a feature.
    pub(super) fn ends(&self, feature: usize) -> Option<[usize; 2]> {
        let member = self.found.features[feature].member;
        self.found.joints.ends[member.strip as usize][member.curve as usize]
    }

    pub(super) fn observations(&self, x: &[f64]) -> Vec<Row> {
        let seen = (0..self.found.features.len()).filter(|i| !self.unseen.contains(i));
        let mut rows: Vec<Row> = seen.flat_map(|i| self.observed(i, x)).collect();
        for (&at, &sigma) in self.layout.joint.iter().zip(&self.doubt.joint) {
            let moved = |k: usize| (x[at + k] - self.layout.start[at + k]) / sigma;
            rows.extend((0..3).map(|k| Row { terms: vec![(at + k, 1.0 / sigma)], residual: moved(k) }));
        }
        rows
    }

    /// The whitened observations of a feature.
    pub(super) fn observed(&self, i: usize, x: &[f64]) -> Vec<Row> {
        let values = match self.found.features[i].round() {
            None => self.line(i, x),
            Some(_) => self.round(i, x),
        };
        let Some(values) = values else { return Vec::new() };
        let whitened = |weights: &[f64; 6]| {
            let mut row = Row { terms: Vec::new(), residual: 0.0 };
            for (value, &w) in values.iter().zip(weights).filter(|(_, w)| **w != 0.0) {
                row.residual += w * value.residual;
                row.terms.extend(value.terms.iter().map(|t| (t.0, w * t.1)));
            }
            row
        };
        self.doubt.white[i].iter().map(whitened).collect()
    }

    /// The six values of a line: those in the middle are none.
    fn line(&self, i: usize, x: &[f64]) -> Option<[Row; 6]> {
        let feature = &self.found.features[i];
        let joints = self.ends(i)?.map(|j| self.layout.joint[j]);
        let away = joints.map(|at| sub(triple(x, at), feature.at));
        // By the joints as they were: the shares must not follow those of a short line.
        let [s, t] = joints.map(|at| dot(sub(triple(&self.layout.start, at), feature.at), feature.direction));
        if t - s <= SHORT * feature.observed.half {
            return None;
        }
        let middle = [t / (t - s), -s / (t - s)];
        let lean = feature.observed.half / (t - s);
        let row = |axis: [f64; 3], shares: [f64; 2]| Row {
            terms: (0..2).flat_map(|k| slopes(joints[k], scale(axis, shares[k]))).collect(),
            residual: (0..2).map(|k| shares[k] * dot(axis, away[k])).sum(),
        };
        let none = || Row { terms: Vec::new(), residual: 0.0 };
        let [u, v] = feature.observed.axes;
        let tilt = [-lean, lean];
        Some([row(u, tilt), row(v, tilt), none(), none(), row(u, middle), row(v, middle)])
    }

    /// The six values of an arc or circle.
    fn round(&self, i: usize, x: &[f64]) -> Option<[Row; 6]> {
        let feature = &self.found.features[i];
        let (centre, radius) = (self.layout.centre[i]?, self.layout.radius[i]?);
        let (direction, sign) = self.layout.direction[i]?;
        let [u, v] = feature.observed.axes;
        let size = feature.observed.half;
        let moved = sub(triple(x, centre), feature.at);
        let shift = |axis| Row { terms: slopes(centre, axis).to_vec(), residual: dot(axis, moved) };
        let tilt = |axis: [f64; 3], factor: f64| {
            let axis = scale(axis, factor * sign * size);
            Row { terms: slopes(direction, axis).to_vec(), residual: dot(axis, triple(x, direction)) }
        };
        let wider = Row { terms: vec![(radius, 1.0)], residual: x[radius] - size };
        Some([shift(u), shift(v), tilt(v, -1.0), tilt(u, 1.0), wider, shift(feature.direction)])
    }
}
