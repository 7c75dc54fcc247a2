//! Clouds as scanners deliver them: clutter, steps of density, rows, noise beyond the spacing.

mod scenes;

use crate::common;
use lineament::section::{Planes, SectionParams, section};
use lineament::shapes::Rng;
use lineament::{Class, Cloud, Error, Extraction, NodeKind, Params, StripKind, extract};

/// A jittered grid on the rectangle from `from` to `to` in the plane z = 0, a point a square of side `step`.
fn sheet(from: [f64; 2], to: [f64; 2], step: f64, rng: &mut Rng) -> Vec<[f64; 3]> {
    let cells = [0, 1].map(|a| ((to[a] - from[a]) / step).round() as usize);
    let mut at = |a: usize, k: usize| from[a] + step * (k as f64 + 0.1 + 0.8 * rng.uniform());
    (0..cells[0] * cells[1]).map(|k| [at(0, k % cells[0]), at(1, k / cells[0]), 0.0]).collect()
}

fn found(points: &[[f64; 3]]) -> Extraction {
    common::found(&Cloud::new(points.to_vec()))
}

/// Strips of each kind, and loose ends.
fn counts(found: &Extraction) -> [usize; 3] {
    let of = |kind| found.network.strips.iter().filter(|s| s.kind == kind).count();
    [of(StripKind::Crease), of(StripKind::Border), found.network.count(NodeKind::End)]
}

#[test]
fn a_step_of_density_is_neither_clutter_nor_a_border() {
    for ratio in [3.0, 5.0, 10.0] {
        let mut rng = Rng::new(4);
        let mut points = sheet([0.0, 0.0], [12.0, 12.0], 1.0 / ratio, &mut rng);
        points.extend(sheet([12.0, 0.0], [36.0, 12.0], 1.0, &mut rng));
        let found = found(&points);
        assert!(found.clutter.len() < 3, "{ratio}: {} points", found.clutter.len());
        assert_eq!(counts(&found), [0, 4, 0], "{ratio}");
    }
}

#[test]
fn two_walls_a_few_spacings_apart_have_a_border_each() {
    for gap in [2.3, 2.5, 3.0] {
        let mut rng = Rng::new(6);
        let mut wall = || sheet([0.0, 0.0], [30.0, 24.0], 1.0, &mut rng);
        let mut points = wall();
        points.extend(wall().iter().map(|&[x, y, _]| [x, y, gap]));
        let found = found(&points);
        assert_eq!(counts(&found), [0, 8, 0], "{gap}");
    }
}

#[test]
fn a_volume_around_a_sheet_is_left_out_however_much_there_is_of_it() {
    for volume in [1_000, 20_000] {
        let mut rng = Rng::new(9);
        let mut points = sheet([0.0, 0.0], [40.0, 40.0], 1.0, &mut rng);
        points.extend((0..volume).map(|_| [0, 1, 2].map(|a| 40.0 * rng.uniform() + [0.0, 0.0, 6.0][a])));
        let found = found(&points);
        assert_eq!(counts(&found), [0, 4, 0], "{volume}");
        let unused = found.report.surface.unused(points.len()).unwrap();
        assert!(unused.contains("on no surface"), "{unused}");
        assert!(found.report.notes.iter().any(|n| n.contains("leaves")), "{:?}", found.report.notes);
    }
}

#[test]
fn a_piece_too_small_for_a_surface_is_clutter_with_and_without_a_stray_elsewhere() {
    let mut rng = Rng::new(2);
    let mut points = sheet([0.0, 0.0], [40.0, 40.0], 1.0, &mut rng);
    points.extend(sheet([100.0, 0.0], [104.0, 5.0], 1.0, &mut rng));
    let alone = found(&points);
    assert_eq!(alone.clutter, (1600..1620).collect::<Vec<u32>>());
    points.push([0.0, 400.0, 90.0]);
    assert_eq!(found(&points).clutter, (1600..1621).collect::<Vec<u32>>());
}

#[test]
fn what_is_left_without_clutter_is_refused_where_it_is_a_line() {
    let mut rng = Rng::new(5);
    let mut points: Vec<[f64; 3]> = (0..1000).map(|k| [f64::from(k), 0.0, 0.0]).collect();
    points.extend((0..5).map(|_| [0; 3].map(|_: i32| 1000.0 * rng.uniform() - 500.0)));
    assert!(matches!(extract(&Cloud::new(points), &Params::default()), Err(Error::Collinear { .. })));
}

/// A sheet whose middle is sampled so densely that the noise, even everywhere, is half a spacing there.
fn dense_middle() -> Vec<[f64; 3]> {
    let mut rng = Rng::new(7);
    let mut points = sheet([-20.0, -20.0], [20.0, 20.0], 1.0, &mut rng);
    points.retain(|p| p[0].abs() > 6.0 || p[1].abs() > 6.0);
    points.extend(sheet([-6.0, -6.0], [6.0, 6.0], 0.15, &mut rng));
    points.iter().map(|&[x, y, _]| [x, y, 0.08 * rng.gaussian()]).collect()
}

#[test]
fn a_place_denser_than_its_noise_allows_is_no_web_of_creases() {
    let found = found(&dense_middle());
    assert_eq!(counts(&found), [0, 4, 0]);
    assert!(found.report.surface.thinned > 1000, "{:?}", found.report.surface);
}

#[test]
fn points_that_are_not_used_have_a_class_and_a_score_and_keep_to_surface_has_all_of_them() {
    let mut points = dense_middle();
    points.push([0.0, 0.0, 50.0]);
    let cloud = Cloud::new(points);
    let found = extract(&cloud, &Params::default()).unwrap();
    let (classes, scores) = (found.classes(), found.scores());
    assert_eq!((classes[cloud.len() - 1], scores[cloud.len() - 1]), (Class::Clutter, 0.0));
    assert!(scores.iter().all(|s| (0.0..=1.0).contains(s)));
    assert_eq!(classes.iter().filter(|&&c| c == Class::Clutter).count(), found.clutter.len());
    let mut params = Params::default();
    params.set("surface.clutter", "keep").unwrap();
    assert_eq!(extract(&cloud, &params).unwrap().report.points, cloud.len());
}

#[test]
fn a_form_as_printed_uses_every_point() {
    let mut points = dense_middle();
    points.push([0.0, 0.0, 50.0]);
    let mut params = Params::default();
    params.set("penalty.form", "paper").unwrap();
    assert_eq!(extract(&Cloud::new(points.clone()), &params).unwrap().report.points, points.len());
}

#[test]
fn sections_follow_no_stray_points() {
    let mut rng = Rng::new(3);
    let tube = |k: i32, rng: &mut Rng| {
        let angle = std::f64::consts::TAU * (f64::from(k % 60) + 0.5 * rng.uniform()) / 60.0;
        [10.0 * angle.cos(), 10.0 * angle.sin(), f64::from(k / 60) + 0.5 * rng.uniform()]
    };
    let mut points: Vec<[f64; 3]> = (0..60 * 30).map(|k| tube(k, &mut rng)).collect();
    points.extend((0..60).map(|_| [0; 3].map(|_: i32| 50.0 * rng.uniform() - 15.0)));
    let params = SectionParams { planes: Planes::Count(5), ..SectionParams::default() };
    let sections = section(&Cloud::new(points), &params).unwrap();
    assert!(sections.clutter >= 50, "{}", sections.clutter);
    for cut in &sections.sections {
        assert!(cut.contours.len() == 1 && cut.contours[0].closed, "at {}", cut.height);
    }
}
