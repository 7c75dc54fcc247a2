//! The schemas `lineament-network/2` and `lineament-network/1`.

use super::{context, floats, written};
use crate::common::network;
use lineament::relation::{Member, Regularised, Related, Relation, RelationKind};
use lineament_io::{NetworkContext, NetworkFormat, write_network_to};
use serde_json::{Value, json};
use std::path::Path;

fn json() -> Value {
    serde_json::from_slice(&written(NetworkFormat::Json)).unwrap()
}

fn first_schema() -> Value {
    let mut bytes = Vec::new();
    let context = NetworkContext { first_schema: true, ..context() };
    write_network_to(&mut bytes, NetworkFormat::Json, &network(), &context).unwrap();
    serde_json::from_slice(&bytes).unwrap()
}

#[test]
fn json_gives_every_number_back_bit_for_bit() {
    let (json, network) = (json(), network());
    assert_eq!(json["schema"], "lineament-network/2");
    for (node, there) in network.nodes.iter().zip(json["nodes"].as_array().unwrap()) {
        assert_eq!(floats(&there["position"]), node.position);
        assert_eq!(there["kind"], node.kind.name());
    }
    for (strip, there) in network.strips.iter().zip(json["strips"].as_array().unwrap()) {
        let points: Vec<Vec<f64>> = there["points"].as_array().unwrap().iter().map(floats).collect();
        assert_eq!(points, strip.points);
        assert_eq!(there["deviation"], strip.deviation);
        assert_eq!(there["length"], strip.length());
        assert_eq!(floats(&there["curve"]["knots"]), strip.curve.knots);
        assert_eq!(there["start"].as_u64(), strip.start.map(u64::from));
        assert_eq!(there["closed"], strip.closed);
    }
}

#[test]
fn json_says_what_was_read_and_how() {
    let json = json();
    assert_eq!(json["input"]["name"], context().input_name);
    assert_eq!(json["input"]["sha256"], "00ff");
    assert_eq!(json["parameters"]["penalty.rho"], 12);
    assert_eq!(json["parameters"]["penalty.alpha"], 0.3);
    assert_eq!(json["parameters"]["penalty.robust"], true);
    assert_eq!(json["parameters"]["penalty.noise"], "auto");
    assert_eq!(json["noise"], Value::Null);
}

/// Whether `value` has what `schema` requires, by the parts of JSON Schema that the project's schema uses.
fn conforms(value: &Value, schema: &Value, root: &Value, at: &str) {
    let schema = match schema["$ref"].as_str() {
        Some(path) => root.pointer(path.trim_start_matches('#')).unwrap_or_else(|| panic!("{path}")),
        None => schema,
    };
    if let Some(constant) = schema.get("const") {
        assert_eq!(value, constant, "{at}");
    }
    if let Some(allowed) = schema.get("enum") {
        assert!(allowed.as_array().unwrap().contains(value), "{at} is {value}");
    }
    let kinds = match &schema["type"] {
        Value::String(kind) => vec![kind.as_str()],
        Value::Array(kinds) => kinds.iter().map(|kind| kind.as_str().unwrap()).collect(),
        _ => vec![],
    };
    let is = |kind: &&str| match *kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("type {other} at {at}"),
    };
    assert!(kinds.is_empty() || kinds.iter().any(is), "{at} is {value}, not {kinds:?}");
    if let (Some(object), Some(properties)) = (value.as_object(), schema["properties"].as_object()) {
        for required in schema["required"].as_array().into_iter().flatten() {
            assert!(object.contains_key(required.as_str().unwrap()), "{at} lacks {required}");
        }
        for (key, inner) in object {
            let known = properties.get(key).unwrap_or_else(|| panic!("{at}.{key} is not in the schema"));
            conforms(inner, known, root, &format!("{at}.{key}"));
        }
    }
    if let (Some(items), Some(inner)) = (value.as_array(), schema.get("items")) {
        for (i, item) in items.iter().enumerate() {
            conforms(item, inner, root, &format!("{at}[{i}]"));
        }
        assert!(items.len() as u64 >= schema["minItems"].as_u64().unwrap_or(0), "{at}");
        assert!(items.len() as u64 <= schema["maxItems"].as_u64().unwrap_or(u64::MAX), "{at}");
    }
}

#[test]
fn json_conforms_to_the_published_schemas() {
    for (version, json) in [(2, json()), (1, first_schema())] {
        let name = format!("../../docs/schema-network-{version}.json");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        let schema: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        conforms(&json, &schema, &schema, "file");
    }
}

