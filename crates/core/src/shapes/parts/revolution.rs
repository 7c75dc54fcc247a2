//! Shapes turned about the z axis.

use crate::shapes::face::Face;
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{Fold, Truth, TruthCurve, circle, fold_between};

/// The surface that a polyline of `(r, z)`, r at least 0, sweeps about the z axis, its outside to the right of the
/// way: upwards on the outer wall. Where the profile turns there is a circle, where it ends off the axis a border, and
/// where it reaches the axis at a slant an apex. A profile that ends where it starts is closed. It may touch the axis
/// at its ends only.
pub fn revolve(name: &'static str, profile: &[[f64; 2]]) -> Shape {
    revolve_about(name, Axes::at([0.0; 3]), profile)
}

/// [`revolve`] about the z axis of a frame.
pub(super) fn revolve_about(name: &'static str, axes: Axes, profile: &[[f64; 2]]) -> Shape {
    let strip = |w: &[[f64; 2]]| Face::new(FaceSurface::Cone { axes, from: w[0], to: w[1] });
    let faces: Vec<Face> = profile.windows(2).map(strip).collect();
    let ring = |[r, z]: [f64; 2]| circle(axes.to_world([0.0, 0.0, z]), axes.x, axes.y, r);
    let mut curves: Vec<TruthCurve> =
        profile.windows(3).filter_map(|w| turn(w[0], w[1], w[2], ring)).collect();
    let mut peaks = Vec::new();
    match (profile, profile) {
        ([first, second, ..], [.., before, last]) if first == last => {
            curves.extend(turn(*before, *first, *second, ring));
        }
        ([first, second, ..], [.., before, last]) => {
            for (end, inner) in [(*first, *second), (*last, *before)] {
                if end[0] > 0.0 {
                    curves.push(TruthCurve::border(ring(end), None));
                } else if end[1] != inner[1] {
                    peaks.push(axes.to_world([0.0, 0.0, end[1]]));
                }
            }
        }
        _ => {}
    }
    Shape { name, faces, network: Truth::with_nodes(&peaks, curves) }
}

/// The circle where a profile turns at `b` on its way from `a` to `c`.
fn turn(
    a: [f64; 2],
    b: [f64; 2],
    c: [f64; 2],
    ring: impl Fn([f64; 2]) -> Vec<[f64; 3]>,
) -> Option<TruthCurve> {
    let (before, after) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    let left = before[0] * after[1] - before[1] * after[0];
    let fold = if left > 0.0 { Fold::Convex } else { Fold::Concave };
    (left != 0.0).then(|| TruthCurve::crease(ring(b), angle(before, after), fold, None))
}

fn angle(a: [f64; 2], b: [f64; 2]) -> f64 {
    fold_between([a[0], a[1], 0.0], [b[0], b[1], 0.0])
}

/// A cone of this base radius and height on a disc at z = 0: one circle and an apex.
pub fn cone(radius: f64, height: f64) -> Shape {
    revolve("cone", &[[0.0, 0.0], [radius, 0.0], [0.0, height]])
}

/// An open cylinder of radius 1 and length 4: two border loops, no crease.
pub fn tube() -> Shape {
    revolve("tube", &[[1.0, 0.0], [1.0, 4.0]])
}

/// A shaft of 7 with three diameters, a collar, a groove and a chamfer; all edges are circles about z.
pub fn stepped_shaft() -> Shape {
    let profile = [
        [0.0, 0.0],
        [0.6, 0.0],
        [0.6, 1.5],
        [1.0, 1.5],
        [1.0, 3.0],
        [1.4, 3.0], // the collar
        [1.4, 3.6],
        [1.0, 3.6],
        [1.0, 4.2],
        [0.8, 4.2], // the groove
        [0.8, 4.8],
        [1.0, 4.8],
        [1.0, 6.7],
        [0.7, 7.0], // the chamfer
        [0.0, 7.0],
    ];
    revolve("stepped shaft", &profile)
}

/// A sphere about the origin: no feature at all.
pub fn sphere(radius: f64) -> Shape {
    let face = Face::new(FaceSurface::Sphere { axes: Axes::at([0.0; 3]), radius });
    Shape { name: "sphere", faces: vec![face], network: Truth::default() }
}

/// A torus about the z axis, `tube` below `ring`: no feature at all.
pub fn torus(ring: f64, tube: f64) -> Shape {
    let face = Face::new(FaceSurface::Torus { axes: Axes::at([0.0; 3]), ring, tube });
    Shape { name: "torus", faces: vec![face], network: Truth::default() }
}
