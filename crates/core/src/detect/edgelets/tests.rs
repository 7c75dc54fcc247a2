use super::moments::Moments;
use super::section::Across;
use super::*;
use crate::math::vec3::{cross, dot, norm, sub, unit};
use crate::resolution::Resolution;
use crate::shapes::Rng;

/// A ridge along x with flanks that fall by `slope` to either side: places, normals.
fn ridge(slope: f64, noise: f64) -> (Vec<[f64; 3]>, Vec<[f32; 3]>) {
    let mut rng = Rng::new(7);
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for i in 0..40 {
        for j in -12..12 {
            let [x, y] = [f64::from(i), f64::from(j) + 0.5].map(|c| c + 0.3 * rng.gaussian());
            let normal = unit([0.0, slope * y.signum(), 1.0]);
            let off = noise * rng.gaussian();
            points.push([x + off * normal[0], y + off * normal[1], off * normal[2] - slope * y.abs()]);
            normals.push(normal.map(|c| c as f32));
        }
    }
    (points, normals)
}

fn scales(noise: f64) -> Scales<'static> {
    Resolution { spacing: 1.0, noise }.into()
}

#[test]
fn the_edge_of_a_ridge_is_found_with_its_direction_and_its_faces() {
    for (slope, noise) in [(1.0, 0.0), (1.0, 0.2), (0.5, 0.1)] {
        let (points, normals) = ridge(slope, noise);
        let found = edgelets(&points, &normals, scales(noise), &EdgeletParams::default());
        assert!(found.len() > 25, "{slope}, {noise}: {}", found.len());
        for e in &found {
            let off = e.place[1].hypot(e.place[2]);
            assert!(off < 0.1 + noise, "{slope}, {noise}: {:?}", e.place);
            assert!(norm(cross(e.along, [1.0, 0.0, 0.0])) < 0.2, "{slope}, {noise}: {:?}", e.along);
            let turn = 2.0 * slope.atan();
            assert!((e.turn() - turn).abs() < 0.1 + noise, "{slope}, {noise}: {} beside {turn}", e.turn());
            assert!(e.arms.iter().all(|arm| arm[2] < 0.0 && dot(*arm, e.along).abs() < 0.01));
            let nearest = points.iter().map(|p| norm(sub(*p, e.place))).fold(f64::INFINITY, f64::min);
            assert_eq!(norm(sub(points[e.point as usize], e.place)), nearest);
        }
    }
}

#[test]
fn errors_are_as_large_as_stated() {
    let (points, normals) = ridge(1.0, 0.2);
    let found = edgelets(&points, &normals, scales(0.2), &EdgeletParams::default());
    let square = |e: &Edgelet| (e.place[1].powi(2) + e.place[2].powi(2)) / (2.0 * e.deviation.powi(2));
    let mean = found.iter().map(square).sum::<f64>() / found.len() as f64;
    // Cross-sections of the whole ridge share most of their points: fewer independent errors than edgelets.
    assert!((0.2..2.0).contains(&mean), "{mean}");
}

#[test]
fn flat_and_gently_curved_surfaces_have_none() {
    for slope in [0.0, 0.1] {
        let (points, normals) = ridge(slope, 0.2);
        assert!(edgelets(&points, &normals, scales(0.2), &EdgeletParams::default()).is_empty(), "{slope}");
    }
    let bent = |y: f64| [y, -y * y / 30.0];
    let mut rng = Rng::new(3);
    let places: Vec<[f64; 2]> = (0..960)
        .map(|i| [f64::from(i % 40), f64::from(i / 40) - 12.0].map(|c| c + 0.3 * rng.gaussian()))
        .collect();
    let points: Vec<[f64; 3]> = places.iter().map(|p| [p[0], bent(p[1])[0], bent(p[1])[1]]).collect();
    let normals: Vec<[f32; 3]> =
        places.iter().map(|p| unit([0.0, p[1] / 15.0, 1.0]).map(|c| c as f32)).collect();
    assert!(edgelets(&points, &normals, scales(0.0), &EdgeletParams::default()).is_empty());
}

#[test]
fn beyond_the_greatest_noise_and_without_normals_there_are_none() {
    let (points, normals) = ridge(1.0, 0.2);
    let params = EdgeletParams { noise_spacings: 0.15, ..EdgeletParams::default() };
    assert!(edgelets(&points, &normals, scales(0.2), &params).is_empty());
    assert!(edgelets(&points, &[], scales(0.2), &EdgeletParams::default()).is_empty());
}

#[test]
fn places_with_many_times_the_points_of_a_plane_have_none() {
    let (points, normals) = ridge(1.0, 0.0);
    let wide = |spacing| Resolution { spacing, noise: 0.0 }.into();
    assert!(!edgelets(&points, &normals, wide(1.4), &EdgeletParams::default()).is_empty());
    assert!(edgelets(&points, &normals, wide(6.0), &EdgeletParams::default()).is_empty());
}

#[test]
fn moments_give_the_parabola_that_the_points_lie_on_in_any_frame() {
    // Nearly straight, so that the prior counts little beside 200 exact points.
    for angle in [0.0f64, 0.7, 2.0, -1.3] {
        let (sin, cos) = angle.sin_cos();
        let across = |k: i32| {
            let x = f64::from(k) / 50.0 - 2.0;
            let y = 0.3 + 0.04 * x * x;
            let raw = [cos * x - sin * y, sin * x + cos * y];
            let normal = [-0.08 * x, 1.0].map(|c| c / (1.0 + 0.0064 * x * x).sqrt());
            let normal = [cos * normal[0] - sin * normal[1], sin * normal[0] + cos * normal[1]];
            Across { raw, place: raw, normal }
        };
        let mut halves = [Moments::default(), Moments::default()];
        (0..200).for_each(|k| halves[usize::from(k % 2 == 0)].add(&across(k)));
        let both = halves[0].with(&halves[1]);
        let fit = both.fit(1e-4).unwrap();
        assert_eq!(both.count(), 200.0);
        for k in 0..200 {
            let (off, gradient, _) = fit.value(across(k).raw);
            assert!(off.abs() < 1e-3, "{angle}: {off}");
            let normal = across(k).normal;
            assert!((gradient[0] * normal[1] - gradient[1] * normal[0]).abs() < 1e-2);
        }
        assert!(fit.cost < 1.0 && halves[0].fit(1e-4).unwrap().cost < fit.cost);
    }
    assert!(Moments::default().fit(1.0).is_none());
}
