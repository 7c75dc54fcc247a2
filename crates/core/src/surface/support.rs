//! Support: the number of points around a point that lie in one plane with it.
//!
//! On a surface a point has others in its plane, at an edge in one of two planes; leaves, rain and stray returns fill a volume.
//! Among the planes of the point and of its nearest neighbours, each fitted to a few points, the best one through the point
//! counts, as in the consensus of the normals (`detect/evidence/consensus.rs`).

use crate::math::eigen3::Symmetric3;
use crate::math::least_axis::least_axis;
use crate::math::tensor::{centred, correlation, scatter};
use crate::math::vec3::{add_scaled, distance2, dot, sub};
use crate::neighbors::{Found, Index, Neighbors};
use crate::parallel;
use crate::resolution::Resolution;
use std::f64::consts::FRAC_2_PI;

/// Neighbours to which a plane is fitted, and whose planes are tried.
const FITTED: usize = 8;
/// Neighbours that are counted.
pub(super) const COUNTED: usize = 24;
/// Greatest distance of a neighbour that counts, local spacings.
pub(super) const NEAR: f64 = 4.0;
/// Greatest distance from a plane of a point in it: local spacings, or standard deviations of the noise if that is more.
const IN_PLANE: (f64, f64) = (0.15, 3.0);

/// Standard deviations by which more points lie in a plane than by chance, as the best of nine planes counts, each laid through
/// some of them.
const CHANCE: f64 = 5.0;

/// A plane fitted to the neighbourhood of a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// Its centre, from the point.
    centre: [f32; 3],
    /// Unit normal without orientation.
    normal: [f32; 3],
    /// Ratio of its points' extents in the plane, at least 1.
    pub(super) elongation: f32,
}

/// `(N)` the plane through each point and its nearest neighbours.
pub(super) fn planes(points: &[[f64; 3]], nearest: &Neighbors) -> Vec<Plane> {
    let fit = |i: usize| {
        let (centre, tensor) = correlation(points, i, fitted(nearest, i));
        let (least, normal) = least_axis(&tensor);
        Plane {
            centre: centre.map(|x| x as f32),
            normal: normal.map(|x| x as f32),
            elongation: elongation(&tensor, least) as f32,
        }
    };
    parallel::map(points.len(), parallel::QUICK, fit)
}

/// The neighbours that the plane of point `i` is fitted to.
pub(super) fn fitted(nearest: &Neighbors, i: usize) -> &[u32] {
    let near = nearest.of(i);
    &near[..near.len().min(FITTED)]
}

/// Square root of the ratio of the two greater eigenvalues, of which the sum and the product follow from the invariants and the least.
fn elongation([a, b, c, d, e, f]: &Symmetric3, least: f64) -> f64 {
    let sum = a + d + f - least;
    let product = a * d - b * b + a * f - c * c + d * f - e * e - least * sum;
    let most = 0.5 * sum + (0.25 * sum * sum - product).max(0.0).sqrt();
    (most / (product / most).max(f64::MIN_POSITIVE)).max(1.0).sqrt()
}

/// Greatest distance from a plane of a point in it, at a place of that spacing.
fn tolerance(spacing: f32, mean: Resolution) -> f64 {
    (IN_PLANE.0 * f64::from(spacing)).max(IN_PLANE.1 * mean.noise)
}

/// What shows that a point lies on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) enum Demand {
    /// Nothing is asked.
    None,
    /// That many neighbours in one plane with it.
    Least(usize),
    /// That many and more than chance puts there: for a point far from its neighbours, of which an upright plane through it
    /// cuts many where the noise makes planes thick.
    BeyondChance(usize),
}

impl Demand {
    /// The number of `near` that must lie within `tolerance` of a plane.
    fn among(self, near: &[[f64; 3]], tolerance: f64) -> usize {
        match self {
            Demand::None => 0,
            Demand::Least(enough) => enough,
            Demand::BeyondChance(enough) => {
                enough.max(by_chance(near.len(), (tolerance / radius(near)).min(1.0)))
            }
        }
    }
}

