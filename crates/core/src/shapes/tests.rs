use std::f64::consts::PI;

use super::*;
use crate::math::vec3::{distance, dot};
use crate::network::{NodeKind, StripKind};

fn all() -> Vec<Shape> {
    vec![
        cube(1.0),
        cuboid([4.0, 3.0, 2.0]),
        wedge(40.0),
        tapered_block(),
        star_prism(5),
        bracket(),
        brick(),
        cylinders(1.0, 0.6),
        cylinders(1.0, 1.0),
        pipe_cross(),
        sheet(),
        sheet_with_hole(),
        bent_sheet(60.0),
        tube(),
        cone(1.0, 2.0),
        stepped_shaft(),
        sphere(1.0),
        torus(1.0, 0.4),
        dome(1.0),
        keyed_shaft(),
        regular_prism(6, 2.0),
        pocketed_block(),
        punched_plate(),
        countersunk_plate(),
        crossed_bores(),
        flange(),
        counterbored_plate(),
        hex_nut(),
        slotted_plate(),
        channel(),
        hollow_shaft(),
        tapered_hub(),
    ]
}

fn ways() -> [Sampling; 5] {
    let scanner = |distance| Sampling::Scanner { views: 6, pitch: 0.15, distance, grazing_deg: 80.0 };
    let count = 1500;
    [
        Sampling::Grid { step: 0.2 },
        Sampling::Area { count },
        Sampling::BlueNoise { count },
        scanner(None),
        scanner(Some(3.0)),
    ]
}

/// Faces that a point lies on, trims allowing for rounding.
fn faces_at(shape: &Shape, p: [f64; 3]) -> usize {
    shape.faces.iter().filter(|f| f.surface.distance(p) < 1e-9 && touches(f, p)).count()
}

fn touches(face: &Face, p: [f64; 3]) -> bool {
    // The truth's chords leave its circles by 1e-5 of the radius.
    let beside = |n: i32| [n % 3, n / 3 % 3, n / 9].map(|s| 2e-5 * f64::from(s - 1));
    (0..27).any(|n| face.holds(crate::math::vec3::add(p, beside(n))))
}

#[test]
fn every_sample_lies_on_its_face() {
    for shape in all() {
        for way in ways() {
            let got = shape.sample(&Scan::new(way).seed(3));
            assert!(got.clean.len() > 100, "{} {way:?} {}", shape.name, got.clean.len());
            assert_eq!(got.clean, got.cloud.positions);
            assert_eq!(got.clean.len(), got.faces.len());
            for (&p, &id) in got.clean.iter().zip(&got.faces) {
                let face = &shape.faces[id as usize];
                let chord = if let Sampling::Grid { .. } = way { 2e-5 } else { 1e-9 };
                assert!(face.surface.distance(p) < chord, "{} {way:?} {p:?}", shape.name);
                assert!(touches(face, p), "{} {way:?} {p:?}", shape.name);
            }
        }
    }
}

#[test]
fn creases_lie_on_two_faces_and_borders_on_one() {
    for shape in all() {
        for curve in &shape.network.curves {
            let inner = &curve.points[usize::from(!curve.closed)..];
            let inner = &inner[..inner.len() - usize::from(!curve.closed)];
            let middles: Vec<_> =
                curve.points.windows(2).map(|w| [0, 1, 2].map(|k| (w[0][k] + w[1][k]) / 2.0)).collect();
            let probes = if inner.is_empty() { &middles } else { inner };
            let wanted = if curve.kind == StripKind::Border { 1 } else { 2 };
            for &p in probes {
                assert_eq!(faces_at(&shape, p), wanted, "{} {p:?}", shape.name);
            }
        }
    }
}

#[test]
fn folds_are_the_angles_between_the_normals_of_the_faces() {
    for shape in all() {
        for curve in shape.network.curves.iter().filter(|c| c.kind == StripKind::Crease) {
            let m = curve.points.len();
            let (p, fold) = if m == 2 {
                ([0, 1, 2].map(|k| (curve.points[0][k] + curve.points[1][k]) / 2.0), curve.fold_deg[0])
            } else {
                (curve.points[m / 3], curve.fold_deg[m / 3])
            };
            let on = |f: &&Face| f.surface.distance(p) < 1e-9 && touches(f, p);
            let normals: Vec<_> = shape.faces.iter().filter(on).map(|f| f.normal(p)).collect();
            let angle = dot(normals[0], normals[1]).clamp(-1.0, 1.0).acos().to_degrees();
            assert!((angle - fold).abs() < 1e-5, "{}: {angle} {fold}", shape.name);
        }
    }
}

