//! Clouds whose sampling differs from place to place, and clouds with points on no surface.

use crate::common::{checked, cloud, found};
use lineament::params::{Auto, Clutter, Method};
use lineament::patch::Surface;
use lineament::shapes::{Rng, Sampling, Scan, cube};
use lineament::{Class, Params, check};

/// Two cubes far apart, the second ten times as large and as coarsely sampled: edges of 10 and 100, 6,000 points each.
fn two_cubes() -> Vec<[f64; 3]> {
    let sampled = |edge, seed| {
        cube(edge).sample(&Scan::new(Sampling::BlueNoise { count: 6000 }).seed(seed)).cloud.positions
    };
    let far = sampled(100.0, 2).into_iter().map(|[x, y, z]| [x + 200.0, y, z]);
    sampled(10.0, 1).into_iter().chain(far).collect()
}

/// Distance of a point from the nearest edge of its cube, over the cube's edge.
fn from_edge(points: &[[f64; 3]], i: usize) -> f64 {
    let own = if i < 6000 { &points[..6000] } else { &points[6000..] };
    let limit = |axis: usize, pick: fn(f64, f64) -> f64| own.iter().map(|p| p[axis]).reduce(pick).unwrap();
    let edge = if i < 6000 { 10.0 } else { 100.0 };
    let mut away: Vec<f64> = (0..3)
        .map(|a| (points[i][a] - limit(a, f64::min)).min(limit(a, f64::max) - points[i][a]) / edge)
        .collect();
    away.sort_by(f64::total_cmp);
    // The point lies on a face; the second coordinate says how far the next face is.
    away[1]
}

#[test]
fn classes_follow_the_spacing_of_each_of_two_cubes() {
    let points = two_cubes();
    let classes = found(&cloud(&points)).classes();
    // The spacing is a third of a tenth of an edge in both.
    for (cube, range) in [("fine", 0..6000), ("coarse", 6000..12_000)] {
        let share = |near: std::ops::Range<f64>| {
            let ring: Vec<usize> = range.clone().filter(|&i| near.contains(&from_edge(&points, i))).collect();
            assert!(ring.len() > 100, "{cube}: {}", ring.len());
            let marked = ring.iter().filter(|&&i| classes[i] != Class::Smooth).count();
            marked as f64 / ring.len() as f64
        };
        let (on, off) = (share(0.0..0.015), share(0.06..0.5));
        assert!(on > 0.95 && off < 0.01, "{cube}: {on:.3} of the points on edges, {off:.3} of the others");
    }
}

#[test]
fn patches_follow_the_spacing_of_each_of_two_cubes() {
    let mut params = Params::default();
    params.patches.find = Auto::Given(true);
    let result = checked(&cloud(&two_cubes()), &params).unwrap();
    let patches = result.patches.as_ref().unwrap();
    check::patches(&result.network, patches).unwrap();
    assert_eq!((patches.patches.len(), patches.separating()), (12, 24));
    for patch in &patches.patches {
        assert!(matches!(patch.fit.surface, Surface::Plane { .. }) && !patch.fit.free, "{:?}", patch.fit);
    }
}

/// A sheet of 40 by 40 points a unit apart, and 20 strays high above it.
fn sheet_with_strays() -> (Vec<[f64; 3]>, std::ops::Range<usize>) {
    let mut rng = Rng::new(5);
    let grid = |i: u32| [f64::from(i % 40), f64::from(i / 40)].map(|x| x + 0.2 * rng.uniform());
    let mut points: Vec<[f64; 3]> = (0..1600).map(grid).map(|[x, y]| [x, y, 0.0]).collect();
    let mut rng = Rng::new(6);
    points
        .extend((0..20).map(|i| [rng.between(0.0, 40.0), rng.between(0.0, 40.0), 8.0 + 5.0 * f64::from(i)]));
    (points, 1600..1620)
}

