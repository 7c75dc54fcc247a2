//! Observations and conditions of the joint least squares, linearised.
//!
//! A curve is observed as it was fitted: a line in the shifts of its middle and its end, an arc or a circle in centre, radius and axis, whitened by
//! their covariance. A joint is observed where it was. Conditions are lengths: how far a relation is from holding.

use super::super::find::Found;
use super::doubts::Doubts;
use super::imposed::Imposed;
use super::layout::{Layout, triple};
use super::row::Row;
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
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
fn slopes(at: usize, slope: [f64; 3]) -> [(usize, f64); 3] {
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

    pub(super) fn conditions(&self, x: &[f64]) -> Vec<Row> {
        let (mut rows, size) = (Vec::new(), self.size());
        for &at in &self.layout.directions {
            let d = triple(x, at);
            let row = slopes(at, scale(d, size)).to_vec();
            rows.push(Row { terms: row, residual: 0.5 * size * (dot(d, d) - 1.0) });
        }
        (0..self.found.features.len()).for_each(|i| self.own(i, x, &mut rows));
        self.turned(x, &mut rows);
        self.flat(x, &mut rows);
        for (members, concentric) in &self.imposed.axes {
            if !concentric {
                members[1..].iter().for_each(|&i| self.coaxial(members[0], i, x, &mut rows));
            }
        }
        self.imposed.tangents.iter().for_each(|t| self.tangent(t.0, t.1, x, &mut rows));
        rows
    }

    /// Two unit vectors across a direction, which turn with it.
    fn across(&self, at: usize, x: &[f64]) -> [[f64; 3]; 2] {
        let d = triple(x, at);
        let u = perpendicular(triple(&self.layout.start, at));
        let u = unit(add_scaled(u, d, -dot(u, d)));
        [u, cross(d, u)]
    }

    /// A line runs in its direction; an arc ends on its joints.
    fn own(&self, i: usize, x: &[f64], rows: &mut Vec<Row>) {
        let (Some(ends), Some((at, _))) = (self.ends(i), self.layout.direction[i]) else { return };
        let joints = ends.map(|j| self.layout.joint[j]);
        let [a, b] = joints.map(|j| triple(x, j));
        let d = triple(x, at);
        let (Some(centre), Some(radius)) = (self.layout.centre[i], self.layout.radius[i]) else {
            let chord = sub(b, a);
            for axis in self.across(at, x) {
                let mut terms = slopes(joints[1], axis).to_vec();
                terms.extend(slopes(joints[0], scale(axis, -1.0)));
                terms.extend(slopes(at, scale(axis, -dot(chord, d))));
                rows.push(Row { terms, residual: dot(axis, chord) });
            }
            return;
        };
        for joint in joints {
            let away = sub(triple(x, joint), triple(x, centre));
            let out = unit(away);
            let mut terms = slopes(joint, out).to_vec();
            terms.extend(slopes(centre, scale(out, -1.0)));
            terms.push((radius, -1.0));
            rows.push(Row { terms, residual: norm(away) - x[radius] });
            let mut terms = slopes(joint, d).to_vec();
            terms.extend(slopes(centre, scale(d, -1.0)));
            terms.extend(slopes(at, away));
            rows.push(Row { terms, residual: dot(d, away) });
        }
    }

    /// Right angles, as lengths over the size of the network.
    fn turned(&self, x: &[f64], rows: &mut Vec<Row>) {
        let size = self.size();
        for classes in &self.imposed.right {
            let [Some(a), Some(b)] = classes.map(|c| self.layout.class[c]) else { continue };
            let (da, db) = (triple(x, a), triple(x, b));
            let mut terms = slopes(a, scale(db, size)).to_vec();
            terms.extend(slopes(b, scale(da, size)));
            rows.push(Row { terms, residual: size * dot(da, db) });
        }
    }

    /// Lines lie in their planes with both ends, arcs and circles with their centres.
    fn flat(&self, x: &[f64], rows: &mut Vec<Row>) {
        for ((class, members), &height) in self.imposed.planes.iter().zip(&self.layout.plane) {
            let Some(at) = self.layout.class[*class] else { continue };
            let normal = triple(x, at);
            let mut places: BTreeSet<usize> = members.iter().filter_map(|&i| self.layout.centre[i]).collect();
            let lines = members.iter().filter(|&&i| self.layout.centre[i].is_none());
            places.extend(lines.filter_map(|&i| self.ends(i)).flatten().map(|j| self.layout.joint[j]));
            for place in places {
                let p = triple(x, place);
                let mut terms = slopes(place, normal).to_vec();
                terms.extend(slopes(at, p));
                terms.push((height, -1.0));
                rows.push(Row { terms, residual: dot(normal, p) - x[height] });
            }
        }
    }

    fn coaxial(&self, first: usize, i: usize, x: &[f64], rows: &mut Vec<Row>) {
        let (Some(a), Some(b)) = (self.layout.centre[first], self.layout.centre[i]) else { return };
        let Some((at, _)) = self.layout.direction[first].filter(|_| a != b) else { return };
        let apart = sub(triple(x, b), triple(x, a));
        let far = dot(apart, triple(x, at));
        for axis in self.across(at, x) {
            let mut terms = slopes(b, axis).to_vec();
            terms.extend(slopes(a, scale(axis, -1.0)));
            terms.extend(slopes(at, scale(axis, -far)));
            rows.push(Row { terms, residual: dot(axis, apart) });
        }
    }

    fn tangent(&self, features: [usize; 2], joint: usize, x: &[f64], rows: &mut Vec<Row>) {
        let place = self.layout.joint[joint];
        let p = triple(x, place);
        match features.map(|i| self.layout.centre[i]) {
            [Some(a), Some(b)] => {
                let Some((normal, _)) = self.layout.direction[features[0]] else { return };
                let n = triple(x, normal);
                let (one, other) = (sub(p, triple(x, a)), sub(p, triple(x, b)));
                let size = norm(one).max(norm(other));
                let (from_a, from_b) = (scale(cross(other, n), 1.0 / size), scale(cross(n, one), 1.0 / size));
                let mut terms = slopes(a, scale(from_a, -1.0)).to_vec();
                terms.extend(slopes(b, scale(from_b, -1.0)));
                terms.extend(slopes(place, add_scaled(from_a, from_b, 1.0)));
                rows.push(Row { terms, residual: dot(n, cross(one, other)) / size });
            }
            [Some(centre), None] => self.touching(features[1], (features[0], centre), place, x, rows),
            [None, Some(centre)] => self.touching(features[0], (features[1], centre), place, x, rows),
            [None, None] => {}
        }
    }

    /// A line is across the radius at the joint, and in the plane of the arc.
    fn touching(
        &self,
        line: usize,
        (arc, centre): (usize, usize),
        place: usize,
        x: &[f64],
        rows: &mut Vec<Row>,
    ) {
        let (Some(ends), Some((at, _))) = (self.ends(line), self.layout.direction[arc]) else { return };
        let [a, b] = ends.map(|j| self.layout.joint[j]);
        let chord = sub(triple(x, b), triple(x, a));
        let long = norm(chord);
        let (along, out) = (scale(chord, 1.0 / long), sub(triple(x, place), triple(x, centre)));
        let lever = scale(out, 1.0 / long);
        let mut terms = slopes(b, lever).to_vec();
        terms.extend(slopes(a, scale(lever, -1.0)));
        terms.extend(slopes(place, along));
        terms.extend(slopes(centre, scale(along, -1.0)));
        rows.push(Row { terms, residual: dot(along, out) });
        let d = triple(x, at);
        let mut terms = slopes(b, d).to_vec();
        terms.extend(slopes(a, scale(d, -1.0)));
        terms.extend(slopes(at, chord));
        rows.push(Row { terms, residual: dot(d, chord) });
    }
}
