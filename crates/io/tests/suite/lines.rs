//! Lines read back from what the writers write, and from what other programs write.

use crate::common::network;
use lineament::curve::Ellipse;
use lineament::curve::pieces::{Piece, Shape};
use lineament::evaluate::{CurveKind, LineKind, Lines, Scoring, score};
use lineament::{extract, shapes};
use lineament_io::{LineFile, NetworkContext, read_lines, write_network};
use std::path::PathBuf;

/// The lines of a text in a file of this name.
fn of(name: &str, text: &str) -> Result<LineFile, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    read_lines(&path, 30.0).map_err(|e| e.to_string())
}

fn lengths(lines: &Lines) -> f64 {
    let apart = |w: &[[f64; 3]]| (0..3).map(|k| (w[1][k] - w[0][k]).powi(2)).sum::<f64>().sqrt();
    lines.lines.iter().map(|l| l.points.windows(2).map(apart).sum::<f64>()).sum()
}

/// Part of an ellipse, tilted in space, and a whole one, are read back from every format of typed curves as they are.
#[test]
fn ellipses_are_the_same_in_json_dxf_and_step() {
    let normal = [0.0, 0.6, 0.8];
    let ellipse = Ellipse { centre: [5.0, -3.0, 2.0], normal, major: [0.0, 4.0, -3.0], minor: 2.0 };
    let mut network = network();
    network.strips.truncate(1);
    let strip = &mut network.strips[0];
    let last = strip.points.len() - 1;
    let piece = |first: f64, sweep: f64| {
        let [from, to] = [ellipse.at(first), ellipse.at(first + sweep)];
        let shape = Shape::Ellipse { ellipse, sweep };
        Piece { shape, from, to, first: 0, last, deviation: 0.0, sigma: None }
    };
    strip.curves = vec![piece(5.5, 2.5), piece(1.0, std::f64::consts::TAU)];
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.dxf", "a.step", "a.json"] {
        let path = folder.path().join(name);
        write_network(&path, &[], &network, &NetworkContext::default()).unwrap();
        let read = read_lines(&path, 30.0).unwrap();
        let curves: Vec<_> = read.lines.curves.iter().filter(|c| c.kind == CurveKind::Ellipse).collect();
        assert_eq!(curves.len(), 2, "{name}");
        if name == "a.json" {
            continue;
        }
        for (curve, piece) in curves.iter().zip(&network.strips[0].curves) {
            let apart = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
            let Shape::Ellipse { sweep, .. } = piece.shape else { panic!() };
            let count = curve.points.len();
            // A whole one may begin anywhere.
            let first = ellipse.angle(curve.points[0]);
            for (k, &p) in curve.points.iter().enumerate() {
                let wanted = ellipse.at(first + sweep * k as f64 / (count - 1) as f64);
                assert!(apart(p, wanted) < 1e-9, "{name}: {p:?} for {wanted:?}");
            }
            assert!(sweep > 6.0 || apart(curve.points[0], piece.from) < 1e-9, "{name}");
        }
    }
}

#[test]
fn a_network_is_the_same_lines_in_every_format() {
    let part = shapes::bracket().sample(&shapes::Scan::new(shapes::Sampling::Area { count: 12_000 }));
    let network = extract(&part.cloud, &Default::default()).unwrap().network;
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| {
        let path: PathBuf = folder.path().join(name);
        let context = NetworkContext { spacing: part.spacing, ..NetworkContext::default() };
        write_network(&path, &[], &network, &context).unwrap();
        read_lines(&path, 30.0).unwrap()
    };
    let json = read("a.json");
    assert!(json.lines == Lines::from(&network), "JSON gives other lines back");
    assert_eq!(json.spacing, Some(part.spacing));
    for (name, typed) in [("a.dxf", true), ("a.step", true), ("a.obj", false)] {
        let file = read(name);
        assert_eq!(file.ignored, Vec::<String>::new(), "{name}");
        let scoring = Scoring { tolerances: &[1e-2], ..Scoring::new(part.spacing) };
        // Pieces leave the points that they stand for by the noise; between formats there is none.
        let found = score(&file.lines, &json.lines, &scoring);
        assert_eq!(found.at_1h.f1, 1.0, "{name}: {found:?}");
        let chamfer = found.chamfer.unwrap();
        assert!(chamfer.cd < 1e-4, "{name}: {chamfer:?}");
        assert_eq!(found.types.map(|t| t.right > 0.99), typed.then_some(true), "{name}");
        if typed {
            assert!(found.types.unwrap().radius_error < 1e-9, "{name}");
        } else {
            assert_eq!(found.at[0].1.f1, 1.0, "{name}");
        }
    }
    let [dxf, step] = ["a.dxf", "a.step"].map(|name| read(name).lines);
    let vertices =
        |lines: &Lines| -> Vec<[f64; 3]> { lines.lines.iter().flat_map(|l| l.points.clone()).collect() };
    let [dxf, step] = [vertices(&dxf), vertices(&step)];
    let off = |p: &[f64; 3], q: &[f64; 3]| (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max);
    let near = |p: &[f64; 3], all: &[[f64; 3]]| all.iter().any(|q| off(p, q) < 1e-6 * part.spacing);
    assert!(dxf.iter().all(|p| near(p, &step)) && step.iter().all(|p| near(p, &dxf)));
}

