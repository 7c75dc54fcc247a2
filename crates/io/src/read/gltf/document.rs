//! The JSON of glTF, as far as the vertices need it.

use crate::error::{Error, Place};
use crate::read::{Decoded, ReadOptions, limit};
use crate::source::Source;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// Bytes in memory, at worst, for an object and for an element of an array: while an array grows there are two of it.
const OBJECT: u64 = 512;
const ELEMENT: u64 = 32;
/// Extensions that do not move vertices, by the beginnings of their names.
const HARMLESS: [&str; 7] = [
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_lights_",
    "KHR_mesh_quantization",
    "KHR_xmp",
    "KHR_animation_pointer",
];
/// One that makes several meshes of one.
const INSTANCES: &str = "EXT_mesh_gpu_instancing";

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase", bound(deserialize = "'de: 'a"))]
pub(super) struct Document<'a> {
    scene: Option<usize>,
    scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<View>,
    pub buffers: Vec<Buffer<'a>>,
    extensions_required: Vec<String>,
    extensions_used: Vec<String>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Scene {
    nodes: Vec<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Node {
    pub mesh: Option<usize>,
    pub children: Vec<usize>,
    pub matrix: Option<Box<[f64; 16]>>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Mesh {
    pub primitives: Vec<Primitive>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Primitive {
    pub attributes: Attributes,
    pub indices: Option<usize>,
    /// 4 for triangles, which is the default, 5 for a strip of them, 6 for a fan.
    pub mode: Option<u32>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Accessor {
    pub buffer_view: Option<usize>,
    pub byte_offset: u64,
    pub component_type: u32,
    pub count: u64,
    #[serde(rename = "type")]
    pub kind: String,
    pub normalized: bool,
    pub sparse: Option<Box<Sparse>>,
}

/// Elements that differ from those of the view, or from zero without one.
#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Sparse {
    pub count: u64,
    pub indices: Part,
    pub values: Part,
}

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Part {
    pub buffer_view: usize,
    pub byte_offset: u64,
    pub component_type: u32,
}

#[derive(Deserialize, Default)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct View {
    pub buffer: usize,
    pub byte_offset: u64,
    pub byte_length: u64,
    pub byte_stride: Option<u64>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Buffer<'a> {
    #[serde(borrow)]
    pub uri: Option<Cow<'a, str>>,
}

/// Refuses JSON that takes more memory than the bound, before it is parsed.
pub(super) fn check(source: &Source, options: &ReadOptions, text: &[u8]) -> Result<(), Error> {
    let (mut objects, mut elements, mut inside, mut escaped) = (0u64, 0u64, false, false);
    for &byte in text {
        match byte {
            _ if escaped => escaped = false,
            b'\\' if inside => escaped = true,
            b'"' => inside = !inside,
            b'{' if !inside => objects += 1,
            b',' | b'[' if !inside => elements += 1,
            _ => {}
        }
    }
    // The text itself, its strings once more, and the decoded strings.
    let needed = OBJECT * objects + ELEMENT * elements + 3 * text.len() as u64;
    if needed <= limit::bound(source, options) {
        return Ok(());
    }
    let what = format!("JSON of {objects} objects, which takes {needed} bytes");
    Err(limit::beyond(source, options, 0, &what))
}

impl Document<'_> {
    /// The nodes that the scene begins with: of a file without scenes, all that no other node holds.
    pub fn roots(&self) -> Result<Vec<usize>, String> {
        if self.scenes.is_empty() && self.scene.is_none() {
            let held: BTreeSet<usize> =
                self.nodes.iter().flat_map(|node| node.children.iter().copied()).collect();
            return Ok((0..self.nodes.len()).filter(|index| !held.contains(index)).collect());
        }
        let index = self.scene.unwrap_or(0);
        let scene = self.scenes.get(index).ok_or_else(|| format!("scene {index}, which does not exist"))?;
        Ok(scene.nodes.clone())
    }

    /// Refuses extensions that the vertices cannot be had without, and notes the one that leaves some out.
    pub fn extensions(&self, source: &Source, out: &mut Decoded) -> Result<(), Error> {
        let harmless = |name: &str| HARMLESS.iter().any(|known| name.starts_with(known));
        if let Some(name) = self.extensions_required.iter().find(|name| !harmless(name)) {
            let found = format!("the extension `{name}`, which the file cannot be read without");
            let advice = "it is not read: save the file without it, uncompressed";
            return Err(source.fault(Place::Byte(0), found, advice));
        }
        if self.extensions_used.iter().any(|name| name == INSTANCES) {
            out.ignored.push(format!("the instances of `{INSTANCES}`: each mesh is read once"));
        }
        Ok(())
    }
}
