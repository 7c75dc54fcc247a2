//! Shapes with known networks, and what is found on scans of them.

use crate::common::{found, scored};
use lineament::curve::pieces::Shape as Curve;
use lineament::shapes::{Sampled, Sampling, Scan, Shape, cube_386, random_cube};
use lineament::shapes::{
    bent_sheet, cuboid, cylinders, sheet, sheet_with_hole, sphere, stepped_shaft, tapered_block,
};
use lineament::shapes::{torus, tube, wedge};
use lineament::{Class, NodeKind, Strip, StripKind, evaluate};

fn blue_noise(shape: &Shape, count: usize, noise: f64) -> Sampled {
    shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(1))
}

#[test]
fn cube_386_has_12_strips_8_junctions_and_92_points_on_edges() {
    let scan = cube_386();
    let result = found(&scan.cloud);
    let network = &result.network;
    assert_eq!((network.strips.len(), network.count(NodeKind::Junction)), (12, 8));
    assert_eq!(network.nodes.len(), 8);
    assert!(evaluate::isomorphic(network, &scan.truth));
    assert_eq!(evaluate::against(network, &scan.truth, scan.spacing).at_1h.f1, 1.0);
    let on_edge = |p: &[f64; 3]| p.iter().filter(|x| x.abs() == 0.5).count() >= 2;
    let classified: Vec<bool> = result.classes().iter().map(|&c| c != Class::Smooth).collect();
    let expected: Vec<bool> = scan.cloud.positions.iter().map(on_edge).collect();
    assert_eq!(expected.iter().filter(|&&e| e).count(), 92);
    assert_eq!(classified, expected);
}

#[test]
fn random_cube_is_a_cube_for_9_seeds_of_10() {
    let good = (1..=10).filter(|&seed| {
        let scan = random_cube(seed, 10_000);
        let network = found(&scan.cloud).network;
        let cube = network.strips.len() == 12 && network.count(NodeKind::Junction) == 8;
        cube && evaluate::isomorphic(&network, &scan.truth)
    });
    let good: Vec<u64> = good.collect();
    assert!(good.len() >= 9, "only seeds {good:?}");
}

#[test]
fn box_with_unlike_edges_is_a_box() {
    is_its_truth(&blue_noise(&cuboid([3.0, 2.0, 1.0]), 6000, 0.0), 0.95);
}

#[test]
fn wedge_of_90_degrees_is_its_truth() {
    is_its_truth(&blue_noise(&wedge(90.0), 6000, 0.0), 0.95);
}

#[test]
fn tapered_block_is_its_truth_for_4_seeds_of_5() {
    let good = (1..=5).filter(|&seed| {
        let scan = tapered_block().sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).seed(seed));
        let network = found(&scan.cloud).network;
        let score = evaluate::against(&network, &scan.truth, scan.spacing);
        assert!(score.at_1h.f1 >= 0.95, "seed {seed}: {score:?}");
        evaluate::isomorphic(&network, &scan.truth)
    });
    let good: Vec<u64> = good.collect();
    assert!(good.len() >= 4, "only seeds {good:?}");
}

#[test]
fn cylinders_of_unlike_radii_meet_in_loops() {
    let scan = blue_noise(&cylinders(1.0, 0.6), 8000, 0.0);
    is_its_truth(&scan, 0.9);
    assert_eq!(scan.truth.loops(), 6);
}

#[test]
fn stepped_shaft_shows_all_13_circles() {
    let scan = blue_noise(&stepped_shaft(), 12_000, 0.0);
    let score = scored(&scan);
    assert!(score.at_1h.f1 >= 0.95, "{score:?}");
    assert_eq!(score.curves_found, [13, 13]);
}

#[track_caller]
fn is_its_truth(scan: &Sampled, least_f1: f64) {
    let network = found(&scan.cloud).network;
    let score = evaluate::against(&network, &scan.truth, scan.spacing);
    let shape = (network.strips.len(), network.loops(), network.nodes.len());
    assert!(score.at_1h.f1 >= least_f1, "{shape:?}: {score:?}");
    assert!(evaluate::isomorphic(&network, &scan.truth), "{shape:?} is not the truth's graph: {score:?}");
}

#[test]
fn smooth_solids_have_no_lines() {
    for shape in [sphere(1.0), torus(1.0, 0.4)] {
        let network = found(&blue_noise(&shape, 6000, 0.0).cloud).network;
        assert!(network.strips.is_empty() && network.nodes.is_empty(), "{}: {network:?}", shape.name);
    }
}

