//! Solids with plane faces.

use super::polyhedron::{polyhedron, prism};
use crate::shapes::shape::Shape;
use crate::shapes::turns::sin_cos;

/// The faces of a box whose corner `i` is high in x, y, z where the bits 0, 1, 2 of `i` are set.
const BOX: [&[u32]; 6] =
    [&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 2, 3, 1], &[4, 5, 7, 6]];

/// A box with these edge lengths, centred at the origin: 12 creases of 90 degrees and 8 junctions.
pub fn cuboid(edges: [f64; 3]) -> Shape {
    let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 1 { 0.5 * edges[k] } else { -0.5 * edges[k] });
    let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
    polyhedron("cuboid", &corners, &BOX)
}

/// A block 4 wide, 3 deep and 2 high, every edge slanted: the top is drawn in by unlike amounts on its four sides.
pub fn tapered_block() -> Shape {
    let (x, y) = ([[0.0, 4.0], [0.5, 3.2]], [[0.0, 3.0], [0.4, 2.5]]);
    let corner = |i: usize| [x[i >> 2][i & 1], y[i >> 2][i >> 1 & 1], 2.0 * (i >> 2) as f64];
    let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
    Shape { name: "tapered block", ..polyhedron("tapered block", &corners, &BOX) }
}

/// A block 2 long with a roof of two plane slopes, 1 by 2 each, whose ridge folds by `fold_deg`, above 0 and below
/// 180. The ridge runs along x from 0 to 2; the eaves fold by `90 - fold_deg / 2` on walls 0.5 high.
pub fn wedge(fold_deg: f64) -> Shape {
    let [half, drop] = sin_cos(fold_deg / 720.0);
    let outline = [[0.0, 0.0], [-half, -drop], [-half, -drop - 0.5], [half, -drop - 0.5], [half, -drop]];
    prism("wedge", &outline, 2.0, |[y, z, x]| [x, y, z])
}

/// A block 3 long, 2 deep and 1 high whose four upright edges are cut off at 45 degrees by faces of this width, above 0 and
/// below 2: 24 creases, 8 of them folding by 45 degrees, and 16 junctions.
pub fn chamfered_block(width: f64) -> Shape {
    let leg = width * std::f64::consts::FRAC_1_SQRT_2;
    let outline = [
        [leg, 0.0],
        [3.0 - leg, 0.0],
        [3.0, leg],
        [3.0, 2.0 - leg],
        [3.0 - leg, 2.0],
        [leg, 2.0],
        [0.0, 2.0 - leg],
        [0.0, leg],
    ];
    prism("chamfered block", &outline, 1.0, |p| p)
}

/// A prism over a star with this many points (4 at least: with 3 the inner corners would be straight), outer radius 1,
/// inner radius 0.5, height 2: convex and concave edges in turn.
pub fn star_prism(points: u32) -> Shape {
    let points = points.max(4);
    let corner = |i: u32| {
        let radius = if i.is_multiple_of(2) { 1.0 } else { 0.5 };
        sin_cos(f64::from(i) / f64::from(2 * points)).map(|x| radius * x)
    };
    let outline: Vec<[f64; 2]> = (0..2 * points).map(corner).collect();
    prism("star prism", &outline, 2.0, |p| p)
}

/// A prism along z over a regular polygon of this many sides (3 at least) about the origin, corners at radius 1.
pub fn regular_prism(sides: u32, height: f64) -> Shape {
    let sides = sides.max(3);
    let outline: Vec<[f64; 2]> = (0..sides).map(|i| sin_cos(f64::from(i) / f64::from(sides))).collect();
    prism("regular prism", &outline, height, |p| p)
}
