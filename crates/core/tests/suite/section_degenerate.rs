//! Slabs that are hard to draw: each gives a valid section or a named reason, whatever the outline and the side.

use std::f64::consts::TAU;

use lineament::Cloud;
use lineament::params::{Auto, Clutter};
use lineament::section::{
    Contour, Missing, Outline, Planes, SectionParams, Sections, Side, section, section_observed,
};

const OUTLINES: [Outline; 3] = [Outline::Middle, Outline::Hull, Outline::Voronoi];

/// Every outline and side at one height, curves and stack included.
fn all_ways(positions: &[[f64; 3]], height: f64) -> Vec<Sections> {
    let cloud = Cloud::new(positions.to_vec());
    let mut found = Vec::new();
    for outline in OUTLINES {
        for side in [Side::Middle, Side::Outside, Side::Inside] {
            for carry in [true, false] {
                let planes = Planes::At(vec![height]);
                // The lone points are what is tried.
                let clutter = Clutter::Keep;
                let params = SectionParams {
                    outline,
                    side,
                    carry,
                    planes,
                    clutter,
                    fit: true,
                    ..SectionParams::default()
                };
                let (sections, _) = section_observed(&cloud, &params, &|_| ()).unwrap();
                valid(&sections);
                found.push(sections);
            }
        }
    }
    found
}

fn valid(sections: &Sections) {
    for s in &sections.sections {
        assert_eq!(s.missing.is_some(), s.contours.is_empty());
        for c in &s.contours {
            assert!(c.points.len() >= if c.closed { 3 } else { 2 });
            assert!(c.points.iter().flatten().all(|x| x.is_finite()) && c.area.is_finite());
            assert!(c.length > 0.0 && c.closed == c.draft_deg.is_some());
            assert!(c.pieces.iter().all(|p| p.worst.is_finite()) && !c.pieces.is_empty());
        }
    }
}

/// A wall over a closed curve given by its angle, `rows` rows of `steps` points, a step apart.
fn wall(steps: usize, rows: i32, step: f64, curve: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 3]> {
    let at = |row: i32, k: usize| {
        let [x, y] = curve(TAU * (k as f64 + 0.5 * f64::from(row & 1)) / steps as f64);
        [x, y, f64::from(row) * step]
    };
    (-rows..=rows).flat_map(|row| (0..steps).map(move |k| at(row, k))).collect()
}

fn circle(radius: f64) -> impl Fn(f64) -> [f64; 2] {
    move |angle: f64| [radius * angle.cos(), radius * angle.sin()]
}

#[test]
fn slabs_of_none_to_three_points_have_a_reason() {
    // A wall far below gives the cloud its spacing.
    let mut points = wall(100, 5, 0.1, circle(1.6));
    points.iter_mut().for_each(|p| p[2] -= 50.0);
    for (k, lone) in [[0.0, 0.0, 0.0], [0.05, 0.0, 0.0], [0.0, 0.05, 0.01]].into_iter().enumerate() {
        for sections in all_ways(&points, 0.0) {
            let wanted = if k == 0 { Missing::Empty } else { Missing::TooFewPoints(k) };
            assert_eq!(sections.sections[0].missing, Some(wanted));
        }
        points.push(lone);
    }
    assert!(all_ways(&points, 0.0).iter().all(|s| s.sections[0].missing == Some(Missing::TooFewPoints(3))));
}

#[test]
fn duplicates_change_nothing() {
    let points = wall(200, 3, 0.05, circle(1.6));
    let doubled: Vec<[f64; 3]> = points.iter().flat_map(|&p| [p; 3]).collect();
    for (once, mut thrice) in all_ways(&points, 0.01).into_iter().zip(all_ways(&doubled, 0.01)) {
        assert_eq!(thrice.merged, 2 * points.len());
        thrice.merged = once.merged;
        assert_eq!(once, thrice);
    }
}

#[test]
fn points_on_a_line_in_the_plane_or_across_it_are_no_curve() {
    for direction in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]] {
        let line: Vec<[f64; 3]> = (-200..200).map(|i| direction.map(|d| d * 0.01 * f64::from(i))).collect();
        assert!(all_ways(&line, 0.0).iter().all(|s| s.sections[0].missing.is_some()), "{direction:?}");
    }
}

#[test]
fn a_contour_that_leaves_the_slab_is_drawn_as_far_as_it_goes() {
    // Half a torus standing on its side, cut where the plane touches its crest.
    let torus = |u: f64, v: f64| [(3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin()];
    let points: Vec<[f64; 3]> = (0..200)
        .flat_map(|i| (0..60).map(move |j| torus(TAU * i as f64 / 200.0, TAU * j as f64 / 60.0)))
        .collect();
    for height in [1.0, 0.999, 0.97, 1.02, 1.2, -1.0] {
        all_ways(&points, height);
    }
    // A wall that ends at the plane shows points of one side only.
    let half: Vec<[f64; 3]> = wall(200, 20, 0.05, circle(1.6)).into_iter().filter(|p| p[2] <= 0.0).collect();
    all_ways(&half, 0.0);
    all_ways(&half, 0.04);
}

#[test]
fn bands_that_touch_or_cross_themselves_are_drawn() {
    let eight = |angle: f64| [3.0 * angle.sin(), 1.5 * (2.0 * angle).sin()];
    for sections in all_ways(&wall(400, 3, 0.04, eight), 0.0) {
        assert!(!sections.sections[0].contours.is_empty());
    }
    // Two tubes side by side, wall to wall.
    let mut tubes = wall(200, 3, 0.05, circle(1.6));
    tubes.extend(wall(200, 3, 0.05, circle(1.6)).into_iter().map(|[x, y, z]| [x + 3.2, y, z + 0.02]));
    for sections in all_ways(&tubes, 0.0) {
        let area: f64 = sections.sections[0].contours.iter().map(|c| c.area).sum();
        assert!((area / (2.0 * 2.56 * 0.5 * TAU) - 1.0).abs() < 0.05, "{area}");
    }
}

#[test]
fn three_hundred_thousand_points_are_one_contour() {
    let (steps, step) = (60_000, 0.01);
    let radius = steps as f64 * step / TAU;
    let cloud = Cloud::new(wall(steps, 2, step, circle(radius)));
    assert_eq!(cloud.len(), 300_000);
    for outline in OUTLINES {
        let planes = Planes::At(vec![0.0]);
        let params =
            SectionParams { outline, planes, fit: true, thickness: Auto::Given(0.06), ..Default::default() };
        let sections = section(&cloud, &params).unwrap();
        valid(&sections);
        assert_eq!(sections.sections[0].points, 300_000);
        let [Contour { closed: true, area, .. }] = &sections.sections[0].contours[..] else {
            panic!("{} contours", sections.sections[0].contours.len());
        };
        assert!((area / (0.5 * TAU * radius * radius) - 1.0).abs() < 1e-6, "{outline:?}: {area}");
    }
}