#[test]
fn rounded_edges_come_back_with_their_radius_and_count_as_no_lines() {
    let outline = shapes::rounded_rectangle([80.0, 60.0], 3.0);
    let part = shapes::walls("rounded", &[outline], 20.0);
    let part = part.sample(&shapes::Scan::new(shapes::Sampling::BlueNoise { count: 7000 }));
    let network = extract(&part.cloud, &Default::default()).unwrap().network;
    let known = Lines::from(&network);
    assert_eq!(known.rounded.len(), 4);
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.json", "a.dxf", "a.step", "a.obj"] {
        let path: PathBuf = folder.path().join(name);
        write_network(&path, &[], &network, &NetworkContext::default()).unwrap();
        let lines = read_lines(&path, 30.0).unwrap().lines;
        let weak = lines.lines.iter().filter(|l| l.kind == LineKind::Weak).count();
        let rounded = if name == "a.json" { lines.rounded.len() } else { weak };
        assert_eq!(rounded, 4, "{name}");
        if name == "a.json" {
            assert!(lines == known);
        }
    }
}

#[test]
fn drawings_of_other_programs_are_read() {
    let text = "999\nby hand\n0\nSECTION\n2\nBLOCKS\n0\nLINE\n10\n7\n20\n7\n11\n9\n21\n9\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n\
        0\nLWPOLYLINE\n8\nBorder edges\n90\n3\n70\n1\n38\n2.5\n10\n0\n20\n0\n10\n4\n20\n0\n42\n1\n10\n4\n20\n2\n210\n0\n220\n0\n230\n-1\n\
        0\nPOLYLINE\n66\n1\n70\n8\n0\nVERTEX\n10\n0\n20\n0\n30\n0\n0\nVERTEX\n10\n0\n20\n0\n30\n3\n0\nSEQEND\n\
        0\nELLIPSE\n10\n0\n20\n0\n30\n0\n11\n3\n21\n0\n31\n0\n40\n0.5\n41\n0\n42\n3.141592653589793\n\
        0\nARC\n10\n1\n20\n0\n30\n0\n40\n2\n50\n350\n51\n10\n\
        0\nSPLINE\n70\n8\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n30\n0\n10\n1\n20\n2\n30\n0\n10\n2\n20\n0\n30\n0\n\
        0\nINSERT\n2\nBLOCK\n0\nPOINT\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n";
    let LineFile { lines, ignored, .. } = of("a.dxf", text).unwrap();
    assert_eq!(ignored, ["1 entities INSERT"]);
    let kinds: Vec<CurveKind> = lines.curves.iter().map(|c| c.kind).collect();
    use CurveKind::*;
    assert_eq!(kinds, [Line, Circle, Line, Line, Ellipse, Circle, Spline]);
    assert!(lines.lines[..3].iter().all(|l| l.kind == LineKind::Border));
    // Seen from below: x runs backwards, the height is below.
    assert_eq!(lines.lines[0].points[1], [-4.0, 0.0, -2.5]);
    let half = &lines.curves[1];
    assert!((half.radius.unwrap() - 1.0).abs() < 1e-12);
    let outermost = half.points.iter().map(|p| p[0]).fold(0.0, f64::min);
    assert!((outermost + 5.0).abs() < 1e-4, "{outermost}");
    assert!((half.points[half.points.len() / 2][1] - 1.0).abs() < 1e-2);
    let arc = &lines.curves[5].points;
    assert!((arc[0][1] + 2.0 * 10f64.to_radians().sin()).abs() < 1e-9 && arc.len() == 41);
    assert!(lines.curves[4].points.iter().all(|p| p[1] > -1e-9));
}

