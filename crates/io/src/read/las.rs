//! LAS 1.0 to 1.4, all point formats, and LAZ, its compressed form (ASPRS LAS 1.4 R15; Isenburg 2013). COPC files are
//! LAZ; with bounds only the nodes that overlap them are read. Coordinates are `integer * scale + offset`, as the format defines them.

mod chunks;
mod copc;
mod geo;
mod gps;
mod header;
mod laz;
mod median;
mod noise;
mod packing;
mod point14;
pub(crate) mod points;
mod records;
mod unpacker;
mod walk;

use super::rows::{Grid, Table, room};
use super::{Decoded, ReadOptions};
use crate::columns::Endian;
use crate::error::Error;
use crate::source::Source;
use header::Header;
use points::Dimension;

pub use header::{LasFrame, Record};
pub(crate) use records::WKT;

/// Reads a LAS or LAZ input from its first byte.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let header = header::parse(source)?;
    if header.compressed {
        source.keep();
    }
    let mut frame = records::read(source, &header)?;
    let mut out = Decoded::default();
    let dimensions = points::dimensions(source, &header, &frame)?;
    let mut table = table(&header, &dimensions, options);
    let fields: Vec<_> = dimensions.iter().map(|d| d.field).collect();
    let rows = if header.compressed {
        let taken = laz::read(source, &header, &frame, options, &fields, &mut table)?;
        note_extended(taken.extended, &mut out);
        frame.records.extend(taken.projections);
        if taken.passed > 0 {
            out.ignored.push(format!("{} points in nodes outside the bounds", taken.passed));
        }
        taken.rows + taken.passed
    } else {
        skip_to_points(source, &header)?;
        let room = room(source, header.points, header.record_length as u64);
        table.reserve(room);
        let rows = table.read(source, header.points, header.record_length, &fields, Endian::Little)?;
        if rows == header.points {
            let found = records::extended(&header, &mut frame.records, |at, count| ahead(source, at, count))?;
            note_extended(found, &mut out);
        }
        note_rest(source, &header, rows, &mut out)?;
        rows
    };
    if rows < header.points {
        let passed = rows - table.positions.len() as u64;
        out.cut(source, options, "points", header.points - passed, rows - passed)?;
    }
    note_bounds(&table, &mut out);
    points::finish(&mut table, &dimensions);
    out.cloud = table.into_cloud();
    out.noise = noise::leave_out(source.name(), &mut out.cloud, options)?;
    note(&header, &frame, options, &mut out);
    out.crs = frame.system();
    out.las = Some(frame);
    Ok(out)
}

fn table(header: &Header, dimensions: &[Dimension], options: &ReadOptions) -> Table {
    let wanted = |d: &Dimension| options.attributes || options.without_noise && noise::tells(&d.name);
    let kept = dimensions.iter().enumerate().skip(3).filter(|(_, d)| wanted(d));
    let attributes = kept.map(|(index, d)| (index, d.name.clone(), d.field.kind)).collect();
    let Header { scale, offset, bounds: (low, high), .. } = *header;
    // A step of the grid beyond the bounds is rounding.
    let bounds =
        [std::array::from_fn(|a| low[a] - scale[a].abs()), std::array::from_fn(|a| high[a] + scale[a].abs())];
    let grid = Some(Grid { scale, offset, bounds, outside: 0 });
    Table { grid, ..Table::new([0, 1, 2], attributes, 0) }
}

fn skip_to_points(source: &mut Source, header: &Header) -> Result<(), Error> {
    let gap = header.points_at.saturating_sub(source.offset());
    if source.skip(gap)? < gap {
        return Err(source.ends_early("bytes before the points", gap, 0));
    }
    Ok(())
}

/// Bytes at a place that lies ahead; `None` where the input ends before or has passed it.
fn ahead(source: &mut Source, at: u64, count: usize) -> Result<Option<Vec<u8>>, Error> {
    let Some(gap) = at.checked_sub(source.offset()) else { return Ok(None) };
    source.skip(gap)?;
    let found = source.peek(count)?.get(..count).map(<[u8]>::to_vec);
    source.consume(count);
    Ok(found)
}

/// Notes the extended records that are not in the cloud, and those that are not in the input.
fn note_extended((others, missing): (u32, u32), out: &mut Decoded) {
    if others > 0 {
        out.ignored.push(format!("{others} extended variable length records"));
    }
    if missing > 0 {
        out.ignored
            .push(format!("{missing} extended records that the header announces and that are not there"));
    }
}

/// Counts the points outside the bounds that the header states: a decoder cannot notice all damage.
fn note_bounds(table: &Table, out: &mut Decoded) {
    let outside = table.grid.as_ref().map_or(0, |grid| grid.outside);
    if outside > 0 {
        out.ignored.push(format!("the bounds in the header: {outside} points lie outside them"));
    }
}

/// Notes the bytes after the points, other than extended records.
fn note_rest(source: &mut Source, header: &Header, rows: u64, out: &mut Decoded) -> Result<(), Error> {
    let extra = source.drain()?;
    if rows == header.points && header.minor < 4 {
        super::rows::note_extra(extra, header.record_length as u64, "point", out);
    }
    Ok(())
}

fn note(header: &Header, frame: &LasFrame, options: &ReadOptions, out: &mut Decoded) {
    if header.has_waves() {
        out.ignored.push("wave packets".into());
    }
    if !options.attributes {
        out.ignored.push("attributes".into());
    }
    let other = frame.records.len() - frame.records.iter().filter(|r| r.is_projection()).count();
    if other > 0 {
        out.ignored.push(format!("{other} variable length records"));
    }
}
