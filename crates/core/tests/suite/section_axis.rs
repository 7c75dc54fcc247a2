//! The automatic axis: along the faces of a part or about its own axis, however the part lies.

use lineament::Cloud;
use lineament::section::{Axis, Planes, SectionParams, section};
use lineament::shapes::{self, Rng, Sampling, Scan, Shape};

const COUNT: usize = 20_000;
/// So many that the bores of a plate are ten spacings wide and more.
const PLATE: usize = 40_000;
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const X: [f64; 3] = [1.0, 0.0, 0.0];

/// A rotation matrix from a quaternion.
fn rotation([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    let n = w * w + x * x + y * y + z * z;
    let entry = |a: f64| a / n;
    [
        [entry(w * w + x * x - y * y - z * z), entry(2.0 * (x * y - w * z)), entry(2.0 * (x * z + w * y))],
        [entry(2.0 * (x * y + w * z)), entry(w * w - x * x + y * y - z * z), entry(2.0 * (y * z - w * x))],
        [entry(2.0 * (x * z - w * y)), entry(2.0 * (y * z + w * x)), entry(w * w - x * x - y * y + z * z)],
    ]
}

fn turned(m: &[[f64; 3]; 3], p: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| (0..3).map(|k| m[i][k] * p[k]).sum())
}

/// The axis found on a part that is turned and moved, turned back.
fn found(shape: &Shape, count: usize, noise: f64, quaternion: [f64; 4]) -> [f64; 3] {
    let scan = Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(1);
    let m = rotation(quaternion);
    let moved = |p| {
        let [x, y, z] = turned(&m, p);
        [x + 30.0, y - 50.0, z + 70.0]
    };
    let axis = axis_of(&shape.sample(&scan).map(1.0, moved).cloud, Axis::Faces);
    [0, 1, 2].map(|i| (0..3).map(|k| m[k][i] * axis[k]).sum())
}

fn axis_of(cloud: &Cloud, axis: Axis) -> [f64; 3] {
    let params = SectionParams { axis, planes: Planes::Count(1), ..SectionParams::default() };
    section(cloud, &params).unwrap().frame.axes[2]
}

/// Degrees between two directions of either sign.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot: f64 = (0..3).map(|k| a[k] * b[k]).sum();
    dot.abs().min(1.0).acos().to_degrees()
}

const TURNS: [[f64; 4]; 3] = [[1.0, 0.0, 0.0, 0.0], [0.8, 0.3, -0.5, 0.2], [0.1, -0.7, 0.4, 0.6]];

#[test]
fn parts_with_one_axis_are_cut_across_it() {
    let turned_parts = [shapes::stepped_shaft(), shapes::flange(), shapes::torus(1.0, 0.4), shapes::tube()];
    let extruded = [shapes::star_prism(5), shapes::hex_nut(), shapes::keyed_shaft(), shapes::cone(1.0, 2.0)];
    let round = [shapes::dome(1.0), shapes::tapered_hub()];
    // Each combination of turn and noise in its turn.
    let cases = (0..6).cycle().map(|k| (TURNS[k % 3], [0.0, 0.25][k % 2]));
    for (shape, (quaternion, noise)) in turned_parts.iter().chain(&extruded).chain(&round).zip(cases) {
        let off = apart(found(shape, COUNT, noise, quaternion), Z);
        assert!(off < 1.0, "{}, noise {noise}: {off} degrees", shape.name);
    }
}

#[test]
fn parts_with_faces_square_to_each_other_are_cut_square_to_them() {
    let parts = [shapes::bracket(), shapes::crossed_bores(), shapes::ribbed_bracket(), shapes::manifold()];
    for (shape, quaternion) in parts.iter().zip(TURNS.into_iter().cycle()) {
        let axis = found(shape, COUNT, 0.1, quaternion);
        let most = axis.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(most.acos().to_degrees() < 1.0, "{}: {axis:?}", shape.name);
    }
}

#[test]
fn of_axes_as_good_the_one_of_fewest_changes_is_taken_and_then_the_longest() {
    // Along a channel nothing changes; a bar has two ends each way.
    assert!(apart(found(&shapes::channel(), COUNT, 0.1, TURNS[1]), X) < 1.0);
    assert!(apart(found(&shapes::cuboid([5.0, 2.0, 1.0]), COUNT, 0.1, TURNS[1]), X) < 1.0);
    // Holes tell a plate's axis.
    assert!(apart(found(&shapes::counterbored_plate(), PLATE, 0.1, TURNS[2]), Z) < 1.0);
}

#[test]
fn without_faces_the_longest_principal_axis_is_taken() {
    let mut rng = Rng::new(2);
    let blob = (0..4000).map(|_| [1.0, 1.0, 3.0].map(|wide| wide * rng.gaussian())).collect();
    let blob = Cloud::new(blob);
    assert!(apart(axis_of(&blob, Axis::Faces), axis_of(&blob, Axis::Principal)) < 1e-9);
}

#[test]
fn the_order_of_the_points_does_not_count() {
    let scan = Scan::new(Sampling::Area { count: 6000 }).noise(0.2).seed(4);
    let cloud = shapes::bracket().sample(&scan).cloud;
    let mut positions = cloud.positions.clone();
    positions.reverse();
    assert_eq!(axis_of(&cloud, Axis::Faces), axis_of(&Cloud::new(positions), Axis::Faces));
}
