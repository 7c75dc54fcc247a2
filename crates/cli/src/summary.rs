//! Messages at the end of a run, on standard error.

use std::path::PathBuf;

use lineament::{Extraction, Network, NodeKind, Related, RelationKind, Report, StripKind};
use lineament_io::{NetworkFormat, PointFormat, PointTable, Unit, las_version, network_format, point_format};

use crate::source::Input;

/// Lines about an extraction, without the time. With `verbose`, also automatic values and omissions.
pub fn of(input: &Input, extraction: &Extraction, verbose: bool) -> Vec<String> {
    chosen(input, extraction, verbose, Vec::new())
}

/// As [`of`], where lines were left out of the extraction, as `left_out` says.
pub fn chosen(input: &Input, extraction: &Extraction, verbose: bool, left_out: Vec<String>) -> Vec<String> {
    let report = &extraction.report;
    let mut lines = vec![points(input, report)];
    lines.extend(noise(input));
    lines.extend(report.surface.unused(report.read));
    lines.extend([resolution(report), counts(&extraction.network)]);
    lines.extend(related(&extraction.related));
    lines.extend(no_line(extraction).filter(|_| left_out.is_empty()));
    lines.extend(left_out);
    lines.extend(warnings(input));
    lines.extend(report.notes.iter().map(|note| format!("note: {note}")));
    if verbose {
        lines.extend(input.remarks.iter().map(|remark| format!("input: {remark}")));
        lines.extend(report.settings.iter().map(|(key, value)| format!("chosen: {key} = {value}")));
    }
    lines
}

/// Points below which a cloud is too small to show a line.
const FEW_POINTS: usize = 200;

/// Why there is no line, where there is none.
fn no_line(extraction: &Extraction) -> Option<String> {
    let Extraction { network, report, .. } = extraction;
    if !network.strips.is_empty() {
        return None;
    }
    let used = |key: &str| report.used.iter().find(|(k, _)| k == key).map_or("", |(_, value)| value.as_str());
    let not_sought = |kind: &str| used(&format!("spanning.{kind}")) == "false";
    let why = match (report.points, report.surface.scattered + report.surface.stray) {
        _ if report.surface.none => {
            "no point lies on a surface (--set surface.clutter=keep takes them as one)".into()
        }
        (points, clutter) if clutter > points => {
            format!(
                "{} lie on no surface (--set surface.clutter=keep takes them in)",
                plural(clutter, "point")
            )
        }
        (points, _) if points < FEW_POINTS => {
            format!("{} are too few: the least feature needs some ten along it", plural(points, "point"))
        }
        _ if not_sought("creases") => {
            "creases were not looked for (spanning.creases), and no border was found".into()
        }
        _ if not_sought("borders") => {
            "borders were not looked for (spanning.borders), and no crease was found".into()
        }
        _ => format!(
            "the surface ends nowhere, and is folded nowhere by some {} degrees (penalty.fold_deg) within two spacings",
            used("penalty.fold_deg")
        ),
    };
    Some(format!("no line: {why}"))
}

/// What makes it doubtful that the points are those that were meant.
pub fn warnings(input: &Input) -> impl Iterator<Item = String> {
    input.missing.iter().chain(&input.warnings).map(|warning| format!("warning: {warning}"))
}

/// A warning where outputs for maps have no coordinate reference system that a reader of them knows.
pub fn unplaced(input: &Input, outputs: &[PathBuf]) -> Option<String> {
    let map = |path: &&PathBuf| {
        path.extension().is_some_and(|e| MAPS.iter().any(|map| e.eq_ignore_ascii_case(map)))
    };
    let output = outputs.iter().find(map).filter(|_| input.epsg.is_none())?;
    let why = match &input.crs {
        Some(crs) => format!("no EPSG code is known for `{crs}`"),
        None => "the input states none".into(),
    };
    let why = format!("{why} (--crs EPSG:N names it)");
    Some(format!("warning: {} has no coordinate reference system: {why}", output.display()))
}

