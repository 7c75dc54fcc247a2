//! DXF read back: every entity with its type, and where JSON has it.

mod parse;
mod sections;

use crate::common::network;
use lineament::curve::BSpline;
use lineament::shapes::{Sampling, Scan};
use lineament::{Extraction, Method, Network, Params, extract, shapes};
use lineament_io::{NetworkContext, NetworkFormat, PointTable, Unit, write_network_to, write_patches};
use parse::{Drawing, Point, near};
use serde_json::Value;

fn written(network: &Network, context: &NetworkContext) -> Drawing {
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, NetworkFormat::Dxf, network, context).unwrap();
    let drawing = Drawing::parse(&String::from_utf8(bytes).unwrap());
    drawing.check_handles();
    drawing
}

fn bracket(method: Method) -> Extraction {
    found("bracket", method)
}

fn found(sample: &str, method: Method) -> Extraction {
    let scan = (shapes::sample(sample).unwrap().make)(1);
    let mut params = Params { method, ..Params::default() };
    params.patches.find = lineament::params::Auto::Given(true);
    extract(&scan.cloud, &params).unwrap()
}

fn json(network: &Network, context: &NetworkContext) -> Value {
    let mut bytes = Vec::new();
    write_network_to(&mut bytes, NetworkFormat::Json, network, context).unwrap();
    serde_json::from_slice(&bytes).unwrap()
}

fn point(value: &Value) -> Point {
    [0, 1, 2].map(|k| value[k].as_f64().unwrap())
}

/// Asserts that an entity is a typed curve of JSON.
fn same(entity: &parse::Entity, curve: &Value) {
    let number = |key: &str| curve[key].as_f64().unwrap();
    let centred = || near(entity.world(entity.place(10)), point(&curve["center"]));
    let radius = || (entity.real(40) - number("radius")).abs() < 1e-6;
    let whole = curve["sweep_deg"] == 360.0;
    match curve["type"].as_str().unwrap() {
        "line" => {
            assert_eq!(entity.kind, "LINE");
            let wanted = [point(&curve["from"]), point(&curve["to"])];
            assert!(
                near(entity.place(10), wanted[0]) && near(entity.place(11), wanted[1]),
                "{entity:?} {curve}"
            );
        }
        "ellipse" => oval(entity, curve),
        kind if kind == "circle" || whole => {
            assert_eq!(entity.kind, "CIRCLE");
            assert!(
                radius() && centred() && near(entity.place(210), point(&curve["normal"])),
                "{entity:?} {curve}"
            );
        }
        "arc" => {
            assert_eq!(entity.kind, "ARC");
            let (from, to) = (entity.on_circle(entity.real(50)), entity.on_circle(entity.real(51)));
            assert!(radius() && centred() && near(from, point(&curve["from"])), "{entity:?} {curve}");
            assert!(near(to, point(&curve["to"])), "{entity:?} {curve}");
            let sweep = (entity.real(51) - entity.real(50)).rem_euclid(360.0);
            assert!((sweep - number("sweep_deg")).abs() < 1e-6, "{entity:?} {curve}");
        }
        _ => free(entity, curve),
    }
}

/// Asserts that a spline is that of JSON.
fn free(entity: &parse::Entity, curve: &Value) {
    let number = |key: &str| curve[key].as_f64().unwrap();
    assert_eq!((entity.kind.as_str(), entity.real(71)), ("SPLINE", number("degree")));
    let reals = |key: &str| curve[key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap());
    let read = |periodic, knots: Vec<f64>, controls| BSpline {
        degree: entity.real(71) as usize,
        knots,
        controls,
        periodic,
    };
    let controls = curve["controls"].as_array().unwrap().iter().map(point).collect();
    let wanted = read(curve["periodic"] == true, reals("knots").collect(), controls);
    let found = read(false, entity.reals(40), entity.places(10));
    let (from, to) = wanted.domain();
    let at = |k: u8| from + (to - from) * f64::from(k) / 50.0;
    assert!((0..=50).all(|k| near(wanted.point(at(k)), found.point(at(k)))), "{entity:?} {curve}");
    assert_eq!(entity.real(72) - entity.real(73) - entity.real(71), 1.0);
}

