//! Classified points as LAS or LAZ: class and score as extra bytes, the attributes of the input where the point format has a place
//! for them, and otherwise as extra bytes too. The version is that of the input where it can hold that, and 1.4 elsewhere.

mod header;

use super::rows::{names, put};
use super::table::PointTable;
use crate::columns::{Number, Scalar, get};
use crate::quiet;
use crate::read::las::points::{Dimension, standard};
use crate::read::{LasFrame, LasRecord};
use laz::{LasZipCompressor, LazItemRecordBuilder, LazVlr, LazVlrBuilder};
use lineament::{Attribute, Column};
use std::io::{self, Cursor, Seek, SeekFrom, Write};

/// Bytes of the header of a variable length record.
const RECORD: usize = 54;

/// A column that goes into extra bytes.
struct Extra<'a> {
    name: String,
    kind: Scalar,
    column: Source<'a>,
}

enum Source<'a> {
    Class,
    Score,
    Attribute(&'a Column),
}

/// Where everything goes.
struct Plan<'a> {
    format: u8,
    /// The version behind its point.
    minor: u8,
    /// Bytes of a record without the extra ones.
    standard: usize,
    dimensions: Vec<(Dimension, &'a Column)>,
    extras: Vec<Extra<'a>>,
    scale: [f64; 3],
    offset: [f64; 3],
}

/// Writes LAS, or LAZ if `packed`.
pub(super) fn write(out: &mut dyn Write, table: &PointTable, packed: bool) -> io::Result<()> {
    let plan = plan(table)?;
    let extra: usize = plan.extras.iter().map(|e| e.kind.size()).sum();
    let length = u16::try_from(plan.standard + extra).map_err(io::Error::other)?;
    let mut vlrs: Vec<LasRecord> = table.las.map_or(Vec::new(), projections);
    if !plan.extras.is_empty() {
        vlrs.push(LasRecord { user: "LASF_Spec".into(), id: 4, data: descriptions(&plan.extras) });
    }
    let laz = packed.then(|| -> io::Result<LazVlr> {
        let items = LazItemRecordBuilder::default_for_point_format_id(plan.format, extra as u16);
        let laz = LazVlrBuilder::new(items.map_err(io::Error::other)?).build();
        let mut data = Vec::new();
        laz.write_to(&mut data)?;
        vlrs.push(LasRecord { user: LazVlr::USER_ID.into(), id: LazVlr::RECORD_ID, data });
        Ok(laz)
    });
    let laz = laz.transpose()?;
    let mut head = header::header(table, &plan, length, &vlrs, packed)?;
    for vlr in &vlrs {
        head.extend(record(vlr)?);
    }
    let Some(laz) = laz else {
        out.write_all(&head)?;
        return rows(table, &plan, |row| out.write_all(row));
    };
    // The packer goes back to fill in the place of its chunk table, so the packed bytes stay in memory until then.
    let mut file = Cursor::new(head);
    file.seek(SeekFrom::End(0))?;
    // It subtracts GPS times of both signs, which overflows where overflow is checked.
    let packed = quiet::catch(|| -> io::Result<()> {
        let mut packer = LasZipCompressor::new(&mut file, laz).map_err(io::Error::other)?;
        rows(table, &plan, |row| packer.compress_one(row))?;
        packer.done()
    });
    packed.unwrap_or_else(|| Err(io::Error::other("the LAZ packer gave up: write LAS")))?;
    out.write_all(file.get_ref())
}

/// Hands out one record after the other.
fn rows(table: &PointTable, plan: &Plan, mut take: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
    let mut record = Vec::new();
    for index in 0..table.cloud.len() {
        record.clear();
        row(table, plan, index, &mut record)?;
        take(&record)?;
    }
    Ok(())
}

/// The records that say where on earth the points are.
fn projections(frame: &LasFrame) -> Vec<LasRecord> {
    frame.records.iter().filter(|record| record.is_projection()).cloned().collect()
}

fn plan<'a>(table: &PointTable<'a>) -> io::Result<Plan<'a>> {
    let attributes = &table.cloud.attributes;
    let coloured = ["red", "green", "blue"].iter().all(|name| attributes.iter().any(|a| a.name == *name));
    let stored = table.las.filter(|frame| frame.is_stored());
    // Formats from 6 on want well-known text, which a code alone does not give.
    let keys = table.las.is_some_and(|frame| !frame.is_stored() && frame.wkt().is_none());
    let format = match stored.map(|frame| frame.point_format) {
        Some(4) => 1,
        Some(5) => 3,
        Some(9) => 6,
        Some(10) => 8,
        Some(format) => format,
        None if keys => 1 + 2 * u8::from(coloured),
        None => 6 + u8::from(coloured),
    };
    let (standard, all) =
        standard(format).ok_or_else(|| io::Error::other(format!("LAS has no point format {format}")))?;
    let mut dimensions: Vec<(Dimension, &Column)> = Vec::new();
    let mut extras = Vec::new();
    if table.classified() {
        extras.push(Extra { name: "class".into(), kind: Scalar::U8, column: Source::Class });
    }
    if !table.scores.is_empty() {
        extras.push(Extra { name: "score".into(), kind: Scalar::F32, column: Source::Score });
    }
    let named = names(table);
    let names = &named[extras.len()..];
    let mut free: Vec<Option<Dimension>> = all.into_iter().map(Some).collect();
    for (attribute, (name, kind)) in attributes.iter().zip(names) {
        let place = free.iter_mut().find(|d| d.as_ref().is_some_and(|d| fits(d, attribute)));
        match place.and_then(Option::take) {
            Some(dimension) => dimensions.push((dimension, &attribute.values)),
            None => extras.push(Extra {
                name: name.clone(),
                kind: *kind,
                column: Source::Attribute(&attribute.values),
            }),
        }
    }
    let (scale, offset) = stored.map_or_else(|| grid(table), |frame| (frame.scale, frame.offset));
    let minor = version(table, format, !extras.is_empty());
    Ok(Plan { format, minor, standard, dimensions, extras, scale, offset })
}

