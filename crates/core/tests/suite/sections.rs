//! Sections of generated scans: what is there is found, and nothing else.

mod features;
mod steps;

use lineament::params::Auto;
use lineament::section::{
    Axis, CurveShape, Feature, Missing, Outline, Planes, SectionParams, Sections, Side, Stack, section, stack,
};
use lineament::shapes::{self, Sampling, Scan, Shape};
use lineament::{Cloud, Error};

fn scanned(shape: &Shape, count: usize, noise: f64) -> Cloud {
    shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(4)).cloud
}

fn cut(cloud: &Cloud, axis: usize, count: usize) -> Sections {
    let params = SectionParams {
        axis: Axis::Coordinate(axis),
        planes: Planes::Count(count),
        fit: true,
        ..SectionParams::default()
    };
    let sections = section(cloud, &params).unwrap();
    check(&sections);
    sections
}

/// The invariants of a result.
fn check(sections: &Sections) {
    assert_eq!(sections.sections.len(), sections.heights.len());
    for (k, s) in sections.sections.iter().enumerate() {
        assert_eq!((s.plane, s.height), (k, sections.heights[k]));
        assert_eq!(s.missing.is_some(), s.contours.is_empty());
        for c in &s.contours {
            assert!(c.points.len() >= if c.closed { 3 } else { 2 });
            assert!(c.points.iter().flatten().all(|x| x.is_finite()));
            assert!(
                c.corners.windows(2).all(|w| w[0] < w[1]) && c.corners.iter().all(|&i| i < c.points.len())
            );
            assert!(c.parent.is_none_or(|p| p < s.contours.len() && s.contours[p].closed));
            assert_eq!(c.depth, c.parent.map_or(0, |p| s.contours[p].depth + 1));
            assert!(if c.depth % 2 == 0 { c.area >= 0.0 } else { c.area <= 0.0 });
            assert!(c.closed || c.area == 0.0);
            for w in c.pieces.windows(2) {
                assert_eq!(w[0].to, w[1].from);
            }
        }
    }
}

#[test]
fn a_star_has_ten_corners_with_lines_between_them() {
    let cloud = scanned(&shapes::star_prism(5), 30_000, 0.0);
    let sections = cut(&cloud, 2, 5);
    for s in &sections.sections {
        let c = &s.contours[0];
        assert_eq!((s.contours.len(), c.closed, c.corners.len()), (1, true, 10));
        assert!(c.pieces.iter().all(|p| p.shape == CurveShape::Line), "{:?}", c.pieces);
        // A side may come as two lines where a vertex beside a corner strays.
        assert!((10..=12).contains(&c.pieces.len()), "{}", c.pieces.len());
        let area = 5.0 * 0.5 * (std::f64::consts::PI / 5.0).sin();
        assert!((c.area - area).abs() < 0.02 * area, "{} for {area}", c.area);
    }
}

#[test]
fn a_sphere_is_cut_in_circles_and_named_a_revolution() {
    let cloud = scanned(&shapes::sphere(3.0), 20_000, 0.05);
    let sections = cut(&cloud, 0, 12);
    let circles =
        sections.contours().filter(|(_, c)| matches!(c.pieces[..], [ref p] if p.shape.name() == "circle"));
    assert!(circles.count() >= 10);
    let found = stack(&cloud, &sections, &SectionParams::default()).unwrap();
    assert!(found.runs.iter().any(|r| matches!(r.feature, Feature::Revolution { .. })), "{:?}", found.runs);
    assert!(found.runs.iter().all(|r| !r.hole));
}

#[test]
fn every_outline_follows_the_tube_on_every_side() {
    let cloud = scanned(&shapes::tube(), 20_000, 0.25);
    for outline in [Outline::Middle, Outline::Hull, Outline::Voronoi] {
        let mean = |side: Side, carry: bool| {
            let params = SectionParams {
                outline,
                side,
                carry,
                planes: Planes::At(vec![2.0]),
                ..SectionParams::default()
            };
            let sections = section(&cloud, &params).unwrap();
            check(&sections);
            let c = &sections.sections[0].contours[0];
            assert!(c.closed);
            let radii: Vec<f64> = c.points.iter().map(|p| p[0].hypot(p[1])).collect();
            (radii.iter().sum::<f64>() / radii.len() as f64, sections.spacing)
        };
        let (inside, h) = mean(Side::Inside, true);
        let (middle, _) = mean(Side::Middle, true);
        let (outside, _) = mean(Side::Outside, true);
        let (projected, _) = mean(Side::Middle, false);
        assert!(
            (middle - 1.0).abs() < 0.15 * h && (projected - 1.0).abs() < 0.15 * h,
            "{outline:?} {middle}"
        );
        assert!(inside < middle && middle < outside, "{outline:?}: {inside} {middle} {outside}");
    }
}

