//! The floor: the lowest large face across the axis.

use crate::math::vec3;
use crate::section::surface::tile::Tile;

/// Cosine of the angle to the axis, 20 degrees, within which the normal of a tile lies on a face across it.
const ACROSS: f64 = 0.94;
/// Height, in spacings of the cloud, over which tiles are one face.
const HEIGHT: f64 = 4.0;
/// Share of the largest face across the axis that a large one has.
const LARGE: f64 = 0.2;

/// Height of the floor along a unit vector, local frame; `None` where no face lies across it.
pub(crate) fn floor(tiles: &[Tile], axis: [f64; 3], spacing: f64) -> Option<f64> {
    let across = |tile: &&Tile| vec3::dot(tile.plane.normal, axis).abs() >= ACROSS;
    let place = |tile: &Tile| (vec3::dot(tile.plane.centre, axis), tile.plane.spacing.powi(2));
    let mut places: Vec<(f64, f64)> = tiles.iter().filter(across).map(place).filter(|p| p.1 > 0.0).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let areas = faces(&places, HEIGHT * spacing);
    let large = LARGE * areas.iter().map(|(_, area)| *area).fold(0.0, f64::max);
    let first = areas.iter().position(|(_, area)| *area >= large && *area > 0.0)?;
    // The face is whole where the most of it lies within the height.
    let reach = places[first].0 + HEIGHT * spacing;
    let near = (first..places.len()).take_while(|&k| places[k].0 <= reach);
    let start = near.max_by(|&a, &b| areas[a].1.total_cmp(&areas[b].1).then(b.cmp(&a)))?;
    let face = &places[start..areas[start].0];
    let half = 0.5 * areas[start].1;
    let mut sum = 0.0;
    face.iter()
        .find(|(_, area)| {
            sum += area;
            sum >= half
        })
        .map(|(height, _)| *height)
}

/// For each place, as the lowest of a face, where that ends and its area.
fn faces(places: &[(f64, f64)], height: f64) -> Vec<(usize, f64)> {
    let (mut end, mut area) = (0, 0.0);
    let mut found = Vec::with_capacity(places.len());
    for &(low, own) in places {
        while let Some((_, next)) = places.get(end).filter(|next| next.0 <= low + height) {
            (end, area) = (end + 1, area + next);
        }
        found.push((end, area));
        area -= own;
    }
    found
}