/// The version behind its point: that of the input, from 1.2 on, unless points carry what only 1.4 has.
fn version(table: &PointTable, format: u8, extras: bool) -> u8 {
    let older = table.las.filter(|frame| frame.is_stored() && frame.minor < 4);
    let holds = format <= 3 && !extras && u32::try_from(table.cloud.len()).is_ok();
    older.filter(|_| holds).map_or(4, |frame| frame.minor.max(2))
}

/// The version, 1.2 to 1.4, behind its point, that these points are written in.
pub(super) fn written_version(table: &PointTable) -> Option<u8> {
    plan(table).ok().map(|plan| plan.minor)
}

/// Whether a dimension is this attribute and holds all its values.
fn fits(dimension: &Dimension, attribute: &Attribute) -> bool {
    let holds = |value: f64| match dimension.bits {
        Some((_, mask)) => u8::narrow(value).is_some_and(|value| value <= mask),
        None => crate::columns::push(&mut dimension.field.kind.column(1), value),
    };
    dimension.name == attribute.name && (0..attribute.values.len()).all(|i| holds(get(&attribute.values, i)))
}

/// The finest decimal scale with which all finite coordinates fit 32 bits, and offsets in the middle.
fn grid(table: &PointTable) -> ([f64; 3], [f64; 3]) {
    let finite = || table.cloud.positions.iter().filter(|p| p.iter().all(|c| c.is_finite()));
    let limit = |a: usize, pick: fn(f64, f64) -> f64| finite().map(|p| p[a]).reduce(pick).unwrap_or(0.0);
    let of = |a: usize| {
        let (low, high) = (limit(a, f64::min), limit(a, f64::max));
        let offset = (low + 0.5 * (high - low)).round();
        let reach = (high - offset).max(offset - low);
        let least = (reach / 2e9).max(high.abs().max(low.abs()) * 1e-15).max(1e-12);
        (10f64.powi(least.log10().ceil() as i32), offset)
    };
    let axes = [of(0), of(1), of(2)];
    (axes.map(|axis| axis.0), axes.map(|axis| axis.1))
}

/// A coordinate as the integer that is stored.
fn stored(plan: &Plan, position: [f64; 3], axis: usize) -> io::Result<i32> {
    let value = ((position[axis] - plan.offset[axis]) / plan.scale[axis]).round();
    i32::narrow(value).ok_or_else(|| {
        io::Error::other(format!(
            "coordinate {} does not fit LAS with scale {}: drop non-finite points, or write PLY",
            position[axis], plan.scale[axis]
        ))
    })
}

/// Fills in a record that is empty.
fn row(table: &PointTable, plan: &Plan, index: usize, record: &mut Vec<u8>) -> io::Result<()> {
    record.resize(plan.standard, 0);
    for axis in 0..3 {
        let value = stored(plan, table.cloud.positions[index], axis)?;
        record[4 * axis..4 * axis + 4].copy_from_slice(&value.to_le_bytes());
    }
    for (dimension, column) in &plan.dimensions {
        let (offset, value) = (dimension.field.offset, get(column, index));
        if let Some((shift, mask)) = dimension.bits {
            record[offset] |= (value as u8 & mask) << shift;
            continue;
        }
        let mut one = dimension.field.kind.column(1);
        crate::columns::push(&mut one, value);
        let mut bytes = Vec::with_capacity(8);
        put(&one, 0, true, &mut bytes);
        record[offset..offset + bytes.len()].copy_from_slice(&bytes);
    }
    for extra in &plan.extras {
        match extra.column {
            Source::Class => record.push(table.classes[index]),
            Source::Score => table.scores[index].put(record),
            Source::Attribute(column) => put(column, index, true, record),
        }
    }
    Ok(())
}

/// The descriptions of the extra bytes.
fn descriptions(extras: &[Extra]) -> Vec<u8> {
    let mut data = Vec::new();
    for extra in extras {
        let mut one = [0u8; 192];
        one[2] = match extra.kind {
            Scalar::U8 => 1,
            Scalar::I8 => 2,
            Scalar::U16 => 3,
            Scalar::I16 => 4,
            Scalar::U32 => 5,
            Scalar::I32 => 6,
            Scalar::U64 => 7,
            Scalar::I64 => 8,
            Scalar::F16 | Scalar::F32 => 9,
            Scalar::F64 => 10,
        };
        for (slot, byte) in one[4..36].iter_mut().zip(extra.name.bytes()) {
            *slot = byte;
        }
        data.extend(one);
    }
    data
}

/// A variable length record with its header.
fn record(vlr: &LasRecord) -> io::Result<Vec<u8>> {
    let length = u16::try_from(vlr.data.len()).map_err(io::Error::other)?;
    let mut bytes = vec![0; RECORD];
    for (slot, byte) in bytes[2..18].iter_mut().zip(vlr.user.bytes()) {
        *slot = byte;
    }
    bytes[18..20].copy_from_slice(&vlr.id.to_le_bytes());
    bytes[20..22].copy_from_slice(&length.to_le_bytes());
    bytes.extend_from_slice(&vlr.data);
    Ok(bytes)
}