#[test]
fn networks_have_the_stated_counts() {
    let counts = |s: &Shape| {
        let t = &s.network;
        let borders = t.curves.iter().filter(|c| c.kind == StripKind::Border).count();
        let concave = t.curves.iter().filter(|c| c.fold == Fold::Concave).count();
        [t.curves.len(), t.loops(), borders, concave, t.count(NodeKind::Junction), t.count(NodeKind::Corner)]
    };
    let stated = [
        [12, 0, 0, 0, 8, 0],
        [12, 0, 0, 0, 8, 0],
        [15, 0, 0, 0, 10, 0],
        [12, 0, 0, 0, 8, 0],
        [30, 0, 0, 5, 20, 0],
        [22, 4, 0, 2, 12, 0],
        [22, 10, 8, 5, 8, 0],
        [6, 6, 0, 2, 0, 0],
        [8, 4, 0, 4, 2, 0],
        [12, 12, 0, 2, 0, 0],
        [4, 0, 4, 0, 0, 4],
        [5, 1, 5, 0, 0, 4],
        [7, 0, 6, 0, 2, 4],
        [2, 2, 2, 0, 0, 0],
        [1, 1, 0, 0, 0, 0],
        [13, 13, 0, 5, 0, 0],
        [0; 6],
        [0; 6],
    ];
    for (shape, stated) in all().iter().zip(stated) {
        assert_eq!(counts(shape), stated, "{}", shape.name);
    }
    assert_eq!(cone(1.0, 2.0).network.nodes[0].position, [0.0, 0.0, 2.0]);
    assert_eq!(cone(1.0, 2.0).network.count(NodeKind::Apex), 1);
}

#[test]
fn areas_are_right() {
    let exact = [
        (cube(1.0), 6.0),
        (sheet_with_hole(), 12.0 - PI * 0.49),
        (tube(), 8.0 * PI),
        (cone(1.0, 2.0), PI * (1.0 + 5f64.sqrt())),
        (sphere(2.0), 16.0 * PI),
        (torus(1.0, 0.4), 1.6 * PI * PI),
        (bent_sheet(60.0), 12.0),
        // The L has 6 + 5 - 1.2 by 1.2 of profile; the bore takes two discs, the boss none.
        (bracket(), 2.0 * 1.2 * 9.8 + 4.0 * 22.0 - 2.0 * PI * 0.81 + 1.8 * PI * 1.2 + 1.6 * PI),
        // Each of four half mantles loses the 4 r^2 that the other's quarter arcs cover: 8 r^2 a cylinder.
        (cylinders(1.0, 1.0), 2.0 * (10.0 * PI - 8.0) + 4.0 * PI),
        (counterbored_plate(), 30.0 + 16.0 * 1.2 + PI * (2.0 * 0.7 - 4.0 * 0.35 * 0.35 + 4.0 * 0.35 * 0.7)),
        (slotted_plate(), 24.0 + 14.0 * 0.8 - 2.0 * (1.12 + PI * 0.16) + 0.8 * (2.8 + 0.8 * PI)),
    ];
    for (shape, area) in exact {
        assert!((shape.area() - area).abs() < 1e-4 * area, "{}: {} {area}", shape.name, shape.area());
    }
}

#[test]
fn sampling_by_area_puts_its_share_on_each_face() {
    for shape in [bracket(), cylinders(1.0, 0.6), cone(1.0, 2.0), brick()] {
        let n = 40_000;
        let got = shape.sample(&Scan::new(Sampling::Area { count: n }).seed(11));
        for (id, face) in (0..).zip(&shape.faces) {
            let share = got.faces.iter().filter(|&&f| f == id).count() as f64 / n as f64;
            let wanted = face.area() / shape.area();
            assert!((share - wanted).abs() < 4.0 * (wanted / n as f64).sqrt(), "{} {id}", shape.name);
        }
    }
}

#[test]
fn samples_are_uniform_along_curved_faces() {
    // A plane across the middle of the axis halves a sphere and a torus; a cone's upper half has a quarter of its area.
    for (shape, level, above) in [(sphere(1.0), 0.5, 0.25), (torus(1.0, 0.4), 0.0, 0.5)] {
        let got = shape.sample(&Scan::new(Sampling::Area { count: 20_000 }).seed(5));
        let share = got.clean.iter().filter(|p| p[2] > level).count() as f64 / 20_000.0;
        assert!((share - above).abs() < 0.015, "{} {share}", shape.name);
    }
    let got = torus(1.0, 0.4).sample(&Scan::new(Sampling::Area { count: 20_000 }).seed(6));
    let outer = got.clean.iter().filter(|p| p[0].hypot(p[1]) > 1.0).count() as f64 / 20_000.0;
    assert!((outer - (0.5 + 0.4 / PI)).abs() < 0.015, "{outer}");
    let lid = revolve("cone", &[[1.0, 0.0], [0.0, 2.0]]);
    let got = lid.sample(&Scan::new(Sampling::Area { count: 20_000 }).seed(7));
    let upper = got.clean.iter().filter(|p| p[2] > 1.0).count() as f64 / 20_000.0;
    assert!((upper - 0.25).abs() < 0.015, "{upper}");
}

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
fn same_seed_same_bits_and_another_seed_others() {
    for way in &ways()[1..] {
        let scan = Scan::new(*way).noise(0.2).gradient(1, 3.0);
        let [a, b, c] = [4, 4, 5].map(|seed| bracket().sample(&scan.seed(seed)));
        assert_eq!(a, b);
        assert_ne!(a.cloud.positions, c.cloud.positions);
    }
}

