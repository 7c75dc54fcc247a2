//! Rounds under noise have hardly a line.

use lineament::shapes::{Sampling, Scan, torus};
use lineament::{Method, Params, StripKind, extract};

#[test]
fn a_coarse_noisy_torus_has_at_most_8_creases_for_2_seeds_of_2() {
    for method in [Method::Auto, Method::Penalty, Method::Projection, Method::Segments] {
        for seed in 1..=2 {
            let scan = Scan::new(Sampling::Area { count: 6000 }).noise(0.25).seed(seed);
            let part = torus(1.0, 0.4).sample(&scan);
            let found = extract(&part.cloud, &Params { method, ..Params::default() }).unwrap();
            let creases = found.network.strips.iter().filter(|s| s.kind == StripKind::Crease).count();
            assert!(creases <= 8, "{method:?}, seed {seed}: {creases}");
        }
    }
}
