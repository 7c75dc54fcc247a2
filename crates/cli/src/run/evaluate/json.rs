//! The figures of an evaluation as JSON, in the schema `lineament-evaluation/1` (`docs/evaluate.md`).

use std::path::{Path, PathBuf};

use lineament::evaluate::{CurveKind, Distances, Hits, MarkScore, Stretch, Topology, Types, Verdict};
use lineament_io::{LineFile, Output};
use serde_json::{Value, json};

use super::{Comparison, table};
use crate::failure::Failure;

const SCHEMA: &str = "lineament-evaluation/1";

/// Writes a value to a file, whole or not at all.
pub fn write(path: &Path, inputs: &[PathBuf], value: &Value) -> Result<(), Failure> {
    Ok(Output::whole(path, inputs, |out| {
        serde_json::to_writer_pretty(&mut *out, value)?;
        writeln!(out)
    })?)
}

/// All figures, and the stretches that were missed or are false.
pub fn of(compared: &Comparison) -> Value {
    let score = &compared.score;
    let at = [(1.0, score.at_1h), (2.0, score.at_2h)].into_iter().chain(score.at.iter().copied());
    let at: Vec<Value> = at.map(|(tolerance, h)| with(hits(h), "tolerance", json!(tolerance))).collect();
    let [result, truth] = score.topology.map(topology);
    let listed = |verdict| -> Vec<Value> {
        compared.stretches.iter().filter(|s| s.verdict == verdict).map(stretch).collect()
    };
    let changed = table::changed(compared);
    let parameters = changed.iter().map(|[key, a, b]| json!({"key": key, "result": a, "truth": b}));
    json!({
        "schema": SCHEMA,
        "result": side(compared.result.0, &compared.result.1, score.length_spacings),
        "truth": side(compared.truth.0, &compared.truth.1, score.truth_spacings),
        "spacing": compared.spacing,
        "at": at,
        "to_truth": distances(score.to_truth),
        "from_truth": distances(score.from_truth),
        "recall_of": {"crease": score.recall_by_kind[0], "border": score.recall_by_kind[1]},
        "curves_found": score.curves_found,
        "junctions_found": score.junctions_hit,
        "topology": {"result": result, "truth": truth},
        "types": score.types.map(types),
        "rounded": score.rounded.map(|r| json!({"precision": r.precision, "recall": r.recall})),
        "chamfer": score.chamfer.map(|c| json!({"cd": c.cd, "hd": c.hd, "hausdorff": c.hausdorff})),
        "wireframe": {
            "tolerance": 2.0,
            "corners": hits(score.wireframe.corners),
            "edges": hits(score.wireframe.edges),
            "offset": score.wireframe.offset,
        },
        "points": points(&compared.marks),
        "tolerance": compared.tolerance,
        "missed": listed(Verdict::Missed),
        "false": listed(Verdict::False),
        "parameters": parameters.collect::<Vec<Value>>(),
    })
}

/// The scores of marks alone.
pub fn of_marks(scores: &[MarkScore]) -> Value {
    json!({"schema": SCHEMA, "points": points(scores)})
}

fn side(path: &Path, file: &LineFile, spacings: f64) -> Value {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    json!({"name": name, "format": file.format, "length_in_spacings": spacings})
}

fn with(mut object: Value, key: &str, value: Value) -> Value {
    object[key] = value;
    object
}

fn hits(hits: Hits) -> Value {
    json!({"precision": hits.precision, "recall": hits.recall, "f1": hits.f1})
}

fn distances(d: Distances) -> Value {
    json!({"mean": d.mean, "p95": d.p95, "max": d.max})
}

fn topology(t: Topology) -> Value {
    json!({
        "lines": t.lines,
        "components": t.components,
        "closed_loops": t.closed_loops,
        "junctions": t.junctions,
        "ends": t.ends,
        "cycles": t.cycles,
    })
}

fn types(types: Types) -> Value {
    let row = |counts: [usize; 4]| -> Value {
        let cells = CurveKind::ALL.iter().zip(counts).map(|(kind, n)| (kind.name().to_string(), json!(n)));
        Value::Object(cells.collect())
    };
    let rows = CurveKind::ALL.iter().zip(types.lengths).map(|(kind, n)| (kind.name().to_string(), row(n)));
    json!({
        "right": types.right,
        "radius_error": types.radius_error,
        "samples": Value::Object(rows.collect()),
    })
}

fn points(scores: &[MarkScore]) -> Vec<Value> {
    let one = |s: &MarkScore| {
        json!({
            "wanted": s.wanted,
            "left_out": s.left_out,
            "precision": s.precision,
            "recall": s.recall,
            "f1": s.f1,
            "accuracy": s.accuracy,
            "mcc": s.mcc,
        })
    };
    scores.iter().map(one).collect()
}

fn stretch(s: &Stretch) -> Value {
    json!({"line": s.line, "length": s.length, "from": s.points.first(), "to": s.points.last()})
}
