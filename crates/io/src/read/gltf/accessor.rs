//! The positions of an accessor, plain or sparse.

use super::buffers::Buffers;
use super::document::{Accessor, Sparse};
use super::transform::{Transform, apply};
use crate::columns::{Endian, Scalar};

/// The views that an accessor needs.
pub(super) fn views(accessor: &Accessor) -> impl Iterator<Item = usize> {
    let sparse =
        accessor.sparse.iter().flat_map(|sparse| [sparse.indices.buffer_view, sparse.values.buffer_view]);
    accessor.buffer_view.into_iter().chain(sparse)
}

/// Appends positions, transformed; the error is the fault of the accessor.
pub(super) fn append(
    accessor: &Accessor,
    buffers: &Buffers,
    transform: &Transform,
    out: &mut Vec<[f64; 3]>,
) -> Result<(), String> {
    let (kind, unit) = component(accessor)?;
    if accessor.kind != "VEC3" {
        return Err(format!("holds {} instead of VEC3", crate::number::shown(accessor.kind.as_bytes())));
    }
    let first = out.len();
    let size = 3 * kind.size() as u64;
    match (accessor.buffer_view, &accessor.sparse) {
        (Some(view), _) => {
            let stride = buffers.view(view)?.byte_stride.unwrap_or(size);
            if stride < size || stride > MOST {
                return Err(format!("has elements of {size} bytes every {stride}"));
            }
            let rows = elements(buffers, view, accessor.byte_offset, accessor.count, size, stride)?;
            out.extend(rows.chunks(stride as usize).map(|row| point(row, kind, unit)));
        }
        (None, Some(_)) => {
            let end = usize::try_from(accessor.count).ok().and_then(|count| first.checked_add(count));
            out.resize(end.ok_or("has too many elements")?, [0.0; 3]);
        }
        (None, None) => {
            return Err("has no bytes: they may be packed by an extension, which is not read".into());
        }
    }
    if let Some(sparse) = &accessor.sparse {
        if sparse.count > accessor.count {
            return Err(format!("has {} sparse elements of {}", sparse.count, accessor.count));
        }
        replace(sparse, buffers, (kind, unit), &mut out[first..])?;
    }
    out[first..].iter_mut().for_each(|p| *p = apply(transform, *p));
    Ok(())
}

/// The whole numbers of an accessor that others are counted by; `None` if it is of another kind or its bytes are not there.
pub(super) fn numbers(accessor: &Accessor, buffers: &Buffers) -> Option<Vec<u32>> {
    let kind = match accessor.component_type {
        5121 => Scalar::U8,
        5123 => Scalar::U16,
        5125 => Scalar::U32,
        _ => return None,
    };
    let (size, view) = (kind.size() as u64, accessor.buffer_view?);
    let plain = accessor.kind == "SCALAR" && accessor.sparse.is_none();
    let rows =
        elements(buffers, view, accessor.byte_offset, accessor.count, size, size).ok().filter(|_| plain)?;
    Some(rows.chunks_exact(kind.size()).map(|row| kind.value(row, Endian::Little) as u32).collect())
}

/// The greatest stride that the format allows.
const MOST: u64 = 252;

/// The type of the numbers, and the value of one.
fn component(accessor: &Accessor) -> Result<(Scalar, f64), String> {
    let (kind, largest) = match accessor.component_type {
        5126 => (Scalar::F32, 1.0),
        5120 => (Scalar::I8, 127.0),
        5121 => (Scalar::U8, 255.0),
        5122 => (Scalar::I16, 32767.0),
        5123 => (Scalar::U16, 65535.0),
        other => return Err(format!("has component type {other}")),
    };
    Ok((kind, if accessor.normalized { 1.0 / largest } else { 1.0 }))
}

/// The bytes of `count` elements of `size` bytes, `stride` bytes apart.
fn elements<'a>(
    buffers: &'a Buffers,
    view: usize,
    from: u64,
    count: u64,
    size: u64,
    stride: u64,
) -> Result<&'a [u8], String> {
    let needed = count.checked_sub(1).map_or(Some(0), |rows| rows.checked_mul(stride)?.checked_add(size));
    buffers.bytes(view, from, needed.ok_or_else(|| format!("has {count} elements"))?)
}

fn point(row: &[u8], kind: Scalar, unit: f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| kind.value(&row[axis * kind.size()..], Endian::Little) * unit)
}

/// Puts the sparse elements in their places.
fn replace(
    sparse: &Sparse,
    buffers: &Buffers,
    (kind, unit): (Scalar, f64),
    points: &mut [[f64; 3]],
) -> Result<(), String> {
    let index = match sparse.indices.component_type {
        5121 => Scalar::U8,
        5123 => Scalar::U16,
        5125 => Scalar::U32,
        other => return Err(format!("has sparse indices of component type {other}")),
    };
    let (wide, size) = (index.size() as u64, 3 * kind.size() as u64);
    let part = &sparse.indices;
    let indices = elements(buffers, part.buffer_view, part.byte_offset, sparse.count, wide, wide)?;
    let part = &sparse.values;
    let values = elements(buffers, part.buffer_view, part.byte_offset, sparse.count, size, size)?;
    for (at, row) in indices.chunks(index.size()).zip(values.chunks(3 * kind.size())) {
        let at = index.value(at, Endian::Little) as usize;
        let there = points.len();
        let place = points.get_mut(at).ok_or_else(|| format!("has a sparse element {at} of {there}"))?;
        *place = point(row, kind, unit);
    }
    Ok(())
}