#[test]
fn noise_of_a_quarter_spacing_draws_no_line_on_smooth_solids() {
    for (shape, count) in [(sphere(1.0), 6000), (torus(1.0, 0.4), 20_000)] {
        let scan = blue_noise(&shape, count, 0.25);
        let network = found(&scan.cloud).network;
        let lengths: Vec<f64> = network.strips.iter().map(|s| s.length() / scan.spacing).collect();
        assert!(network.strips.is_empty(), "{}: {lengths:?} spacings", shape.name);
    }
}

#[test]
fn open_sheet_has_its_border_and_no_crease() {
    for noise in [0.0, 0.25] {
        let scan = blue_noise(&sheet(), 4000, noise);
        let network = found(&scan.cloud).network;
        assert!(network.strips.iter().all(|s| s.kind == StripKind::Border), "noise {noise}");
        let score = evaluate::against(&network, &scan.truth, scan.spacing);
        assert!(score.at_2h.recall >= 0.95 && score.at_2h.precision >= 0.95, "noise {noise}: {score:?}");
    }
}

#[test]
fn border_of_a_sheet_is_one_ring() {
    let scan = blue_noise(&sheet(), 4000, 0.0);
    assert!(evaluate::isomorphic(&found(&scan.cloud).network, &scan.truth));
}

#[test]
fn corners_of_a_sheet_are_nodes_with_and_without_noise() {
    for noise in [0.0, 0.25] {
        let scan = blue_noise(&sheet(), 4000, noise);
        let network = found(&scan.cloud).network;
        let near = |p: &[f64; 3]| {
            let d = |q: &[f64; 3]| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
            network.nodes.iter().any(|node| d(&node.position) <= 2.0 * scan.spacing)
        };
        let hit = scan.truth.nodes.iter().filter(|node| near(&node.position)).count();
        assert_eq!((hit, network.nodes.len()), (4, 4), "noise {noise}");
    }
}

#[test]
fn crease_of_a_bent_sheet_ends_on_its_border() {
    for noise in [0.0, 0.25] {
        let scan = blue_noise(&bent_sheet(70.0), 6000, noise);
        let network = found(&scan.cloud).network;
        let creases: Vec<&Strip> = network.strips.iter().filter(|s| s.kind == StripKind::Crease).collect();
        assert_eq!(creases.len(), 1, "noise {noise}");
        assert_eq!(network.count(NodeKind::End), 0, "noise {noise}");
        assert_eq!(network.count(NodeKind::Junction), 2, "noise {noise}");
        let score = evaluate::against(&network, &scan.truth, scan.spacing);
        assert!(score.at_2h.f1 >= 0.95, "noise {noise}: {score:?}");
    }
}

#[test]
fn sheet_with_a_hole_has_two_border_rings() {
    let scan = blue_noise(&sheet_with_hole(), 4000, 0.0);
    is_its_truth(&scan, 0.9);
}

#[test]
fn tube_has_two_border_loops() {
    for noise in [0.0, 0.25] {
        let scan = blue_noise(&tube(), 5000, noise);
        let network = found(&scan.cloud).network;
        let what: Vec<(StripKind, bool)> =
            network.strips.iter().map(|s: &Strip| (s.kind, s.closed)).collect();
        assert_eq!(what, [(StripKind::Border, true); 2], "noise {noise}");
        let score = evaluate::against(&network, &scan.truth, scan.spacing);
        assert!(score.at_2h.f1 >= 0.95, "noise {noise}: {score:?}");
    }
}

#[test]
fn wedge_with_noise_keeps_its_ridge() {
    let scan = blue_noise(&wedge(90.0), 8000, 0.25);
    let score = scored(&scan);
    assert!(score.at_2h.recall >= 0.8, "{score:?}");
}

/// Radii of the steps of the shaft.
const STEPS: [f64; 5] = [0.6, 0.7, 0.8, 1.0, 1.4];

/// The rims of a shaft are circles with the radii of its steps. Circles through the vertices alone are too large by .02 to .04
/// spacings, all of them.
#[test]
fn rims_have_the_radii_of_their_faces() {
    let scan = blue_noise(&stepped_shaft(), 12_000, 0.0);
    let network = found(&scan.cloud).network;
    let circles = network.strips.iter().flat_map(|strip| &strip.curves).filter_map(|c| match c.shape {
        Curve::Circle(round) => Some(round.radius),
        _ => None,
    });
    let mut errors: Vec<f64> = circles
        .map(|radius| STEPS.iter().map(|step| (step - radius).abs()).fold(f64::INFINITY, f64::min))
        .map(|error| error / scan.spacing)
        .collect();
    assert_eq!(errors.len(), network.strips.len());
    errors.sort_by(f64::total_cmp);
    assert!(errors[errors.len() / 2] < 1e-3 && errors[errors.len() - 1] < 0.05, "{errors:?}");
}
