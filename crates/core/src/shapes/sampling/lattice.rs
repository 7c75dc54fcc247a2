//! Regular lattices on faces and along curves: the grid sampling.
//!
//! Points lie at equal steps along every curve of the truth, with nodes once, and inside each face on a lattice in its own
//! parameters, without lattice points nearer than half a step to a curve or node. On a cube whose edge is a whole number of
//! steps this is the grid whose faces share their edge points. On round curves the points lie on the chords of the truth, at
//! most 1e-5 of the radius inside the circle.

use std::f64::consts::TAU;

use crate::math::vec3::{add_scaled, distance, sub};
use crate::shapes::nearest::Tree;
use crate::shapes::shape::Shape;
use crate::shapes::surface::{FaceSurface, slant};
use crate::shapes::truth::TruthCurve;
use crate::shapes::turns::sin_cos;

/// `(N, 3)` points and the face of each (for points of curves and nodes, the first face that they lie on).
pub(super) fn grid(shape: &Shape, step: f64) -> (Vec<[f64; 3]>, Vec<u32>) {
    let mut points: Vec<[f64; 3]> = shape.network.nodes.iter().map(|n| n.position).collect();
    for curve in &shape.network.curves {
        points.append(&mut along(curve, step));
    }
    let mut faces: Vec<u32> = points.iter().map(|&p| nearest_face(shape, p)).collect();
    let [sharp, weak] = [shape.network.index(step / 2.0), shape.network.index_of_weak(step / 2.0)];
    let nodes = Tree::new(&points[..shape.network.nodes.len()]);
    let clear = |p| {
        let to_node = nodes.nearest(p).map_or(f64::INFINITY, |(_, d2)| d2.sqrt());
        sharp.distance(p).min(weak.distance(p)).min(to_node) > 0.5 * step
    };
    for (id, face) in (0..).zip(&shape.faces) {
        for uv in lattice(&face.surface, step) {
            let p = face.surface.at(uv);
            if face.holds(p) && clear(p) {
                points.push(p);
                faces.push(id);
            }
        }
    }
    (points, faces)
}

fn nearest_face(shape: &Shape, p: [f64; 3]) -> u32 {
    let away = |id: u32| shape.faces[id as usize].surface.distance(p);
    (0..shape.faces.len() as u32).min_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap_or(0)
}

/// The number of equal intervals nearest to `step` in a length; at least one.
fn intervals(length: f64, step: f64) -> u32 {
    (length / step).round().max(1.0) as u32
}

/// Points at equal steps along a curve, without those of its nodes.
fn along(curve: &TruthCurve, step: f64) -> Vec<[f64; 3]> {
    let length = curve.length();
    let count = intervals(length, step);
    let wanted = |k: u32| length * f64::from(k) / f64::from(count);
    let (mut points, mut next, mut before) = (Vec::new(), u32::from(!curve.closed), 0.0);
    for [a, b] in curve.segments() {
        let piece = distance(a, b);
        while next < count && wanted(next) <= before + piece {
            points.push(add_scaled(a, sub(b, a), (wanted(next) - before) / piece));
            next += 1;
        }
        before += piece;
    }
    points
}

/// `(u, v)` of a lattice whose neighbours are about `step` apart, the ends of the ranges included.
fn lattice(surface: &FaceSurface, step: f64) -> Vec<[f64; 2]> {
    let share = |i: u32, n: u32| f64::from(i) / f64::from(n);
    let rings = |rows: Vec<(f64, f64)>| {
        let ring = |(v, radius): (f64, f64)| {
            let n = intervals(TAU * radius, step);
            (0..n).map(move |i| [share(i, n), v])
        };
        rows.into_iter().flat_map(ring).collect()
    };
    match surface {
        FaceSurface::Plane { low, high, .. } => {
            let n = [0, 1].map(|k| intervals(high[k] - low[k], step));
            let at = move |k: usize, i: u32| low[k] + (high[k] - low[k]) * share(i, n[k]);
            (0..=n[1]).flat_map(|j| (0..=n[0]).map(move |i| [at(0, i), at(1, j)])).collect()
        }
        FaceSurface::Cone { from, to, .. } => {
            let n = intervals(slant(*from, *to), step);
            rings((0..=n).map(|j| (share(j, n), from[0] + (to[0] - from[0]) * share(j, n))).collect())
        }
        FaceSurface::Sphere { radius, .. } => {
            let n = intervals(0.5 * TAU * radius, step);
            let row = |j| sin_cos(0.5 * share(j, n) - 0.25);
            rings((0..=n).map(|j| (row(j)[1], radius * row(j)[0])).collect())
        }
        FaceSurface::Torus { ring, tube, .. } => {
            let n = intervals(TAU * tube, step);
            rings((0..n).map(|j| (share(j, n), ring + tube * sin_cos(share(j, n))[0])).collect())
        }
    }
}
