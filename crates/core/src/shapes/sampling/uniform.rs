//! Random points on faces: independent by area, or at a distance from each other.

use std::iter;

use crate::math::vec3::distance2;
use crate::shapes::random::Rng;
use crate::shapes::shape::Shape;

/// Number of darts thrown for each point of a blue-noise cloud.
const DARTS: usize = 8;
/// Number of halvings of the range in which the least distance is searched.
const HALVINGS: usize = 6;
/// Number of successive points in trims after which a shape counts as trimmed away altogether.
const MISSES: u32 = 10_000_000;
/// The end of a chain.
const NONE: u32 = u32::MAX;

/// `(N, 3)` independent points, uniform by area, and the face of each. No points if trims leave no area.
pub(super) fn by_area(shape: &Shape, count: usize, rng: &mut Rng) -> (Vec<[f64; 3]>, Vec<u32>) {
    let mut sums = Vec::with_capacity(shape.faces.len());
    let total = shape.faces.iter().fold(0.0, |sum, face| {
        sums.push(sum + face.surface.area());
        sum + face.surface.area()
    });
    let (mut points, mut faces) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut misses = 0;
    while points.len() < count && total > 0.0 && misses < MISSES {
        let pick = rng.uniform() * total;
        let id = sums.partition_point(|&s| s <= pick).min(sums.len() - 1);
        let face = &shape.faces[id];
        let p = face.surface.at(face.surface.uniform(rng));
        misses += 1;
        if face.holds(p) {
            points.push(p);
            faces.push(id as u32);
            misses = 0;
        }
    }
    (points, faces)
}

/// As [`by_area`], but with the greatest least distance at which enough of the darts stay (dart throwing; Cook,
/// "Stochastic sampling in computer graphics", 1986). Distances are straight, also across a thin wall.
pub(super) fn blue_noise(shape: &Shape, count: usize, rng: &mut Rng) -> (Vec<[f64; 3]>, Vec<u32>) {
    let (darts, faces) = by_area(shape, DARTS * count, rng);
    let scale = (shape.area() / count.max(1) as f64).sqrt();
    // At 0.6 of the mean distance far more than enough stay; at 0.9 no throw has kept as many.
    let (mut low, mut high) = (0.6 * scale, 0.9 * scale);
    let mut kept = apart(&darts, low);
    for _ in 0..HALVINGS {
        let radius = 0.5 * (low + high);
        let apart = apart(&darts, radius);
        if apart.len() >= count {
            (low, kept) = (radius, apart);
        } else {
            high = radius;
        }
    }
    kept.truncate(count);
    kept.iter().map(|&i| (darts[i as usize], faces[i as usize])).unzip()
}

/// The darts that lie at least `radius` from all darts kept before them. Cells of that size are hashed into chained buckets;
/// cells that share a bucket cost a few more distances and do not change the result.
fn apart(darts: &[[f64; 3]], radius: f64) -> Vec<u32> {
    let buckets = darts.len().next_power_of_two();
    let mut heads = vec![NONE; buckets];
    let mut next = vec![NONE; darts.len()];
    let bucket = |cell: [i64; 3]| {
        let word = cell
            .iter()
            .fold(0u64, |h, &c| (h ^ c as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29));
        word as usize & (buckets - 1)
    };
    let mut kept = Vec::new();
    for (i, &p) in (0..).zip(darts) {
        let cell = p.map(|x| (x / radius).floor() as i64);
        // Cell 13 of the 27 is the dart's own, in which it is most often too close: it is tried first.
        let order = (13..40).map(|n| n % 27);
        let near = order.map(|n| [cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1]);
        let mut chains = near.map(|c| heads[bucket(c)]);
        let close = |j: &u32| distance2(darts[*j as usize], p) < radius * radius;
        let link = |j: u32| (j != NONE).then_some(j);
        let chain = |head: u32| iter::successors(link(head), |&j| link(next[j as usize]));
        if !chains.any(|head| chain(head).any(|j| close(&j))) {
            let head = &mut heads[bucket(cell)];
            next[i as usize] = std::mem::replace(head, i);
            kept.push(i);
        }
    }
    kept
}
