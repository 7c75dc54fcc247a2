use super::moments::Moments;
use super::section::Across;
use super::*;
use crate::math::union_find::UnionFind;
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
        let found = edgelets(&points, &normals, scales(noise), &EdgeletParams::default()).edgelets;
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
    let found = edgelets(&points, &normals, scales(0.2), &EdgeletParams::default()).edgelets;
    let square = |e: &Edgelet| (e.place[1].powi(2) + e.place[2].powi(2)) / (2.0 * e.deviation.powi(2));
    let mean = found.iter().map(square).sum::<f64>() / found.len() as f64;
    // Cross-sections of the whole ridge share most of their points: fewer independent errors than edgelets.
    assert!((0.2..2.0).contains(&mean), "{mean}");
}

#[test]
fn flat_and_gently_curved_surfaces_have_none() {
    for slope in [0.0, 0.1] {
        let (points, normals) = ridge(slope, 0.2);
        assert!(
            edgelets(&points, &normals, scales(0.2), &EdgeletParams::default()).edgelets.is_empty(),
            "{slope}"
        );
    }
    let bent = |y: f64| [y, -y * y / 30.0];
    let mut rng = Rng::new(3);
    let places: Vec<[f64; 2]> = (0..960)
        .map(|i| [f64::from(i % 40), f64::from(i / 40) - 12.0].map(|c| c + 0.3 * rng.gaussian()))
        .collect();
    let points: Vec<[f64; 3]> = places.iter().map(|p| [p[0], bent(p[1])[0], bent(p[1])[1]]).collect();
    let normals: Vec<[f32; 3]> =
        places.iter().map(|p| unit([0.0, p[1] / 15.0, 1.0]).map(|c| c as f32)).collect();
    assert!(edgelets(&points, &normals, scales(0.0), &EdgeletParams::default()).edgelets.is_empty());
}

#[test]
fn beyond_the_greatest_noise_and_without_normals_there_are_none() {
    let (points, normals) = ridge(1.0, 0.2);
    let params = EdgeletParams { noise_spacings: 0.15, ..EdgeletParams::default() };
    assert!(edgelets(&points, &normals, scales(0.2), &params).edgelets.is_empty());
    assert!(edgelets(&points, &[], scales(0.2), &EdgeletParams::default()).edgelets.is_empty());
}

