//! Two cylinders that cross at right angles (Demarsin et al., "Detection of closed sharp edges in point clouds", 2007,
//! figures 1 to 6).

use super::revolution::revolve_about;
use crate::math::vec3::unit;
use crate::network::StripKind;
use crate::shapes::face::Trim;
use crate::shapes::shape::Shape;
use crate::shapes::surface::Axes;
use crate::shapes::truth::{CIRCLE, Fold, Truth, TruthCurve, fold_between};
use crate::shapes::turns::sin_cos;

/// Half the length of either cylinder in greater radii.
const HALF_LENGTH: f64 = 2.5;

/// The solid union of two closed cylinders, the one of the greater radius along x, the other along y.
///
/// Unlike radii: six loops, the four rims and two concave curves where the thinner cylinder leaves the thicker. Equal
/// radii: the four rims, and four half ellipses that meet at two junctions, where the fold fades to nothing; below 30
/// degrees it is marked weak.
pub fn cylinders(radius_a: f64, radius_b: f64) -> Shape {
    let radii = [radius_a.max(radius_b), radius_a.min(radius_b)];
    let half = HALF_LENGTH * radii[0];
    let [mut a, b] = [0, 1].map(|k| {
        let r = radii[k];
        revolve_about("cylinders", axis(k), &[[0.0, -half], [r, -half], [r, half], [0.0, half]])
    });
    a.join(b);
    a.faces[1].trims.push(bore(1, radii[1]));
    a.faces[4].trims.push(bore(0, radii[0]));
    if radii[0] > radii[1] {
        a.network.curves.extend(saddles(radii, Fold::Concave));
        return a;
    }
    let poles = [-radii[0], radii[0]].map(|z| [0.0, 0.0, z]);
    let curves = a.network.curves.into_iter().chain(half_ellipses(radii[0])).collect();
    a.network = Truth { weak_below_deg: 30.0, ..Truth::with_nodes(&poles, curves) };
    a
}

/// Two pipes with open bores that cross and join: radii 1 and 0.7 outside, 0.6 and 0.4 inside. Ten smooth regions and
/// no node, as in the paper's example (10 large clusters in its table 1, and in table 2 as many edges as vertices in the
/// closed graph, so loops only); its text does not say more of that model.
pub fn pipe_cross() -> Shape {
    let (outer, inner) = ([1.0, 0.7], [0.6, 0.4]);
    let half = HALF_LENGTH;
    let [mut a, b] = [0, 1].map(|k| {
        let (r, s) = (outer[k], inner[k]);
        let profile = [[s, -half], [r, -half], [r, half], [s, half], [s, -half]];
        revolve_about("pipe cross", axis(k), &profile)
    });
    a.join(b);
    for (face, other, radius) in [(1, 1, outer[1]), (3, 1, inner[1]), (5, 0, outer[0]), (7, 0, inner[0])] {
        a.faces[face].trims.push(bore(other, radius));
    }
    a.network.curves.extend(saddles(outer, Fold::Concave));
    a.network.curves.extend(saddles(inner, Fold::Convex));
    a
}

impl Shape {
    /// Takes in the faces and curves of another shape without nodes.
    pub(in crate::shapes) fn join(&mut self, other: Shape) {
        self.faces.extend(other.faces);
        self.network.curves.extend(other.network.curves);
    }
}

/// The frame about x for 0, about y for 1.
fn axis(k: usize) -> Axes {
    Axes::along([0.0; 3], if k == 0 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] })
}

fn bore(k: usize, radius: f64) -> Trim {
    Trim::Cylinder { origin: [0.0; 3], axis: axis(k).z, radius }
}

/// The two closed curves in which the thinner cylinder, about y, leaves the thicker one, about x.
fn saddles(radii: [f64; 2], fold: Fold) -> [TruthCurve; 2] {
    [-1.0, 1.0].map(|side| {
        let at = |i| {
            let [x, z] = sin_cos(f64::from(i) / f64::from(CIRCLE)).map(|c| radii[1] * c);
            [x, side * (radii[0] * radii[0] - z * z).sqrt(), z]
        };
        crossing((0..CIRCLE).map(at).collect(), fold, None)
    })
}

/// The arcs from the lower pole to the upper in which two cylinders of one radius meet.
fn half_ellipses(radius: f64) -> [TruthCurve; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[sx, sy]| {
        let at = |i| {
            let [c, s] = sin_cos(f64::from(i) / f64::from(CIRCLE) - 0.25);
            [radius * sx * c, radius * sy * c, radius * s]
        };
        crossing((0..=CIRCLE / 2).map(at).collect(), Fold::Concave, Some([0, 1]))
    })
}

/// A curve that lies on both cylinders, with the angle between their normals.
fn crossing(points: Vec<[f64; 3]>, fold: Fold, ends: Option<[u32; 2]>) -> TruthCurve {
    let angle = |&[x, y, z]: &[f64; 3]| fold_between(unit([0.0, y, z]), unit([x, 0.0, z]));
    let fold_deg = points.iter().map(angle).collect();
    TruthCurve::new(StripKind::Crease, points, fold_deg, fold, ends)
}
