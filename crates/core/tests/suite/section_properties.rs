//! What holds for the sections of any prism, whatever its outline, its direction and its size.

use std::f64::consts::TAU;

use lineament::Cloud;
use lineament::section::{Axis, Outline, Planes, SectionParams, Sections, Side, section};
use lineament::shapes::Rng;

/// A prism over a star-shaped outline with a hole of half its size: walls alone, a point a spacing, along any direction.
struct Prism {
    /// Amplitudes and phases of the waves of the outline about radius 1.
    waves: Vec<(f64, f64)>,
    axes: [[f64; 3]; 3],
    scale: f64,
}

const HEIGHT: f64 = 0.6;

impl Prism {
    fn random(random: &mut Rng, scale: f64) -> Self {
        // Slopes stay so small that a quarter of the waves' radius of bend is still many spacings.
        let wave =
            |k: usize, random: &mut Rng| (0.25 / (k * k) as f64 * random.uniform(), TAU * random.uniform());
        let waves = (2..5).map(|k| wave(k, random)).collect();
        let axes = frame([random.gaussian(), random.gaussian(), random.gaussian()]);
        Self { waves, axes, scale }
    }

    fn radius(&self, angle: f64) -> f64 {
        let wave = |(k, &(size, phase)): (usize, &(f64, f64))| size * ((k + 2) as f64 * angle + phase).cos();
        1.0 + self.waves.iter().enumerate().map(wave).sum::<f64>()
    }

    /// Of the outline without the hole.
    fn area(&self) -> f64 {
        let n = 20_000;
        let sum: f64 = (0..n).map(|k| self.radius(TAU * f64::from(k) / f64::from(n)).powi(2)).sum();
        0.5 * sum * TAU / f64::from(n) * self.scale * self.scale
    }

    fn scan(&self, noise: f64, random: &mut Rng) -> Cloud {
        let step = 0.03;
        let mut points = Vec::new();
        for (size, angles) in [(1.0, 220), (0.5, 110)] {
            for row in 0..(HEIGHT / step) as u32 {
                for k in 0..angles {
                    let angle = TAU * (f64::from(k) + 0.6 * random.uniform()) / f64::from(angles);
                    let r = size * self.radius(angle) + noise * step * random.gaussian();
                    let z = (f64::from(row) + random.uniform()) * step;
                    points.push(self.place([r * angle.cos(), r * angle.sin(), z]));
                }
            }
        }
        Cloud::new(points)
    }

    fn place(&self, p: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| self.scale * (0..3).map(|k| p[k] * self.axes[k][a]).sum::<f64>())
    }

    fn cut(&self, cloud: &Cloud, outline: Outline, side: Side) -> Sections {
        let planes = Planes::At([0.2, 0.3, 0.4].map(|z| z * self.scale).into());
        let params = SectionParams {
            axis: Axis::Vector(self.axes[2]),
            planes,
            outline,
            side,
            ..SectionParams::default()
        };
        section(cloud, &params).unwrap()
    }
}

/// A right-handed frame whose third axis has a direction.
fn frame(direction: [f64; 3]) -> [[f64; 3]; 3] {
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
    };
    let w = unit(direction);
    let other = if w[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let u = unit(cross(other, w));
    [u, cross(w, u), w]
}

#[test]
fn sections_of_prisms_are_closed_nested_and_of_the_right_area() {
    let random = &mut Rng::new(11);
    for round in 0..12 {
        let scale = 10f64.powi(round % 5 - 2);
        let prism = Prism::random(random, scale);
        let cloud = prism.scan(if round % 2 == 0 { 0.0 } else { 0.1 }, random);
        for outline in [Outline::Middle, Outline::Hull, Outline::Voronoi] {
            for s in prism.cut(&cloud, outline, Side::Middle).sections {
                let closed: Vec<bool> = s.contours.iter().map(|c| c.closed).collect();
                assert_eq!(closed, [true, true], "{round} {outline:?}");
                assert_eq!(
                    (s.contours[0].parent, s.contours[1].parent),
                    (None, Some(0)),
                    "{round} {outline:?}"
                );
                for (contour, share) in s.contours.iter().zip([1.0, -0.25]) {
                    let wanted = share * prism.area();
                    let off = (contour.area - wanted).abs() / wanted.abs();
                    assert!(off < 0.01, "{round} {outline:?}: {} for {wanted}", contour.area);
                }
            }
        }
    }
}

#[test]
fn turning_and_scaling_a_cloud_turns_and_scales_its_sections() {
    let random = &mut Rng::new(12);
    for round in 0..6 {
        let scale = 1.0 + 4.0 * random.uniform();
        let turned = Prism::random(random, scale);
        let plain = Prism { waves: turned.waves.clone(), axes: frame([0.0, 0.0, 1.0]), scale: 1.0 };
        let (mut one, mut other) = (Rng::new(round), Rng::new(round));
        let before = plain.cut(&plain.scan(0.1, &mut one), Outline::Middle, Side::Middle);
        let after = turned.cut(&turned.scan(0.1, &mut other), Outline::Middle, Side::Middle);
        for ((_, a), (_, b)) in before.contours().zip(after.contours()) {
            // Areas to a tenth of a spacing all round.
            let (length, area) = (b.length / turned.scale, b.area / turned.scale.powi(2));
            assert!((length - a.length).abs() < 0.02 * a.length, "{round}: {length} for {}", a.length);
            assert!(
                (area - a.area).abs() < 0.1 * before.spacing * a.length,
                "{round}: {area} for {}",
                a.area
            );
            let centre = turned
                .place([0, 1, 2].map(|k| (0..3).map(|a_| a.centroid[a_] * plain.axes[k][a_]).sum::<f64>()));
            let apart = (0..3).map(|k| (centre[k] - b.centroid[k]).powi(2)).sum::<f64>().sqrt();
            assert!(apart < 0.01 * turned.scale, "{round}: {apart}");
        }
        assert_eq!(before.contours().count(), after.contours().count(), "{round}");
    }
}

#[test]
fn the_inner_side_lies_within_the_middle_and_the_middle_within_the_outer() {
    let random = &mut Rng::new(13);
    for round in 0..6 {
        let prism = Prism::random(random, 1.0);
        let cloud = prism.scan(0.2, random);
        for outline in [Outline::Middle, Outline::Hull, Outline::Voronoi] {
            let areas = [Side::Inside, Side::Middle, Side::Outside].map(|side| {
                let sections = prism.cut(&cloud, outline, side);
                sections.contours().map(|(_, c)| c.area.abs()).collect::<Vec<f64>>()
            });
            for k in 0..areas[1].len() {
                let [inside, middle, outside] = [0, 1, 2].map(|side| areas[side][k]);
                assert!(inside < middle && middle < outside, "{round} {outline:?} {k}: {areas:?}");
            }
        }
    }
}