#[test]
fn contours_close_over_the_holes_that_chance_leaves_in_a_slab() {
    // Points strewn at random, unlike those of blue noise, leave stretches of several spacings bare in some slabs.
    let scan = Scan::new(Sampling::Area { count: 400_000 }).noise(0.1).seed(1);
    let sections = cut(&shapes::bracket().sample(&scan).cloud, 2, 40);
    let open = sections.contours().filter(|(_, c)| !c.closed).count();
    assert!(open <= 1, "{open} open contours in 40 slices");
}

#[test]
fn contours_of_solids_close_where_few_points_lie_or_all_on_one_side_of_the_plane() {
    let scan = Scan::new(Sampling::Area { count: 20_000 }).seed(1);
    let (mut all, mut open) = (0, 0);
    for shape in
        [shapes::star_prism(5), shapes::tapered_block(), shapes::hex_nut(), shapes::regular_prism(6, 2.0)]
    {
        let cloud = shape.sample(&scan).cloud;
        for axis in 0..3 {
            let sections = cut(&cloud, axis, 37);
            let mut points: Vec<usize> = sections.sections.iter().map(|s| s.points).collect();
            points.sort_unstable();
            // A plane with many more points than the others runs along a face.
            for section in sections.sections.iter().filter(|s| s.points * 2 <= points[18] * 3) {
                all += section.contours.len();
                open += section.contours.iter().filter(|c| !c.closed).count();
            }
        }
    }
    println!("{open} of {all} contours are open");
    assert!(all > 400 && open * 100 <= all, "{open} of {all} contours are open");
}

#[test]
fn an_open_sheet_gives_open_contours() {
    let cloud = scanned(&shapes::bent_sheet(60.0), 10_000, 0.05);
    let sections = cut(&cloud, 1, 5);
    for s in &sections.sections {
        assert_eq!((s.contours.len(), s.contours[0].closed), (1, false), "plane {}", s.plane);
    }
}

#[test]
fn adaptive_slabs_are_few_on_a_prism_and_more_on_a_shaft() {
    let adapted = |shape: &Shape| {
        let cloud = scanned(shape, 20_000, 0.05);
        let params =
            SectionParams { planes: Planes::Adaptive { start: 16, most: 64 }, ..SectionParams::default() };
        let sections = section(&cloud, &params).unwrap();
        check(&sections);
        let slabs: Vec<[f64; 2]> = sections.sections.iter().filter_map(|s| s.slab).collect();
        assert!(slabs.windows(2).all(|w| w[0][1] == w[1][0]), "{slabs:?}");
        let [low, high] = [slabs[0][0], slabs[slabs.len() - 1][1]];
        assert!(cloud.positions.iter().all(|p| (low - 1e-9..=high + 1e-9).contains(&p[2])));
        slabs.len()
    };
    let (prism, shaft) = (adapted(&shapes::star_prism(5)), adapted(&shapes::stepped_shaft()));
    assert_eq!(prism, 1);
    assert!((6..=64).contains(&shaft), "{shaft}");
}

