//! E57 (ASTM E2807): all scans, each moved by its pose into the frame of the file; spherical coordinates become
//! Cartesian; points whose state is invalid, or of which only a direction is known, are left out and counted.
//! The crate `e57` reads the description in XML; pages and packets are read here.

mod packets;
mod pages;
mod point;
mod xml;

use super::{Decoded, ReadOptions, limit};
use crate::columns::narrowed;
use crate::crs::Crs;
use crate::error::{Error, Place};
use crate::quiet;
use crate::source::{Shared, Source};
use crate::unit::Unit;
use e57::{E57Reader, PointCloud};
use lineament::{Attribute, Column};
use packets::Packets;
use pages::Pages;
use point::{Fields, Point};

/// Rows that are decoded at a time; then the memory taken is compared with its bound.
const ROWS: u64 = 1 << 12;
/// Bytes of the header of the file.
const HEADER: usize = 48;

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
    let shared = source.seekable()?;
    let shared = Shared::new(shared).map_err(|e| source.io(e))?;
    let mut pages = pages(source, options, &shared)?;
    let opened = quiet::catch(|| E57Reader::new(shared.window(0, u64::MAX)));
    let reader = match opened {
        Some(Ok(reader)) => reader,
        Some(Err(error)) => return Err(fault(source, 0, describe(&error))),
        None => return Err(fault(source, 0, "a header that cannot be decoded".into())),
    };
    let scans = reader.pointclouds();
    if scans.is_empty() {
        return Err(fault(source, 0, "a file without scans".into()));
    }
    let crs = Crs::parse(reader.coordinate_metadata().unwrap_or_default());
    // The standard has all lengths in metres.
    let mut out = Decoded { crs, unit: Some(Unit::Metre), ..Decoded::default() };
    let mut columns = Columns {
        has_color: options.attributes && scans.iter().any(PointCloud::has_color),
        has_intensity: options.attributes && scans.iter().any(PointCloud::has_intensity),
        ..Columns::default()
    };
    let mut left_out = 0;
    for (index, scan) in chosen(source, &scans, options)? {
        left_out += read_scan(source, &mut pages, (index, scan), options, &mut out, &mut columns)?;
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

/// The pages, once the XML in them has been found to be no more than memory holds.
fn pages(source: &Source, options: &ReadOptions, shared: &Shared) -> Result<Pages, Error> {
    let header = shared.at(0, HEADER.min(shared.length() as usize)).map_err(|e| source.io(e))?;
    let number = |at: usize| header.get(at..at + 8)?.first_chunk().map(|bytes| u64::from_le_bytes(*bytes));
    let (Some(at), Some(length), Some(size)) = (number(24), number(32), number(40)) else {
        return Err(fault(source, 0, format!("a header of {} bytes", header.len())));
    };
    let Some(mut pages) = Pages::new(shared, size) else {
        let found = format!("{} bytes, no whole number of pages of {size}", shared.length());
        return Err(fault(source, 40, found));
    };
    if length > shared.length() {
        return Err(fault(source, 32, format!("XML of {length} bytes")));
    }
    let text = pages.seek(at).and_then(|()| pages.take(length as usize));
    let text = text.map_err(|error| fault(source, at, format!("XML of {length} bytes: {error}")))?;
    let needed = xml::needed(text).map_err(|found| fault(source, at, found))?;
    if needed > limit::bound(source, options) {
        return Err(limit::beyond(source, options, at, &format!("XML that takes {needed} bytes")));
    }
    Pages::new(shared, size).ok_or_else(|| fault(source, 40, format!("pages of {size} bytes")))
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
    pages: &mut Pages,
    (number, scan): (usize, &PointCloud),
    options: &ReadOptions,
    out: &mut Decoded,
    columns: &mut Columns,
) -> Result<u64, Error> {
    let at = scan.file_offset;
    let kinds = scan.prototype.iter().map(|record| record.data_type.clone()).collect();
    let mut fields = Fields::new(scan);
    let packets = Packets::new(pages, at, kinds);
    let mut packets = packets.map_err(|error| fault(source, at, format!("scan {number}: {error}")))?;
    if packets.available().is_none() {
        // Without bits nothing in the file bounds the number of points.
        limit::check(source, options, scan.records, 24 + columns.row_bytes())?;
    }
    let (mut done, mut left_out) = (0, 0);
    while done < scan.records {
        let rows = packets.available().unwrap_or(u64::MAX).min(scan.records - done).min(ROWS);
        let step = if rows == 0 {
            packets.advance().map_err(|error| error.to_string())
        } else {
            fields.decode(&mut packets, rows as usize)
        };
        if let Err(error) = step {
            if options.salvage {
                out.cut(source, options, &format!("points of scan {number}"), scan.records, done)?;
                break;
            }
            let what = format!("scan {number}, point {done} of {}: {error}", scan.records);
            return Err(fault(source, at, what));
        }
        if rows == 0 {
            continue;
        }
        done += rows;
        limit::check(source, options, out.cloud.len() as u64 + rows, 24 + columns.row_bytes())?;
        for row in 0..rows as usize {
            match fields.point(row) {
                Some(point) => {
                    out.cloud.positions.push(point.position);
                    columns.push(&point, number);
                }
                None => left_out += 1,
            }
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
            let color = point.color.unwrap_or([f32::NAN; 3]);
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
