//! A face across the axis: flat, or the crest of a curved one, as of a bore that lies along the slices or a dome. A curved
//! face has its height where it is level, which a parabola through its points tells.

use super::near::{Search, Spot};
use super::{By, End};
use crate::math::least_squares::least_squares;
use crate::math::vec3;

/// Fewest points that show a face.
const FACE: usize = 8;
/// Share of the squared spread that a parabola may leave to be preferred to a level.
const BETTER: f64 = 0.8;
/// What it must explain, in shares of one point of the squared spread.
const CLEARLY: f64 = 12.0;

/// The first face met going away from the slice: a cluster of heights without a gap.
pub(super) fn face(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let gap = (0.25 + noise) * h;
    let centre = search.outline.round.map(|r| r.centre).filter(|_| !search.upright);
    let mut cluster: Vec<Spot> = Vec::new();
    for spot in spots.iter().filter(|s| s.flat()) {
        if cluster.last().is_some_and(|last| (spot.height - last.height).abs() > gap) {
            if let Some(found) = settled(&cluster, centre, h, noise) {
                return Some(found).filter(|e| search.holds(e.height));
            }
            cluster.clear();
        }
        cluster.push(*spot);
    }
    settled(&cluster, centre, h, noise).filter(|e| search.holds(e.height))
}

/// The height of a cluster that is as thin as the noise allows, as a level or as a parabola.
fn settled(cluster: &[Spot], centre: Option<[f64; 2]>, h: f64, noise: f64) -> Option<End> {
    if cluster.len() < FACE {
        return None;
    }
    let heights: Vec<f64> = cluster.iter().map(|s| s.height).collect();
    let level = middle(&heights);
    let n = cluster.len() as f64;
    let models = [centre.and_then(|c| ring(cluster, c)), crest(cluster, h)].into_iter().flatten();
    let (height, spread) = models
        .filter(|m| m.1 * m.1 <= level.1 * level.1 * (1.0 - CLEARLY / n).min(BETTER))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or(level);
    let thin = height.is_finite() && spread <= (0.3 + 3.0 * noise) * h;
    let error = 1.3 * spread / n.sqrt() + 1e-3 * h;
    thin.then_some(End { height, error, by: By::Face })
}

/// The median, and the width of the middle two thirds.
fn middle(values: &[f64]) -> (f64, f64) {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share) as usize];
    (at(0.5), at(0.84) - at(0.16))
}

/// The level height and the spread about a parabola over the distance from a centre.
fn ring(cluster: &[Spot], centre: [f64; 2]) -> Option<(f64, f64)> {
    let origin = cluster[0].height;
    let radius = |s: &Spot| super::super::super::vec2::distance(s.at, centre);
    let radii: Vec<f64> = cluster.iter().map(radius).collect();
    let (least, most) = radii.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &r| (l.min(r), m.max(r)));
    let scale = most.max(f64::MIN_POSITIVE);
    // About an axis that the face reaches the parabola is level there.
    let cap = least < 0.2 * most;
    let row = |(s, r): (&Spot, &f64)| {
        let x = r / scale;
        ([1.0, if cap { 0.0 } else { x }, x * x], s.height - origin)
    };
    let rows = || cluster.iter().zip(&radii).map(row);
    let [a, b, c] = if cap {
        let [a, c] = least_squares(rows().map(|(x, y)| ([x[0], x[2]], y)))?;
        [a, 0.0, c]
    } else {
        least_squares(rows())?
    };
    let level = (-b / (2.0 * c)).clamp(least / scale, 1.0);
    let level = if cap { 0.0 } else { level };
    let rest: Vec<f64> = rows().map(|(x, y)| y - a * x[0] - b * x[1] - c * x[2]).collect();
    Some((origin + a + b * level + c * level * level, middle(&rest).1))
}

/// The level height and the spread about a parabola over both coordinates. Where it is bent one way only, as over a bore,
/// that way alone counts; not a number where it is slanted and nowhere level.
fn crest(cluster: &[Spot], h: f64) -> Option<(f64, f64)> {
    let n = cluster.len() as f64;
    let mean = vec3::scale(
        cluster.iter().fold([0.0; 3], |sum, s| vec3::add(sum, [s.at[0], s.at[1], s.height])),
        1.0 / n,
    );
    let places: Vec<[f64; 3]> =
        cluster.iter().map(|s| vec3::sub([s.at[0], s.at[1], s.height], mean)).collect();
    let reach = places.iter().map(|p| p[0].abs().max(p[1].abs())).fold(f64::MIN_POSITIVE, f64::max);
    let row = |p: &[f64; 3]| {
        let (x, y) = (p[0] / reach, p[1] / reach);
        ([1.0, x, y, x * x, x * y, y * y], p[2])
    };
    let [a, bx, by, xx, xy, yy] = least_squares(places.iter().map(row))?;
    let rest: Vec<f64> = places
        .iter()
        .map(row)
        .map(|(x, z)| z - [a, bx, by, xx, xy, yy].iter().zip(x).map(|(c, x)| c * x).sum::<f64>())
        .collect();
    let spread = middle(&rest).1;
    // Axes of the bend, and along each the way to where it is level.
    let angle = 0.5 * xy.atan2(xx - yy);
    let mut height = a;
    let (sine, cosine) = angle.sin_cos();
    for [u, v] in [[cosine, sine], [-sine, cosine]] {
        let bend = xx * u * u + xy * u * v + yy * v * v;
        let slope = bx * u + by * v;
        let level = -slope / (2.0 * bend);
        // What the bend changes over the cluster must stand out of the rest.
        if bend.abs() * n.sqrt() > 4.0 * spread && level.abs() <= 1.5 {
            height += 0.5 * slope * level;
        } else if slope.abs() > (0.5 * h).max(spread) {
            // Nowhere level.
            return Some((f64::NAN, spread));
        }
    }
    Some((mean[2] + height, spread))
}
