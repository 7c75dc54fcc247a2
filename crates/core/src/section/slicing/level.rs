//! The floor: the lowest large face across the axis.

use crate::math::vec3;
use crate::section::surface::tile::Tile;

/// Cosine of the angle to the axis, 20 degrees, within which the normal of a tile lies on a face across it.
const ACROSS: f64 = 0.94;
/// Height, in spacings of the cloud, over which tiles are one face.
const HEIGHT: f64 = 4.0;
/// Share of the largest face across the axis that a large one has.
const LARGE: f64 = 0.2;
/// Least share of the whole surface that a floor has: a sill or a ridge has less.
const LEAST: f64 = 0.05;
/// Greatest share of the whole surface below a floor: below a roof are the walls.
const BELOW: f64 = 0.33;

/// Height of the floor along a unit vector, local frame; `None` where no face across it is large enough, or
/// much of the surface lies below it.
pub(crate) fn floor(tiles: &[Tile], axis: [f64; 3], spacing: f64) -> Option<f64> {
    let across = |tile: &&Tile| vec3::dot(tile.plane.normal, axis).abs() >= ACROSS;
    let place = |tile: &Tile| (vec3::dot(tile.plane.centre, axis), tile.plane.spacing.powi(2));
    let whole: f64 = tiles.iter().map(|tile| place(tile).1).sum();
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
    let lower = |tile: &&Tile| place(tile).0 < places[start].0 - HEIGHT * spacing;
    let below: f64 = tiles.iter().filter(lower).map(|tile| place(tile).1).sum();
    if areas[start].1 < LEAST * whole || below > BELOW * whole {
        return None;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::surface::plane::TangentPlane;

    /// Tiles of one spacing: so many level ones at a height, and upright ones at each height from 0 to 9.
    fn tiles(level: &[(f64, usize)], upright: usize) -> Vec<Tile> {
        let tile = |height: f64, normal: [f64; 3]| {
            let plane = TangentPlane { centre: [0.0, 0.0, height], normal, residual: 0.0, spacing: 0.1 };
            Tile { plane, ..Tile::EMPTY }
        };
        let lie = level.iter().flat_map(|&(height, n)| (0..n).map(move |_| tile(height, [0.0, 0.0, 1.0])));
        let stand = (0..10 * upright).map(|k| tile((k % 10) as f64, [1.0, 0.0, 0.0]));
        lie.chain(stand).collect()
    }

    #[test]
    fn the_floor_is_the_lowest_large_level_face() {
        let find = |level: &[(f64, usize)]| floor(&tiles(level, 10), [0.0, 0.0, 1.0], 0.1);
        assert_eq!(find(&[(0.0, 40), (3.0, 8), (9.0, 40)]), Some(0.0));
        assert_eq!(find(&[(1.0, 40), (9.0, 60)]), Some(1.0), "walls of a cellar below");
    }

    #[test]
    fn sills_ridges_and_roofs_are_no_floors() {
        let find = |level: &[(f64, usize)]| floor(&tiles(level, 10), [0.0, 0.0, 1.0], 0.1);
        assert_eq!(find(&[(1.0, 3)]), None, "a sill");
        assert_eq!(find(&[(9.0, 60)]), None, "a flat roof");
        assert_eq!(find(&[]), None);
    }
}