/// Asserts that an ellipse is that of JSON.
fn oval(entity: &parse::Entity, curve: &Value) {
    let number = |key: &str| curve[key].as_f64().unwrap();
    assert_eq!(entity.kind, "ELLIPSE");
    let (major, normal) = (entity.place(11), entity.place(210));
    assert!(near(entity.place(10), point(&curve["center"])) && near(major, point(&curve["major"])));
    let [x, y, z] = major;
    let minor = entity.real(40) * (x * x + y * y + z * z).sqrt();
    assert!(near(normal, point(&curve["normal"])) && (minor - number("minor")).abs() < 1e-6, "{curve}");
    let sweep = (entity.real(42) - entity.real(41)).rem_euclid(std::f64::consts::TAU).to_degrees();
    assert!(
        (sweep - number("sweep_deg")).abs() < 1e-6 || (sweep == 0.0 && number("sweep_deg") == 360.0),
        "{entity:?} {curve}"
    );
}

#[test]
fn a_network_is_the_typed_curves_of_its_json() {
    let mut kinds = agrees(&bracket(Method::Auto).network);
    kinds.extend(agrees(&found("equal-cylinders", Method::Auto).network));
    let scan = Scan::new(Sampling::BlueNoise { count: 12_000 });
    let slots = shapes::slotted_plate().sample(&scan);
    kinds.extend(agrees(&extract(&slots.cloud, &Params::default()).unwrap().network));
    let has = |kind: &&str| kinds.iter().any(|k| k == kind);
    assert!(["LINE", "ARC", "CIRCLE", "ELLIPSE"].iter().all(has), "{kinds:?}");
}

/// Holds the drawing of a network against its JSON; returns the kinds of its curves.
fn agrees(network: &Network) -> Vec<String> {
    let drawing = written(network, &NetworkContext::default());
    let json = json(network, &NetworkContext::default());
    let mut entities = drawing.entities.iter();
    let mut kinds = Vec::new();
    for strip in json["strips"].as_array().unwrap() {
        for curve in strip["curves"].as_array().unwrap() {
            let entity = entities.next().unwrap();
            assert_eq!(entity.layer, strip["kind"].as_str().unwrap().to_uppercase());
            same(entity, curve);
            kinds.push(entity.kind.clone());
        }
    }
    for node in json["nodes"].as_array().unwrap() {
        let entity = entities.next().unwrap();
        assert!(entity.kind == "POINT" && near(entity.place(10), point(&node["position"])));
        assert_eq!(entity.layer, node["kind"].as_str().unwrap().to_uppercase());
    }
    assert!(entities.next().is_none());
    kinds
}

#[test]
fn map_coordinates_and_splines_are_given_back_bit_for_bit() {
    let network = network();
    let drawing = written(&network, &NetworkContext::default());
    let json = json(&network, &NetworkContext::default());
    let curves = json["strips"][0]["curves"].as_array().unwrap();
    for (entity, curve) in drawing.entities.iter().zip(curves).filter(|(_, c)| c["type"] != "arc") {
        same(entity, curve);
    }
    assert_eq!(drawing.entities[0].place(10), network.strips[0].points[0]);
    assert_eq!(drawing.entities[4].places(10)[1], [1.0 / 3.0, 5648349.895035, -1e-9]);
    assert_eq!(drawing.corner("$EXTMAX")[1], 5648349.895035);
}

#[test]
fn a_strip_without_typed_curves_is_a_polyline_in_space() {
    let mut network = network();
    network.strips.iter_mut().for_each(|strip| strip.curves.clear());
    let drawing = written(&network, &NetworkContext::default());
    let flags: Vec<f64> = drawing.of_kind("POLYLINE").iter().map(|e| e.real(70)).collect();
    assert_eq!(flags, [8.0, 8.0, 9.0]);
    let vertices = drawing.of_kind("VERTEX");
    let points: Vec<Point> = network.strips.iter().flat_map(|s| s.points.clone()).collect();
    assert_eq!(vertices.iter().map(|v| v.place(10)).collect::<Vec<Point>>(), points);
    assert!(vertices.iter().all(|v| v.real(70) == 32.0) && vertices[10].layer == "BORDER");
    assert_eq!((drawing.of_kind("SEQEND").len(), drawing.of_kind("POINT").len()), (3, 2));
    assert_eq!((drawing.corner("$EXTMIN"), drawing.corner("$EXTMAX")[0]), ([0.1, 0.0, -1e-9], 6.0));
}

