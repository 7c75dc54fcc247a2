//! Creases and corners recovered from their faces (Gumhold 2001, sections 4.1 and 4.2) by the method `penalty`, against exact truths.
//! `cargo bench -p lineament --bench recovery` has the many seeds.

use crate::common::checked;
use lineament::params::{Method, WedgeForm};
use lineament::shapes::{Sampled, Sampling, Scan, Shape, bracket, cuboid, wedge};
use lineament::{Network, NodeKind, Params, StripKind};

fn scan(shape: &Shape, count: usize, noise: f64) -> Sampled {
    shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(1))
}

fn network(scan: &Sampled, form: WedgeForm) -> Network {
    let mut params = Params { method: Method::Penalty, ..Params::default() };
    params.recover.wedge = form;
    checked(&scan.cloud, &params).unwrap().network
}

/// Mean distance of the points of creases from the truth, spacings.
fn away(network: &Network, scan: &Sampled) -> f64 {
    let truth = scan.truth.index(0.01 * scan.spacing);
    let creases = network.strips.iter().filter(|s| s.kind == StripKind::Crease);
    let all: Vec<f64> = creases.flat_map(|s| &s.points).map(|&p| truth.distance(p) / scan.spacing).collect();
    all.iter().sum::<f64>() / all.len() as f64
}

#[test]
fn creases_of_a_noisy_box_lie_several_times_nearer_the_truth_than_the_spline() {
    for (noise, least) in [(0.1, 0.03), (0.5, 0.16)] {
        let scan = scan(&cuboid([3.0, 2.0, 1.0]), 6000, noise);
        let [before, printed, ours] =
            [WedgeForm::None, WedgeForm::Paper, WedgeForm::Quadric].map(|f| away(&network(&scan, f), &scan));
        assert!(
            printed < before && ours < least && ours < 0.5 * before,
            "{noise}: {before}, {printed}, {ours}"
        );
    }
}

#[test]
fn folds_are_measured_to_2_degrees() {
    for fold in [40.0, 90.0, 120.0] {
        let scan = scan(&wedge(fold), 6000, 0.1);
        let network = network(&scan, WedgeForm::Quadric);
        let ridge = network.strips.iter().max_by(|a, b| height(a).total_cmp(&height(b))).unwrap();
        let found = ridge.fold_deg.unwrap();
        assert!((found - fold).abs() < 2.0, "{found} for {fold}");
    }
}

/// The height of the lowest point of a strip: the ridge's is greatest.
fn height(strip: &lineament::Strip) -> f64 {
    strip.points.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min)
}

#[test]
fn corners_of_a_noisy_bracket_are_recovered_with_their_standard_deviations() {
    let scan = scan(&bracket(), 12_000, 0.25);
    let network = network(&scan, WedgeForm::Quadric);
    let corners: Vec<[f64; 3]> =
        scan.truth.nodes.iter().filter(|n| n.kind == NodeKind::Junction).map(|n| n.position).collect();
    let (mut near, mut within, mut all) = (0, 0, 0);
    for corner in &corners {
        let off = |n: &lineament::Node| [0, 1, 2].map(|k| n.position[k] - corner[k]);
        let far = |n: &lineament::Node| off(n).iter().map(|x| x * x).sum::<f64>().sqrt();
        let node = network.nodes.iter().min_by(|a, b| far(a).total_cmp(&far(b))).unwrap();
        near += usize::from(far(node) < 0.5 * scan.spacing);
        if let Some(sigma) = node.sigma {
            within += off(node).iter().zip(sigma).filter(|(x, s)| x.abs() <= 1.96 * s).count();
            all += 3;
        }
    }
    assert!(near >= corners.len() - 1, "{near} of {}", corners.len());
    assert!(all >= 3 * (corners.len() - 1) && within as f64 >= 0.8 * all as f64, "{within} of {all}");
}

#[test]
fn nothing_is_recovered_unless_asked_for() {
    let scan = scan(&cuboid([1.0; 3]), 3000, 0.1);
    let network = checked(&scan.cloud, &Params::default()).unwrap().network;
    assert!(
        network.strips.iter().all(|s| s.sigma.is_empty()) && network.nodes.iter().all(|n| n.sigma.is_none())
    );
}
