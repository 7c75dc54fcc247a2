//! The figures of an evaluation as a table for people.

use std::path::Path;

use lineament::evaluate::{CurveKind, Distances, Hits, MarkScore, Stretch, Types, Verdict};
use lineament_io::LineFile;

use super::Comparison;
use crate::failure::shown;
use crate::summary::{figure, plural};

/// Stretches of either kind that are listed.
const LISTED: usize = 5;
/// Width of the first column, and of a figure.
const FIRST: usize = 28;
const FIGURE: usize = 11;

/// The whole table.
pub fn of(compared: &Comparison) -> String {
    let mut text = head(compared);
    text += &near(compared);
    text += &graph(compared);
    text += &curves(compared);
    text += &published(compared);
    if !compared.marks.is_empty() {
        text += "\npoints within a spacing of a line of the result, by their labels\n";
        text += &of_marks(&compared.marks);
    }
    text += &stretches(compared, Verdict::Missed, "missed: in the truth alone");
    text += &stretches(compared, Verdict::False, "false: in the result alone");
    text += &parameters(compared);
    text
}

fn row(first: &str, cells: &[String]) -> String {
    let cells: String = cells.iter().map(|cell| format!("{cell:>FIGURE$}")).collect();
    format!("{first:<FIRST$}{cells}").trim_end().to_string() + "\n"
}

fn names(cells: &[&str]) -> String {
    row("", &cells.iter().map(|cell| cell.to_string()).collect::<Vec<_>>())
}

/// A share with four decimals; `-` for none.
fn share(value: f64) -> String {
    if value.is_nan() { "-".into() } else { format!("{value:.4}") }
}

fn length(value: f64) -> String {
    if value.is_nan() { "-".into() } else { figure(value) }
}

fn hits(first: &str, hits: Hits) -> String {
    row(first, &[hits.precision, hits.recall, hits.f1].map(share))
}

fn head(compared: &Comparison) -> String {
    let side = |name: &str, path: &Path, file: &LineFile, spacings: f64| {
        let ignored: String = file.ignored.iter().map(|what| format!("        {}\n", shown(what))).collect();
        format!(
            "{name:<8}{} ({}): {}, {} spacings long\n{ignored}",
            shown(&path.display().to_string()),
            file.format,
            plural(file.lines.lines.len(), "line"),
            figure(spacings)
        )
    };
    let score = &compared.score;
    side("result", compared.result.0, &compared.result.1, score.length_spacings)
        + &side("truth", compared.truth.0, &compared.truth.1, score.truth_spacings)
        + &format!("spacing {} ({})\n\n", figure(compared.spacing), compared.stated)
}

fn near(compared: &Comparison) -> String {
    let score = &compared.score;
    let mut text = names(&["precision", "recall", "F1"]);
    text += &hits("within 1 spacing", score.at_1h);
    text += &hits("within 2 spacings", score.at_2h);
    for &(tolerance, found) in &score.at {
        text += &hits(&format!("within {tolerance} spacings"), found);
    }
    let distances = |first: &str, d: Distances| row(first, &[d.mean, d.p95, d.max].map(length));
    text += &format!("\n{}", names(&["mean", "95 %", "greatest"]));
    text += &distances("result to truth, spacings", score.to_truth);
    text += &distances("truth to result, spacings", score.from_truth);
    text
}

fn graph(compared: &Comparison) -> String {
    let score = &compared.score;
    let [a, b] = score.topology;
    let mut text = format!("\n{}", names(&["result", "truth"]));
    for (name, pair) in [
        ("lines", [a.lines, b.lines]),
        ("connected parts", [a.components, b.components]),
        ("closed loops", [a.closed_loops, b.closed_loops]),
        ("junctions", [a.junctions, b.junctions]),
        ("loose ends", [a.ends, b.ends]),
        ("cycles", [a.cycles, b.cycles]),
    ] {
        text += &row(name, &pair.map(|n| n.to_string()));
    }
    let of = |[some, all]: [usize; 2]| format!("{some} of {all}");
    text += &format!("\n{}", row("whole curves found", &[of(score.curves_found)]));
    text += &row("junctions found", &[of(score.junctions_hit)]);
    for (name, found) in ["creases", "borders"].iter().zip(score.recall_by_kind) {
        if !found.is_nan() {
            text += &row(&format!("recall of {name}"), &[share(found)]);
        }
    }
    text
}

