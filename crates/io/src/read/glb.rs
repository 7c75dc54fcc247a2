//! Binary glTF 2.0 (Khronos): the vertices of every mesh of the scene, moved by the nodes that hold it. Coordinates stay in
//! the format's frame, in which y points up.

use super::{Decoded, ReadOptions, limit};
use crate::columns::{Endian, Scalar};
use crate::error::{Error, Place};
use crate::source::Source;
use serde::Deserialize;
use std::collections::BTreeSet;

/// Bytes before the JSON, and before the binary part.
const HEADER: usize = 20;
const CHUNK: usize = 8;
/// Bytes in memory for a byte of JSON, at worst.
const JSON_FACTOR: u64 = 48;

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
struct Document {
    scene: Option<usize>,
    scenes: Vec<Scene>,
    nodes: Vec<Node>,
    meshes: Vec<Mesh>,
    accessors: Vec<Accessor>,
    buffer_views: Vec<View>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Scene {
    nodes: Vec<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Node {
    mesh: Option<usize>,
    children: Vec<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Mesh {
    primitives: Vec<Primitive>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Primitive {
    attributes: Attributes,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Attributes {
    #[serde(rename = "POSITION")]
    position: Option<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
struct Accessor {
    buffer_view: Option<usize>,
    byte_offset: u64,
    component_type: u32,
    count: u64,
    #[serde(rename = "type")]
    kind: String,
    normalized: bool,
    sparse: Option<serde::de::IgnoredAny>,
}

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
struct View {
    buffer: usize,
    byte_offset: u64,
    byte_length: u64,
    byte_stride: Option<u64>,
}

/// Columns of a transformation: the images of the axes, then of the origin.
type Transform = [[f64; 3]; 4];

const IDENTITY: Transform = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]];

/// Reads a GLB input.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let document = document(source, options)?;
    let binary_at = source.offset();
    let binary = binary(source)?;
    let fault = |found: String| {
        source.fault(
            Place::Byte(binary_at),
            found,
            "the file is damaged, or refers to other files: pack it into one GLB",
        )
    };
    let mut out = Decoded::default();
    let mut seen = BTreeSet::new();
    let scene = document.scenes.get(document.scene.unwrap_or(0));
    let mut stack: Vec<(usize, Transform)> =
        scene.map_or(Vec::new(), |s| s.nodes.iter().rev().map(|&n| (n, IDENTITY)).collect());
    while let Some((index, above)) = stack.pop() {
        let Some(node) = document.nodes.get(index).filter(|_| seen.insert(index)) else {
            return Err(fault(format!("node {index}, which does not exist or stands in the scene twice")));
        };
        let transform = node.transform(&above);
        stack.extend(node.children.iter().rev().map(|&child| (child, transform)));
        let primitives = node
            .mesh
            .and_then(|mesh| document.meshes.get(mesh))
            .map_or(&[] as &[Primitive], |m| &m.primitives);
        let accessors: BTreeSet<usize> = primitives.iter().filter_map(|p| p.attributes.position).collect();
        for accessor in accessors {
            let count = document.accessors.get(accessor).map_or(0, |a| a.count);
            limit::check(source, options, count.saturating_add(out.cloud.len() as u64), 24)?;
            document.append(accessor, &binary, &transform, &mut out.cloud.positions).map_err(fault)?;
        }
    }
    out.ignored.push("everything but the vertices; y is up".into());
    Ok(out)
}

/// The JSON part; the source then stands behind it.
fn document(source: &mut Source, options: &ReadOptions) -> Result<Document, Error> {
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
    limit::check(source, options, json, JSON_FACTOR as usize)?;
    let bytes = source.peek(HEADER + json as usize)?;
    let Some(text) = bytes.get(HEADER..HEADER + json as usize) else {
        let there = bytes.len() as u64;
        return Err(source.ends_early("bytes of JSON", json, there.saturating_sub(HEADER as u64)));
    };
    let parsed = serde_json::from_slice(text);
    let document =
        parsed.map_err(|error| source.malformed(format!("JSON: {error}"), "the file is damaged"))?;
    source.consume(HEADER + json as usize);
    Ok(document)
}

/// The binary part; nothing if there is none.
fn binary(source: &mut Source) -> Result<Vec<u8>, Error> {
    let header = source.peek(CHUNK)?;
    let Some(length) = header.get(..4).map(|b| Scalar::U32.value(b, Endian::Little) as usize) else {
        return Ok(Vec::new());
    };
    if header.get(4..8) != Some(b"BIN\0") {
        return Ok(Vec::new());
    }
    let bytes = source.peek(CHUNK + length)?;
    let there = bytes.len().saturating_sub(CHUNK) as u64;
    let Some(binary) = bytes.get(CHUNK..CHUNK + length).map(<[u8]>::to_vec) else {
        return Err(source.ends_early("bytes of the binary part", length as u64, there));
    };
    source.consume(CHUNK + length);
    Ok(binary)
}

impl Document {
    /// Appends the positions of an accessor, transformed.
    fn append(
        &self,
        index: usize,
        binary: &[u8],
        transform: &Transform,
        out: &mut Vec<[f64; 3]>,
    ) -> Result<(), String> {
        let accessor = self.accessors.get(index).ok_or_else(|| format!("accessor {index} does not exist"))?;
        let view = accessor.buffer_view.and_then(|view| self.buffer_views.get(view));
        let Some(view) = view.filter(|view| view.buffer == 0 && accessor.sparse.is_none()) else {
            return Err(format!("positions of accessor {index}, which are sparse or in another file"));
        };
        let (kind, largest) = match accessor.component_type {
            5126 => (Scalar::F32, 1.0),
            5120 => (Scalar::I8, 127.0),
            5121 => (Scalar::U8, 255.0),
            5122 => (Scalar::I16, 32767.0),
            5123 => (Scalar::U16, 65535.0),
            other => return Err(format!("positions of accessor {index} with component type {other}")),
        };
        let size = 3 * kind.size() as u64;
        let stride = view.byte_stride.unwrap_or(size);
        let needed =
            accessor.count.checked_sub(1).map_or(Some(0), |rows| rows.checked_mul(stride)?.checked_add(size));
        let room = view.byte_length.saturating_sub(accessor.byte_offset);
        let start = view.byte_offset.saturating_add(accessor.byte_offset);
        let Some(needed) = needed.filter(|&n| n <= room && accessor.kind == "VEC3" && stride >= size) else {
            return Err(format!(
                "accessor {index} of {} {} in a view of {room} bytes",
                accessor.count, accessor.kind
            ));
        };
        let bytes = usize::try_from(start)
            .ok()
            .and_then(|start| binary.get(start..start.checked_add(needed as usize)?));
        let bytes = bytes.ok_or_else(|| {
            format!("accessor {index} reaches to byte {} of {}", start.saturating_add(needed), binary.len())
        })?;
        let unit = if accessor.normalized { 1.0 / largest } else { 1.0 };
        for row in bytes.chunks(stride as usize) {
            let p = [0, 1, 2].map(|axis| kind.value(&row[axis * kind.size()..], Endian::Little) * unit);
            out.push(apply(transform, p));
        }
        Ok(())
    }
}

impl Node {
    /// What the node does to points, after those above it.
    fn transform(&self, above: &Transform) -> Transform {
        let own: Transform = match self.matrix {
            Some(m) => [0, 4, 8, 12].map(|column| [m[column], m[column + 1], m[column + 2]]),
            None => {
                let scale = self.scale.unwrap_or([1.0; 3]);
                let axes = rotation(self.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
                let scaled = |i: usize| axes[i].map(|c| c * scale[i]);
                [scaled(0), scaled(1), scaled(2), self.translation.unwrap_or([0.0; 3])]
            }
        };
        let linear: Transform = [above[0], above[1], above[2], [0.0; 3]];
        [apply(&linear, own[0]), apply(&linear, own[1]), apply(&linear, own[2]), apply(above, own[3])]
    }
}

fn apply(t: &Transform, p: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| t[0][axis] * p[0] + t[1][axis] * p[1] + t[2][axis] * p[2] + t[3][axis])
}

/// The images of the axes under a rotation by the quaternion x, y, z, w.
fn rotation([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
        [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
        [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
}
