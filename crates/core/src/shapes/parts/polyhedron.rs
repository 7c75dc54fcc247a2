//! Shapes with plane faces: solids, and sheets whose outer edges are borders.

use std::collections::BTreeMap;

use crate::math::vec3::{add, cross, dot, sub, unit};
use crate::shapes::face::{Face, Trim, shoelace};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{Fold, Truth, TruthCurve, fold_between};

/// Faces with their corners in order, seen from outside turning left. An edge of two faces becomes a crease (no
/// curve if the faces are coplanar), an edge of one face a border. Corners become nodes, so at each of them the edges must turn.
///
/// Corners of a face (at least three, distinct) must lie in one plane, and each edge belong to at most two faces.
pub(super) fn polyhedron(name: &'static str, corners: &[[f64; 3]], outlines: &[&[u32]]) -> Shape {
    let faces: Vec<Face> = outlines.iter().map(|outline| plane_face(corners, outline)).collect();
    // The faces of each edge, with the direction in which they pass it.
    let mut edges: BTreeMap<[u32; 2], Vec<(usize, bool)>> = BTreeMap::new();
    for (id, outline) in outlines.iter().enumerate() {
        for (&a, &b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            edges.entry([a.min(b), a.max(b)]).or_default().push((id, a < b));
        }
    }
    let curves = edges.iter().filter_map(|(&ends, sides)| edge_curve(corners, &faces, ends, sides)).collect();
    Shape { name, faces, network: Truth::with_nodes(corners, curves) }
}

/// A prism along z over an outline in x and y that turns left, then carried over by `place`, a rotation. Faces: that
/// at z = 0, that at z = `height`, and one for each edge of the outline.
pub(super) fn prism(
    name: &'static str,
    outline: &[[f64; 2]],
    height: f64,
    place: fn([f64; 3]) -> [f64; 3],
) -> Shape {
    let n = outline.len() as u32;
    let level = |z: f64| outline.iter().map(move |p| place([p[0], p[1], z]));
    let corners: Vec<[f64; 3]> = level(0.0).chain(level(height)).collect();
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    let outlines: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    polyhedron(name, &corners, &outlines)
}

fn edge_curve(
    corners: &[[f64; 3]],
    faces: &[Face],
    ends: [u32; 2],
    sides: &[(usize, bool)],
) -> Option<TruthCurve> {
    let points = ends.map(|i| corners[i as usize]);
    let &[(first, forwards), (second, _)] = sides else {
        return Some(TruthCurve::border(points.to_vec(), Some(ends)));
    };
    let [a, b] = [first, second].map(|id| faces[id].normal(points[0]));
    let way = if forwards { sub(points[1], points[0]) } else { sub(points[0], points[1]) };
    let fold = if dot(cross(a, b), way) > 0.0 { Fold::Convex } else { Fold::Concave };
    let angle = fold_between(a, b);
    (angle > 1e-6).then(|| TruthCurve::crease(points.to_vec(), angle, fold, Some(ends)))
}

/// The plane polygon over these corners, `u` along its first edge.
fn plane_face(corners: &[[f64; 3]], outline: &[u32]) -> Face {
    let points: Vec<[f64; 3]> = outline.iter().map(|&i| corners[i as usize]).collect();
    let z = newell(&points);
    let x = unit(sub(points[1], points[0]));
    let axes = Axes { origin: points[0], x, y: cross(z, x), z };
    let flat: Vec<[f64; 2]> = points.iter().map(|&p| axes.to_local(p)).map(|q| [q[0], q[1]]).collect();
    let least = |k: usize| flat.iter().map(|q| q[k]).fold(f64::INFINITY, f64::min);
    let most = |k: usize| flat.iter().map(|q| q[k]).fold(f64::NEG_INFINITY, f64::max);
    let surface = FaceSurface::Plane { axes, low: [least(0), least(1)], high: [most(0), most(1)] };
    let mut face = Face::new(surface);
    if (shoelace(&flat) - surface.area()).abs() > 1e-9 * surface.area() {
        face.trims.push(Trim::Polygon(flat));
    }
    face
}

/// Unit normal of a plane polygon (Newell's sum, right also where corners are concave).
fn newell(points: &[[f64; 3]]) -> [f64; 3] {
    let next = points.iter().cycle().skip(1);
    unit(points.iter().zip(next).fold([0.0; 3], |sum, (&a, &b)| add(sum, cross(a, b))))
}
