//! Surfaces of known shape through the filter.

use super::long::edges_of;
use super::*;
use crate::shapes::{Sampling, Scan, Shape, cube, sheet_with_hole, sphere};
use std::collections::BTreeMap;

fn points(shape: &Shape, count: usize) -> Vec<[f64; 3]> {
    shape.sample(&Scan::new(Sampling::BlueNoise { count }).seed(6)).cloud.positions
}

/// How many triangles each edge has.
fn uses(triangles: &[Triangle]) -> BTreeMap<[u32; 2], usize> {
    let mut uses = BTreeMap::new();
    triangles.iter().flat_map(edges_of).for_each(|edge| *uses.entry(edge).or_insert(0) += 1);
    uses
}

#[test]
fn a_sphere_and_a_cube_of_a_grid_are_closed_surfaces() {
    for points in [points(&sphere(3.0), 900), crate::shapes::cube_386().cloud.positions] {
        let filtered = filter(&points).unwrap();
        assert_eq!(filtered.triangles.len(), 2 * points.len() - 4);
        assert!(uses(&filtered.triangles).values().all(|&count| count == 2));
        assert!(filtered.gabriel >= filtered.triangles.len() && filtered.tetrahedra > 0);
    }
}

#[test]
fn the_filter_of_long_edges_opens_a_hole_again_and_parts_two_sheets() {
    let mut sheets = points(&sheet_with_hole(), 1500);
    let count = sheets.len() as u32;
    sheets.extend_from_within(..);
    sheets[count as usize..].iter_mut().for_each(|p| p[2] += 2.0);
    let filtered = filter(&sheets).unwrap();
    let joins = |t: &&Triangle| t[0] < count && t[2] >= count;
    assert!(filtered.umbrella.iter().filter(joins).count() > 0);
    assert_eq!(filtered.triangles.iter().filter(joins).count(), 0);
    let graph = graph(&sheets).unwrap();
    assert!((0..sheets.len()).all(|i| graph.of(i).iter().all(|&j| (j < count) == ((i as u32) < count))));
}

#[test]
fn a_cube_of_scattered_points_has_an_umbrella_at_every_point() {
    let points = points(&cube(10.0), 1200);
    let filtered = filter(&points).unwrap();
    let mut at = vec![0; points.len()];
    filtered.triangles.iter().flatten().for_each(|&corner| at[corner as usize] += 1);
    assert!(at.iter().all(|&count| count >= 3));
    let even = uses(&filtered.triangles).values().filter(|&&count| count == 2).count();
    assert!(even * 100 >= uses(&filtered.triangles).len() * 95, "{even}");
}

#[test]
fn points_without_a_tetrahedron_are_refused() {
    assert!(matches!(filter(&[[0.0; 3]; 3]), Err(Error::TooFewPoints { .. })));
}
