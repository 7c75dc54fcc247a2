//! Meshes with known features.

use super::*;
use crate::math::vec3::{distance, sub};

/// A box of sides `size` at `corner`, twelve triangles.
fn brick(size: [f64; 3], corner: [f64; 3]) -> (Vec<[f64; 3]>, Faces) {
    let vertex = |i: usize| std::array::from_fn(|a| corner[a] + size[a] * (i >> a & 1) as f64);
    let mut faces = Faces::default();
    for quad in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
        faces.push(&[quad[0], quad[1], quad[2]]);
        faces.push(&[quad[0], quad[2], quad[3]]);
    }
    ((0..8).map(vertex).collect(), faces)
}

/// A height field on a grid of `n` by `n` vertices.
fn field(n: u32, height: impl Fn(f64, f64) -> f64) -> (Vec<[f64; 3]>, Faces) {
    let vertex = |i: u32| {
        let [x, y] = [i % n, i / n].map(f64::from);
        [x, y, height(x, y)]
    };
    let mut faces = Faces::default();
    for i in (0..n * (n - 1)).filter(|i| i % n + 1 < n) {
        faces.push(&[i, i + 1, i + n + 1, i + n]);
    }
    ((0..n * n).map(vertex).collect(), faces)
}

/// The least distance between two points, by a plain search in strips.
fn least_distance(points: &[[f64; 3]]) -> f64 {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut least = f64::INFINITY;
    for (i, &p) in sorted.iter().enumerate() {
        for &q in &sorted[i + 1..] {
            if q[0] - p[0] >= least {
                break;
            }
            least = least.min(distance(p, q));
        }
    }
    least
}

#[test]
fn a_box_is_sampled_evenly_over_its_faces() {
    let (vertices, faces) = brick([3.0, 2.0, 1.0], [10.0, -5.0, 2.0]);
    let sample = sample(&vertices, &faces, MeshPoints::Auto).unwrap();
    assert_eq!(sample.points.len(), 20_000);
    let spacing = (22.0_f64 / 20_000.0).sqrt();
    assert!((sample.spacing - spacing).abs() < 1e-12);
    let on_face = |p: &[f64; 3]| {
        let q = sub(*p, [10.0, -5.0, 2.0]);
        (0..3).any(|a| q[a].abs() < 1e-12 || (q[a] - [3.0, 2.0, 1.0][a]).abs() < 1e-12)
    };
    assert!(sample.points.iter().all(on_face));
    // Independent points would lie a hundredth of that apart.
    assert!(least_distance(&sample.points) > 0.5 * spacing, "{}", least_distance(&sample.points));
    let top = sample.points.iter().filter(|p| p[2] == 3.0).count() as f64;
    assert!((top / 20_000.0 - 6.0 / 22.0).abs() < 0.005, "{top}");
}

#[test]
fn samples_depend_on_the_surface_alone() {
    let (vertices, faces) = brick([3.0, 2.0, 1.0], [0.0; 3]);
    let expected = sample(&vertices, &faces, MeshPoints::Sampled(3000)).unwrap().points;
    // A vertex each for the corners of all faces, the faces backwards and each begun elsewhere, two of them twice, all moved.
    let (mut soup, mut turned) = (Vec::new(), Faces::default());
    let mut all: Vec<&[u32]> = faces.iter().collect();
    all.reverse();
    all.extend_from_within(..2);
    for face in all {
        let first = soup.len() as u32;
        soup.extend([1, 2, 0].map(|i| vertices[face[i] as usize].map(|c| c + 1024.0)));
        turned.push(&[first, first + 1, first + 2]);
    }
    let found = sample(&soup, &turned, MeshPoints::Sampled(3000)).unwrap().points;
    assert_eq!(found.len(), 3000);
    let moved: Vec<[f64; 3]> = expected.iter().map(|p| p.map(|c| c + 1024.0)).collect();
    assert_eq!(found, moved);
}

#[test]
fn both_sides_of_a_thin_wall_are_sampled_as_if_they_stood_apart() {
    let (vertices, faces) = brick([100.0, 100.0, 0.1], [0.0; 3]);
    let points = sample(&vertices, &faces, MeshPoints::Sampled(4000)).unwrap().points;
    for side in [0.0, 0.1] {
        let of: Vec<[f64; 3]> = points.iter().filter(|p| p[2] == side).copied().collect();
        assert!((1900..2100).contains(&of.len()), "{}", of.len());
        assert!(least_distance(&of) > 0.5 * (1e4_f64 / 2000.0).sqrt());
    }
}

#[test]
fn faces_that_lie_on_each_other_do_not_pile_up() {
    let (mut vertices, mut faces) = (Vec::new(), Faces::default());
    for i in 0..2000 {
        let first = vertices.len() as u32;
        vertices.extend([[0.0, 0.0, 0.0], [1.0 + f64::from(i), 0.0, 0.0], [0.0, 1.0, 0.0]]);
        faces.push(&[first, first + 1, first + 2]);
    }
    let points = sample(&vertices, &faces, MeshPoints::Sampled(20_000)).unwrap().points;
    assert!(points.len() <= 20_000 && points.len() > 500, "{}", points.len());
}

