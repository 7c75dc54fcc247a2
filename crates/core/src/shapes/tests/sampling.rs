//! Samples lie on their faces, as dense and as noisy as asked, and are the same of the same seed.

use std::f64::consts::PI;

use super::super::*;
use super::{all, touches, ways};
use crate::math::vec3::distance;

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