#[test]
fn typed_curves_and_sigma_stand_in_the_second_schema_alone() {
    let (second, first) = (json(), first_schema());
    let curves = second["strips"][0]["curves"].as_array().unwrap();
    let names: Vec<&str> = curves.iter().map(|c| c["type"].as_str().unwrap()).collect();
    assert_eq!(names, ["line", "arc", "circle", "ellipse", "b-spline"]);
    assert_eq!(curves[1]["radius"], 1.0 / 3.0);
    assert_eq!(curves[1]["sweep_deg"], 1.5_f64.to_degrees());
    assert_eq!(curves[1]["range"], serde_json::json!([1, 1]));
    assert_eq!(curves[1]["covariance"][3][3], 1e-6);
    assert_eq!(
        (&curves[3]["major"], &curves[3]["minor"]),
        (&serde_json::json!([0.0, 2.0 / 3.0, 0.0]), &serde_json::json!(1.0 / 3.0))
    );
    assert_eq!(curves[3]["sigma"]["minor"], 1e-3);
    assert_eq!(curves[3]["covariance"][4][4], 1e-6);
    assert_eq!(first["schema"], "lineament-network/1");
    assert!(first["strips"][0].get("curves").is_none());
    assert_eq!(second["strips"][0]["sigma"][2], serde_json::json!([0.5, 0.25, 0.125]));
    assert_eq!(second["nodes"][0]["sigma"], serde_json::json!([0.25, 0.5, 0.0]));
    assert!(first["strips"][0].get("sigma").is_none() && first["nodes"][0].get("sigma").is_none());
}

#[test]
fn the_schema_page_names_every_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schema-network-2.md");
    let page = std::fs::read_to_string(path).unwrap();
    fn keys(value: &Value, into: &mut Vec<String>) {
        match value {
            Value::Object(object) => object.iter().for_each(|(key, inner)| {
                into.push(key.clone());
                keys(inner, into);
            }),
            Value::Array(items) => items.iter().for_each(|item| keys(item, into)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    keys(&json(), &mut all);
    for key in all.iter().filter(|key| !key.contains('.')) {
        assert!(page.contains(&format!("`{key}`")), "{key}");
    }
}

fn related() -> Related {
    let member = |strip| Member { strip, curve: 0 };
    let relation = |kind, others: &[Member]| Relation {
        kind,
        members: vec![member(0), member(1)],
        others: others.to_vec(),
        likelihood: 0.96875,
        deviation: 0.5,
        direction: Some([0.0, 0.0, 1.0]),
        point: None,
        radius: Some(2.0),
        imposed: kind == RelationKind::EqualRadius,
    };
    let nodes = (0..network().nodes.len()).map(|n| n as f64).collect();
    let curves = network().strips.iter().map(|s| vec![0.25; s.curves.len()]).collect();
    let released = vec![member(1)];
    Related {
        relations: vec![
            relation(RelationKind::Perpendicular, &[member(2)]),
            relation(RelationKind::EqualRadius, &[]),
        ],
        regularised: Some(Regularised { nodes, curves, released }),
    }
}

#[test]
fn relations_and_moves_stand_in_the_second_schema_alone() {
    let related = related();
    let of = |first_schema| -> Value {
        let context = NetworkContext { related: related.clone(), first_schema, ..context() };
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, NetworkFormat::Json, &network(), &context).unwrap();
        serde_json::from_slice(&bytes).unwrap()
    };
    let (first, second) = (of(true), of(false));
    let right = &second["relations"][0];
    assert_eq!(right["type"], "perpendicular");
    assert_eq!((&right["members"], &right["others"]), (&json!([[0, 0], [1, 0]]), &json!([[2, 0]])));
    assert_eq!(right["deviation_deg"], 0.5_f64.to_degrees());
    assert_eq!(right["direction"], json!([0.0, 0.0, 1.0]));
    let radii = &second["relations"][1];
    assert_eq!(
        (&radii["deviation_before"], &radii["radius"], &radii["imposed"]),
        (&json!(0.5), &json!(2.0), &json!(true))
    );
    assert!(["others", "point", "deviation"].iter().all(|key| radii.get(key).is_none()));
    assert_eq!(second["nodes"][1]["moved"], 1.0);
    assert_eq!(second["strips"][0]["curves"][0]["moved"], 0.25);
    assert_eq!(
        second["regularised"],
        json!({"greatest": network().nodes.len() as f64 - 1.0, "released": [[1, 0]]})
    );
    assert!(first.get("relations").is_none() && first["nodes"][0].get("moved").is_none());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schema-network-2.json");
    let schema: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    conforms(&second, &schema, &schema, "network");
}
