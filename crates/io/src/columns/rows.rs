//! Columns from the rows of a file.

use super::scalar::{Scalar, each_column};
use super::stored::{Endian, Half, Number, Stored, number};
use lineament::Column;
use rayon::prelude::*;

/// Appends field `offset` of every row (`stride` bytes each) of `rows` to a column of the field's type.
pub(crate) fn append(column: &mut Column, rows: &[u8], stride: usize, offset: usize, endian: Endian) {
    each_column!(column, values => extend(values, rows, stride, offset, endian));
}

/// Appends a field of this type, which may be one that the column holds as another.
pub(crate) fn append_as(
    kind: Scalar,
    column: &mut Column,
    rows: &[u8],
    stride: usize,
    offset: usize,
    endian: Endian,
) {
    match (kind, column) {
        (Scalar::F16, Column::F32(values)) => {
            each_row(values, rows, stride, |row| number::<Half>(&row[offset..], endian).single());
        }
        (_, column) => append(column, rows, stride, offset, endian),
    }
}

fn extend<T: Number>(values: &mut Vec<T>, rows: &[u8], stride: usize, offset: usize, endian: Endian) {
    each_row(values, rows, stride, |row| number::<T>(&row[offset..], endian));
}

/// Bytes of rows from which on threads share them: most of the time goes into touching memory that is fresh.
pub(crate) const SHARED: usize = 1 << 20;
/// Rows that a thread takes at least.
const LEAST_ROWS: usize = 1 << 13;

/// Appends the value that `take` reads from every row (`stride` bytes each) of `rows`, in their order.
fn each_row<T: Send>(
    values: &mut Vec<T>,
    rows: &[u8],
    stride: usize,
    take: impl Fn(&[u8]) -> T + Send + Sync,
) {
    if rows.len() < SHARED {
        values.extend(rows.chunks_exact(stride).map(take));
    } else {
        values.par_extend(rows.par_chunks_exact(stride).with_min_len(LEAST_ROWS).map(take));
    }
}

/// Appends the points whose coordinates are fields, at `offsets` and all of one type, of every row (`stride` bytes each).
pub(crate) fn append_points(
    points: &mut Vec<[f64; 3]>,
    rows: &[u8],
    stride: usize,
    (kind, offsets): (Scalar, [usize; 3]),
    endian: Endian,
) {
    if kind == Scalar::F16 {
        return points_like::<Half>(&[], points, rows, stride, offsets, endian);
    }
    each_column!(&kind.column(0), values => points_like(values, points, rows, stride, offsets, endian));
}

/// Points from fields of the type of `_kind`.
fn points_like<T: Stored>(
    _kind: &[T],
    points: &mut Vec<[f64; 3]>,
    rows: &[u8],
    stride: usize,
    offsets: [usize; 3],
    endian: Endian,
) {
    let point = |row: &[u8], endian| offsets.map(|offset| number::<T>(&row[offset..], endian).to_f64());
    match endian {
        Endian::Little => each_row(points, rows, stride, |row| point(row, Endian::Little)),
        Endian::Big => each_row(points, rows, stride, |row| point(row, Endian::Big)),
    }
}
