//! Planes of symmetry: across each of the first classes of directions the middle of the network, if nearly every curve has its image.

use super::feature::Feature;
use super::parallel::Class;
use crate::math::vec3::{add_scaled, cross, distance, dot};
use std::collections::BTreeMap;

/// Classes that are tried.
const TRIED: usize = 6;
/// Least share of the length that has its image.
const SHARE: f64 = 0.9;
/// Fewest curves.
const FEWEST: usize = 6;
/// Greatest distance between a curve's middle and its image, in spacings.
const NEAR: f64 = 1.5;
/// Greatest sine between a line and its image.
const TURNED: f64 = 0.05;

/// A mirror.
#[derive(Clone, Debug)]
pub(super) struct Mirror {
    /// The class of its normal.
    pub class: usize,
    /// A point of it.
    pub point: [f64; 3],
    /// Features with their images, each pair once; a feature that is its own image is left out.
    pub pairs: Vec<[usize; 2]>,
    /// Share of the length that has its image.
    pub share: f64,
    /// Root mean square distance of the middles from the images.
    pub deviation: f64,
}

/// A curve with the middle between its ends and its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drawn {
    /// The middle; the centre of an arc or circle.
    pub middle: [f64; 3],
    /// Ends, or the ends of a circle's diameter.
    pub ends: [[f64; 3]; 2],
    /// Its length.
    pub length: f64,
}

/// The mirrors of features as drawn, where points are `spacing` apart.
pub(super) fn mirrors(features: &[Feature], drawn: &[Drawn], classes: &[Class], spacing: f64) -> Vec<Mirror> {
    if features.len() < FEWEST {
        return Vec::new();
    }
    let near = NEAR * spacing;
    let mut grid: BTreeMap<[i64; 3], Vec<usize>> = BTreeMap::new();
    let cell = |p: [f64; 3]| p.map(|x| (x / near).floor() as i64);
    drawn.iter().enumerate().for_each(|(i, d)| grid.entry(cell(d.middle)).or_default().push(i));
    let tried = classes.iter().enumerate().take(TRIED);
    tried.filter_map(|(k, class)| one(features, drawn, k, class, near, &grid)).collect()
}

fn one(
    features: &[Feature],
    drawn: &[Drawn],
    class: usize,
    Class { direction, .. }: &Class,
    near: f64,
    grid: &BTreeMap<[i64; 3], Vec<usize>>,
) -> Option<Mirror> {
    let heights = || drawn.iter().flat_map(|d| d.ends).map(|p| dot(p, *direction));
    let least = heights().fold(f64::INFINITY, f64::min);
    let most = heights().fold(f64::NEG_INFINITY, f64::max);
    let middle = 0.5 * (least + most);
    let image = |p: [f64; 3]| add_scaled(p, *direction, 2.0 * (middle - dot(p, *direction)));
    let (mut pairs, mut squares, mut found, mut length) = (Vec::new(), 0.0, 0.0, 0.0);
    for (i, d) in drawn.iter().enumerate() {
        length += d.length;
        let at = image(d.middle);
        let [x, y, z] = at.map(|x| (x / near).floor() as i64);
        let cells = (0..27).map(|k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
        let candidates = cells.filter_map(|c| grid.get(&c)).flatten().copied();
        let far = |j: &usize| distance(drawn[*j].middle, at);
        let alike = candidates.filter(|&j| alike(&features[i], &features[j], *direction, near));
        let Some(j) =
            alike.min_by(|a, b| far(a).total_cmp(&far(b)).then(a.cmp(b))).filter(|j| far(j) <= near)
        else {
            continue;
        };
        found += d.length;
        squares += far(&j).powi(2);
        if i < j {
            pairs.push([i, j]);
        }
    }
    let share = found / length;
    let matched = features.len().max(1) as f64;
    let point = add_scaled([0.0; 3], *direction, middle);
    let deviation = (squares / matched).sqrt();
    (share >= SHARE && !pairs.is_empty()).then_some(Mirror { class, point, pairs, share, deviation })
}

/// Whether a curve may be the image of another.
fn alike(a: &Feature, b: &Feature, normal: [f64; 3], near: f64) -> bool {
    let turned = add_scaled(a.direction, normal, -2.0 * dot(a.direction, normal));
    let sine = cross(turned, b.direction);
    let sizes = match (a.round(), b.round()) {
        (None, None) => true,
        (Some(a), Some(b)) => (a.radius - b.radius).abs() <= near,
        _ => false,
    };
    sizes && dot(sine, sine) <= TURNED * TURNED
}
