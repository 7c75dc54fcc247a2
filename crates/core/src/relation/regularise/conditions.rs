//! The conditions of the joint least squares, linearised: lengths, how far a relation is from holding.

use super::super::tangent::Tangent;
use super::cause::Cause;
use super::layout::triple;
use super::row::Row;
use super::rows::{System, slopes};
use crate::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
use std::collections::BTreeMap;

/// Conditions with what each stems from.
#[derive(Clone, Debug, Default)]
pub(super) struct Conditions {
    pub rows: Vec<Row>,
    pub causes: Vec<Cause>,
}

impl Conditions {
    fn push(&mut self, cause: Cause, terms: Vec<(usize, f64)>, residual: f64) {
        self.rows.push(Row { terms, residual });
        self.causes.push(cause);
    }

    /// The greatest of what they lack.
    pub(super) fn lacking(&self) -> f64 {
        self.rows.iter().map(|c| c.residual.abs()).fold(0.0, f64::max)
    }
}

impl System<'_> {
    pub(super) fn conditions(&self, x: &[f64]) -> Conditions {
        let (mut all, size) = (Conditions::default(), self.size());
        for &at in &self.layout.directions {
            let d = triple(x, at);
            all.push(Cause::Unit, slopes(at, scale(d, size)).to_vec(), 0.5 * size * (dot(d, d) - 1.0));
        }
        (0..self.found.features.len()).for_each(|i| self.own(i, x, &mut all));
        self.turned(x, &mut all);
        self.flat(x, &mut all);
        for axis in self.imposed.axes.iter().filter(|a| !a.concentric) {
            let first = axis.members[0];
            for &i in &axis.members[1..] {
                self.coaxial(first, i, Cause::Coaxial(axis.found, i), x, &mut all);
            }
        }
        self.imposed.tangents.iter().for_each(|&t| self.tangent(t, x, &mut all));
        all
    }

    /// Two unit vectors across a direction, which turn with it.
    fn across(&self, at: usize, x: &[f64]) -> [[f64; 3]; 2] {
        let d = triple(x, at);
        let u = perpendicular(triple(&self.layout.start, at));
        let u = unit(add_scaled(u, d, -dot(u, d)));
        [u, cross(d, u)]
    }

    /// A line runs in its direction; an arc ends on its joints.
    fn own(&self, i: usize, x: &[f64], all: &mut Conditions) {
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
                all.push(Cause::Parallel(i), terms, dot(axis, chord));
            }
            return;
        };
        for joint in joints {
            let away = sub(triple(x, joint), triple(x, centre));
            let out = unit(away);
            let mut terms = slopes(joint, out).to_vec();
            terms.extend(slopes(centre, scale(out, -1.0)));
            terms.push((radius, -1.0));
            all.push(Cause::Feature(i), terms, norm(away) - x[radius]);
            let mut terms = slopes(joint, d).to_vec();
            terms.extend(slopes(centre, scale(d, -1.0)));
            terms.extend(slopes(at, away));
            all.push(Cause::Feature(i), terms, dot(d, away));
        }
    }

    /// Right angles, as lengths over the size of the network.
    fn turned(&self, x: &[f64], all: &mut Conditions) {
        let size = self.size();
        for right in &self.imposed.right {
            let [Some(a), Some(b)] = right.classes.map(|c| self.layout.class[c]) else { continue };
            let (da, db) = (triple(x, a), triple(x, b));
            let mut terms = slopes(a, scale(db, size)).to_vec();
            terms.extend(slopes(b, scale(da, size)));
            all.push(Cause::Perpendicular(right.found), terms, size * dot(da, db));
        }
    }

    /// Lines lie in their planes with both ends, arcs and circles with their centres.
    fn flat(&self, x: &[f64], all: &mut Conditions) {
        for (plane, &height) in self.imposed.planes.iter().zip(&self.layout.plane) {
            let Some(at) = self.layout.class[plane.class] else { continue };
            let normal = triple(x, at);
            // A joint of several lines is told once, as the least known one's.
            let mut places: BTreeMap<usize, usize> = BTreeMap::new();
            let doubt = |i: usize| self.found.features[i].doubt();
            for &i in &plane.members {
                let ends = || self.ends(i).into_iter().flatten().map(|j| self.layout.joint[j]).collect();
                let own: Vec<usize> = self.layout.centre[i].map_or_else(ends, |centre| vec![centre]);
                for place in own {
                    let of = places.entry(place).or_insert(i);
                    *of = if doubt(i) > doubt(*of) { i } else { *of };
                }
            }
            for (place, i) in places {
                let p = triple(x, place);
                let mut terms = slopes(place, normal).to_vec();
                terms.extend(slopes(at, p));
                terms.push((height, -1.0));
                all.push(Cause::Coplanar(plane.found, i), terms, dot(normal, p) - x[height]);
            }
        }
    }

    fn coaxial(&self, first: usize, i: usize, cause: Cause, x: &[f64], all: &mut Conditions) {
        let (Some(a), Some(b)) = (self.layout.centre[first], self.layout.centre[i]) else { return };
        let Some((at, _)) = self.layout.direction[first].filter(|_| a != b) else { return };
        let apart = sub(triple(x, b), triple(x, a));
        let far = dot(apart, triple(x, at));
        for axis in self.across(at, x) {
            let mut terms = slopes(b, axis).to_vec();
            terms.extend(slopes(a, scale(axis, -1.0)));
            terms.extend(slopes(at, scale(axis, -far)));
            all.push(cause, terms, dot(axis, apart));
        }
    }

    fn tangent(&self, t: usize, x: &[f64], all: &mut Conditions) {
        let Tangent { features, joint, .. } = self.found.tangents[t];
        let place = self.layout.joint[joint];
        let cause = Cause::Tangent(t);
        match features.map(|i| self.layout.centre[i]) {
            [Some(a), Some(b)] => self.rolling(features, [a, b], place, cause, x, all),
            [Some(centre), None] => {
                self.touching(features[1], (features[0], centre), place, cause, x, all);
            }
            [None, Some(centre)] => {
                self.touching(features[0], (features[1], centre), place, cause, x, all);
            }
            [None, None] => {}
        }
    }

    /// The tangent of one arc at the joint is across the radius of the other, and in its plane.
    fn rolling(
        &self,
        features: [usize; 2],
        [a, b]: [usize; 2],
        place: usize,
        cause: Cause,
        x: &[f64],
        all: &mut Conditions,
    ) {
        let [Some((normal, _)), Some((second, _))] = features.map(|i| self.layout.direction[i]) else {
            return;
        };
        let (p, n, m) = (triple(x, place), triple(x, normal), triple(x, second));
        let (one, other) = (sub(p, triple(x, a)), sub(p, triple(x, b)));
        let size = norm(one).max(norm(other));
        let (from_a, from_b) = (scale(cross(other, n), 1.0 / size), scale(cross(n, one), 1.0 / size));
        let mut terms = slopes(a, scale(from_a, -1.0)).to_vec();
        terms.extend(slopes(b, scale(from_b, -1.0)));
        terms.extend(slopes(place, add_scaled(from_a, from_b, 1.0)));
        terms.extend(slopes(normal, scale(cross(one, other), 1.0 / size)));
        all.push(cause, terms, dot(n, cross(one, other)) / size);
        if normal != second {
            let mut terms = slopes(second, cross(n, one)).to_vec();
            terms.extend(slopes(normal, cross(one, m)));
            terms.extend(slopes(place, cross(m, n)));
            terms.extend(slopes(a, cross(n, m)));
            all.push(cause, terms, dot(m, cross(n, one)));
        }
    }

    /// A line is across the radius at the joint, and in the plane of the arc.
    fn touching(
        &self,
        line: usize,
        (arc, centre): (usize, usize),
        place: usize,
        cause: Cause,
        x: &[f64],
        all: &mut Conditions,
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
        all.push(cause, terms, dot(along, out));
        let d = triple(x, at);
        let mut terms = slopes(b, d).to_vec();
        terms.extend(slopes(a, scale(d, -1.0)));
        terms.extend(slopes(at, chord));
        all.push(cause, terms, dot(d, chord));
    }
}