/// The radius of a disc in which places vary as much about their centre as these do.
fn radius(near: &[[f64; 3]]) -> f64 {
    let share = 1.0 / near.len() as f64;
    let centre = near.iter().fold([0.0; 3], |sum, &d| add_scaled(sum, d, share));
    let variance: f64 = near.iter().map(|&d| distance2(d, centre) * share).sum();
    (2.0 * variance).sqrt()
}

/// The most of `count` points in a disc that lie within `half` radii of a diameter by chance.
fn by_chance(count: usize, half: f64) -> usize {
    let share = FRAC_2_PI * (half * (1.0 - half * half).sqrt() + half.asin());
    let mean = count as f64 * share;
    (mean + CHANCE * (mean * (1.0 - share)).sqrt()).ceil() as usize
}

/// `(N)` whether as many of the 24 nearest of every point lie in one plane with it as `demand` says. `spacing` is the
/// spacing at each point. Most points have enough in their list of neighbours, so that few need a search.
pub(super) fn supported(
    points: &[[f64; 3]],
    nearest: &Neighbors,
    planes: &[Plane],
    raw: &[f32],
    spacing: &[f32],
    mean: Resolution,
    demand: impl Fn(usize) -> Demand + Sync,
) -> Vec<bool> {
    let index = Index::build(points);
    let own = |(near, found): &mut (Vec<[f64; 3]>, Vec<Found>), i: usize| {
        let reach = NEAR * f64::from(spacing[i].max(raw[i]));
        let (tolerance, demand) = (tolerance(spacing[i], mean), demand(i));
        if matches!(demand, Demand::None) {
            return true;
        }
        let mut gather = |some: &mut dyn Iterator<Item = u32>| {
            near.clear();
            let offsets = some.map(|j| sub(points[j as usize], points[i]));
            near.extend(offsets.take_while(|&d| dot(d, d) <= reach * reach));
            let enough = demand.among(near, tolerance);
            near.len() >= enough && is_held(points, i, nearest, planes, near, tolerance, enough)
        };
        if gather(&mut nearest.of(i).iter().copied()) {
            return true;
        }
        index.nearest(points[i], COUNTED + 1, found);
        if gather(&mut found.iter().map(|f| f.index).filter(|&j| j as usize != i)) {
            return true;
        }
        let enough = demand.among(near, tolerance);
        near.len() >= enough && lies_in_layer(near, tolerance, enough)
    };
    parallel::map_with(points.len(), parallel::QUICK, own)
}

/// Whether the point at the origin and at least `enough` of the places `near` lie in one layer of a sheet: in the plane through
/// the point along all of them.
///
/// Where both sides of a thin sheet were scanned, the few points of the planes above come from both and lean the planes; the
/// sheet as a whole gives its direction.
fn lies_in_layer(near: &[[f64; 3]], tolerance: f64, enough: usize) -> bool {
    let sum = near.iter().fold([0.0; 3], |sum, &d| add_scaled(sum, d, 1.0));
    let (_, tensor) = centred(sum, scatter(near.iter().copied()), (near.len() + 1) as f64);
    let (_, normal) = least_axis(&tensor);
    near.iter().filter(|&&d| dot(normal, d).abs() <= tolerance).nth(enough - 1).is_some()
}

/// Whether one of the planes around point `i` holds it and at least `enough` of the places `near`, relative to it.
fn is_held(
    points: &[[f64; 3]],
    i: usize,
    nearest: &Neighbors,
    planes: &[Plane],
    near: &[[f64; 3]],
    tolerance: f64,
    enough: usize,
) -> bool {
    [i as u32].iter().chain(nearest.of(i).iter().take(FITTED)).map(|&j| j as usize).any(|j| {
        let normal = planes[j].normal.map(f64::from);
        let offset = dot(normal, sub(sub(points[j], points[i]), planes[j].centre.map(|x| -f64::from(x))));
        let in_plane = |d: &&[f64; 3]| (dot(normal, **d) - offset).abs() <= tolerance;
        offset.abs() <= tolerance && near.iter().filter(in_plane).nth(enough - 1).is_some()
    })
}
