//! Lines as JSON: a network that `extract` wrote, a truth, sections, or any object with a list of polylines.

use super::LineFile;
use crate::error::{Error, Place};
use crate::source::Source;
use lineament::evaluate::{CurveKind, Line, LineKind, Lines, RoundedEdge, TypedCurve, stretch};
use serde_json::Value;

/// The names that a list of lines may have.
const LISTS: [&str; 4] = ["strips", "polylines", "lines", "curves"];

/// Angle between the faces of a rounded edge where it is not said, degrees.
const SQUARE: f64 = 90.0;

/// Reads the lines with all that stands beside them.
pub(super) fn read(source: &mut Source) -> Result<LineFile, Error> {
    let bytes = super::all(source)?;
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let root: Value = serde_json::from_slice(text).map_err(|e| {
        source.fault(Place::Line(e.line() as u64), format!("no JSON: {e}"), "give a file that is whole")
    })?;
    parse(&root).map_err(|what| Error::Unsupported {
        name: source.name().into(),
        what,
        advice: "expected a network of `extract`, or a list `polylines` of objects with `points`".into(),
    })
}

fn parse(root: &Value) -> Result<LineFile, String> {
    let schema = root["schema"].as_str().unwrap_or("lines");
    let mut out = LineFile::new(format!("JSON ({schema})"));
    let (name, list) = list(root)?;
    for (i, item) in list.iter().enumerate() {
        add(item, &mut out.lines).map_err(|e| format!("{name}[{i}]{e}"))?;
    }
    for (i, item) in of(root, "typed").iter().enumerate() {
        let row = points(&item["points"]).map_err(|e| format!("typed[{i}].{e}"))?;
        out.lines.curves.extend(typed(item, &row, &Value::Null));
    }
    for (i, item) in of(root, "rounded").iter().enumerate() {
        out.lines.rounded.push(rounded(item).map_err(|e| format!("rounded[{i}].{e}"))?);
    }
    out.lines.junctions = junctions(root)?;
    out.spacing = root["spacing"].as_f64().filter(|h| *h > 0.0);
    let pairs = root["parameters"].as_object().into_iter().flatten();
    let shown = |value: &Value| value.as_str().map_or_else(|| value.to_string(), String::from);
    out.parameters = pairs.map(|(key, value)| (key.clone(), shown(value))).collect();
    Ok(out)
}

/// The list of lines, and its name.
fn list(root: &Value) -> Result<(&'static str, &Vec<Value>), String> {
    if let Some(list) = root.as_array() {
        return Ok(("", list));
    }
    let named = LISTS.into_iter().find_map(|name| Some((name, root[name].as_array()?)));
    named.ok_or_else(|| format!("no list of lines: none of {}", LISTS.join(", ")))
}

fn of<'a>(root: &'a Value, key: &str) -> &'a [Value] {
    root[key].as_array().map_or(&[], Vec::as_slice)
}

/// Adds a line with its typed curves, or a rounded edge.
fn add(item: &Value, lines: &mut Lines) -> Result<(), String> {
    let kind = item["kind"].as_str().or_else(|| item["type"].as_str());
    if kind == Some("rounded") {
        lines.rounded.push(rounded(item).map_err(|e| format!(".{e}"))?);
        return Ok(());
    }
    let bare = item.is_array();
    let mut row = points(if bare { item } else { &item["points"] }).map_err(|e| format!(".{e}"))?;
    let closed = item["closed"].as_bool().unwrap_or(false);
    if closed && super::ends_in_its_first(&row) {
        row.pop();
    }
    if row.len() < 2 {
        return Ok(());
    }
    let whole = [Value::from(0), Value::from(row.len() - usize::from(!closed))];
    match of(item, "curves") {
        [] if item["curve"].is_object() => {
            lines.curves.extend(typed(&item["curve"], &row, &Value::from(whole.to_vec())));
        }
        pieces => lines.curves.extend(pieces.iter().filter_map(|piece| typed(piece, &row, &piece["range"]))),
    }
    let kind = match kind {
        Some("border") => LineKind::Border,
        Some("weak") => LineKind::Weak,
        _ => LineKind::Crease,
    };
    lines.lines.push(Line { kind, closed, points: row });
    Ok(())
}

/// A curve with its type; `range` are the first and the last of the points that it stands for, all if there is none.
fn typed(item: &Value, row: &[[f64; 3]], range: &Value) -> Option<TypedCurve> {
    let kind = match item["type"].as_str()? {
        "line" => CurveKind::Line,
        "arc" | "circle" => CurveKind::Circle,
        name if name.contains("ellip") => CurveKind::Ellipse,
        _ => CurveKind::Spline,
    };
    let index = |i: usize| range[i].as_u64().map(|i| i as usize);
    let points = match (index(0), index(1)) {
        (Some(first), Some(last)) if first < row.len() => stretch(row, first, last),
        _ => row.to_vec(),
    };
    (points.len() > 1).then(|| TypedCurve {
        kind,
        radius: item["radius"].as_f64().filter(|r| *r > 0.0),
        points,
    })
}

fn rounded(item: &Value) -> Result<RoundedEdge, String> {
    Ok(RoundedEdge {
        radius: item["radius"].as_f64().unwrap_or(0.0),
        turn_deg: item["turn_deg"].as_f64().or_else(|| item["fold_deg"].as_f64()).unwrap_or(SQUARE),
        closed: item["closed"].as_bool().unwrap_or(false),
        points: points(&item["points"])?,
    })
}

/// The nodes at which rounded edges end, ascending: they have nodes of their own.
fn rounded_ends(root: &Value) -> Vec<u64> {
    let strips = root["strips"].as_array().into_iter().flatten().filter(|s| s["kind"] == "rounded");
    let mut ends: Vec<u64> =
        strips.flat_map(|s| ["start", "end"].map(|key| s[key].as_u64())).flatten().collect();
    ends.sort_unstable();
    ends
}

/// The junctions that a network or a truth names; `None` where it names no nodes.
fn junctions(root: &Value) -> Result<Option<Vec<[f64; 3]>>, String> {
    for (name, place) in [("nodes", "position"), ("corners", "p")] {
        let Some(list) = root[name].as_array() else { continue };
        let rounded = rounded_ends(root);
        let junction = |(i, item): &(usize, &Value)| {
            item["kind"] == "junction" && rounded.binary_search(&(*i as u64)).is_err()
        };
        let at = |(i, item): (usize, &Value)| {
            point(&item[place]).ok_or_else(|| format!("{name}[{i}].{place}: three numbers were expected"))
        };
        return list.iter().enumerate().filter(junction).map(at).collect::<Result<_, _>>().map(Some);
    }
    Ok(None)
}

fn points(value: &Value) -> Result<Vec<[f64; 3]>, String> {
    let list = value.as_array().ok_or("points: a list was expected")?;
    let at = |(i, p)| point(p).ok_or_else(|| format!("points[{i}]: three numbers were expected"));
    list.iter().enumerate().map(at).collect()
}

fn point(value: &Value) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    numbers?.try_into().ok()
}
