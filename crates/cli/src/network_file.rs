//! Networks that `extract` wrote as JSON, as far as drawing them needs.

use std::path::Path;

use lineament::{Blend, Network, Node, NodeKind, Strip, StripKind};
use serde_json::Value;

use crate::failure::{Code, Failure};

/// The schemas that are read; newest first.
const SCHEMAS: [&str; 2] = ["lineament-network/2", "lineament-network/1"];

/// Reads nodes and strips; curves, sources and measures are left out.
///
/// # Errors
/// Input if the file cannot be read, is not JSON, or not of the schema; with file and place.
pub fn read(path: &Path) -> Result<Network, Failure> {
    let fail = |message: String| {
        Failure::new(Code::Input, format!("{}: {message}", path.display()))
            .advise("give a JSON file that `lineament extract` wrote, or `computed`, or `none`")
    };
    let bytes = std::fs::read(path).map_err(|e| fail(format!("cannot read the network: {e}")))?;
    let root: Value = serde_json::from_slice(&bytes).map_err(|e| fail(format!("not JSON: {e}")))?;
    parse(&root).map_err(fail)
}

fn parse(root: &Value) -> Result<Network, String> {
    match root["schema"].as_str() {
        Some(known) if SCHEMAS.contains(&known) => {}
        Some(other) => return Err(format!("schema: `{other}` where `{}` was expected", SCHEMAS[0])),
        None => return Err(format!("no `schema`; `{}` was expected", SCHEMAS[0])),
    }
    Ok(Network { nodes: items(root, "nodes", node)?, strips: items(root, "strips", strip)? })
}

/// The items of the list `key`, each with its place in the error.
fn items<T>(root: &Value, key: &str, item: fn(&Value) -> Result<T, String>) -> Result<Vec<T>, String> {
    let list = root[key].as_array().ok_or_else(|| format!("no list `{key}`"))?;
    list.iter().enumerate().map(|(i, value)| item(value).map_err(|e| format!("{key}[{i}].{e}"))).collect()
}

fn node(value: &Value) -> Result<Node, String> {
    let position = point(&value["position"]).ok_or("position: three numbers were expected")?;
    let kinds = [NodeKind::Junction, NodeKind::Corner, NodeKind::End, NodeKind::Apex];
    let kind = kinds.into_iter().find(|kind| value["kind"] == kind.name());
    let kind = kind.ok_or_else(|| format!("kind: {} is no kind of node", value["kind"]))?;
    let degree = value["degree"].as_u64().and_then(|d| d.try_into().ok()).unwrap_or(0);
    Ok(Node { position, kind, degree, source: 0, sigma: None })
}

fn strip(value: &Value) -> Result<Strip, String> {
    let kinds = [StripKind::Crease, StripKind::Border, StripKind::Rounded];
    let kind = kinds.into_iter().find(|kind| value["kind"] == kind.name());
    let kind = kind.ok_or_else(|| format!("kind: {} is no kind of strip", value["kind"]))?;
    let points = value["points"].as_array().and_then(|list| list.iter().map(point).collect());
    let index = |key: &str| value[key].as_u64().and_then(|i| u32::try_from(i).ok());
    Ok(Strip {
        kind,
        closed: value["closed"].as_bool().ok_or("closed: true or false was expected")?,
        start: index("start"),
        end: index("end"),
        points: points.ok_or("points: a list of three numbers each was expected")?,
        curve: Default::default(),
        sources: Vec::new(),
        fold_deg: None,
        evidence: None,
        curves: Vec::new(),
        deviation: 0.0,
        confidence: value["confidence"].as_f64().unwrap_or(0.0),
        sigma: Vec::new(),
        blend: value["radius"].as_f64().map(|radius| {
            let sigma = value["radius_sigma"].as_f64().unwrap_or(0.0);
            Blend { radius, sigma }
        }),
    })
}

fn point(value: &Value) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    numbers?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn nodes_and_strips_are_read() {
        let root = json!({
            "schema": SCHEMAS[1],
            "nodes": [{"id": 0, "position": [1, 2, 3.5], "kind": "end", "degree": 1}],
            "strips": [{"id": 0, "kind": "border", "closed": false, "start": 0, "end": 0, "points": [[0, 0, 0], [1, 0, 0]]}],
        });
        let network = parse(&root).unwrap();
        assert_eq!(network.nodes[0].position, [1.0, 2.0, 3.5]);
        assert_eq!(network.strips[0].points, [[0.0; 3], [1.0, 0.0, 0.0]]);
        assert_eq!(network.strips[0].start, Some(0));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place() {
        let cases = [
            (json!({}), "schema"),
            (json!({"schema": "other/2"}), "other/2"),
            (json!({"schema": SCHEMAS[1], "nodes": []}), "strips"),
            (
                json!({"schema": SCHEMAS[1], "nodes": [{"position": [1, 2]}], "strips": []}),
                "nodes[0].position",
            ),
            (json!({"schema": SCHEMAS[1], "nodes": [], "strips": [{"kind": "ridge"}]}), "strips[0].kind"),
        ];
        for (root, part) in cases {
            let error = parse(&root).unwrap_err();
            assert!(error.contains(part), "{part} in {error}");
        }
    }
}