#[test]
fn a_periodic_spline_is_clamped_and_marked_as_closed() {
    use lineament::curve::pieces::Shape;
    let mut network = network();
    let controls = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.5]];
    let curve = BSpline { degree: 3, knots: vec![0.0, 1.0, 2.5, 3.0, 4.0], controls, periodic: true };
    network.strips[2].curves.truncate(1);
    network.strips[2].curves[0].shape = Shape::Spline(curve.clone());
    let drawing = written(&network, &NetworkContext::default());
    let splines = drawing.of_kind("SPLINE");
    let spline = splines.last().unwrap();
    assert_eq!((spline.real(70), spline.real(72), spline.real(73)), (1.0, 11.0, 7.0));
    let read = BSpline { degree: 3, knots: spline.reals(40), controls: spline.places(10), periodic: false };
    for t in (0..=40).map(|i| 0.1 * f64::from(i)) {
        assert!(near(read.point(t), curve.point(t)), "{t}");
    }
}

#[test]
fn the_unit_is_stated_and_scales_nothing() {
    let network = network();
    let of = |unit, crs: Option<&str>| {
        let drawing =
            written(&network, &NetworkContext { unit, crs: crs.map(Into::into), ..Default::default() });
        assert_eq!(drawing.entities[0].place(10), network.strips[0].points[0]);
        let variable = |name| drawing.variable(name).unwrap()[0].1.parse::<u8>().unwrap();
        (variable("$INSUNITS"), variable("$MEASUREMENT"))
    };
    let known: Vec<(u8, u8)> = Unit::ALL.iter().map(|&unit| of(Some(unit), None)).collect();
    assert_eq!(known, [(4, 1), (5, 1), (6, 1), (1, 0), (2, 0), (21, 0)]);
    assert_eq!(of(None, None).0, 0);
    assert_eq!(of(None, Some("EPSG:25832")), (6, 1));
    assert_eq!((of(None, Some("EPSG:2056")), of(None, Some("EPSG:2263"))), ((6, 1), (21, 0)));
    assert_eq!(of(Some(Unit::Foot), Some("EPSG:25832")), (2, 0));
}

#[test]
fn the_tables_and_blocks_of_the_release_are_there() {
    for network in [network(), Network::default()] {
        let drawing = written(&network, &NetworkContext::default());
        assert_eq!(drawing.variable("$ACADVER").unwrap(), [(1, "AC1015")]);
        let tables = drawing.tables();
        let names: Vec<&str> = tables.keys().map(String::as_str).collect();
        let required =
            ["APPID", "BLOCK_RECORD", "DIMSTYLE", "LAYER", "LTYPE", "STYLE", "UCS", "VIEW", "VPORT"];
        assert_eq!(names, required);
        assert!(tables.values().all(|[stated, has]| stated == has), "{tables:?}");
        assert_eq!(drawing.variable("$EXTMIN").is_some(), !network.nodes.is_empty());
    }
}

#[test]
fn loops_of_patches_are_their_curves_on_their_layers() {
    let found = bracket(Method::Segments);
    let patches = found.patches.clone().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("loops.dxf");
    let scan = (shapes::sample("bracket").unwrap().make)(1);
    let classes = vec![0; scan.cloud.len()];
    let table = PointTable { cloud: &scan.cloud, classes: &classes, scores: &[], las: None };
    let context = NetworkContext { patches: Some(patches.clone()), ..Default::default() };
    write_patches(&path, &[], &found.network, &context, &table).unwrap();
    let drawing = Drawing::parse(&std::fs::read_to_string(&path).unwrap());
    drawing.check_handles();
    let json = json(&found.network, &context);
    let mut entities = drawing.entities.iter();
    for (p, patch) in patches.patches.iter().enumerate() {
        for coedge in patch.loops.iter().flat_map(|l| &l.coedges) {
            for curve in json["strips"][coedge.strip as usize]["curves"].as_array().unwrap() {
                let entity = entities.next().unwrap();
                assert_eq!(entity.layer, format!("PATCH_{p:04}"));
                same(entity, curve);
            }
        }
    }
    assert!(entities.next().is_none() && drawing.of_kind("CIRCLE").len() >= 4);
}
