//! The data of a report but for its points, in the schema `lineament-report/1`.

use super::{Report, lines, patches, slices};
use crate::write::encode::json::{Head, Number, Point, Text, Value, list};
use crate::write::network::context::Parameter;
use lineament::Class;
use lineament::inspect::rims;
use std::io::{self, Write};

/// The members of the object up to the points, which `points::write` appends together with the closing brace.
pub(super) fn lines(report: &Report) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    let (out, context): (&mut dyn Write, _) = (&mut text, report.context);
    Head {
        schema: "lineament-report/1",
        version: &context.program_version,
        input: &context.input_name,
        sha256: context.input_sha256.as_deref(),
        points: context.input_points,
    }
    .write(out)?;
    writeln!(out, "\"method\": {},", Text(&context.method))?;
    write!(out, "\"parameters\": {{")?;
    list(out, &context.parameters, |out, _, Parameter { key, value }| {
        write!(out, "{}: {}", Text(key), Value(value))
    })?;
    writeln!(out, "}},\n\"spacing\": {},", Number(spacing(report)))?;
    writeln!(out, "\"noise\": {},", Number(context.noise.unwrap_or(f64::NAN)))?;
    match &context.crs {
        Some(crs) => writeln!(out, "\"crs\": {},", Text(crs))?,
        None => writeln!(out, "\"crs\": null,")?,
    }
    writeln!(out, "\"up\": {},", Point(&report.up))?;
    if let Some(network) = report.network {
        lines::write(out, network, context, &rims(&network.strips, &surface(report), spacing(report)))?;
    }
    if let Some(found) = &context.patches {
        patches::write(out, found)?;
    }
    if let Some((sections, stack)) = report.sections {
        slices::write(out, sections, stack)?;
    }
    Ok(text)
}

/// Spacing of the cloud, of the network or else of the sections.
fn spacing(report: &Report) -> f64 {
    let given = Some(report.context.spacing).filter(|&s| s > 0.0);
    given.or(report.sections.map(|(sections, _)| sections.spacing)).unwrap_or(f64::NAN)
}

/// The points on surfaces.
fn surface(report: &Report) -> Vec<[f64; 3]> {
    let Some(cloud) = report.cloud else { return Vec::new() };
    let clutter = |i: usize| report.classes.get(i) == Some(&(Class::Clutter as u8));
    let kept =
        cloud.positions.iter().enumerate().filter(|(i, p)| !clutter(*i) && p.iter().all(|x| x.is_finite()));
    kept.map(|(_, p)| *p).collect()
}
