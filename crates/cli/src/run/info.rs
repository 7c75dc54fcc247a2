//! `lineament info`.

use std::fmt::Write;

use lineament::neighbors::{all_nearest, riemannian};
use lineament::{Cloud, Column, Frame, Resolution};
use lineament_io::ReadOptions;

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
    let input = origin.load(&args.source.reading, &ReadOptions::default())?;
    let mut text = String::new();
    file_lines(&mut text, &input);
    cloud_lines(&mut text, &input.cloud).map_err(|e| e.at(origin.shown()))?;
    Ok(text)
}

fn line(text: &mut String, label: &str, value: impl std::fmt::Display) {
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
    match (&input.crs, input.epsg) {
        (Some(crs), Some(code)) if *crs != format!("EPSG:{code}") => {
            line(text, "reference", format!("{crs} (EPSG:{code})"));
        }
        (Some(crs), _) => line(text, "reference", crs),
        (None, _) => {}
    }
    line(text, "points", grouped(input.cloud.len()));
    for attribute in &input.cloud.attributes {
        line(text, "attribute", format!("{} ({})", attribute.name, type_name(&attribute.values)));
    }
    input.missing.iter().chain(&input.warnings).for_each(|warning| line(text, "warning", warning));
    input.remarks.iter().for_each(|remark| line(text, "note", remark));
}

fn cloud_lines(text: &mut String, cloud: &Cloud) -> Result<(), Failure> {
    let local = Frame::localise(cloud)?.with_spacing()?;
    line(text, "not finite", grouped(local.dropped));
    line(text, "duplicates", grouped(local.merged()));
    if local.positions.is_empty() {
        return Ok(());
    }
    for (axis, [min, max]) in ["x", "y", "z"].into_iter().zip(bounds(cloud)) {
        line(text, axis, format!("{min} to {max} (extent {})", figure(max - min)));
    }
    if local.positions.len() > 1 {
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

fn type_name(column: &Column) -> &'static str {
    match column {
        Column::I8(_) => "i8",
        Column::U8(_) => "u8",
        Column::I16(_) => "i16",
        Column::U16(_) => "u16",
        Column::I32(_) => "i32",
        Column::U32(_) => "u32",
        Column::I64(_) => "i64",
        Column::U64(_) => "u64",
        Column::F32(_) => "f32",
        Column::F64(_) => "f64",
    }
}
