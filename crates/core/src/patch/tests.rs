use super::NO_PATCH;
use crate::params::{Auto, Method};
use crate::patch::Surface;
use crate::shapes::{Sampling, Scan, Shape, bracket, cube, pipe_cross};
use crate::{Cloud, Extraction, Params, check, extract};

fn params() -> Params {
    let mut params = Params { method: Method::Segments, ..Params::default() };
    params.patches.find = Auto::Given(true);
    params
}

pub(super) fn patched(shape: &Shape, count: usize, noise: f64) -> Extraction {
    let part = shape.sample(&Scan::new(Sampling::Area { count }).noise(noise).seed(1));
    let found = extract(&part.cloud, &params()).unwrap();
    check::network(&found.network).unwrap();
    check::patches(&found.network, found.patches.as_ref().unwrap()).unwrap();
    found
}

#[test]
fn a_cube_has_six_plane_patches_each_with_one_loop_of_four_convex_strips() {
    for noise in [0.0, 0.1] {
        let found = patched(&cube(10.0), 15_000, noise);
        let patches = found.patches.as_ref().unwrap();
        assert_eq!(patches.patches.len(), 6, "noise {noise}");
        assert_eq!(patches.separating(), 12);
        assert!(patches.label.iter().all(|&l| l != NO_PATCH));
        for patch in &patches.patches {
            assert_eq!(patch.neighbors.len(), 4);
            assert_eq!(patch.loops.len(), 1);
            assert!(patch.loops[0].closed && patch.loops[0].coedges.len() == 4);
            assert!((patch.area - 100.0).abs() < 2.0, "area {} at noise {noise}", patch.area);
            assert!(!patch.fit.free);
            assert!(matches!(patch.fit.surface, Surface::Plane { .. }), "{:?}", patch.fit);
        }
        for side in &patches.sides {
            assert_eq!(side.convex, Some(true));
            let fold = side.fold_deg.unwrap();
            assert!((fold - 90.0).abs() < 3.0, "fold {fold}");
        }
    }
}

#[test]
fn crossing_pipes_have_ten_patches_and_cylinders_of_their_radii() {
    let found = patched(&pipe_cross(), 26_846, 0.0);
    let patches = found.patches.as_ref().unwrap();
    assert_eq!(patches.patches.len(), 10);
    assert_eq!(patches.separating(), found.network.strips.len());
    let mut radii: Vec<f64> = patches
        .patches
        .iter()
        .filter_map(|p| match p.fit.surface {
            Surface::Cylinder { radius, .. } if !p.fit.free => Some(radius),
            _ => None,
        })
        .collect();
    radii.sort_by(f64::total_cmp);
    for known in [1.0, 0.7, 0.6, 0.4] {
        assert!(radii.iter().any(|r| (r - known).abs() < 0.01), "{known} is not in {radii:?}");
    }
}

#[test]
fn a_bracket_knows_its_bore_and_what_is_convex() {
    let found = patched(&bracket(), 60_000, 0.1);
    let patches = found.patches.as_ref().unwrap();
    let radii: Vec<f64> = patches
        .patches
        .iter()
        .filter_map(|p| match p.fit.surface {
            Surface::Cylinder { radius, .. } if !p.fit.free => Some(radius),
            _ => None,
        })
        .collect();
    assert!(radii.iter().any(|r| (r - 0.9).abs() < 0.01), "{radii:?}");
    for (strip, side) in found.network.strips.iter().zip(&patches.sides) {
        let Some(convex) = side.convex else { continue };
        // Only the inner edge, at y = z = 1.2, and the foot of the boss, at y = 1.2 and z from 2.5 to 4.1, are concave.
        let [_, y, z] = strip.points[strip.points.len() / 2];
        let hollow = (y - 1.2).abs() < 0.1
            && z > 1.1
            && z < 4.2
            && strip.points.iter().all(|p| (p[1] - 1.2).abs() < 0.2)
            && strip.points.iter().all(|p| p[2] < 4.3);
        let along_x = strip.points.iter().all(|p| (p[2] - z).abs() < 0.2);
        if hollow && (along_x || strip.closed) {
            assert!(!convex, "concave at {:?}", [y, z]);
        } else if !hollow {
            assert!(convex, "convex at {:?}", [y, z]);
        }
    }
    assert!(patches.sides.iter().any(|s| s.convex == Some(false)));
}

#[test]
fn patches_are_the_same_for_any_order_of_the_points() {
    let part = bracket().sample(&Scan::new(Sampling::Area { count: 8_000 }).noise(0.1).seed(2));
    let mut turned = part.cloud.positions.clone();
    turned.reverse();
    let found = [part.cloud.positions, turned].map(|p| extract(&Cloud::new(p), &params()).unwrap());
    let [a, b] = found.each_ref().map(|f| f.patches.as_ref().unwrap());
    assert_eq!(a, b);
    let mut labels = found[1].patch_labels();
    labels.reverse();
    assert_eq!(found[0].patch_labels(), labels);
}