/// A warning where outputs of CAD state a unit that nobody told, or none.
pub fn unmeasured(unit: Option<Unit>, outputs: &[PathBuf]) -> Option<String> {
    let of = |format: NetworkFormat| {
        outputs.iter().find(|path| network_format(path).is_ok_and(|f| f == format)).filter(|_| unit.is_none())
    };
    let states = |format, what| of(format).map(|path| format!("{} states {what}", path.display()));
    let parts = [states(NetworkFormat::Dxf, "no unit"), states(NetworkFormat::Step, "millimetres")];
    let all: Vec<String> = parts.into_iter().flatten().collect();
    let why = "as none is known: --unit tells it, or --crs where the coordinates are those of a map";
    (!all.is_empty()).then(|| format!("warning: {}, {why}", all.join(" and ")))
}

/// A note where LAS outputs are of another version than the LAS input.
pub fn other_version(table: &PointTable, outputs: &[PathBuf]) -> Option<String> {
    let is_las = |path: &&PathBuf| matches!(point_format(path), Ok(PointFormat::Las | PointFormat::Laz));
    let output = outputs.iter().find(is_las)?;
    let (before, now) = (table.las.filter(|frame| frame.is_stored())?.minor, las_version(table)?);
    (before != now).then(|| {
        let why = if now == 4 { ", which holds all columns" } else { "" };
        format!("note: {} is of version 1.{now}{why}: the input is of 1.{before}", output.display())
    })
}

/// Ratio of the spacings that nine in ten points lie between from which on both are told.
const UNEVEN: f64 = 2.0;
/// Extensions of outputs for maps.
const MAPS: [&str; 2] = ["geojson", "gpkg"];

/// How many points the file itself says are none of the scene.
pub fn noise(input: &Input) -> Option<String> {
    let count = Some(input.noise).filter(|count| *count > 0)?;
    let count = plural(count, "point");
    Some(format!(
        "left out: {count} flagged as withheld or classed as noise in the file (--all-points keeps them)"
    ))
}

/// What was read.
pub fn points(input: &Input, report: &Report) -> String {
    read(input, [report.read, report.dropped, report.merged])
}

/// How many points were read, how many of them are not finite, and how many repeat another one.
pub fn read(input: &Input, counts: [usize; 3]) -> String {
    let [read, dropped, merged] = counts.map(grouped);
    if let Some(sampled) = &input.sampled {
        let [faces, spacing] = [grouped(sampled.faces), figure(sampled.spacing)];
        let hidden = sampled.feature.filter(|size| *size < sampled.spacing);
        let hidden = hidden.map(|size| format!(", too far for features of {}", figure(size)));
        return format!(
            "{}: {read} points sampled over {faces} faces, {spacing} apart{} (--samples for others, --vertices for the vertices alone)",
            input.name,
            hidden.unwrap_or_default()
        );
    }
    format!("{}: {read} points read, {dropped} not finite, {merged} duplicates", input.name)
}

/// Spacing and noise.
pub fn resolution(report: &Report) -> String {
    let share = if report.spacing > 0.0 { report.noise / report.spacing } else { 0.0 };
    let [least, most] = report.surface.spread;
    let uneven = most > UNEVEN * least;
    let spread = if uneven { format!(" ({} to {})", figure(least), figure(most)) } else { String::new() };
    format!(
        "spacing {}{spread}, noise {} ({share:.2} spacings)",
        figure(report.spacing),
        figure(report.noise)
    )
}

fn counts(network: &Network) -> String {
    let strips = |kind| {
        let of_kind = network.strips.iter().filter(move |s| s.kind == kind);
        let closed = of_kind.clone().filter(|s| s.closed).count();
        let loops = if closed > 0 { format!(" ({})", plural(closed, "loop")) } else { String::new() };
        format!("{}{loops}", plural(of_kind.count(), StripKind::name(kind)))
    };
    let mut parts = vec![strips(StripKind::Crease), strips(StripKind::Border)];
    let rounded = network.strips.iter().filter(|s| s.kind == StripKind::Rounded).count();
    if rounded > 0 {
        parts.push(plural(rounded, "rounded edge"));
    }
    for kind in [NodeKind::Junction, NodeKind::Corner, NodeKind::End] {
        parts.push(plural(network.count(kind), kind.name()));
    }
    if network.count(NodeKind::Apex) > 0 {
        parts.push(format!("apex: {}", network.count(NodeKind::Apex)));
    }
    parts.join(", ")
}

