//! Solids of the project's own shapes as boundary representations.

use super::*;
use crate::math::vec3::distance;
use crate::patch::tests::patched;
use crate::shapes::{Sampling, Scan, bracket, cube, pipe_cross, stepped_shaft};

fn of(shape: &crate::shapes::Shape, count: usize, noise: f64) -> Brep {
    let found = patched(shape, count, noise);
    let brep = brep(&found.network, found.patches.as_ref().unwrap());
    check(&brep);
    brep
}

/// Loops go from vertex to vertex, and no edge ends off its vertices.
fn check(brep: &Brep) {
    let ends = |&(e, forward): &(u32, bool)| {
        let [a, b] = brep.edges[e as usize].ends;
        if forward { [a, b] } else { [b, a] }
    };
    for row in brep.faces.iter().flat_map(|f| &f.loops) {
        for (a, b) in row.iter().zip(row.iter().cycle().skip(1)) {
            assert_eq!(ends(a)[1], ends(b)[0], "{row:?}");
        }
    }
}

/// Vertices less edges plus faces: 2 for a ball, less 2 for every hole through it; a loop beyond the first of a face counts as an edge.
fn euler(brep: &Brep) -> i64 {
    let inner: usize = brep.faces.iter().map(|f| f.loops.len().saturating_sub(1)).sum();
    brep.vertices.len() as i64 - (brep.edges.len() + inner) as i64 + brep.faces.len() as i64
}

#[test]
fn a_cube_is_a_closed_shell_whose_edges_lie_on_its_planes() {
    for noise in [0.0, 0.1] {
        let brep = of(&cube(10.0), 15_000, noise);
        assert_eq!((brep.vertices.len(), brep.edges.len(), brep.faces.len()), (8, 12, 6));
        assert!(brep.shells.len() == 1 && brep.shells[0].closed && brep.omitted.is_empty());
        assert!(brep.edges.iter().all(|e| e.shape == Shape::Line) && brep.gap < 1e-9, "{}", brep.gap);
        for edge in &brep.edges {
            let [a, b] = edge.ends.map(|v| brep.vertices[v as usize]);
            assert!((distance(a, b) - 10.0).abs() < 0.05, "{}", distance(a, b));
        }
    }
}

#[test]
fn a_small_part_on_a_map_keeps_its_edges() {
    let part = cube(0.1).sample(&Scan::new(Sampling::Area { count: 15_000 }).seed(1));
    let moved = part.cloud.positions.iter().map(|p| [p[0] + 665_186.25, p[1] + 5_648_349.5, p[2] + 241.5]);
    let mut params = crate::Params { method: crate::Method::Segments, ..Default::default() };
    params.patches.find = crate::params::Auto::Given(true);
    let found = crate::extract(&crate::Cloud::new(moved.collect()), &params).unwrap();
    let brep = brep(&found.network, found.patches.as_ref().unwrap());
    assert!(brep.omitted.is_empty() && brep.shells[0].closed, "{:?}", brep.omitted);
    assert_eq!((brep.vertices.len(), brep.edges.len()), (8, 12));
    assert!(brep.gap < 1e-8, "{}", brep.gap);
}

#[test]
fn a_bracket_with_bore_and_boss_is_a_closed_shell() {
    let brep = of(&bracket(), 60_000, 0.05);
    assert!(brep.omitted.is_empty(), "{:?}", brep.omitted);
    assert!(brep.shells.len() == 1 && brep.shells[0].closed);
    // One bore goes through.
    assert_eq!((brep.faces.len(), euler(&brep)), (11, 0));
    let circles = brep.edges.iter().filter(|e| matches!(e.shape, Shape::Circle(_))).count();
    assert_eq!(circles, 4);
    assert!(brep.gap < 5e-3, "{}", brep.gap);
}

#[test]
fn the_sides_of_a_shaft_are_cut_open_along_one_row_of_seams() {
    let brep = of(&stepped_shaft(), 60_000, 0.0);
    assert!(brep.omitted.is_empty() && brep.shells.len() == 1 && brep.shells[0].closed);
    assert_eq!(euler(&brep), 2);
    for face in brep.faces.iter().filter(|f| !matches!(f.surface, Surface::Plane { .. })) {
        let [row] = &face.loops[..] else { panic!("{face:?}") };
        // Circle, seam, circle, seam.
        assert!(row.len() == 4 && row[1].0 == row[3].0 && row[1].1 != row[3].1, "{row:?}");
    }
    assert!(brep.gap < 1e-9, "{}", brep.gap);
}

#[test]
fn pipes_meet_in_splines_on_both_of_their_surfaces() {
    let brep = of(&pipe_cross(), 26_846, 0.0);
    assert!(brep.omitted.is_empty(), "{:?}", brep.omitted);
    assert!(brep.edges.iter().any(|e| matches!(e.shape, Shape::Spline(_))));
    assert!(brep.gap < 1e-4, "{}", brep.gap);
}

#[test]
fn a_side_of_a_shaft_with_one_of_its_two_loops_is_left_out() {
    let found = patched(&stepped_shaft(), 60_000, 0.0);
    let mut patches = found.patches.clone().unwrap();
    let side = |p: &crate::Patch| matches!(p.fit.surface, Surface::Cylinder { .. }) && p.loops.len() == 2;
    let open = patches.patches.iter().position(side).unwrap();
    patches.patches[open].loops.pop();
    let brep = brep(&found.network, &patches);
    assert_eq!(brep.omitted, [(open as u32, Omission::Tangled)]);
    assert_eq!(brep.faces.len() + 1, patches.patches.len());
    assert!(brep.shells.iter().all(|s| !s.closed));
}

#[test]
fn a_patch_with_a_gap_in_its_lines_is_left_out_and_the_shell_stays_open() {
    let part = cube(10.0).sample(&Scan::new(Sampling::Area { count: 15_000 }).seed(1));
    let mut params = crate::Params { method: crate::Method::Segments, ..Default::default() };
    params.patches.find = crate::params::Auto::Given(true);
    let found = crate::extract(&part.cloud, &params).unwrap();
    let mut patches = found.patches.clone().unwrap();
    patches.patches[2].loops[0].coedges.pop();
    patches.patches[2].loops[0].closed = false;
    patches.patches[4].fit.free = true;
    let brep = brep(&found.network, &patches);
    assert_eq!(brep.omitted, [(2, Omission::Open), (4, Omission::FreeForm)]);
    assert!(brep.faces.len() == 4 && brep.shells.iter().all(|s| !s.closed));
    assert!(brep.gap < 1e-9);
}