#[test]
fn places_with_many_times_the_points_of_a_plane_have_none() {
    let (points, normals) = ridge(1.0, 0.0);
    let wide = |spacing| Resolution { spacing, noise: 0.0 }.into();
    assert!(!edgelets(&points, &normals, wide(1.4), &EdgeletParams::default()).edgelets.is_empty());
    assert!(edgelets(&points, &normals, wide(6.0), &EdgeletParams::default()).edgelets.is_empty());
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

/// A wall of even points, and ground before it whose points begin at a distance.
fn wall_before_ground(gap: f64) -> (Vec<[f64; 3]>, Vec<[f32; 3]>) {
    let mut rng = Rng::new(11);
    let mut even = |to: f64| to + 0.2 * rng.gaussian();
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for i in 0..40 {
        for k in 0..12 {
            points.push([even(f64::from(i)), 0.0, even(f64::from(k) + 0.5).abs()]);
            normals.push([0.0, 1.0, 0.0]);
            points.push([even(f64::from(i)), -even(gap + 0.5 * f64::from(k)).max(gap), 0.0]);
            normals.push([0.0, 0.0, 1.0]);
        }
    }
    (points, normals)
}

#[test]
fn the_foot_of_a_wall_is_found_where_the_ground_begins_a_few_spacings_before_it() {
    let found = |gap: f64| {
        let (points, normals) = wall_before_ground(gap);
        edgelets(&points, &normals, scales(0.01), &EdgeletParams::default()).edgelets
    };
    for gap in [1.2, 2.0, 2.6] {
        let foot = found(gap);
        assert!(foot.len() > 20, "{gap}: {}", foot.len());
        for e in foot {
            assert!(e.place[1].hypot(e.place[2]) < 0.3 && (e.turn() - 1.57).abs() < 0.15, "{gap}: {e:?}");
        }
    }
    assert!(found(3.5).is_empty());
}

#[test]
fn flat_places_lie_away_from_the_edge() {
    let (points, normals) = ridge(1.0, 0.05);
    let flat = edgelets(&points, &normals, scales(0.05), &EdgeletParams::default()).flat;
    assert!(flat.len() > 20, "{}", flat.len());
    assert!(flat.iter().all(|p| p[1].abs() > 1.0), "{flat:?}");
}

#[test]
fn both_corners_of_a_step_are_found_where_no_point_lies_on_its_face() {
    for (height, noise) in [(1.4, 0.05), (2.0, 0.05), (2.4, 0.05), (1.4, 0.15)] {
        let mut rng = Rng::new(5);
        let mut points = Vec::new();
        for i in 0..40 {
            for j in -12..12 {
                let [x, y] = [f64::from(i), f64::from(j) + 0.5].map(|c| c + 0.2 * rng.gaussian());
                let y = if j < 0 { y.min(0.0) } else { y.max(0.0) };
                points.push([x, y, noise * rng.gaussian() + if j < 0 { 0.0 } else { height }]);
            }
        }
        let normals = vec![[0.0, 0.0, 1.0]; points.len()];
        let found = edgelets(&points, &normals, scales(noise), &EdgeletParams::default()).edgelets;
        for z in [0.0, height] {
            let near = |e: &&Edgelet| (e.place[2] - z).abs() < 0.2;
            assert!(found.iter().filter(near).count() > 20, "{height}, {noise}: {}", found.len());
        }
        for e in &found {
            assert!(e.place[1].abs() < 0.6, "{height}, {noise}: {:?}", e.place);
            assert!(norm(cross(e.along, [1.0, 0.0, 0.0])) < 0.2, "{height}, {noise}: {:?}", e.along);
            assert!((e.turn().to_degrees() - 90.0).abs() < 20.0, "{height}, {noise}: {}", e.turn());
        }
        // One sheet above another is no step, however near.
        let sheets: Vec<[f64; 3]> =
            points.iter().flat_map(|p| [[p[0], p[1], 0.0], [p[0] + 0.5, p[1] + 0.5, height]]).collect();
        let normals = vec![[0.0, 0.0, 1.0]; sheets.len()];
        assert!(edgelets(&sheets, &normals, scales(noise), &EdgeletParams::default()).edgelets.is_empty());
    }
}

#[test]
fn rows_of_points_along_the_line_are_linked_with_each_other() {
    let mut rng = Rng::new(9);
    let across = |k: i32, rng: &mut Rng| {
        let place = [0.65 * f64::from(k / 18) + 0.05 * rng.gaussian(), 0.05 * rng.gaussian()];
        Across { raw: place, place, normal: [0.0, 1.0] }
    };
    let points: Vec<Across> = (0..90).map(|k| across(k, &mut rng)).collect();
    let mut links = Links::default();
    links.find(&points, 0.05);
    let mut sets = UnionFind::new(points.len());
    links.all.iter().for_each(|link| {
        sets.union(link.a, link.b);
    });
    assert!((0..90).all(|i| sets.find(i) == sets.find(0)));
}

#[test]
fn a_thin_pipe_has_no_creases() {
    let mut rng = Rng::new(11);
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    for i in 0..30 {
        for j in 0..14 {
            let x = f64::from(i) + 0.2 * rng.gaussian();
            let angle = (f64::from(j) + 0.2 * rng.gaussian()) * std::f64::consts::TAU / 14.0;
            let radius = 2.2 + 0.05 * rng.gaussian();
            points.push([x, radius * angle.cos(), radius * angle.sin()]);
            normals.push([0.0, angle.cos() as f32, angle.sin() as f32]);
        }
    }
    let Found { edgelets: found, flat: smooth, .. } =
        edgelets(&points, &normals, scales(0.05), &EdgeletParams::default());
    assert!(found.is_empty(), "{}", found.len());
    assert!(smooth.len() > 20, "{}", smooth.len());
}
