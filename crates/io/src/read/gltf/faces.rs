//! The triangles of a mesh: lists, strips and fans of vertices, numbered or in their order.

use super::accessor;
use super::buffers::Buffers;
use super::document::{Document, Primitive};
use crate::error::Error;
use crate::read::Decoded;
use crate::read::mesh::NO_VERTEX;
use std::collections::BTreeMap;

/// Bytes that a triangle takes in memory, at least.
const TRIANGLE: u64 = 16;

/// Appends the triangles of a mesh. `firsts` leads from an accessor of positions to its first vertex. Primitives that hold none,
/// or whose numbers cannot be read, are counted as one odd face each; beyond `room` bytes nothing more is read.
pub(super) fn append(
    document: &Document,
    mesh: usize,
    firsts: &BTreeMap<usize, usize>,
    buffers: &mut Buffers,
    room: u64,
    out: &mut Decoded,
) -> Result<(), Error> {
    for primitive in document.meshes.get(mesh).iter().flat_map(|mesh| &mesh.primitives) {
        let mode = primitive.mode.unwrap_or(4);
        let place =
            primitive.attributes.position.and_then(|position| Some((position, *firsts.get(&position)?)));
        let (Some((position, first)), 4..=6) = (place, mode) else { continue };
        if let Some(stated) = primitive.indices.and_then(|index| document.accessors.get(index)) {
            buffers.load(accessor::views(stated))?;
        }
        let count = document.accessors.get(position).map_or(0, |accessor| accessor.count);
        let held = TRIANGLE * out.faces.len() as u64;
        match numbers(document, primitive, count, buffers, room.saturating_sub(held)) {
            Some(numbers) => triangles(&numbers, mode, (first as u64, count), out),
            None => out.odd_faces += 1,
        }
    }
    Ok(())
}

/// The numbers of the vertices of a primitive in their order; `None` if they cannot be read, or take more than `room`.
fn numbers(
    document: &Document,
    primitive: &Primitive,
    count: u64,
    buffers: &Buffers,
    room: u64,
) -> Option<Vec<u32>> {
    let Some(index) = primitive.indices else {
        return (count.saturating_mul(TRIANGLE) <= room).then(|| (0..count as u32).collect());
    };
    let stated = document.accessors.get(index)?;
    (stated.count.saturating_mul(TRIANGLE) <= room).then(|| accessor::numbers(stated, buffers)).flatten()
}

/// Adds the triangles of a mode. `first` and `count` are those of the vertices that the numbers count.
fn triangles(numbers: &[u32], mode: u32, (first, count): (u64, u64), out: &mut Decoded) {
    let place = |n: u32| {
        let vertex = Some(first + u64::from(n)).filter(|_| u64::from(n) < count);
        vertex.and_then(|vertex| u32::try_from(vertex).ok()).unwrap_or(NO_VERTEX)
    };
    let mut add = |corners: [u32; 3]| out.faces.push(&corners.map(place));
    match mode {
        4 => numbers.chunks_exact(3).for_each(|t| add([t[0], t[1], t[2]])),
        5 => numbers.windows(3).enumerate().for_each(|(i, t)| add([t[0], t[1 + i % 2], t[2 - i % 2]])),
        _ => numbers.iter().skip(1).zip(numbers.iter().skip(2)).for_each(|(&a, &b)| add([numbers[0], a, b])),
    }
}
