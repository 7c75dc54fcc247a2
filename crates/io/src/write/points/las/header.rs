//! The public header block of LAS outputs.

use super::{Plan, RECORD};
use crate::columns::get;
use crate::read::{LasRecord, WKT};
use crate::write::points::table::PointTable;
use std::io;

/// Bytes of the header by version: up to 1.2, of 1.3, of 1.4.
const SIZES: [usize; 3] = [227, 235, 375];
/// Returns that are counted, before 1.4 and since.
const LEGACY_RETURNS: usize = 5;
const RETURNS: usize = 15;
/// Bits of the global encoding: the kind of GPS times; return numbers that were made up; well-known text.
const GPS: u16 = 1;
const SYNTHETIC: u16 = 1 << 3;
const HAS_WKT: u16 = 1 << 4;

/// The header for records of `length` bytes behind these variable length records.
pub(super) fn header(
    table: &PointTable,
    plan: &Plan,
    length: u16,
    vlrs: &[LasRecord],
    packed: bool,
) -> io::Result<Vec<u8>> {
    let size = SIZES[usize::from(plan.minor.clamp(2, 4)) - 2];
    let mut bytes = vec![0u8; size];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    let points_at = size + vlrs.iter().map(|vlr| RECORD + vlr.data.len()).sum::<usize>();
    put(0, b"LASF");
    put(6, &encoding(table, plan, vlrs).to_le_bytes());
    put(24, &[1, plan.minor]);
    put(26, b"lineament");
    put(58, b"lineament");
    // The day of the input: the same input gives the same bytes on every day.
    let created = table.las.map_or([0; 2], |frame| frame.created);
    put(90, &created[0].to_le_bytes());
    put(92, &created[1].to_le_bytes());
    put(94, &(size as u16).to_le_bytes());
    put(96, &u32::try_from(points_at).map_err(io::Error::other)?.to_le_bytes());
    put(100, &(vlrs.len() as u32).to_le_bytes());
    put(104, &[plan.format | if packed { 0x80 } else { 0 }]);
    put(105, &length.to_le_bytes());
    counts(table, plan, &mut put);
    for axis in 0..3 {
        put(131 + 8 * axis, &plan.scale[axis].to_le_bytes());
        put(155 + 8 * axis, &plan.offset[axis].to_le_bytes());
        let finite = || table.cloud.positions.iter().map(|p| p[axis]).filter(|c| c.is_finite());
        put(179 + 16 * axis, &finite().reduce(f64::max).unwrap_or(0.0).to_le_bytes());
        put(187 + 16 * axis, &finite().reduce(f64::min).unwrap_or(0.0).to_le_bytes());
    }
    Ok(bytes)
}

/// The global encoding: what the input says of times and returns, and whether its system is defined by well-known text.
fn encoding(table: &PointTable, plan: &Plan, vlrs: &[LasRecord]) -> u16 {
    let kept = if plan.minor > 2 { GPS | SYNTHETIC } else { GPS };
    let input = table.las.map_or(0, |frame| frame.encoding) & kept;
    let wkt = plan.minor >= 4 && vlrs.iter().any(|vlr| vlr.is_projection() && vlr.id == WKT);
    input | if wkt { HAS_WKT } else { 0 }
}

/// The numbers of points, all of them and by return; the fields of old where they hold them and the point format is of old too.
fn counts(table: &PointTable, plan: &Plan, put: &mut impl FnMut(usize, &[u8])) {
    let all = table.cloud.len() as u64;
    let mut returns = [0u64; RETURNS];
    if let Some((_, column)) = plan.dimensions.iter().find(|(d, _)| d.name == "return_number") {
        for index in 0..table.cloud.len() {
            let number = get(column, index) as usize;
            if let Some(count) = number.checked_sub(1).and_then(|at| returns.get_mut(at)) {
                *count += 1;
            }
        }
    }
    let legacy = |count: u64| u32::try_from(count).ok().filter(|_| plan.format < 6).unwrap_or(0);
    put(107, &legacy(all).to_le_bytes());
    for (index, &count) in returns.iter().enumerate() {
        if index < LEGACY_RETURNS {
            put(111 + 4 * index, &legacy(count).to_le_bytes());
        }
        if plan.minor >= 4 {
            put(255 + 8 * index, &count.to_le_bytes());
        }
    }
    if plan.minor >= 4 {
        put(247, &all.to_le_bytes());
    }
}
