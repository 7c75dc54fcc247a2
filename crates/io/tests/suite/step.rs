//! STEP read back: curves with their types, where JSON has them; faces with shared edges.

mod faces;
mod parse;
mod sections;

use crate::common::network;
use lineament::curve::BSpline;
use lineament::{Network, extract, shapes};
use lineament_io::{NetworkContext, NetworkFormat, StepProtocol, Unit, write_network_to};
use parse::{File, Point, Value};
use serde_json::Value as Json;

fn bytes(network: &Network, format: NetworkFormat, context: &NetworkContext) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, format, network, context).unwrap();
    bytes
}

fn written(network: &Network, context: &NetworkContext) -> File {
    File::parse(&String::from_utf8(bytes(network, NetworkFormat::Step, context)).unwrap())
}

fn near(a: Point, b: Point) -> bool {
    (0..3).all(|k| (a[k] - b[k]).abs() < 1e-6)
}

fn point(value: &Json) -> Point {
    [0, 1, 2].map(|k| value[k].as_f64().unwrap())
}

/// Asserts that points run along a typed curve of JSON from end to end.
fn same(kind: &str, points: &[Point], curve: &Json) {
    let number = |key: &str| curve[key].as_f64().unwrap();
    let ends = || near(points[0], point(&curve["from"])) && near(points[32], point(&curve["to"]));
    let on_circle = || {
        let (centre, normal) = (point(&curve["center"]), point(&curve["normal"]));
        points.iter().all(|p| {
            let d = [0, 1, 2].map(|k| p[k] - centre[k]);
            let dot = |a: Point, b: Point| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
            dot(d, normal).abs() < 1e-6 && (dot(d, d).sqrt() - number("radius")).abs() < 1e-6
        })
    };
    let good = match (curve["type"].as_str().unwrap(), kind) {
        ("line", "LINE") => ends(),
        ("circle", "CIRCLE") => on_circle(),
        ("arc", "CIRCLE") => ends() && on_circle(),
        ("ellipse", "ELLIPSE") => number("sweep_deg") == 360.0 || ends(),
        ("b-spline", "B_SPLINE_CURVE_WITH_KNOTS") => {
            let numbers = |key: &str| curve[key].as_array().unwrap().iter();
            let wanted = BSpline {
                degree: number("degree") as usize,
                knots: numbers("knots").map(|v| v.as_f64().unwrap()).collect(),
                controls: numbers("controls").map(point).collect(),
                periodic: curve["periodic"] == true,
            };
            let (from, to) = wanted.domain();
            let at = |k: usize| wanted.point(from + (to - from) * k as f64 / 32.0);
            (0..=32).all(|k| near(points[k], at(k)))
        }
        _ => false,
    };
    assert!(good, "{kind} {points:?} for {curve}");
}

#[test]
fn a_wireframe_is_the_typed_curves_of_its_json_named_and_on_layers() {
    for sample in ["bracket", "pipe-cross"] {
        let scan = (shapes::sample(sample).unwrap().make)(1);
        let found = extract(&scan.cloud, &Default::default()).unwrap().network;
        let file = written(&found, &NetworkContext::default());
        let json = bytes(&found, NetworkFormat::Json, &NetworkContext::default());
        let json: Json = serde_json::from_slice(&json).unwrap();
        let strips = json["strips"].as_array().unwrap();
        let sets = file.all("GEOMETRIC_CURVE_SET");
        assert_eq!(sets.len(), strips.len());
        for (i, (set, strip)) in sets.iter().zip(strips).enumerate() {
            assert_eq!(set[0], Value::Text(format!("{}_{i}", strip["kind"].as_str().unwrap())));
            let (ids, curves) = (File::ids(&set[1]), strip["curves"].as_array().unwrap());
            assert_eq!(ids.len(), curves.len());
            for (id, curve) in ids.into_iter().zip(curves) {
                let (kind, points) = file.along(id);
                same(kind, &points, curve);
            }
        }
        let of_kind = |kind: &str| strips.iter().filter(|s| s["kind"] == kind).count();
        for layer in file.all("PRESENTATION_LAYER_ASSIGNMENT") {
            let Value::Text(name) = &layer[0] else { panic!("{layer:?}") };
            assert_eq!(File::ids(&layer[2]).len(), of_kind(&name.to_lowercase()), "{name}");
        }
        let shape = file.all("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION")[0];
        assert_eq!(File::ids(&shape[1]).len(), strips.len() + 1);
    }
}

#[test]
fn a_strip_without_typed_curves_is_a_polyline_of_its_points() {
    let mut network = network();
    network.strips.iter_mut().for_each(|strip| strip.curves.clear());
    let file = written(&network, &NetworkContext::default());
    let sets = file.all("GEOMETRIC_CURVE_SET");
    for (set, strip) in sets.iter().zip(&network.strips) {
        let (kind, points) = file.along(File::ids(&set[1])[0]);
        let closing = strip.points.first().filter(|_| strip.closed);
        let wanted: Vec<Point> = strip.points.iter().chain(closing).copied().collect();
        assert_eq!((kind, points), ("POLYLINE", wanted));
    }
}

#[test]
fn the_unit_is_that_of_the_input_and_millimetres_where_none_is_known() {
    let of = |unit| written(&network(), &NetworkContext { unit, ..NetworkContext::default() });
    for (unit, prefix) in [
        (None, "MILLI"),
        (Some(Unit::Millimetre), "MILLI"),
        (Some(Unit::Centimetre), "CENTI"),
        (Some(Unit::Metre), "$"),
    ] {
        let lengths: Vec<Value> = of(unit)
            .all("SI_UNIT")
            .iter()
            .filter(|u| u[1] == Value::Word("METRE".into()))
            .map(|u| u[0].clone())
            .collect();
        assert_eq!(lengths, [Value::Word(prefix.into())], "{unit:?}");
    }
    for (unit, name, millimetres) in [(Unit::Inch, "INCH", 25.4), (Unit::Foot, "FOOT", 304.8)] {
        let file = of(Some(unit));
        let own = file.all("CONVERSION_BASED_UNIT")[0];
        assert_eq!(own[0], Value::Text(name.into()));
        assert_eq!(File::number(&file.of(File::id(&own[1])).1[0]), millimetres);
        let context = file.all("GLOBAL_UNIT_ASSIGNED_CONTEXT")[0];
        let length = &file.instances[&File::ids(&context[0])[0]];
        assert_eq!(length[0].0, "CONVERSION_BASED_UNIT");
    }
}

#[test]
fn the_protocol_is_that_asked_for_and_nothing_tells_the_time() {
    let of = |step| written(&network(), &NetworkContext { step, ..NetworkContext::default() }).header;
    assert!(of(StepProtocol::Ap242).contains("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"));
    assert!(of(StepProtocol::Ap214).contains("AUTOMOTIVE_DESIGN"));
    assert_eq!(of(StepProtocol::Ap242), of(StepProtocol::Ap242));
}

#[test]
fn names_are_written_in_ascii() {
    let name = "it's \u{e9}.ply".to_string();
    let file = written(&network(), &NetworkContext { input_name: name, ..NetworkContext::default() });
    assert!(file.header.contains("'it''s \\X4\\000000E9\\X0\\.ply'"), "{}", file.header);
}
