//! Clouds with their labels, by name, and moved.

use super::super::*;

#[test]
fn cube_386_has_386_points_and_92_on_edges() {
    let got = cube_386();
    assert_eq!(got.cloud.len(), 386);
    let half = |p: &[f64; 3]| p.iter().filter(|x| x.abs() == 0.5).count();
    assert_eq!(got.clean.iter().filter(|p| half(p) >= 2).count(), 92);
    assert_eq!(got.clean.iter().filter(|p| half(p) == 3).count(), 8);
    assert_eq!(got.distances().iter().filter(|&&d| d < 1e-12).count(), 92);
    assert!(got.clean.iter().flatten().all(|x| x * 8.0 == (x * 8.0).round()));
}

#[test]
fn random_cube_fills_the_shell_between_its_cubes() {
    let got = random_cube(1, 10_000);
    let size = |p: &[f64; 3]| p.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(got.clean.iter().all(|p| (0.8..=1.0).contains(&size(p))));
    let inner = got.clean.iter().filter(|p| size(p) < 0.9).count() as f64 / 10_000.0;
    let wanted = (0.9f64.powi(3) - 0.8f64.powi(3)) / (1.0 - 0.8f64.powi(3));
    assert!((inner - wanted).abs() < 0.02);
    assert!((got.truth.curves.iter().map(TruthCurve::length).sum::<f64>() - 12.0 * 1.8).abs() < 1e-12);
}

#[test]
fn labels_name_the_points_near_the_truth() {
    let got = cube(1.0).sample(&Scan::new(Sampling::Area { count: 5000 }).seed(8));
    let to_edge = |p: &[f64; 3]| {
        let mut away = p.map(|x| 0.5 - x.abs());
        away.sort_by(f64::total_cmp);
        away[0].hypot(away[1])
    };
    for ((p, d), label) in got.clean.iter().zip(got.distances()).zip(got.labels()) {
        assert!((d - to_edge(p)).abs() < 1e-9, "{d} {p:?}");
        let wanted = if d <= got.spacing {
            1
        } else if d <= 1.5 * got.spacing {
            2
        } else {
            0
        };
        assert_eq!(label, wanted);
    }
    let fading = cylinders(1.0, 1.0).sample(&Scan::new(Sampling::Area { count: 20_000 }).seed(8));
    let pole = |p: &[f64; 3]| p[0].hypot(p[1]) < fading.spacing && p[2] > 0.0;
    let at_pole: Vec<u8> =
        fading.clean.iter().zip(fading.labels()).filter(|(p, _)| pole(p)).map(|x| x.1).collect();
    assert!(!at_pole.is_empty() && at_pole.iter().all(|&l| l == 3), "{at_pole:?}");
    assert!(sphere(1.0).sample(&Scan::new(Sampling::Area { count: 50 })).labels().iter().all(|&l| l == 0));
}

#[test]
fn every_sample_name_is_its_own_and_makes_a_cloud() {
    assert_eq!(sample(DEFAULT_SAMPLE).map(|s| s.name), Some(samples()[0].name));
    let names: std::collections::BTreeSet<_> = samples().iter().map(|s| s.name).collect();
    assert_eq!(names.len(), samples().len());
    assert!(sample("no such thing").is_none());
    for s in samples() {
        let got = (s.make)(1);
        println!(
            "{:16} {:6} points, spacing {:.4}, {} curves",
            s.name,
            got.cloud.len(),
            got.spacing,
            got.truth.curves.len()
        );
        assert!(got.spacing > 0.0 && got.cloud.positions.iter().flatten().all(|x| x.is_finite()));
    }
    assert!((55_000..65_000).contains(&(samples()[0].make)(0).cloud.len()));
}

#[test]
fn a_moved_scan_keeps_its_distances() {
    let got = bracket().sample(&Scan::new(Sampling::Area { count: 500 }));
    let moved = got.map(2.0, |[x, y, z]| [2.0 * y + 8.0, 2.0 * z, 2.0 * x - 4.0]);
    for (a, b) in got.distances().iter().zip(moved.distances()) {
        assert!((2.0 * a - b).abs() < 1e-9);
    }
}
