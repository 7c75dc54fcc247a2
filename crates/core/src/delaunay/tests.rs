//! Surfaces of known shape through the filter.

use super::triangle::edges_of;
use super::*;
use crate::error::Error;
use crate::shapes::{Sampling, Scan, Shape, sheet_with_hole, sphere};
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
fn a_sphere_is_a_closed_surface() {
    let points = points(&sphere(3.0), 900);
    let filtered = filter(&points).unwrap();
    assert_eq!(filtered.triangles.len(), 2 * points.len() - 4);
    assert!(uses(&filtered.triangles).values().all(|&count| count == 2));
    assert!(filtered.gabriel >= filtered.triangles.len() && filtered.tetrahedra > 0);
}

#[test]
fn the_filter_of_long_edges_opens_a_hole_again_and_parts_two_sheets() {
    let mut sheets = points(&sheet_with_hole(), 1500);
    let count = sheets.len() as u32;
    sheets.extend_from_within(..);
    sheets[count as usize..].iter_mut().for_each(|p| p[2] += 2.0);
    let filtered = filter(&sheets).unwrap();
    let joins = |t: &&Triangle| t[0] < count && t[2] >= count;
    let [before, after] = [&filtered.umbrella, &filtered.triangles].map(|t| t.iter().filter(joins).count());
    assert!(before > 40 && 20 * after <= before, "{after} of {before} triangles join the sheets");
    let graph = graph(&sheets).unwrap();
    assert!(
        (0..sheets.len()).all(|i| graph.of(i).iter().all(|&j| graph.of(j as usize).contains(&(i as u32))))
    );
}

#[test]
fn the_filter_cuts_the_edges_of_a_cube_as_in_figure_3_b() {
    let cube = crate::shapes::cube_386().cloud.positions;
    let triangles = filter(&cube).unwrap().triangles;
    let mut at = vec![0; cube.len()];
    triangles.iter().flatten().for_each(|&corner| at[corner as usize] += 1);
    // Every point has a fan, but some edges have three triangles.
    assert!(at.iter().all(|&count| count >= 3));
    assert!(uses(&triangles).values().filter(|&&count| count > 2).count() > 10);
}

#[test]
fn points_without_a_tetrahedron_are_refused() {
    assert!(matches!(filter(&[[0.0; 3]; 3]), Err(Error::TooFewPoints { .. })));
}
