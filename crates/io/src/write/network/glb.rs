//! A network as binary glTF 2.0: lines, a mesh for each kind. Positions are single floats by the format's rules, so they are
//! stored relative to the middle of the network, which stands in the scene as a translation. The format's y points up:
//! a rotation turns the z of scans there.

use crate::write::encode::polyline::Polylines;
use lineament::{Network, StripKind};
use std::io::{self, Write};

/// Numbers of the format: line segments, floats, unsigned ints, vertex and index buffers.
const LINES: u32 = 1;
const FLOAT: u32 = 5126;
const UNSIGNED: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Name and colour of each kind.
const KINDS: [(StripKind, &str, [f32; 3]); 3] = [
    (StripKind::Crease, "crease", [0.8, 0.05, 0.05]),
    (StripKind::Border, "border", [0.05, 0.2, 0.8]),
    (StripKind::Rounded, "rounded", [0.5, 0.2, 0.6]),
];

/// Writes one file with all lines. Shared nodes are shared vertices.
pub(super) fn write(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    let Polylines { mut vertices, paths } = Polylines::of(network);
    if paths.iter().all(|path| path.len() < 2) {
        vertices.clear();
    }
    let middle = middle(&vertices);
    let local: Vec<[f32; 3]> =
        vertices.iter().map(|v| [0, 1, 2].map(|a| (v[a] - middle[a]) as f32)).collect();
    let segments = KINDS.map(|(kind, ..)| {
        let of_kind = network.strips.iter().zip(&paths).filter(|(strip, _)| strip.kind == kind);
        let pairs =
            of_kind.flat_map(|(_, path)| path.windows(2).flat_map(|pair| [pair[0] as u32, pair[1] as u32]));
        pairs.collect::<Vec<u32>>()
    });
    let mut json = json(&local, &segments, middle);
    while !json.len().is_multiple_of(4) {
        json.push(' ');
    }
    let binary = 12 * local.len() + 4 * segments.iter().map(Vec::len).sum::<usize>();
    let chunk =
        |length: usize| u32::try_from(length).map_err(|_| io::Error::other("a GLB file holds at most 4 GiB"));
    out.write_all(b"glTF")?;
    let total = 12 + 8 + json.len() + 8 + binary;
    for number in [2, chunk(total)?, chunk(json.len())?] {
        out.write_all(&number.to_le_bytes())?;
    }
    out.write_all(b"JSON")?;
    out.write_all(json.as_bytes())?;
    out.write_all(&chunk(binary)?.to_le_bytes())?;
    out.write_all(b"BIN\0")?;
    for coordinate in local.iter().flatten() {
        out.write_all(&coordinate.to_le_bytes())?;
    }
    for index in segments.iter().flatten() {
        out.write_all(&index.to_le_bytes())?;
    }
    Ok(())
}

/// Least and greatest coordinates; zero if there are none.
fn bounds<T: Copy + PartialOrd + Default>(points: &[[T; 3]]) -> [[T; 3]; 2] {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold([first; 2], |[low, high], p| {
        let pick = |a: [T; 3], less: bool| {
            [0, 1, 2].map(|i| if (p[i] < a[i]) == less && p[i] != a[i] { p[i] } else { a[i] })
        };
        [pick(low, true), pick(high, false)]
    })
}

fn middle(vertices: &[[f64; 3]]) -> [f64; 3] {
    let [low, high] = bounds(vertices);
    [0, 1, 2].map(|a| low[a] + 0.5 * (high[a] - low[a]))
}

/// The lists of the JSON part.
#[derive(Default)]
struct Lists {
    views: Vec<String>,
    accessors: Vec<String>,
    meshes: Vec<String>,
    materials: Vec<String>,
    nodes: Vec<String>,
    /// Bytes of the buffer so far.
    bytes: usize,
}

impl Lists {
    /// The positions, which all meshes share.
    fn positions(&mut self, local: &[[f32; 3]]) {
        let [low, high] = bounds(local);
        let (count, length) = (local.len(), 12 * local.len());
        self.views
            .push(format!("{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{length},\"target\":{VERTICES}}}"));
        self.accessors.push(format!(
            "{{\"bufferView\":0,\"componentType\":{FLOAT},\"count\":{count},\"type\":\"VEC3\",\"min\":{low:?},\"max\":{high:?}}}"
        ));
        self.bytes += length;
    }

    /// A mesh of line segments in one colour, and a node that shows it.
    fn mesh(&mut self, name: &str, [r, g, b]: [f32; 3], indices: &[u32]) {
        let (count, length, offset) = (indices.len(), 4 * indices.len(), self.bytes);
        let (view, accessor, mesh) = (self.views.len(), self.accessors.len(), self.meshes.len());
        self.views.push(format!(
            "{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length},\"target\":{INDICES}}}"
        ));
        self.accessors.push(format!(
            "{{\"bufferView\":{view},\"componentType\":{UNSIGNED},\"count\":{count},\"type\":\"SCALAR\"}}"
        ));
        self.meshes.push(format!("{{\"name\":\"{name}\",\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"indices\":{accessor},\"material\":{mesh},\"mode\":{LINES}}}]}}"));
        self.materials.push(format!("{{\"name\":\"{name}\",\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{r:?},{g:?},{b:?},1.0]}},\"extensions\":{{\"KHR_materials_unlit\":{{}}}}}}"));
        self.nodes.push(format!("{{\"name\":\"{name}\",\"mesh\":{mesh}}}"));
        self.bytes += length;
    }

    /// The nodes above those of the meshes: the place of the network, and the turn that makes its z point up.
    fn root(&mut self, middle: [f64; 3]) {
        let children: Vec<String> = (0..self.nodes.len()).map(|node| node.to_string()).collect();
        let children = children.join(",");
        self.nodes
            .push(format!("{{\"name\":\"network\",\"translation\":{middle:?},\"children\":[{children}]}}"));
        let (half, child) = (std::f64::consts::FRAC_1_SQRT_2, self.nodes.len() - 1);
        self.nodes.push(format!(
            "{{\"name\":\"z up\",\"rotation\":[{:?},0.0,0.0,{half:?}],\"children\":[{child}]}}",
            -half
        ));
    }
}

/// The JSON part.
fn json(local: &[[f32; 3]], segments: &[Vec<u32>; 3], middle: [f64; 3]) -> String {
    let mut lists = Lists::default();
    lists.positions(local);
    for ((_, name, colour), indices) in KINDS.iter().zip(segments).filter(|(_, indices)| !indices.is_empty())
    {
        lists.mesh(name, *colour, indices);
    }
    if lists.meshes.is_empty() {
        return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"lineament\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\
                \"nodes\":[{\"name\":\"network\"}]}"
            .into();
    }
    lists.root(middle);
    let Lists { views, accessors, meshes, materials, nodes, bytes } = lists;
    format!(
        "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"lineament\"}},\"extensionsUsed\":[\"KHR_materials_unlit\"],\
         \"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}],\"materials\":[{}],\
         \"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{bytes}}}]}}",
        nodes.len() - 1,
        nodes.join(","),
        meshes.join(","),
        materials.join(","),
        accessors.join(","),
        views.join(","),
    )
}