#[test]
fn small_features_call_for_more_points() {
    let (vertices, faces) = brick([40.0, 40.0, 4.0], [0.0; 3]);
    let found = sample(&vertices, &faces, MeshPoints::Auto).unwrap();
    // Its sides are 4 wide and 40 long: twice the area over the boundary.
    let width = 2.0 * 160.0 / 88.0;
    assert!((found.feature.unwrap() - width).abs() < 1e-9, "{:?}", found.feature);
    let wanted = 3_840.0 * 100.0 / (width * width);
    assert_eq!(found.points.len(), wanted as usize);
}

#[test]
fn a_mesh_of_few_triangles_gets_few_points_however_small_its_features() {
    let (vertices, faces) = brick([1.0, 1.0, 1e-6], [0.0; 3]);
    let surface = Surface::new(&vertices, &faces).unwrap();
    assert_eq!(Features::of(&surface).samples, 50_000);
}

/// Bricks on a plate, in rows of 50, of the sizes that `side` gives for their numbers.
fn bricks(count: usize, side: impl Fn(usize) -> f64) -> Surface {
    let (mut vertices, mut faces) = brick([1000.0, 1000.0, 100.0], [0.0, 0.0, -100.0]);
    for i in 0..count {
        let corner = [20.0 * (i % 50) as f64, 20.0 * (i / 50) as f64, 0.0];
        let first = vertices.len() as u32;
        let (more, its) = brick([side(i); 3], corner);
        vertices.extend(more);
        its.iter().for_each(|face| faces.push(&face.iter().map(|&v| first + v).collect::<Vec<u32>>()));
    }
    Surface::new(&vertices, &faces).unwrap()
}

#[test]
fn heaps_of_facets_too_small_to_show_get_few_points() {
    let samples = |surface: &Surface| Features::of(surface).samples;
    // Points 5.6 apart show bricks of 18; 3.5 apart they show no crumbs of a tenth, nor most bricks of 18 down to .018.
    assert_eq!(samples(&bricks(2000, |_| 18.0)), 200_000);
    assert_eq!(samples(&bricks(2000, |_| 0.1)), 30_000);
    assert_eq!(samples(&bricks(2000, |i| 18.0 * 0.1_f64.powi(i as i32 % 4))), 30_000);
}

#[test]
fn a_plan_tells_what_sampling_gives() {
    let (vertices, faces) = brick([3.0, 2.0, 1.0], [0.0; 3]);
    for points in [MeshPoints::Auto, MeshPoints::Sampled(777), MeshPoints::Vertices] {
        let sample = sample(&vertices, &faces, points);
        let found =
            sample.map(|s| MeshPlan { points: s.points.len(), spacing: s.spacing, feature: s.feature });
        assert_eq!(plan(&vertices, &faces, points), found);
    }
}

#[test]
fn dense_vertices_stand_for_themselves() {
    let wave = |x: f64, y: f64| (0.1 * x).sin() + (0.1 * y).cos();
    let (vertices, faces) = field(60, wave);
    assert_eq!(sample(&vertices, &faces, MeshPoints::Auto), None);
    assert_eq!(sample(&vertices, &faces, MeshPoints::Vertices), None);
    assert_eq!(sample(&vertices, &faces, MeshPoints::Sampled(777)).unwrap().points.len(), 777);
    // Stretched to needles, the same vertices leave holes.
    let needles: Vec<[f64; 3]> = vertices.iter().map(|p| [20.0 * p[0], p[1], p[2]]).collect();
    let dense = |vertices: &[[f64; 3]]| dense::is_dense(&Surface::new(vertices, &faces).unwrap(), None);
    assert_eq!([dense(&vertices), dense(&needles)], [true, false]);
}

#[test]
fn faces_without_area_or_vertices_give_nothing() {
    let line: Vec<[f64; 3]> = (0..5).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let mut faces = Faces::default();
    faces.push(&[0, 1, 2]);
    faces.push(&[0, 1]);
    assert_eq!(faces.len(), 1);
    assert_eq!(sample(&line, &faces, MeshPoints::Auto), None);
    faces.push(&[0, 1, 5]);
    assert_eq!(sample(&line, &faces, MeshPoints::Auto), None);
    let far = [[0.0; 3], [1.7e308, 0.0, 0.0], [-1.7e308, 1.0, 0.0]];
    let mut one = Faces::default();
    one.push(&[0, 1, 2]);
    assert_eq!(sample(&far, &one, MeshPoints::Auto), None);
    assert_eq!(sample(&[[f64::NAN; 3]; 3], &one, MeshPoints::Auto), None);
}
