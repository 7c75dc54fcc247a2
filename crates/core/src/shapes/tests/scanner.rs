//! What a scanner sees.

use super::super::*;

#[test]
fn a_scanner_sees_only_what_nothing_hides() {
    let inside_out = |shape: &Shape| {
        let got = shape.sample(&Scan::new(Sampling::Scanner {
            views: 12,
            pitch: 0.1,
            distance: None,
            grazing_deg: 85.0,
        }));
        (0..shape.faces.len() as u32)
            .map(|id| got.faces.iter().filter(|&&f| f == id).count())
            .collect::<Vec<_>>()
    };
    let mut boxed = cube(1.0);
    boxed.join(sphere(0.4));
    let seen = inside_out(&boxed);
    assert!(seen[..6].iter().all(|&n| n > 100) && seen[6] == 0, "{seen:?}");
    let from_above =
        Scan::new(Sampling::Scanner { views: 1, pitch: 0.05, distance: None, grazing_deg: 80.0 });
    let got = cube(1.0).sample(&from_above);
    let faces: std::collections::BTreeSet<u32> = got.faces.iter().copied().collect();
    assert!(faces.len() <= 3, "one view sees three sides of a cube at most: {faces:?}");
}

#[test]
fn a_scanner_loses_what_it_sees_at_a_grazing_angle() {
    let view = |grazing_deg| Sampling::Scanner { views: 1, pitch: 0.02, distance: None, grazing_deg };
    let widest = |limit: f64| {
        let got = sphere(1.0).sample(&Scan::new(view(limit)));
        // The one view looks along -x; on a unit sphere the normal is the point.
        let least = got.clean.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        assert!(least > 0.0, "nothing behind is seen");
        least.acos().to_degrees()
    };
    for limit in [40.0, 80.0] {
        assert!((limit - 3.0..=limit + 1e-9).contains(&widest(limit)), "{limit} {}", widest(limit));
    }
}