#[test]
fn edges_of_solids_in_step_are_read_with_angles_in_degrees() {
    let text = "ISO-10303-21;\nHEADER;\nFILE_NAME('DATA;','',(''),(''),'','','');\nENDSEC;\nDATA;\n\
        #1=CARTESIAN_POINT('',(1.,0.,0.)); /* #9= */ #2=CARTESIAN_POINT('',(0.,1.,0.));#3=CARTESIAN_POINT('',(0.,0.,0.));\n\
        #4=AXIS2_PLACEMENT_3D('',#3,$,$);#5=CIRCLE('',#4,1.);\n\
        #6=VERTEX_POINT('',#1);#7=VERTEX_POINT('',#2);#8=EDGE_CURVE('',#7,#6,#5,.F.);\n\
        #10=DIRECTION('',(0.,0.,2.));#11=VECTOR('',#10,3.);#12=LINE('',#3,#11);#13=EDGE_CURVE('',#6,#7,#20,.T.);\n\
        #20=SURFACE_CURVE('',#21,(),.CURVE_3D.);\n\
        #21=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#1,#22,#2),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)\n\
        CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.7071067811865476,1.))REPRESENTATION_ITEM(''));\n\
        #22=CARTESIAN_POINT('',(1.,1.,0.));\n";
    let end = "ENDSEC;\nEND-ISO-10303-21;\n";
    let edges = of("a.stp", &format!("{text}{end}")).unwrap();
    assert_eq!(edges.lines.lines.len(), 2);
    assert_eq!(edges.ignored.len(), 1);
    for line in &edges.lines.lines {
        let near = |p: &[f64; 3]| (p[0].hypot(p[1]) - 1.0).abs() < 1e-9 && p[0] > -1e-9 && p[1] > -1e-9;
        assert!(line.points.iter().all(near), "{line:?}");
    }
    let set = "#30=TRIMMED_CURVE('',#5,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(90.)),.T.,.PARAMETER.);\n\
        #31=TRIMMED_CURVE('',#12,(#3),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);\n\
        #32=GEOMETRIC_CURVE_SET('border_1',(#30,#31,#1));\n\
        #33=CONVERSION_BASED_UNIT('DEGREE',#34);#34=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925),#35);\n";
    let set = of("a.step", &format!("{text}{set}{end}")).unwrap();
    assert_eq!(set.ignored, ["1 items of sets that are no curves"]);
    assert!((lengths(&set.lines) - (std::f64::consts::FRAC_PI_2 + 6.0)).abs() < 1e-4);
    assert!(set.lines.lines.iter().all(|l| l.kind == LineKind::Border));
}

#[test]
fn a_mesh_stands_for_its_edges_in_every_format() {
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n\
        facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n\
        facet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 1\nvertex 1 0 0\nendloop\nendfacet\nendsolid a\n";
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nf 1 2 3 4\nf 1 5 2\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\nelement face 2\n\
        property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 1\n4 0 1 2 3\n3 0 4 1\n";
    let found = [("a.stl", stl), ("a.obj", obj), ("a.ply", ply)].map(|(name, text)| of(name, text).unwrap());
    for file in &found {
        let creases = file.lines.lines.iter().filter(|l| l.kind == LineKind::Crease).count();
        assert_eq!((creases, file.lines.lines.len()), (1, 6), "{}", file.format);
        assert!(file.lines == found[0].lines, "{} gives other lines", file.format);
    }
}

#[test]
fn what_holds_no_lines_is_refused_with_its_name_and_place() {
    for (name, text, part) in [
        ("a.xyz", "0 0 0\n1 0 0\n", "without faces"),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n",
            "without faces",
        ),
        ("a.json", "{\"schema\": 1}", "no list of lines"),
        ("a.json", "{\"strips\": [{\"points\": [[0, 0, 0], [1, 2]]}]}", "strips[0].points[1]"),
        ("a.json", "{\"strips\": [\n{]", "line 2"),
        ("a.obj", "v 0 0 0\nl 1 2\n", "line 2"),
        ("a.obj", "v 0 0 0\nv nan 0 0\nl 1 2\n", "NaN"),
        ("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n0\nEOF\n", "line 8"),
        ("a.dxf", "0\nSECTION\n2\nENTITIES\n", "EOF"),
        ("a.step", "ISO-10303-21;\nDATA;\n#1=POLYLINE('',(#2,#3)\n", "byte"),
        (
            "a.step",
            "ISO-10303-21;\nDATA;\n#1=TRIMMED_CURVE('',#1,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);#2=GEOMETRIC_SET('',(#1));ENDSEC;",
            "without end",
        ),
        ("a.json", "", "empty"),
    ] {
        let error = of(name, text).unwrap_err();
        assert!(error.contains(part) && error.contains(name), "{part} in {error}");
    }
}

#[test]
fn a_file_that_is_cut_anywhere_gives_an_answer() {
    let part = shapes::cube(1.0);
    let cloud = part.sample(&shapes::Scan::new(shapes::Sampling::Area { count: 2000 })).cloud;
    let network = extract(&cloud, &Default::default()).unwrap().network;
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.dxf", "a.step", "a.json", "a.obj"] {
        let path = folder.path().join(name);
        write_network(&path, &[], &network, &NetworkContext::default()).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        for end in (0..bytes.len()).step_by((bytes.len() / 150).max(1)) {
            std::fs::write(&path, &bytes[..end]).unwrap();
            let _ = read_lines(&path, 30.0);
        }
    }
}
