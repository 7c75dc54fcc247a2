//! E57 (ASTM E2807): all scans, each moved by its pose into the frame of the file; spherical coordinates become
//! Cartesian; points whose state is invalid, or of which only a direction is known, are left out and counted.
//! Pages, their checksums and the packets are decoded by the crate `e57`.

use super::{Decoded, ReadOptions, limit};
use crate::columns::narrowed;
use crate::error::{Error, Place};
use crate::quiet;
use crate::source::{Input, Source};
use e57::{CartesianCoordinate, E57Reader, Point, PointCloud};
use lineament::{Attribute, Column};

/// Rows after which the memory taken is compared with its bound.
const STEP: u64 = 1 << 16;

/// Columns beside the positions. Missing values are NaN until all points are there.
#[derive(Default)]
struct Columns {
    color: [Vec<f32>; 3],
    intensity: Vec<f32>,
    scan: Vec<u16>,
    has_color: bool,
    has_intensity: bool,
}

/// Reads an E57 input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let input = source.seekable()?;
    let opened = quiet::catch(|| E57Reader::new(input));
    let mut reader = match opened {
        Some(Ok(reader)) => reader,
        Some(Err(error)) => return Err(fault(source, 0, describe(&error))),
        None => return Err(fault(source, 0, "a header that cannot be decoded".into())),
    };
    let scans = reader.pointclouds();
    if scans.is_empty() {
        return Err(fault(source, 0, "a file without scans".into()));
    }
    let mut out = Decoded { crs: reader.coordinate_metadata().map(String::from), ..Decoded::default() };
    let mut columns = Columns {
        has_color: options.attributes && scans.iter().any(PointCloud::has_color),
        has_intensity: options.attributes && scans.iter().any(PointCloud::has_intensity),
        ..Columns::default()
    };
    let mut left_out = 0;
    for (index, scan) in chosen(source, &scans, options)? {
        let read =
            quiet::catch(|| read_scan(source, &mut reader, (index, scan), options, &mut out, &mut columns));
        left_out += read.unwrap_or_else(|| {
            Err(fault(source, scan.file_offset, "a scan that cannot be decoded".into()))
        })?;
        if out.missing.is_some() {
            break;
        }
    }
    if left_out > 0 {
        out.ignored.push(format!("{left_out} points whose state is invalid"));
    }
    if scans.len() > 1 && options.scan.is_none() {
        out.ignored.push(format!("nothing of {} scans, which are one cloud", scans.len()));
    }
    out.cloud.attributes = columns.finish(options.attributes && scans.len() > 1);
    Ok(out)
}

/// The scans to read with their numbers, from 1.
fn chosen<'a>(
    source: &Source,
    scans: &'a [PointCloud],
    options: &ReadOptions,
) -> Result<Vec<(usize, &'a PointCloud)>, Error> {
    let numbered = scans.iter().enumerate().map(|(index, scan)| (index + 1, scan));
    let chosen: Vec<_> =
        numbered.filter(|(number, _)| options.scan.is_none_or(|wanted| wanted == *number)).collect();
    if chosen.is_empty() {
        let found = format!("there is no scan {} of {}", options.scan.unwrap_or(0), scans.len());
        return Err(source.fault(Place::Byte(0), found, "scans are numbered from 1"));
    }
    Ok(chosen)
}

/// Reads one scan; gives how many of its points are left out.
fn read_scan(
    source: &Source,
    reader: &mut E57Reader<Input>,
    (number, scan): (usize, &PointCloud),
    options: &ReadOptions,
    out: &mut Decoded,
    columns: &mut Columns,
) -> Result<u64, Error> {
    let at = scan.file_offset;
    let mut points = reader.pointcloud_simple(scan).map_err(|error| fault(source, at, describe(&error)))?;
    points.intensity_to_color(false);
    points.normalize_intensity(false);
    points.normalize_color(false);
    let mut left_out = 0;
    for (index, point) in (0u64..).zip(&mut points) {
        let point = match point {
            Ok(point) => point,
            Err(_) if options.salvage => {
                out.cut(source, options, &format!("points of scan {number}"), scan.records, index)?;
                break;
            }
            Err(error) => {
                let what = format!("scan {number}, point {index} of {}: {}", scan.records, describe(&error));
                return Err(fault(source, at, what));
            }
        };
        if index % STEP == 0 {
            limit::check(source, options, out.cloud.len() as u64, 24 + columns.row_bytes())?;
        }
        match point.cartesian {
            CartesianCoordinate::Valid { x, y, z } => {
                out.cloud.positions.push([x, y, z]);
                columns.push(&point, number);
            }
            _ => left_out += 1,
        }
    }
    Ok(left_out)
}

fn fault(source: &Source, at: u64, found: String) -> Error {
    source.fault(Place::Byte(at), found, "the file is cut or damaged; get it anew")
}

/// An error with what caused it.
fn describe(error: &dyn std::error::Error) -> String {
    match error.source() {
        Some(cause) => format!("{error} ({cause})"),
        None => error.to_string(),
    }
}

impl Columns {
    fn row_bytes(&self) -> usize {
        2 + if self.has_color { 12 } else { 0 } + if self.has_intensity { 4 } else { 0 }
    }

    fn push(&mut self, point: &Point, scan: usize) {
        if self.has_color {
            let color = point.color.as_ref().map_or([f32::NAN; 3], |c| [c.red, c.green, c.blue]);
            self.color.iter_mut().zip(color).for_each(|(column, value)| column.push(value));
        }
        if self.has_intensity {
            self.intensity.push(point.intensity.unwrap_or(f32::NAN));
        }
        self.scan.push(u16::try_from(scan).unwrap_or(u16::MAX));
    }

    fn finish(self, several: bool) -> Vec<Attribute> {
        let mut attributes = Vec::new();
        if self.has_color {
            for (name, values) in ["red", "green", "blue"].into_iter().zip(self.color) {
                let wide = values.iter().map(|&v| v.into()).collect();
                let values = match narrowed(wide) {
                    Column::F64(_) => Column::F32(values),
                    whole => whole,
                };
                attributes.push(Attribute { name: name.into(), values });
            }
        }
        if self.has_intensity {
            attributes.push(Attribute { name: "intensity".into(), values: Column::F32(self.intensity) });
        }
        if several {
            attributes.push(Attribute { name: "scan".into(), values: Column::U16(self.scan) });
        }
        attributes
    }
}
