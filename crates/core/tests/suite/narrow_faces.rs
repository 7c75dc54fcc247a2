//! Faces that are narrower than a neighbourhood: each of their edges is a line of its own.

mod rounded_edges;

use lineament::shapes::{Sampling, Scan, Shape, chamfered_block, cuboid};
use lineament::{Extraction, Method, Params, check, evaluate, extract};

const METHODS: [Method; 4] = [Method::Auto, Method::Penalty, Method::Projection, Method::Segments];

/// What is found on 6,000 points of a shape at a given noise, with its score against the truth.
fn found(shape: &Shape, noise: f64, method: Method) -> (Extraction, evaluate::Score) {
    let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).noise(noise).seed(1));
    let found = extract(&scan.cloud, &Params { method, ..Params::default() }).unwrap();
    check::network(&found.network).unwrap();
    let score = evaluate::against(&found.network, &scan.truth, scan.spacing);
    (found, score)
}

#[test]
fn both_rims_of_chamfers_two_and_a_half_spacings_wide_are_found() {
    for method in METHODS {
        let (_, score) = found(&chamfered_block(0.16), 0.0, method);
        assert!(score.at_1h.f1 >= 0.99, "{method:?}: {score:?}");
    }
}

#[test]
fn both_rims_of_plates_one_and_a_half_to_three_spacings_thick_are_found() {
    for method in METHODS {
        for (thickness, noise) in [(0.096, 0.0), (0.096, 0.1), (0.128, 0.1), (0.16, 0.0), (0.192, 0.1)] {
            let (found, score) = found(&cuboid([3.0, 2.0, thickness]), noise, method);
            let strips = found.network.strips.len();
            assert!(score.at_1h.f1 >= 0.95, "{method:?}, {thickness}, {noise}: {score:?}");
            // Rungs between the rims would be many more.
            assert!(strips <= 24, "{method:?}, {thickness}, {noise}: {strips} strips");
        }
    }
}

#[test]
fn narrow_chamfers_are_patches_of_their_own() {
    let (found, _) = found(&chamfered_block(0.16), 0.0, Method::Segments);
    let patches = found.patches.unwrap();
    assert_eq!(patches.patches.len(), 10);
    assert_eq!(patches.separating(), found.network.strips.len());
}
