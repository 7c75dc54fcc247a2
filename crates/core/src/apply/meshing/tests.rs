//! Meshes of shapes with known edges.

use super::*;
use crate::extract::extract;
use crate::math::vec3::distance;
use crate::measure::Class;
use crate::params::Params;
use crate::shapes::{Sampling, Scan, Shape, bracket, sheet_with_hole};
use std::collections::BTreeSet;

/// The mesh of a scan of a shape, and the spacing.
fn mesh(shape: &Shape, count: usize, options: &MeshOptions) -> (SurfaceMesh, f64) {
    let cloud = shape.sample(&Scan::new(Sampling::BlueNoise { count }).seed(5)).cloud;
    let params = Params::default();
    let found = extract(&cloud, &params).unwrap();
    (mesh_surface(&cloud, &found, &params, options).unwrap(), found.report.spacing)
}

#[test]
fn the_creases_of_a_bracket_are_edges_of_a_closed_mesh() {
    let shape = bracket();
    let (mesh, spacing) = mesh(&shape, 6000, &MeshOptions::default());
    assert_eq!(mesh.open_edges(), 0);
    let edges: BTreeSet<[u32; 2]> = mesh.triangles.iter().flat_map(surface_mesh::edges).collect();
    // Euler's formula for a solid with one bore.
    assert_eq!(mesh.vertices.len() + mesh.triangles.len(), edges.len());
    let near = |v: u32| mesh.kinds[v as usize] != Class::Smooth;
    let along: Vec<&[u32; 2]> = edges.iter().filter(|e| near(e[0]) && near(e[1])).collect();
    let truth = shape.network.index(0.25 * spacing);
    let longest = along.iter().map(|e| distance(mesh.vertices[e[0] as usize], mesh.vertices[e[1] as usize]));
    assert!(longest.fold(0.0, f64::max) < 2.0 * spacing);
    for v in (0..mesh.vertices.len()).filter(|&v| near(v as u32)) {
        assert!(truth.distance(mesh.vertices[v]) < 0.6 * spacing, "{:?}", mesh.vertices[v]);
        let at = along.iter().filter(|e| e.contains(&(v as u32))).count();
        assert!(at >= 2, "a point on a line has {at} edges along it");
    }
}

/// Length of a polyline.
fn length(points: &[[f64; 3]]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

#[test]
fn a_sheet_keeps_its_hole_and_its_border() {
    let (mesh, spacing) = mesh(&sheet_with_hole(), 2000, &MeshOptions::default());
    // The border of the sheet and the rim of its hole, of radius 0.7.
    let around = mesh.open_edges() as f64 * 0.7 * spacing;
    let length: f64 = sheet_with_hole().network.curves.iter().map(|c| length(&c.points)).sum();
    assert!((0.85..1.25).contains(&(around / length)), "{around} of {length}");
}

#[test]
fn the_outside_is_outside() {
    let (mesh, _) = mesh(&crate::shapes::cube(10.0), 2500, &MeshOptions::default());
    let volume = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let volume = mesh.triangles.iter().map(volume).sum::<f64>() / 6.0;
    assert!((990.0..1010.0).contains(&volume), "{volume}");
}
