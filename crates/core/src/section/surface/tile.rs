//! A leaf of the index as a tile of the surface: one plane for its sixteen points where they lie on it as well as noise
//! explains.

use super::plane::TangentPlane;
use super::spread::{self, Spread};
use crate::math::vec3;
use crate::neighbors::{Leaf, WIDTH};

/// Fewest points of a tile that may stand for all of them.
const FEWEST_POINTS: f64 = 12.0;
/// Least variance along the shorter side of a tile that shows a plane by itself, in squared spacings: two rows of points do not show how the
/// surface lies across them.
pub(crate) const NARROW: f64 = 0.4;
/// Noise in spacings above which sixteen points do not show a plane well enough.
pub(crate) const NOISY: f64 = 0.15;

/// A leaf of the index.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tile {
    /// The plane of its points, local frame.
    pub plane: TangentPlane,
    /// Whether that plane holds for each of them.
    pub flat: bool,
    /// Whether the four tiles of its quad share one plane, which is then the plane of each.
    pub joined: bool,
    /// Whether its points do not show how it lies across.
    pub narrow: bool,
    /// Least and greatest height of its points across the slices, local frame.
    pub heights: (f64, f64),
}

/// The greatest distance of the points of a leaf from a plane.
pub(crate) fn most_off(leaf: &Leaf, plane: &TangentPlane) -> f64 {
    let base = vec3::dot(plane.normal, plane.centre);
    leaf.along(plane.normal)[..leaf.len()].iter().fold(0.0, |most: f64, x| most.max((x - base).abs()))
}

/// Distance from its plane in spacings that noise explains for each point of a tile.
pub(crate) fn farthest(noise: f64) -> f64 {
    3.0 * noise + 0.1
}

impl Tile {
    /// Of no leaf.
    pub(crate) const EMPTY: Tile =
        Tile { plane: TangentPlane::NONE, flat: false, joined: false, narrow: false, heights: (0.0, 0.0) };

    /// The tile of a leaf, its heights along `axis`, and the spread of its points.
    pub(crate) fn new(leaf: &Leaf, noise: f64, axis: [f64; 3]) -> (Self, Spread) {
        let heights = leaf.along(axis)[..leaf.len()]
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &z| (l.min(z), h.max(z)));
        let spread = spread(leaf);
        let Spread { weight, centre, tensor } = spread;
        let (least, normal) = spread::normal(&tensor);
        let sides = Sides::new(&tensor, least.max(0.0));
        // Points spread evenly over a rectangle have a twelfth of its squared sides as variances.
        let spacing = (12.0 * sides.product.sqrt() / weight.max(1.0)).sqrt();
        let residual = (least.max(0.0) * weight / (weight - 3.0).max(1.0)).sqrt();
        let plane = TangentPlane { centre, normal, residual, spacing };
        let flat = noise <= NOISY
            && weight >= FEWEST_POINTS
            && residual <= good(noise) * spacing
            && most_off(leaf, &plane) <= farthest(noise) * spacing;
        let narrow = sides.shorter < NARROW * spacing * spacing;
        (Self { plane, flat, joined: false, narrow, heights }, spread)
    }
}

/// The spread of the points of a leaf; of a full one in four sums side by side, which compilers vectorise.
fn spread(leaf: &Leaf) -> Spread {
    let origin = leaf.points().next().map_or([0.0; 3], |(_, p)| p);
    if leaf.len() < WIDTH {
        return Spread::of(leaf.points().map(|(_, p)| (p, 1.0)), origin);
    }
    let mut sums = [[0.0; 4]; 9];
    for i in (0..WIDTH).step_by(4) {
        for l in 0..4 {
            let [x, y, z] = [0, 1, 2].map(|a| leaf.at[a][i + l] - origin[a]);
            for (sum, value) in sums.iter_mut().zip([x, y, z, x * x, x * y, x * z, y * y, y * z, z * z]) {
                sum[l] += value;
            }
        }
    }
    let [x, y, z, xx, xy, xz, yy, yz, zz] = sums.map(|s| (s[0] + s[1] + s[2] + s[3]) / WIDTH as f64);
    let tensor = [xx - x * x, xy - x * y, xz - x * z, yy - y * y, yz - y * z, zz - z * z];
    Spread { weight: WIDTH as f64, centre: vec3::add(origin, [x, y, z]), tensor }
}

/// The variances along a tile.
pub(crate) struct Sides {
    /// Their product.
    pub product: f64,
    /// The shorter.
    pub shorter: f64,
}

impl Sides {
    /// From the covariance and its least eigenvalue.
    pub(crate) fn new(&[xx, xy, xz, yy, yz, zz]: &[f64; 6], least: f64) -> Self {
        let sum = xx + yy + zz - least;
        let minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
        let product = (minors - least * sum).max(0.0);
        let shorter = 0.5 * (sum - (sum * sum - 4.0 * product).max(0.0).sqrt());
        Self { product, shorter }
    }
}

/// Residual in spacings that noise explains.
pub(crate) fn good(noise: f64) -> f64 {
    1.4 * noise + 0.03
}
