//! Points sampled on meshes, whose own folds are creases.

use lineament::mesh::{Faces, MeshPoints, MeshSample, sample};
use lineament::{Extraction, Params, check, extract, extract_sampled};

/// A sheet in pleats of width 1 along y, whose sides fold by some 60 degrees, 30 of them and 30 long; the faces from the last to the first if
/// `back`.
fn pleats(back: bool) -> (Vec<[f64; 3]>, Faces) {
    let vertex = |i: u32| {
        let (k, side) = (i / 2, i % 2);
        [0.875 * f64::from(k), 30.0 * f64::from(side), 0.5 * f64::from(k % 2)]
    };
    let mut faces = Faces::default();
    let halves = |k: u32| [[2 * k, 2 * k + 1, 2 * k + 3], [2 * k, 2 * k + 3, 2 * k + 2]];
    let mut all: Vec<[u32; 3]> = (0..30).flat_map(halves).collect();
    if back {
        all.reverse();
        all.iter_mut().for_each(|face| face.rotate_left(1));
    }
    all.iter().for_each(|face| faces.push(face));
    ((0..62).map(vertex).collect(), faces)
}

/// Two points to the width of a pleat.
fn sampled((vertices, faces): &(Vec<[f64; 3]>, Faces)) -> MeshSample {
    sample(vertices, faces, MeshPoints::Sampled(3600)).unwrap()
}

fn found(mesh: &MeshSample, params: &Params) -> Extraction {
    let found = extract_sampled(&mesh.points, &mesh.folds, params, &|_| ()).unwrap();
    check::network(&found.network).unwrap();
    found
}

/// The share of the folds within a spacing of a crease.
fn recall(found: &Extraction, mesh: &MeshSample) -> f64 {
    let creases = || found.network.strips.iter().filter(|s| s.kind == lineament::StripKind::Crease);
    let (mut met, mut all) = (0, 0);
    for fold in &mesh.folds {
        for k in 0..=60 {
            let [p, q] = fold.ends;
            let place: [f64; 3] = std::array::from_fn(|a| p[a] + (q[a] - p[a]) * f64::from(k) / 60.0);
            let off = |p: &[f64; 3]| (0..3).map(|a| (p[a] - place[a]).powi(2)).sum::<f64>().sqrt();
            met += usize::from(creases().flat_map(|s| &s.points).any(|p| off(p) <= mesh.spacing));
            all += 1;
        }
    }
    met as f64 / f64::from(all)
}

#[test]
fn folds_between_facets_of_two_spacings_are_creases() {
    let mesh = sampled(&pleats(false));
    assert_eq!(mesh.folds.len(), 29);
    let turn = 2.0 * (0.5_f64 / 0.875).atan();
    assert!(mesh.folds.iter().all(|fold| (fold.turn() - turn).abs() < 1e-9));
    let known = found(&mesh, &Params::default());
    assert!(recall(&known, &mesh) > 0.98, "{}", recall(&known, &mesh));
    // Away from the borders, where lines of the points end, every crease lies where the sheet folds.
    let inner = |p: &&[f64; 3]| (3.0..27.0).contains(&p[1]) && (3.0..23.0).contains(&p[0]);
    for strip in known.network.strips.iter().filter(|s| s.kind == lineament::StripKind::Crease) {
        let off = strip.points.iter().filter(inner).map(|p| p[2].abs().min((0.5 - p[2]).abs()));
        assert!(off.fold(0.0, f64::max) < 0.1 * mesh.spacing, "{:?}", strip.points);
        assert!((strip.fold_deg.unwrap() - turn.to_degrees()).abs() < 10.0);
    }
}

#[test]
fn folds_are_left_to_the_points_if_that_is_asked_for() {
    let mesh = sampled(&pleats(false));
    let mut params = Params::default();
    params.edgelets.folds = false;
    let without = found(&mesh, &params);
    assert_eq!(without.network, extract(&mesh.points, &Params::default()).unwrap().network);
    assert!(recall(&without, &mesh) < 0.9, "{}", recall(&without, &mesh));
}

#[test]
fn folds_count_where_there_are_points_alone() {
    let mut mesh = sampled(&pleats(false));
    mesh.points.retain(|p| p[0] < 12.0);
    let creases = found(&mesh, &Params::default()).network.strips;
    let farthest = creases.iter().flat_map(|s| &s.points).map(|p| p[0]).fold(0.0, f64::max);
    assert!((11.0..13.6).contains(&farthest), "{farthest}");
}

#[test]
fn creases_of_a_mesh_depend_on_its_surface_alone() {
    let [first, second] =
        [false, true].map(|back| found(&sampled(&pleats(back)), &Params::default()).network);
    assert_eq!(first, second);
}