#[test]
fn bits_are_those_of_every_machine() {
    let scan = Scan::new(Sampling::Area { count: 1000 }).noise(0.3).seed(9);
    let got = stepped_shaft().sample(&scan);
    let hash = got
        .cloud
        .positions
        .iter()
        .flatten()
        .fold(0xcbf2_9ce4_8422_2325u64, |h, x| (h ^ x.to_bits()).wrapping_mul(0x100_0000_01b3));
    assert_eq!(hash, 0xa9fd_3174_8bff_3d5c, "{hash:#x}");
}

#[test]
fn spacing_is_the_mean_distance_to_six_neighbours() {
    let got = bracket().sample(&Scan::new(Sampling::Area { count: 600 }).noise(0.5).seed(2));
    let mean = got.clean.iter().map(|&p| {
        let mut d: Vec<f64> = got.clean.iter().map(|&q| distance(p, q)).collect();
        d.sort_by(f64::total_cmp);
        d[1..7].iter().sum::<f64>() / 6.0
    });
    assert!((got.spacing - mean.sum::<f64>() / 600.0).abs() < 1e-12);
}

#[test]
fn noise_has_the_standard_deviation_asked_for() {
    let base = Scan::new(Sampling::Area { count: 20_000 }).seed(2);
    for scan in [base.noise(0.25), Scan { noise: Noise::Units(0.01), ..base }] {
        let got = cube(1.0).sample(&scan);
        let moved = got.clean.iter().zip(&got.cloud.positions).map(|(&p, &q)| distance(p, q).powi(2));
        let sigma = (moved.sum::<f64>() / 60_000.0).sqrt();
        let wanted = if scan.noise == Noise::Units(0.01) { 0.01 } else { 0.25 * got.spacing };
        assert!((sigma / wanted - 1.0).abs() < 0.02, "{sigma} {wanted}");
    }
}

#[test]
fn blue_noise_keeps_its_points_apart_and_their_number() {
    let got = sphere(1.0).sample(&Scan::new(Sampling::BlueNoise { count: 3000 }).seed(1));
    assert_eq!(got.clean.len(), 3000);
    let tree = Tree::new(&got.clean);
    let least = got.clean.iter().map(|&p| tree.k_nearest(p, 2)[1].0.sqrt()).fold(f64::INFINITY, f64::min);
    assert!(least > 0.72 * (4.0 * PI / 3000.0).sqrt(), "{least}");
}

#[test]
fn a_gradient_thins_towards_the_high_end() {
    let scan = Scan::new(Sampling::Area { count: 60_000 }).gradient(0, 6.0).seed(1);
    let got = sheet().sample(&scan);
    let within =
        |low: f64, high: f64| got.clean.iter().filter(|p| (low..high).contains(&p[0])).count() as f64;
    let ratio = within(0.0, 0.2) / within(3.8, 4.0);
    assert!((4.8..7.0).contains(&ratio), "{ratio}");
}

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

#[test]
fn a_grid_has_its_step_on_curved_faces_too() {
    for shape in [sphere(1.0), torus(1.0, 0.4), tube(), cone(1.0, 2.0), bracket(), cylinders(1.0, 1.0)] {
        let got = shape.sample(&Scan::new(Sampling::Grid { step: 0.1 }));
        let tree = Tree::new(&got.clean);
        let nearest: Vec<f64> = got.clean.iter().map(|&p| tree.k_nearest(p, 2)[1].0.sqrt()).collect();
        let mean = nearest.iter().sum::<f64>() / nearest.len() as f64;
        assert!((0.075..0.105).contains(&mean), "{} {mean}", shape.name);
        let odd: Vec<_> =
            nearest.iter().zip(&got.clean).filter(|(d, _)| !(0.035..0.13).contains(*d)).collect();
        assert!(odd.is_empty(), "{} {odd:?}", shape.name);
        let share = got.clean.len() as f64 * 0.01 / shape.area();
        assert!((0.9..1.15).contains(&share), "{} {share}", shape.name);
    }
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
