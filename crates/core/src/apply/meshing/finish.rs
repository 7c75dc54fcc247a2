//! The finish of a mesh: one fan at every vertex, small gaps filled, the outside outside, no vertex without a triangle.

use super::fill::fill;
use super::surface_mesh::{SurfaceMesh, edges};
use super::vertices::Vertices;
use crate::math::union_find::UnionFind;
use crate::math::vec3::{add, cross, dot, scale, sub};

/// The mesh of triangles over vertices, in the frame of `to_world`.
pub(super) fn finish(
    vertices: &Vertices,
    mut triangles: Vec<[u32; 3]>,
    across: impl Fn(usize, usize) -> bool,
    to_world: impl Fn([f64; 3]) -> [f64; 3],
) -> SurfaceMesh {
    turn_outwards(&vertices.points, &mut triangles);
    let (corners, of) = fans(&triangles);
    let mut mesh = SurfaceMesh { triangles: corners, ..SurfaceMesh::default() };
    let points: Vec<[f64; 3]> = of.iter().map(|&vertex| vertices.points[vertex as usize]).collect();
    fill(&points, &mut mesh.triangles, |a, b| across(of[a as usize] as usize, of[b as usize] as usize));
    for vertex in of {
        mesh.vertices.push(to_world(vertices.points[vertex as usize]));
        mesh.kinds.push(vertices.kinds[vertex as usize]);
    }
    mesh
}

/// Sets of corners that share a vertex and an edge there: the triangles with a number for each fan, and the vertex of each. Fans
/// that touch in a vertex alone get one each.
fn fans(triangles: &[[u32; 3]]) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut sets = UnionFind::new(3 * triangles.len());
    let mut ends: Vec<([u32; 2], u32, u32)> = Vec::with_capacity(6 * triangles.len());
    for (t, triangle) in triangles.iter().enumerate() {
        for (k, edge) in edges(triangle).into_iter().enumerate() {
            let corner = |k: usize| (3 * t + k % 3) as u32;
            ends.push((edge, triangle[k], corner(k)));
            ends.push((edge, triangle[(k + 1) % 3], corner(k + 1)));
        }
    }
    ends.sort_unstable();
    for pair in ends.windows(2).filter(|w| (w[0].0, w[0].1) == (w[1].0, w[1].1)) {
        sets.union(pair[0].2, pair[1].2);
    }
    let mut roots: Vec<(u32, u32)> = (0..3 * triangles.len() as u32)
        .map(|c| (triangles[c as usize / 3][c as usize % 3], sets.find(c)))
        .collect();
    roots.sort_unstable();
    roots.dedup();
    let number = |vertex: u32, root: u32| roots.partition_point(|&r| r < (vertex, root)) as u32;
    let corners = (0..triangles.len())
        .map(|t| [0, 1, 2].map(|k| number(triangles[t][k], sets.find((3 * t + k) as u32))))
        .collect();
    (corners, roots.into_iter().map(|r| r.0).collect())
}

/// Turns every connected part so that it encloses a positive volume, seen from its middle.
fn turn_outwards(points: &[[f64; 3]], triangles: &mut [[u32; 3]]) {
    let mut parts = UnionFind::new(points.len());
    for &[a, b, c] in triangles.iter() {
        parts.union(a, b);
        parts.union(b, c);
    }
    let root: Vec<usize> = triangles.iter().map(|t| parts.find(t[0]) as usize).collect();
    let corners = |t: &[u32; 3]| t.map(|i| points[i as usize]);
    let mut middle = vec![([0.0; 3], 0.0); points.len()];
    for (t, &part) in triangles.iter().zip(&root) {
        let (sum, count) = &mut middle[part];
        *sum = corners(t).into_iter().fold(*sum, add);
        *count += 3.0;
    }
    let mut volume = vec![0.0; points.len()];
    for (t, &part) in triangles.iter().zip(&root) {
        let (sum, count) = middle[part];
        let [a, b, c] = corners(t).map(|p| sub(p, scale(sum, 1.0 / count)));
        volume[part] += dot(a, cross(b, c));
    }
    for (t, part) in triangles.iter_mut().zip(root) {
        if volume[part] < 0.0 {
            t.swap(1, 2);
        }
    }
}
