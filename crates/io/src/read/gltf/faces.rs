//! The triangles of a mesh: lists, strips and fans of vertices, numbered or in their order.

use super::accessor;
use super::buffers::Buffers;
use super::document::{Document, Primitive};
use crate::error::Error;
use crate::read::Decoded;
use crate::read::mesh::NO_VERTEX;
use std::collections::BTreeMap;

/// Bytes that a triangle counts for: its own, and the least that sampling takes for it. Any number of primitives and nodes may share
/// the bytes that a triangle is read from.
const TRIANGLE: u64 = 48;

/// Appends the triangles of a mesh. `firsts` leads from an accessor of positions to its first vertex. Primitives whose numbers cannot be
/// read are counted as one odd face each. So many
/// triangles that they take more than `room` bytes are an error, which `beyond` makes of their number.
pub(super) fn append(
    document: &Document,
    mesh: usize,
    firsts: &BTreeMap<usize, usize>,
    buffers: &mut Buffers,
    (room, beyond): (u64, &dyn Fn(u64) -> Error),
    out: &mut Decoded,
) -> Result<(), Error> {
    for primitive in document.meshes.get(mesh).iter().flat_map(|mesh| &mesh.primitives) {
        let mode = primitive.mode.unwrap_or(4);
        let place =
            primitive.attributes.position.and_then(|position| Some((position, *firsts.get(&position)?)));
        let (Some((position, first)), 4..=6) = (place, mode) else { continue };
        let indices = primitive.indices.and_then(|index| document.accessors.get(index));
        if let Some(stated) = indices {
            buffers.load(accessor::views(stated))?;
        }
        let count = document.accessors.get(position).map_or(0, |accessor| accessor.count);
        let corners = indices.map_or(count, |indices| indices.count);
        let more = if mode == 4 { corners / 3 } else { corners };
        let all = more.saturating_add(out.faces.len() as u64);
        if all.saturating_mul(TRIANGLE) > room {
            return Err(beyond(all));
        }
        match numbers(document, primitive, count, buffers) {
            Some(numbers) => triangles(&numbers, mode, (first as u64, count), out),
            None => out.odd_faces += 1,
        }
    }
    Ok(())
}

/// The numbers of the vertices of a primitive in their order; `None` if they cannot be read.
fn numbers(document: &Document, primitive: &Primitive, count: u64, buffers: &Buffers) -> Option<Vec<u32>> {
    let Some(index) = primitive.indices else { return Some((0..count as u32).collect()) };
    accessor::numbers(document.accessors.get(index)?, buffers)
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
