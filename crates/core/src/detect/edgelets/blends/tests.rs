use super::super::{Found, edgelets};
use crate::math::vec3::{norm, unit};
use crate::params::EdgeletParams;
use crate::resolution::Resolution;
use crate::shapes::Rng;
use std::f64::consts::FRAC_PI_2;

/// A strip of surface along x over 40 spacings, 16 to either side of the middle, by its height and its turn at a length across.
fn strip(noise: f64, profile: impl Fn(f64) -> ([f64; 2], f64)) -> Found {
    let mut rng = Rng::new(11);
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for i in 0..40 {
        for j in -16..16 {
            let [x, s] = [f64::from(i), f64::from(j) + 0.5].map(|c| c + 0.25 * rng.gaussian());
            let ([y, z], angle) = profile(s);
            let normal = [0.0, angle.sin(), angle.cos()];
            let off = noise * rng.gaussian();
            points.push([x, y + off * normal[1], z + off * normal[2]]);
            normals.push(unit(normal).map(|c| c as f32));
        }
    }
    let scales = Resolution { spacing: 1.0, noise }.into();
    edgelets(&points, &normals, scales, &EdgeletParams::default())
}

/// An arc of radius `r` about the middle of a right angle, and the faces that it touches. The arc's middle is the origin.
fn rounded(r: f64) -> impl Fn(f64) -> ([f64; 2], f64) {
    move |s| {
        let angle = (s / r).clamp(-0.5 * FRAC_PI_2, 0.5 * FRAC_PI_2);
        let beyond = s - angle * r;
        let arc = [r * angle.sin(), r * angle.cos() - r];
        ([arc[0] + beyond * angle.cos(), arc[1] - beyond * angle.sin()], angle)
    }
}

/// A right angle cut by a face of width `w`.
fn cut(w: f64) -> impl Fn(f64) -> ([f64; 2], f64) {
    move |s| {
        let beyond = (s.abs() - 0.5 * w).max(0.0) * s.signum();
        let angle = if beyond == 0.0 { 0.0 } else { 0.5 * FRAC_PI_2 * s.signum() };
        let y = s.clamp(-0.5 * w, 0.5 * w) + beyond * angle.cos();
        ([y, -beyond.abs() * angle.abs().sin()], angle)
    }
}

#[test]
fn the_design_edge_of_a_round_is_found_with_its_radius() {
    for (r, noise) in [(1.5, 0.0), (3.0, 0.0), (6.0, 0.0), (3.0, 0.1), (5.0, 0.25)] {
        let Found { blends, .. } = strip(noise, rounded(r));
        assert!(blends.len() > 12, "{r}, {noise}: {}", blends.len());
        let height = r * (std::f64::consts::SQRT_2 - 1.0);
        for e in &blends {
            let off = e.place[1].hypot(e.place[2] - height);
            assert!(off < 0.1 + 0.15 * r * (0.2 + noise), "{r}, {noise}: {e:?}");
            assert!((e.radius / r - 1.0).abs() < 0.1 + noise, "{r}, {noise}: {}", e.radius);
            assert!((e.turn() - FRAC_PI_2).abs() < 0.1 + 0.5 * noise, "{r}, {noise}: {}", e.turn());
            assert!(norm([0.0, e.along[1], e.along[2]]) < 0.15, "{e:?}");
        }
        let mean = blends.iter().map(|e| e.radius).sum::<f64>() / blends.len() as f64;
        assert!((mean / r - 1.0).abs() < 0.02 + 0.15 * noise, "{r}, {noise}: {mean}");
        let shown = blends.iter().map(|e| e.evidence).sum::<f64>();
        assert!(shown > 0.0, "{r}, {noise}: {shown}");
    }
}

#[test]
fn sharp_edges_chamfers_and_smooth_surfaces_are_no_rounds() {
    for noise in [0.0, 0.1] {
        assert!(strip(noise, cut(0.0)).blends.is_empty(), "{noise}");
        for w in [2.0, 3.0] {
            let shown: f64 = strip(noise, cut(w)).blends.iter().map(|e| e.evidence).sum();
            assert!(shown <= 0.0, "{w}, {noise}: {shown}");
        }
        // A pipe, a bend too wide for a blend, and a wave.
        assert!(
            strip(noise, |s| ([4.0 * (s / 4.0).sin(), 4.0 * (s / 4.0).cos()], s / 4.0)).blends.is_empty()
        );
        assert!(strip(noise, rounded(14.0)).blends.is_empty(), "{noise}");
    }
}
