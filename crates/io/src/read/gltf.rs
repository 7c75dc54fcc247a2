//! glTF 2.0 (Khronos), binary (GLB) or JSON: the vertices of every mesh of the scene, moved by the nodes that hold it, and its
//! triangles where they are asked for.
//! Coordinates stay in the format's frame, in which y points up.

mod accessor;
mod buffers;
mod document;
mod faces;
mod transform;

use super::{Decoded, ReadOptions, limit};
use crate::columns::{Endian, Scalar};
use crate::error::{Error, Place};
use crate::source::Source;
use buffers::Buffers;
use document::Document;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use transform::{IDENTITY, Transform};

/// First bytes of the binary form.
pub(crate) const MAGIC: &[u8] = b"glTF";
/// Bytes before the JSON of the binary form, and before the binary part.
const HEADER: usize = 20;
const CHUNK: usize = 8;

/// Whether text begins as the JSON form does.
pub(crate) fn begins(start: &[u8]) -> bool {
    start.trim_ascii_start().starts_with(b"{") && memchr::memmem::find(start, b"\"asset\"").is_some()
}

/// Reads a glTF input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let packed = source.peek(MAGIC.len())?.starts_with(MAGIC);
    let text = if packed { packed_text(source, options)? } else { whole(source)? };
    document::check(source, options, &text)?;
    let json = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&text);
    let document: Document = serde_json::from_slice(json)
        .map_err(|error| source.malformed(format!("JSON: {error}"), "the file is damaged, or no glTF"))?;
    let mut out = Decoded::default();
    document.extensions(source, &mut out)?;
    // The text of a pipe is taken in other steps than that of a file: its end is no place to name.
    let at = if packed { source.offset() } else { 0 };
    let binary = if packed { binary(source)? } else { None };
    let mut buffers = Buffers::new(source, &document, binary);
    let fault = |found: String| source.fault(Place::Byte(at), found, "the file is damaged, or not whole");
    let too_many = |faces: u64| limit::beyond(source, options, 0, &format!("{faces} triangles of all nodes"));
    let meshes = accessors(&document);
    for (mesh, transform) in placed(&document).map_err(fault)? {
        let mut firsts = BTreeMap::new();
        for &accessor in meshes.get(mesh).into_iter().flatten() {
            let stated = document.accessors.get(accessor);
            let stated = stated.ok_or_else(|| fault(format!("accessor {accessor}, which does not exist")))?;
            buffers.load(accessor::views(stated))?;
            let needed = stated.count.saturating_add(out.cloud.len() as u64).saturating_mul(24);
            if needed > buffers.room(options, text.capacity()) {
                let what = format!("{} vertices that unpack to {needed} bytes", stated.count);
                return Err(limit::beyond(source, options, 0, &what));
            }
            firsts.insert(accessor, out.cloud.len());
            accessor::append(stated, &buffers, &transform, &mut out.cloud.positions)
                .map_err(|found| fault(format!("accessor {accessor} {found}")))?;
        }
        if options.mesh.is_some() {
            let room = buffers.room(options, text.capacity()).saturating_sub(24 * out.cloud.len() as u64);
            faces::append(&document, mesh, &firsts, &mut buffers, (room, &too_many), &mut out)?;
        }
    }
    out.beside = buffers.files();
    let what = if options.mesh.is_some() { "vertices and triangles" } else { "vertices" };
    out.ignored.push(format!("everything but the {what}; y is up"));
    Ok(out)
}

/// The accessors of positions of every mesh, each once. Those that are said to be empty are left out: any number of nodes may
/// hold a mesh, so that what they hold must take memory, which has a bound.
fn accessors(document: &Document) -> Vec<BTreeSet<usize>> {
    let filled = |index: &usize| document.accessors.get(*index).is_none_or(|accessor| accessor.count > 0);
    let meshes =
        document.meshes.iter().map(|mesh| mesh.primitives.iter().filter_map(|p| p.attributes.position));
    meshes.map(|positions| positions.filter(filled).collect()).collect()
}

/// The meshes that nodes of the scene hold, each with what the nodes above it do to it.
fn placed(document: &Document) -> Result<Vec<(usize, Transform)>, String> {
    if document.nodes.is_empty() {
        return Ok((0..document.meshes.len()).map(|mesh| (mesh, IDENTITY)).collect());
    }
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    let mut stack: Vec<(usize, Transform)> =
        document.roots()?.into_iter().rev().map(|root| (root, IDENTITY)).collect();
    while let Some((index, above)) = stack.pop() {
        let Some(node) = document.nodes.get(index).filter(|_| seen.insert(index)) else {
            return Err(format!("node {index}, which does not exist or stands in the scene twice"));
        };
        let transform = transform::of(node, &above);
        stack.extend(node.children.iter().rev().map(|&child| (child, transform)));
        found.extend(node.mesh.map(|mesh| (mesh, transform)));
    }
    Ok(found)
}

/// All bytes of the JSON form.
fn whole(source: &mut Source) -> Result<Vec<u8>, Error> {
    let mut text = Vec::new();
    let read = source.seekable()?.read_to_end(&mut text);
    read.map_err(|error| source.io(error))?;
    Ok(text)
}

/// The JSON part of the binary form; the source then stands behind it.
fn packed_text(source: &mut Source, options: &ReadOptions) -> Result<Vec<u8>, Error> {
    let header = source.peek(HEADER)?.to_vec();
    let number = |at: usize| header.get(at..at + 4).map(|b| Scalar::U32.value(b, Endian::Little) as u64);
    let (Some(2), Some(length), Some(json), Some(b"JSON")) =
        (number(4), number(8), number(12), header.get(16..20))
    else {
        return Err(
            source.malformed("a header that is not that of a GLB of version 2", "the file is damaged")
        );
    };
    let there = source.size();
    if source.remaining().is_some() && there < length {
        return Err(source.ends_early("bytes", length, there));
    }
    limit::check(source, options, json, 2)?;
    let bytes = source.peek(HEADER + json as usize)?;
    let Some(text) = bytes.get(HEADER..HEADER + json as usize).map(<[u8]>::to_vec) else {
        let there = bytes.len() as u64;
        return Err(source.ends_early("bytes of JSON", json, there.saturating_sub(HEADER as u64)));
    };
    source.consume(HEADER + json as usize);
    Ok(text)
}

/// The binary part; `None` if there is none.
fn binary(source: &mut Source) -> Result<Option<Vec<u8>>, Error> {
    let header = source.peek(CHUNK)?;
    let Some(length) = header.get(..4).map(|b| Scalar::U32.value(b, Endian::Little) as usize) else {
        return Ok(None);
    };
    if header.get(4..8) != Some(b"BIN\0") {
        return Ok(None);
    }
    if source.remaining().is_some_and(|here| here < (CHUNK + length) as u64) {
        let there = source.remaining().unwrap_or(0).saturating_sub(CHUNK as u64);
        return Err(source.ends_early("bytes of the binary part", length as u64, there));
    }
    let bytes = source.peek(CHUNK + length)?;
    let there = bytes.len().saturating_sub(CHUNK) as u64;
    let Some(binary) = bytes.get(CHUNK..CHUNK + length).map(<[u8]>::to_vec) else {
        return Err(source.ends_early("bytes of the binary part", length as u64, there));
    };
    source.consume(CHUNK + length);
    Ok(Some(binary))
}
