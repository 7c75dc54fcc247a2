//! glTF: any nodes, meshes, accessors and views over one buffer, as JSON or binary.

use super::{Number, or};
use arbitrary::Arbitrary;

#[derive(Arbitrary, Debug)]
struct Node {
    mesh: Option<u8>,
    children: Vec<u8>,
    matrix: Option<[f32; 16]>,
    scale: Option<[f32; 3]>,
}

#[derive(Arbitrary, Debug)]
struct Primitive {
    position: u8,
    colour: Option<u8>,
    indices: Option<u8>,
    mode: Option<u8>,
}

#[derive(Arbitrary, Debug)]
struct Accessor {
    view: Option<u8>,
    offset: Option<Number>,
    component: u8,
    kind: u8,
    count: Number,
    normalized: bool,
    /// Count, views of indices and values.
    sparse: Option<(Number, u8, u8)>,
}

#[derive(Arbitrary, Debug)]
struct View {
    offset: Option<Number>,
    length: Option<Number>,
    stride: Option<Number>,
}

/// The parts of a file.
#[derive(Arbitrary, Debug)]
pub struct Gltf {
    nodes: Vec<Node>,
    meshes: Vec<Vec<Primitive>>,
    accessors: Vec<Accessor>,
    views: Vec<View>,
    buffer: Vec<u8>,
    stated: Option<Number>,
    binary: bool,
}

const COMPONENTS: [u32; 7] = [5120, 5121, 5122, 5123, 5125, 5126, 7];
const KINDS: [&str; 5] = ["SCALAR", "VEC2", "VEC3", "VEC4", "MAT4"];

impl Gltf {
    /// The file.
    pub fn bytes(&self) -> Vec<u8> {
        let uri = if self.binary {
            String::new()
        } else {
            format!(",\"uri\":\"data:;base64,{}\"", base64(&self.buffer))
        };
        let json = format!(
            "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{}],\"meshes\":[{}],\
             \"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}{uri}}}]}}",
            list(&self.nodes, node),
            list(&self.meshes, |mesh| format!("{{\"primitives\":[{}]}}", list(mesh, primitive))),
            list(&self.accessors, accessor),
            list(&self.views, |view| self.view(view)),
            or(self.stated, self.buffer.len())
        );
        if self.binary { glb(json.into_bytes(), self.buffer.clone()) } else { json.into_bytes() }
    }

    fn view(&self, view: &View) -> String {
        let length = or(view.length, self.buffer.len());
        let offset = view.offset.map_or(String::new(), |n| format!(",\"byteOffset\":{}", n.0));
        let stride = view.stride.map_or(String::new(), |n| format!(",\"byteStride\":{}", n.0));
        format!("{{\"buffer\":0,\"byteLength\":{length}{offset}{stride}}}")
    }
}

fn list<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    items.iter().map(text).collect::<Vec<_>>().join(",")
}

/// Numbers as JSON has them.
fn floats(values: &[f32]) -> String {
    list(values, |value| if value.is_finite() { format!("{value:e}") } else { "0".into() })
}

fn node(node: &Node) -> String {
    let mut parts = vec![format!("\"children\":[{}]", list(&node.children, u8::to_string))];
    parts.extend(node.mesh.map(|mesh| format!("\"mesh\":{mesh}")));
    parts.extend(node.matrix.map(|matrix| format!("\"matrix\":[{}]", floats(&matrix))));
    parts.extend(node.scale.map(|scale| format!("\"scale\":[{}]", floats(&scale))));
    format!("{{{}}}", parts.join(","))
}

fn primitive(primitive: &Primitive) -> String {
    let colour = primitive.colour.map_or(String::new(), |c| format!(",\"COLOR_0\":{c}"));
    let indices = primitive.indices.map_or(String::new(), |i| format!(",\"indices\":{i}"));
    let mode = primitive.mode.map_or(String::new(), |m| format!(",\"mode\":{}", m % 9));
    format!("{{\"attributes\":{{\"POSITION\":{}{colour}}}{indices}{mode}}}", primitive.position)
}

fn accessor(accessor: &Accessor) -> String {
    let component = COMPONENTS[usize::from(accessor.component) % COMPONENTS.len()];
    let kind = KINDS[usize::from(accessor.kind) % KINDS.len()];
    let view = accessor.view.map_or(String::new(), |view| format!(",\"bufferView\":{view}"));
    let offset = accessor.offset.map_or(String::new(), |n| format!(",\"byteOffset\":{}", n.0));
    let sparse = accessor.sparse.map_or(String::new(), |(count, indices, values)| {
        format!(
            ",\"sparse\":{{\"count\":{},\"indices\":{{\"bufferView\":{indices},\"componentType\":5123}},\
             \"values\":{{\"bufferView\":{values}}}}}",
            count.0
        )
    });
    format!(
        "{{\"componentType\":{component},\"type\":\"{kind}\",\"count\":{},\"normalized\":{}{view}{offset}{sparse}}}",
        accessor.count.0, accessor.normalized
    )
}

/// A binary file of two chunks.
fn glb(mut json: Vec<u8>, mut binary: Vec<u8>) -> Vec<u8> {
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let word = |number: usize| (number as u32).to_le_bytes();
    let total = 12 + 8 + json.len() + 8 + binary.len();
    let head = [b"glTF".as_slice(), &word(2), &word(total)].concat();
    let chunk = |kind: &[u8; 4], body: &[u8]| [&word(body.len()), kind.as_slice(), body].concat();
    [head, chunk(b"JSON", &json), chunk(b"BIN\0", &binary)].concat()
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let three = |three: &[u8]| {
        let bits = (0..3).fold(0u32, |bits, i| bits << 8 | u32::from(three.get(i).copied().unwrap_or(0)));
        let digit =
            |i: usize| if i <= three.len() { DIGITS[(bits >> (18 - 6 * i) & 63) as usize] } else { b'=' };
        [0, 1, 2, 3].map(digit)
    };
    bytes.chunks(3).flat_map(three).map(char::from).collect()
}
