//! Faces of patches.

use super::parse::{File, Value};
use lineament::params::Auto;
use lineament::shapes::{Sampling, Scan, Shape, bracket, cube};
use lineament::{Extraction, Method, Params, Patches, extract};
use lineament_io::{NetworkContext, PointTable, write_patches};
use std::collections::BTreeMap;

fn found(shape: &Shape, count: usize) -> Extraction {
    let cloud = shape.sample(&Scan::new(Sampling::Area { count }).seed(1)).cloud;
    let mut params = Params { method: Method::Segments, ..Params::default() };
    params.patches.find = Auto::Given(true);
    extract(&cloud, &params).unwrap()
}

fn written(found: &Extraction, patches: &Patches) -> File {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("faces.stp");
    let context = NetworkContext { patches: Some(patches.clone()), ..NetworkContext::default() };
    let cloud = lineament::Cloud::new(Vec::new());
    let table = PointTable { cloud: &cloud, classes: &[], scores: &[], las: None };
    write_patches(&path, &[], &found.network, &context, &table).unwrap();
    File::parse(&std::fs::read_to_string(&path).unwrap())
}

/// How often each edge is gone along forwards and backwards.
fn uses(file: &File) -> BTreeMap<usize, [usize; 2]> {
    let mut uses = BTreeMap::new();
    for edge in file.all("ORIENTED_EDGE") {
        let backward = usize::from(edge[4] == Value::Word("F".into()));
        uses.entry(File::id(&edge[3])).or_insert([0; 2])[backward] += 1;
    }
    uses
}

/// Vertices lie on the curves of their edges, and edges on the planes and cylinders of their faces, within the stated uncertainty.
fn check_places(file: &File) {
    let stated = File::number(&file.all("UNCERTAINTY_MEASURE_WITH_UNIT")[0][0]);
    for face in file.all("ADVANCED_FACE") {
        let (kind, surface) = file.of(File::id(&face[2]));
        let [at, axis, _] = file.axes(File::id(&surface[1]));
        let bounds = File::ids(&face[1]).into_iter().map(|b| File::id(&file.of(b).1[1]));
        let oriented = bounds.flat_map(|ring| File::ids(&file.of(ring).1[1]));
        for edge in oriented.map(|o| File::id(&file.of(o).1[3])) {
            let [a, b] = [1, 2].map(|k| file.triple(&file.of(File::id(&file.of(edge).1[k])).1[1]));
            let (curve, points) = file.along(File::id(&file.of(edge).1[3]));
            let points = if curve == "LINE" { vec![a, b] } else { [points, vec![a, b]].concat() };
            for p in points {
                let d = [0, 1, 2].map(|k| p[k] - at[k]);
                let height = (0..3).map(|k| d[k] * axis[k]).sum::<f64>();
                let off = match kind {
                    "PLANE" => height.abs(),
                    "CYLINDRICAL_SURFACE" => {
                        let square = d.iter().map(|x| x * x).sum::<f64>() - height * height;
                        (square.sqrt() - File::number(&surface[2])).abs()
                    }
                    _ => panic!("{kind}"),
                };
                assert!(off <= stated * 1.01 + 1e-12, "{off:.1e} off a {kind}, {stated:.1e} stated");
            }
        }
    }
}

#[test]
fn a_cube_and_a_bracket_are_solids_that_share_their_edges() {
    for (shape, count, faces) in [(cube(10.0), 15_000, 6), (bracket(), 60_000, 11)] {
        let found = found(&shape, count);
        let patches = found.patches.as_ref().unwrap();
        let omitted = lineament::patch::brep(&found.network, patches).omitted;
        assert!(omitted.is_empty(), "{omitted:?}");
        let file = written(&found, patches);
        assert_eq!(file.all("ADVANCED_FACE").len(), faces);
        assert_eq!((file.all("CLOSED_SHELL").len(), file.all("OPEN_SHELL").len()), (1, 0));
        assert_eq!(File::ids(&file.all("CLOSED_SHELL")[0][1]).len(), faces);
        assert_eq!(file.all("ADVANCED_BREP_SHAPE_REPRESENTATION").len(), 1);
        let uses = uses(&file);
        assert!(
            uses.len() == file.all("EDGE_CURVE").len() && uses.values().all(|u| *u == [1, 1]),
            "{uses:?}"
        );
        check_places(&file);
    }
}

#[test]
fn what_is_no_face_leaves_an_open_shell() {
    let found = found(&cube(10.0), 15_000);
    let mut patches = found.patches.clone().unwrap();
    patches.patches[0].fit.free = true;
    let file = written(&found, &patches);
    assert_eq!((file.all("ADVANCED_FACE").len(), file.all("CLOSED_SHELL").len()), (5, 0));
    assert_eq!(file.all("OPEN_SHELL").len(), 1);
    assert_eq!(file.all("MANIFOLD_SURFACE_SHAPE_REPRESENTATION").len(), 1);
    assert_eq!(uses(&file).values().filter(|u| u.iter().sum::<usize>() == 1).count(), 4);
    patches.patches.iter_mut().for_each(|p| p.fit.free = true);
    assert!(written(&found, &patches).all("ADVANCED_FACE").is_empty());
}