#[test]
fn strays_are_clutter_that_scores_nothing_unless_clutter_is_kept() {
    let (points, strays) = sheet_with_strays();
    let result = found(&cloud(&points));
    let (classes, scores) = (result.classes(), result.scores());
    let clutter: Vec<u32> = strays.clone().map(|i| i as u32).collect();
    assert_eq!((&result.clutter, result.report.points), (&clutter, 1600));
    for i in 0..points.len() {
        let stray = strays.contains(&i);
        assert_eq!(classes[i] == Class::Clutter, stray, "{i}");
        assert_eq!(result.canonical[i] == u32::MAX, stray, "{i}");
        assert!(if stray { scores[i] == 0.0 } else { scores[i].is_finite() }, "{i}: {}", scores[i]);
    }
    let mut params = Params::default();
    params.surface.clutter = Clutter::Keep;
    let kept = checked(&cloud(&points), &params).unwrap();
    assert!(kept.clutter.is_empty() && kept.canonical.iter().all(|&c| c != u32::MAX));
    assert!(!kept.classes().contains(&Class::Clutter));
}

#[test]
fn clean_parts_the_points_of_the_input_into_surface_and_clutter() {
    let (mut points, strays) = sheet_with_strays();
    points.insert(0, [f64::NAN; 3]);
    points.push(points[1]);
    for keep in [Clutter::Auto, Clutter::LeaveOut, Clutter::Keep] {
        let mut params = Params::default();
        params.surface.clutter = keep;
        let cleaned = lineament::clean(&cloud(&points), &params).unwrap();
        let clutter: Vec<u32> = strays.clone().map(|i| i as u32 + 1).collect();
        let surface: Vec<u32> = (1..=1600).chain([1621]).collect();
        assert_eq!((cleaned.clutter, cleaned.surface), (clutter, surface));
        assert_eq!((cleaned.report.dropped, cleaned.report.merged), (1, 1));
    }
    assert!(lineament::clean(&cloud(&points[..4]), &Params::default()).is_err());
}

/// A sheet folded by a right angle, in rows 1 apart along which points lie .2 apart.
pub fn rows() -> Vec<[f64; 3]> {
    let along = |i: i32| if i < 100 { [f64::from(i) * 0.2, 0.0] } else { [20.0, f64::from(i - 100) * 0.2] };
    let mut rng = Rng::new(7);
    let mut point = |row: i32, i: i32| {
        let [x, z] = along(i);
        [x, f64::from(row) + 0.1 * rng.uniform(), z]
    };
    (0..20).flat_map(|row| (0..200).map(move |i| (row, i))).map(|(row, i)| point(row, i)).collect()
}

#[test]
fn points_that_rows_are_thinned_of_have_the_class_and_score_of_those_beside_them() {
    let points = rows();
    let result = found(&cloud(&points));
    assert!(result.report.points < points.len() / 2, "{} of {}", result.report.points, points.len());
    let (classes, scores) = (result.classes(), result.scores());
    for (i, &place) in result.canonical.iter().enumerate() {
        let beside = result.source[place as usize] as usize;
        assert!(lineament::math::vec3::distance(points[i], points[beside]) < 1.0, "{i}");
        assert_eq!((classes[i], scores[i]), (classes[beside], scores[beside]), "{i}");
    }
    assert!(classes.contains(&Class::Crease) && !classes.contains(&Class::Clutter));
}

#[test]
fn a_filled_volume_has_no_line_and_says_so() {
    let mut rng = Rng::new(5);
    let points: Vec<[f64; 3]> = (0..3000).map(|_| [0; 3].map(|_| rng.uniform())).collect();
    for method in [Method::Auto, Method::Segments, Method::Projection] {
        let mut params = Params { method, ..Params::default() };
        params.patches.find = Auto::Given(true);
        let result = checked(&cloud(&points), &params).unwrap();
        assert!(result.network.strips.is_empty() && result.report.surface.none, "{method:?}");
        assert!(result.classes().iter().all(|&c| c == Class::Clutter), "{method:?}");
        let patches = result.patches.unwrap();
        assert_eq!((patches.label.len(), patches.patches.len()), (points.len(), 0));
        params.surface.clutter = Clutter::Keep;
        assert!(!checked(&cloud(&points), &params).unwrap().report.surface.none);
    }
}