/// Types and radii, and rounded edges.
fn curves(compared: &Comparison) -> String {
    let mut text = String::new();
    if let Some(types) = &compared.score.types {
        text += &format!("\n{}", row("right types", &[share(types.right)]));
        text += &row("relative error of radii", &[share(types.radius_error)]);
        text += &confusion(types);
    }
    if let Some(rounded) = &compared.score.rounded {
        let cells = [rounded.precision, rounded.recall].map(share);
        text += &format!("\n{}", names(&["precision", "recall"]));
        text += &row("rounded edges", &cells);
    }
    text
}

/// By the type in the truth the share of the length that was found as each type.
fn confusion(types: &Types) -> String {
    let found = CurveKind::ALL.map(|kind| format!("as {}", kind.name()));
    let mut text = row("", &found);
    for (kind, counts) in CurveKind::ALL.iter().zip(types.lengths) {
        let all: usize = counts.iter().sum();
        if all > 0 {
            text += &row(kind.name(), &counts.map(|n| share(n as f64 / all as f64)));
        }
    }
    text
}

fn published(compared: &Comparison) -> String {
    let mut text = String::from("\nmeasures of others\n");
    if let Some(c) = &compared.score.chamfer {
        let cells = [c.cd, c.hd].map(|x| format!("{x:.6}"));
        text += &names(&["CD", "HD"]);
        text += &row("PI3DETR, NerVE: box of 2", &cells);
    }
    let frame = &compared.score.wireframe;
    text += &names(&["precision", "recall", "F1"]);
    text += &hits("corners within 2 spacings", frame.corners);
    text += &hits("edges between such corners", frame.edges);
    text
}

/// The scores of marks in each reading of the labels.
pub fn of_marks(scores: &[MarkScore]) -> String {
    let listed = |labels: &[u8]| labels.iter().map(u8::to_string).collect::<Vec<_>>().join(" and ");
    let mut text = names(&["precision", "recall", "F1", "accuracy", "MCC"]);
    for s in scores {
        let mut name = format!("label {}", listed(s.wanted));
        if !s.left_out.is_empty() {
            name += &format!(", without {}", listed(s.left_out));
        }
        text += &row(&name, &[s.precision, s.recall, s.f1, s.accuracy, s.mcc].map(share));
    }
    text
}

/// The longest stretches with a verdict.
fn stretches(compared: &Comparison, verdict: Verdict, head: &str) -> String {
    let mut all: Vec<&Stretch> = compared.stretches.iter().filter(|s| s.verdict == verdict).collect();
    if all.is_empty() {
        return format!("\n{head}: nothing\n");
    }
    let spacings = |s: &Stretch| s.length / compared.spacing;
    let total: f64 = all.iter().map(|s| spacings(s)).sum();
    all.sort_by(|a, b| b.length.total_cmp(&a.length));
    let count = plural(all.len(), "stretch").replace("stretchs", "stretches");
    let mut text = format!("\n{head}: {count}, {} spacings long\n", figure(total));
    for s in all.iter().take(LISTED) {
        let place = |p: Option<&[f64; 3]>| p.map_or(String::new(), |p| p.map(figure).join(" "));
        let (from, to) = (place(s.points.first()), place(s.points.last()));
        text += &format!("  {:>9} of line {:<5} {from}  to  {to}\n", figure(spacings(s)), s.line);
    }
    text
}

/// The parameters that differ between two results: key, value of the result, value of the truth.
pub fn changed(compared: &Comparison) -> Vec<[String; 3]> {
    let (new, old) = (&compared.result.1.parameters, &compared.truth.1.parameters);
    if new.is_empty() || old.is_empty() {
        return Vec::new();
    }
    let of = |all: &[(String, String)], key: &str| {
        all.iter().find(|(k, _)| k == key).map_or("-".into(), |(_, value)| value.clone())
    };
    let added = new.iter().filter(|(key, _)| !old.iter().any(|(k, _)| k == key));
    let keys = old.iter().chain(added).map(|(key, _)| key);
    let all = keys.map(|key| [key.clone(), of(new, key), of(old, key)]);
    all.filter(|[_, new, old]| new != old).collect()
}

fn parameters(compared: &Comparison) -> String {
    let all = changed(compared);
    if all.is_empty() {
        return String::new();
    }
    let line = |[key, new, old]: &[String; 3]| shown(&format!("  {key}: {new}, in the truth {old}")) + "\n";
    format!("\nparameters that differ\n{}", all.iter().map(line).collect::<String>())
}