#[test]
fn threads_order_and_origin_change_nothing() {
    let cloud = scanned(&shapes::bracket(), 8_000, 0.1);
    let params = |shift: f64| SectionParams {
        planes: Planes::At(vec![0.5 + shift, 3.0 + shift]),
        ..SectionParams::default()
    };
    let plain = section(&cloud, &params(0.0)).unwrap();
    let mut turned = cloud.clone();
    turned.positions.reverse();
    assert_eq!(section(&turned, &params(0.0)).unwrap(), plain);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(pool.install(|| section(&cloud, &params(0.0))).unwrap(), plain);
    let rounded: Vec<[f64; 3]> =
        cloud.positions.iter().map(|p| p.map(|x| (x * 65536.0).round() / 65536.0)).collect();
    let moved: Vec<[f64; 3]> = rounded.iter().map(|p| p.map(|x| x + 1024.0)).collect();
    let (near, far) = (section(&rounded, &params(0.0)), section(&moved, &params(1024.0)));
    for ((_, a), (_, b)) in near.unwrap().contours().zip(far.unwrap().contours()) {
        assert_eq!(a.points.len(), b.points.len());
        let back = b.points.iter().map(|p| p.map(|x| x - 1024.0));
        assert!(a.points.iter().zip(back).all(|(p, q)| (0..3).all(|k| (p[k] - q[k]).abs() < 1e-9)));
    }
}

#[test]
fn degenerate_slabs_give_a_reason_or_a_curve() {
    let line: Vec<[f64; 3]> = (0..50).map(|i| [f64::from(i), 0.0, 0.0]).collect();
    let flat: Vec<[f64; 3]> = (0..400).map(|i| [f64::from(i % 20), f64::from(i / 20), 0.0]).collect();
    let clouds: Vec<Vec<[f64; 3]>> = vec![
        vec![],
        vec![[1.0, 2.0, 0.0]],
        vec![[0.0; 3], [1.0, 0.0, 0.0]],
        vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        vec![[3.0, 4.0, 0.0]; 100],
        line.clone(),
        flat,
        line.iter().map(|p| [p[0] * 1e-9, 0.0, 1e7]).collect(),
        vec![[f64::NAN, 0.0, 0.0], [f64::INFINITY, 1.0, 1.0]],
    ];
    for (k, positions) in clouds.into_iter().enumerate() {
        for outline in [Outline::Middle, Outline::Hull, Outline::Voronoi] {
            for planes in
                [Planes::At(vec![0.0, 5.0]), Planes::Count(3), Planes::Adaptive { start: 2, most: 4 }]
            {
                let params = SectionParams { outline, planes, fit: true, ..SectionParams::default() };
                let cloud = Cloud::new(positions.clone());
                let sections = section(&cloud, &params).unwrap();
                check(&sections);
                assert!(sections.sections.iter().all(|s| s.missing.is_some()), "cloud {k}: {sections:?}");
                assert_eq!(stack(&cloud, &sections, &params).unwrap(), Stack::default());
            }
        }
    }
    let far = SectionParams { planes: Planes::At(vec![99.0]), ..SectionParams::default() };
    let empty = section(&scanned(&shapes::tube(), 500, 0.0), &far).unwrap();
    assert_eq!(empty.sections[0].missing, Some(Missing::Empty));
}

#[test]
fn a_plane_along_a_face_or_at_the_rim_is_no_panic() {
    let cloud = scanned(&shapes::cuboid([2.0, 2.0, 2.0]), 6_000, 0.0);
    for z in [-1.0, 1.0, 1.0 - 1e-12, -1.0 + 1e-3, 0.999_999] {
        let params = SectionParams { planes: Planes::At(vec![z]), fit: true, ..SectionParams::default() };
        check(&section(&cloud, &params).unwrap());
    }
}

#[test]
fn parameters_outside_their_range_are_refused_by_name() {
    let cloud = Cloud::default();
    let refused = |params: SectionParams, key: &str| match section(&cloud, &params) {
        Err(Error::Parameter { key: named, .. }) => assert_eq!(named, key),
        other => panic!("{key}: {other:?}"),
    };
    let standard = SectionParams::default;
    refused(SectionParams { planes: Planes::Every(0.0), ..standard() }, "section.planes");
    refused(SectionParams { planes: Planes::At(vec![f64::NAN]), ..standard() }, "section.planes");
    refused(SectionParams { planes: Planes::Count(0), ..standard() }, "section.planes");
    refused(SectionParams { axis: Axis::Vector([0.0; 3]), ..standard() }, "section.axis");
    refused(SectionParams { thickness: Auto::Given(-1.0), ..standard() }, "section.thickness");
    refused(SectionParams { reach_spacings: 0.0, ..standard() }, "section.reach_spacings");
}
