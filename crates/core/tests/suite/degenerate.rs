//! Clouds that are hardly one: a valid network or a named refusal, soon.

use std::time::{Duration, Instant};

use crate::common::{checked, cloud};
use lineament::shapes::{Rng, Sampling, Scan, cube_386, sphere};
use lineament::{Error, Extraction, Method, NodeKind, Params};

const SOON: Duration = Duration::from_secs(5);

type Points = Vec<[f64; 3]>;

/// The result in either form of the penalties, the robust one first. The other methods give a valid network or a refusal
/// as soon.
#[track_caller]
fn both(name: &str, points: &[[f64; 3]]) -> [Result<Extraction, Error>; 2] {
    for method in [Method::Projection, Method::Segments] {
        let start = Instant::now();
        let result = checked(&cloud(points), &Params { method, ..Params::default() });
        assert!(start.elapsed() < SOON, "{name}, {method:?}: {:?}", start.elapsed());
        assert!(!matches!(result, Err(Error::Parameter { .. })), "{name}, {method:?}: {result:?}");
    }
    ["robust", "paper"].map(|form| {
        let mut params = Params::default();
        params.set("penalty.form", form).unwrap();
        let start = Instant::now();
        let result = checked(&cloud(points), &params);
        assert!(start.elapsed() < SOON, "{name}, {form}: {:?}", start.elapsed());
        result
    })
}

#[track_caller]
fn refused(name: &str, points: &[[f64; 3]], what: impl Fn(&Error) -> bool) {
    for result in both(name, points) {
        match result {
            Err(error) => assert!(what(&error), "{name}: {error:?}"),
            Ok(found) => panic!("{name}: {:?}", found.report),
        }
    }
}

#[track_caller]
fn valid(name: &str, points: &[[f64; 3]]) -> [Extraction; 2] {
    both(name, points).map(|result| result.unwrap_or_else(|e| panic!("{name}: {e}")))
}

fn random(count: usize, sides: [f64; 3]) -> Points {
    let mut rng = Rng::new(5);
    (0..count).map(|_| sides.map(|side| side * rng.uniform())).collect()
}

fn map(points: &[[f64; 3]], f: impl Fn(f64) -> f64) -> Points {
    points.iter().map(|p| p.map(&f)).collect()
}

#[test]
fn fewer_than_four_distinct_points_are_too_few() {
    let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let few = |e: &Error| matches!(e, Error::TooFewPoints { needed: 4, .. });
    for count in 0..=3 {
        refused(&format!("{count} points"), &triangle[..count], few);
    }
    refused("coincident", &[[3.0, 4.0, 5.0]; 1000], few);
    refused("three places", &triangle.repeat(300), few);
    refused("NaN", &[[f64::NAN, 0.0, 1.0]; 100], few);
    refused("infinite", &[[f64::INFINITY; 3], [f64::NEG_INFINITY; 3], [0.0; 3]], few);
}

#[test]
fn points_on_a_line_are_collinear() {
    let along = |d: [f64; 3], o: [f64; 3]| -> Points {
        (0..500).map(|i| [0, 1, 2].map(|k| o[k] + f64::from(i) * d[k])).collect()
    };
    let collinear = |e: &Error| matches!(e, Error::Collinear { distinct: 500 });
    refused("along x", &along([0.1, 0.0, 0.0], [0.0; 3]), collinear);
    refused("along z", &along([0.0, 0.0, 2.0], [5.0, 6.0, 7.0]), collinear);
    refused("oblique", &along([1.0, 2.0, 3.0], [0.0; 3]), collinear);
    refused("oblique and rounded", &along([0.1, 0.7, -0.3], [0.1, 0.2, 0.3]), collinear);
    refused("tiny", &along([1e-9, 2e-9, 3e-9], [0.0; 3]), collinear);
    refused("huge", &along([1e9, 2e9, 3e9], [0.0; 3]), collinear);
}

#[test]
fn planes_have_no_crease() {
    let grid: Points = (0..900).map(|i| [f64::from(i % 30), f64::from(i / 30), 0.0]).collect();
    let oblique: Points = grid.iter().map(|&[x, y, _]| [x, y, 0.3 * x - 0.7 * y]).collect();
    let cases = [("grid", grid), ("oblique grid", oblique), ("random", random(2000, [1.0, 1.0, 0.0]))];
    for (name, points) in cases {
        let [robust, _] = valid(name, &points);
        let creases = robust.network.strips.iter().filter(|s| s.kind == lineament::StripKind::Crease);
        assert_eq!(creases.count(), 0, "{name}");
    }
}

#[test]
fn thin_sets_give_valid_networks() {
    let circle: Points = (0..400)
        .map(|i| {
            let (s, c) = (f64::from(i) * std::f64::consts::TAU / 400.0).sin_cos();
            [c, s, 0.0]
        })
        .collect();
    valid("circle", &circle);
    let crossing: Points = (0..400)
        .map(|i| if i % 2 == 0 { [f64::from(i), 200.0, 0.0] } else { [200.0, f64::from(i), 0.0] })
        .collect();
    valid("two lines", &crossing);
    valid("ball", &random(3000, [1.0; 3]));
    valid(
        "grid of a volume",
        &(0..1000).map(|i| [i % 10, i / 10 % 10, i / 100].map(f64::from)).collect::<Points>(),
    );
}

