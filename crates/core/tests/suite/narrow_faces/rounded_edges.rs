//! Rounded edges: design edges with their radius, and no crease where a blend is.

use lineament::shapes::{Sampling, Scan, rounded_rectangle, walls};
use lineament::{Extraction, Params, StripKind, check, extract};

/// Four walls 30 high about a rectangle with round corners, of 24,000 points, and their spacing.
fn found(radius: f64, noise: f64) -> (Extraction, f64) {
    let shape = walls("rounded", &[rounded_rectangle([80.0, 60.0], radius)], 30.0);
    let scan = shape.sample(&Scan::new(Sampling::BlueNoise { count: 12_000 }).noise(noise).seed(3));
    let found = extract(&scan.cloud, &Params::default()).unwrap();
    check::network(&found.network).unwrap();
    (found, scan.spacing)
}

#[test]
fn the_four_upright_edges_are_rounded_with_their_radius() {
    for (spacings, noise) in [(1.5, 0.0), (3.0, 0.0), (5.0, 0.0), (3.0, 0.1)] {
        let (found, h) = found(spacings * 0.9, noise);
        let radius = spacings * 0.9;
        let rounded: Vec<_> = found.network.strips.iter().filter(|s| s.kind == StripKind::Rounded).collect();
        assert_eq!(rounded.len(), 4, "{spacings}, {noise}, spacing {h}");
        for strip in rounded {
            let blend = strip.blend.unwrap();
            assert!((blend.radius / radius - 1.0).abs() < 0.06, "{spacings}, {noise}: {blend:?}");
            assert!(strip.length() > 20.0, "{spacings}, {noise}: {}", strip.length());
            let corner = |p: &[f64; 3]| (p[0].abs() - 40.0).hypot(p[1].abs() - 30.0);
            let off = strip.points.iter().map(corner).fold(0.0, f64::max);
            assert!(off < 0.3 * h + 0.1 * radius, "{spacings}, {noise}: {off}");
            assert!((strip.fold_deg.unwrap() - 90.0).abs() < 5.0);
        }
        // Of 120 in all; none but at the least radius, where a stretch may look sharp.
        let creases = found.network.strips.iter().filter(|s| s.kind == StripKind::Crease);
        let left: f64 = creases.map(lineament::Strip::length).sum();
        assert!(left <= if spacings < 2.0 { 12.0 } else { 0.0 }, "{spacings}, {noise}: {left}");
    }
}

#[test]
fn sharp_corners_and_wide_bends_have_none() {
    for (radius, noise) in [(1e-3, 0.0), (1e-3, 0.1), (14.0, 0.0)] {
        let (found, _) = found(radius, noise);
        assert!(found.network.strips.iter().all(|s| s.kind != StripKind::Rounded), "{radius}, {noise}");
    }
}