/// The relations between curves, where there are any, and what their imposition moved.
fn related(related: &Related) -> Option<String> {
    let counts = RelationKind::ALL.into_iter().map(|kind| (kind, related.count(kind)));
    let named: Vec<String> = counts
        .filter(|c| c.1 > 0)
        .map(|(kind, count)| format!("{} {}", grouped(count), kind.name()))
        .collect();
    let moved = related.regularised.as_ref().map(|moved| {
        // Mirrors are only reported.
        let could = related.relations.iter().filter(|r| r.kind != RelationKind::Symmetric);
        match (could.clone().filter(|r| r.imposed).count(), could.count()) {
            (_, 0) => String::new(),
            (0, _) => "; none imposed".to_owned(),
            (held, of) => {
                let held = if held == of { "imposed".to_owned() } else { format!("{held} of {of} imposed") };
                let out = match moved.released.len() {
                    0 => String::new(),
                    n => format!(", {} left out", plural(n, "curve")),
                };
                format!("; {held}, nothing moved by more than {}{out}", figure(moved.greatest()))
            }
        }
    });
    (!named.is_empty()).then(|| format!("relations: {}{}", named.join(", "), moved.unwrap_or_default()))
}

/// Heads of the table of many inputs.
pub const HEADER: [&str; 9] =
    ["input", "points", "creases", "borders", "loops", "junctions", "corners", "ends", "seconds"];

/// The cells of the table of many inputs, after the name.
pub fn row(read: usize, network: Option<&Network>, seconds: f64) -> Vec<String> {
    let of_kind = |network: &Network, kind| network.strips.iter().filter(|s| s.kind == kind).count();
    let counts = match network {
        Some(n) => [
            of_kind(n, StripKind::Crease),
            of_kind(n, StripKind::Border),
            n.loops(),
            n.count(NodeKind::Junction),
            n.count(NodeKind::Corner),
            n.count(NodeKind::End),
        ]
        .map(grouped),
        None => [(); 6].map(|()| "-".into()),
    };
    [vec![grouped(read)], counts.to_vec(), vec![format!("{seconds:.2}")]].concat()
}

/// The time of each stage; the total includes further work.
pub fn times(input: &Input, report: &Report, writing: f64, total: f64) -> String {
    let stages = report.stages.iter().map(|(stage, seconds)| (stage.name(), *seconds));
    let all = [("read", input.seconds)].into_iter().chain(stages).chain([("write", writing)]);
    let parts: Vec<String> = all.map(|(name, seconds)| format!("{name} {seconds:.2}")).collect();
    format!("{total:.2} s: {}", parts.join(", "))
}

/// The names of the files written.
pub fn written(outputs: &[PathBuf]) -> String {
    let names = outputs
        .iter()
        .map(|p| if p.as_os_str() == "-" { "standard output".into() } else { p.display().to_string() });
    format!("wrote {}", names.collect::<Vec<String>>().join(", "))
}

/// A count with its noun.
pub fn plural(count: usize, noun: &str) -> String {
    format!("{} {noun}{}", grouped(count), if count == 1 { "" } else { "s" })
}

/// An integer with thousands set apart.
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A position, to a tenth of the spacing at least, so that it can be found in the cloud.
pub fn position(value: f64, spacing: f64) -> String {
    let decimals = if spacing > 0.0 { (1.0 - spacing.log10().floor()).clamp(0.0, 12.0) } else { 6.0 };
    format!("{value:.0$}", decimals as usize)
}

/// A number with four significant digits.
pub fn figure(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".into()
    } else if (1e-4..1e6).contains(&size) {
        let decimals = (3 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.3e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_234_567), "1,234,567");
    }

    #[test]
    fn positions_have_the_digits_of_a_tenth_of_the_spacing() {
        assert_eq!(position(1317.437, 0.02), "1317.437");
        assert_eq!(position(3_106_123.456, 0.5), "3106123.46");
        assert_eq!(position(3_106_123.456, 500.0), "3106123");
    }

    #[test]
    fn figures_have_four_digits() {
        let shown = [0.0, 0.012_345, 7.654_32, 1234.56, 2.5e-9, 123_456.0].map(figure);
        assert_eq!(shown, ["0", "0.01235", "7.654", "1235", "2.500e-9", "123456"]);
    }
}