#[test]
fn few_points_in_space_give_a_network_or_a_refusal() {
    let points = random(60, [1.0; 3]);
    for count in 4..60 {
        valid(&format!("{count} points"), &points[..count]);
    }
}

#[test]
fn stretched_clouds_give_valid_networks() {
    valid("sheet 1000:1", &random(3000, [1000.0, 1.0, 0.0]));
    valid("box 1000:1:1", &random(3000, [1000.0, 1.0, 1.0]));
    valid("plate 1000:1000:1", &random(3000, [1000.0, 1000.0, 1.0]));
    let sphere = sphere(1.0).sample(&Scan::new(Sampling::Area { count: 3000 })).cloud.positions;
    valid("needle", &sphere.iter().map(|&[x, y, z]| [x * 1000.0, y, z]).collect::<Points>());
}

#[track_caller]
fn is_the_cube(name: &str, points: &[[f64; 3]]) {
    let [robust, _] = valid(name, points);
    let shape = (robust.network.strips.len(), robust.network.count(NodeKind::Junction));
    assert_eq!(shape, (12, 8), "{name}");
}

#[test]
fn scale_and_offset_leave_the_cube_a_cube() {
    let cube = cube_386().cloud.positions;
    for scale in [1e-130, 1e-9, 1e-3, 1e3, 1e9, 1e140] {
        is_the_cube(&format!("scale {scale:e}"), &map(&cube, |x| x * scale));
    }
    for offset in [1e7, -1e7, 1e9] {
        is_the_cube(&format!("offset {offset:e}"), &map(&cube, |x| x + offset));
    }
}

#[test]
fn extent_whose_square_leaves_f64_is_refused() {
    let cube = cube_386().cloud.positions;
    refused("scale 1e300", &map(&cube, |x| x * 1e300), |e| matches!(e, Error::Extent { .. }));
    refused("scale 1e-300", &map(&cube, |x| x * 1e-300), |e| matches!(e, Error::Extent { .. }));
    refused("scale 1e-310", &map(&cube, |x| x * 1e-310), |_| true);
    // The first two stand for no value beside the others.
    refused("greatest", &[[f64::MAX; 3], [f64::MIN; 3], [0.0; 3], [1.0; 3]], |e| {
        matches!(e, Error::TooFewPoints { distinct: 2, .. })
    });
}

#[test]
fn one_far_point_leaves_the_cube_a_cube() {
    for far in [[30.0, 0.0, 4.0], [1e3, -2e3, 5e2], [1e7; 3]] {
        let [robust, _] = valid(&format!("{far:?}"), &[cube_386().cloud.positions, vec![far]].concat());
        let shape = (robust.network.strips.len(), robust.network.count(NodeKind::Junction));
        assert_eq!(shape, (12, 8), "{far:?}");
    }
}

#[test]
fn two_cubes_far_apart_are_two_cubes() {
    let cube = cube_386().cloud.positions;
    for distance in [10.0, 1e3, 1e6] {
        let points = [cube.clone(), map(&cube, |x| x + distance)].concat();
        let [robust, _] = valid(&format!("{distance:e} apart"), &points);
        let shape = (robust.network.strips.len(), robust.network.count(NodeKind::Junction));
        assert_eq!(shape, (24, 16), "{distance:e} apart");
    }
}

/// Lines that shrink to a point of the written coordinates are left out, and so are the nodes that nothing else meets.
#[test]
fn lines_below_the_resolution_of_far_coordinates_are_left_out() {
    let ladder = (0..48).map(|k| [0.0, 1e-270 * f64::from(k % 5), 10_f64.powi(5 * k - 300)]);
    let far = [[0.0; 3], [0.5, 1.0, 0.25], [1.0, 2.0, 0.5], [1.5, 3.0, 0.0], [0.0, 3.0e-5, 0.0]];
    let points: Points = ladder.chain(far).collect();
    for result in both("heights from 1e-300 to 1e-65 among points 1 apart", &points).into_iter().flatten() {
        assert!(result.network.nodes.iter().all(|node| node.degree > 0));
    }
}

/// Most points lie in a knot 300 orders of magnitude smaller than the rest, and so does the spacing.
#[test]
fn points_of_two_scales_give_a_network_or_a_refusal_by_every_method() {
    let knot = (0..40).map(|i| [i % 8, i % 7, i].map(|c| f64::from(c) * 1e-314));
    let rest = (0..20).map(|i| [f64::from(i) * 0.5, f64::from(i % 7), f64::from(i % 3) * 0.25]);
    let points: Points = knot.chain(rest).collect();
    for method in [Method::Auto, Method::Penalty, Method::Projection, Method::Segments] {
        let params = Params { method, ..Params::default() };
        let start = Instant::now();
        let _ = checked(&cloud(&points), &params);
        assert!(start.elapsed() < SOON, "{method:?}: {:?}", start.elapsed());
    }
}
