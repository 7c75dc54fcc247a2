//! `lineament info`.

use std::fmt::{Display, Write};

use lineament::neighbors::{all_nearest, riemannian};
use lineament::{Cloud, Column, Frame, Resolution};
use lineament_io::{Planned, ReadOptions, Sampled};

use crate::args::Info;
use crate::batch;
use crate::failure::{Failure, shown};
use crate::source::{self, Input, Origin, print};
use crate::summary::{figure, grouped};

/// Neighbours that spacing and noise are estimated from.
const NEIGHBORS: usize = 12;
/// Fewer points have a spacing, but no noise that means anything.
const LEAST_FOR_NOISE: usize = 20;

/// Describes each file on standard output.
pub fn run(args: &Info) -> Result<(), Failure> {
    if source::is_list(&args.source) {
        return source::print_list();
    }
    let origins = source::origins(&args.source)?;
    let mut failed = 0;
    for (i, origin) in origins.iter().enumerate() {
        match described(origin, args) {
            Ok(text) => print(&format!("{}{text}", if i > 0 { "\n" } else { "" }))?,
            Err(failure) if origins.len() == 1 => return Err(failure),
            Err(failure) => {
                failed += 1;
                failure.tell();
            }
        }
    }
    batch::partial(failed, origins.len())
}

fn described(origin: &Origin, args: &Info) -> Result<String, Failure> {
    let input = origin.load(&args.source.reading, &ReadOptions { plan: true, ..ReadOptions::default() })?;
    let mut text = String::new();
    file_lines(&mut text, &input);
    cloud_lines(&mut text, &input.cloud, input.planned.as_ref()).map_err(|e| e.at(origin.shown()))?;
    Ok(text)
}

fn line(text: &mut String, label: &str, value: impl Display) {
    // Names come from the file.
    let _ = writeln!(text, "{label:<12}{}", shown(&value.to_string()).replace('\n', "\\n"));
}

fn file_lines(text: &mut String, input: &Input) {
    line(text, "input", &input.name);
    if let Some((format, bytes)) = &input.format {
        line(text, "format", format);
        line(text, "bytes", grouped(*bytes as usize));
    }
    if let Some(las) = &input.las {
        line(text, "version", format!("1.{}, point format {}", las.minor, las.point_format));
    }
    let reference = match (&input.crs, input.epsg) {
        (Some(crs), Some(code)) if *crs != format!("EPSG:{code}") => Some(format!("{crs} (EPSG:{code})")),
        (crs, _) => crs.clone(),
    };
    reference.iter().for_each(|reference| line(text, "reference", reference));
    input.unit.iter().for_each(|unit| line(text, "unit", unit.sign()));
    input.beside.iter().for_each(|path| line(text, "read too", path.display()));
    match (&input.planned, &input.sampled) {
        (Some(Planned { faces, plan }), _) => {
            line(text, "faces", grouped(*faces));
            line(text, "vertices", grouped(input.cloud.len()));
            line(
                text,
                "points",
                format!("{}, sampled over the faces for all other commands", grouped(plan.points)),
            );
        }
        (_, sampled) => {
            let over = |s: &Sampled| format!(", sampled over {} faces", grouped(s.faces));
            let over = sampled.as_ref().map_or(String::new(), over);
            line(text, "points", format!("{}{over}", grouped(input.cloud.len())));
        }
    }
    for attribute in &input.cloud.attributes {
        let (kind, range) = described_column(&attribute.values);
        line(text, "attribute", format!("{} ({kind}){range}", attribute.name));
    }
    input.missing.iter().chain(&input.warnings).for_each(|warning| line(text, "warning", warning));
    input.remarks.iter().for_each(|remark| line(text, "left out", remark));
}

/// A coordinate as it was written: one of single precision has no digits beyond it.
fn tidy(x: f64) -> String {
    let single = x as f32;
    if f64::from(single) == x { single.to_string() } else { x.to_string() }
}

/// `planned` tells that the points are the vertices of a mesh, whose distances say nothing.
fn cloud_lines(text: &mut String, cloud: &Cloud, planned: Option<&Planned>) -> Result<(), Failure> {
    let local = Frame::localise(cloud)?.with_spacing()?;
    line(text, "not finite", grouped(local.dropped));
    line(text, "duplicates", grouped(local.merged()));
    if local.positions.is_empty() {
        return Ok(());
    }
    for (axis, [min, max]) in ["x", "y", "z"].into_iter().zip(bounds(cloud)) {
        line(text, axis, format!("{} to {} (extent {})", tidy(min), tidy(max), figure(max - min)));
    }
    if let Some(Planned { plan, .. }) = planned {
        line(text, "spacing", figure(plan.spacing));
        if let Some(size) = plan.feature {
            line(
                text,
                "features",
                format!("{} and more ({:.1} spacings)", figure(size), size / plan.spacing),
            );
        }
    } else if local.positions.len() > 1 {
        let nearest = all_nearest(&local.positions, NEIGHBORS);
        let graph = riemannian::graph(&local.positions, &nearest);
        let resolution = Resolution::estimate(&local.positions, &nearest, &graph);
        line(text, "spacing", figure(resolution.spacing * local.frame.scale));
        if local.positions.len() >= LEAST_FOR_NOISE {
            let noise = figure(resolution.noise * local.frame.scale);
            let share = resolution.noise / resolution.spacing;
            line(text, "noise", format!("{noise} ({share:.2} spacings)"));
        }
    }
    Ok(())
}

/// Least and greatest finite coordinate on each axis.
fn bounds(cloud: &Cloud) -> [[f64; 2]; 3] {
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for point in cloud.positions.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
        for (bound, &x) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(x), bound[1].max(x)];
        }
    }
    bounds
}

/// The type of a column's values and, behind a comma, their range.
fn described_column(column: &Column) -> (&'static str, String) {
    match column {
        Column::I8(v) => ("i8", range(v)),
        Column::U8(v) => ("u8", range(v)),
        Column::I16(v) => ("i16", range(v)),
        Column::U16(v) => ("u16", range(v)),
        Column::I32(v) => ("i32", range(v)),
        Column::U32(v) => ("u32", range(v)),
        Column::I64(v) => ("i64", range(v)),
        Column::U64(v) => ("u64", range(v)),
        Column::F32(v) => ("f32", range(v)),
        Column::F64(v) => ("f64", range(v)),
    }
}

/// Least and greatest value in words; nothing for no values, or for none that can be compared.
fn range<T: Copy + PartialOrd + Display>(values: &[T]) -> String {
    let known = || values.iter().copied().filter(|v| v.partial_cmp(v).is_some());
    let least = known().reduce(|a, b| if b < a { b } else { a });
    let most = known().reduce(|a, b| if b > a { b } else { a });
    match (least, most) {
        (Some(least), Some(most)) if least < most => format!(", {least} to {most}"),
        (Some(only), _) => format!(", all {only}"),
        _ => String::new(),
    }
}
