//! Meshes with few vertices, whose faces are sampled: the same part in every format gives the same points.

use crate::common::from_bytes;
use lineament::mesh::MeshPoints;
use lineament::{NodeKind, Params, extract_sampled};
use lineament_io::{ReadOptions, Scan};

/// The corners of a box, and its twelve triangles, outwards.
const SIZE: [f32; 3] = [30.0, 20.0, 12.5];
const TRIANGLES: [[usize; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

fn corner(i: usize) -> [f32; 3] {
    [0, 1, 2].map(|a| if i >> a & 1 == 1 { SIZE[a] } else { 0.0 })
}

fn line(word: &str, numbers: [f32; 3]) -> String {
    format!("{word}{} {} {}\n", numbers[0], numbers[1], numbers[2])
}

fn bytes(numbers: impl IntoIterator<Item = f32>) -> Vec<u8> {
    numbers.into_iter().flat_map(f32::to_le_bytes).collect()
}

fn stl() -> Vec<u8> {
    let mut file = vec![0; 80];
    file.extend(12u32.to_le_bytes());
    for triangle in TRIANGLES {
        file.extend(bytes([0.0; 3]));
        file.extend(bytes(triangle.iter().flat_map(|&v| corner(v))));
        file.extend([0, 0]);
    }
    file
}

fn ascii_stl() -> Vec<u8> {
    let facet = |t: &[usize; 3]| {
        let vertices: String = t.iter().map(|&v| line("vertex ", corner(v))).collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    format!("solid box\n{}endsolid box\n", TRIANGLES.iter().map(facet).collect::<String>()).into()
}

/// Faces in every spelling: plain, with texture and normal, counted from behind.
fn obj() -> Vec<u8> {
    let mut text: String = (0..8).map(|i| line("v ", corner(i))).collect();
    for (k, [a, b, c]) in TRIANGLES.iter().enumerate() {
        text += &match k % 3 {
            0 => format!("f {} {} {}\n", a + 1, b + 1, c + 1),
            1 => format!("f {}/1/1 {}//1 {}/2\n", a + 1, b + 1, c + 1),
            _ => format!("f -{} -{} -{}\n", 8 - a, 8 - b, 8 - c),
        };
    }
    text.into()
}

fn off() -> Vec<u8> {
    let vertices: String = (0..8).map(|i| line("", corner(i))).collect();
    let faces: String = TRIANGLES.iter().map(|[a, b, c]| format!("3 {a} {b} {c} 255 0 0\n")).collect();
    format!("OFF\n8 12 0\n{vertices}{faces}").into()
}

/// All on one line, as some programs write it.
fn running_off() -> Vec<u8> {
    let text = String::from_utf8(off()).unwrap().replace(" 255 0 0", "");
    let (head, rest) = text.split_at(text.match_indices('\n').nth(1).unwrap().0 + 1);
    format!("{head}{}\n", rest.trim().replace('\n', " ")).into()
}

fn ply(format: &str) -> Vec<u8> {
    let mut file = format!(
        "ply\nformat {format} 1.0\nelement face 12\nproperty uchar flags\nproperty list uchar int vertex_indices\n\
         element vertex 8\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
    )
    .into_bytes();
    for t in TRIANGLES {
        match format {
            "ascii" => file.extend(format!("7 3 {} {} {}\n", t[0], t[1], t[2]).bytes()),
            _ => {
                file.extend([7, 3]);
                t.iter().for_each(|&v| file.extend((v as i32).to_le_bytes()));
            }
        }
    }
    for i in 0..8 {
        match format {
            "ascii" => file.extend(line("", corner(i)).bytes()),
            _ => file.extend(bytes(corner(i))),
        }
    }
    file
}

/// A list of triangles by numbers, and a fan and a strip that follow the order of their own vertices.
fn glb() -> Vec<u8> {
    let mut binary = bytes((0..8).flat_map(corner));
    TRIANGLES[2..].iter().flatten().for_each(|&v| binary.extend((v as u16).to_le_bytes()));
    let own = binary.len();
    binary.extend(bytes([0, 2, 3, 1].into_iter().flat_map(corner)));
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],
        "bufferViews":[{{"buffer":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":60}},
        {{"buffer":0,"byteOffset":{own},"byteLength":48}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"}},
        {{"bufferView":1,"componentType":5123,"count":30,"type":"SCALAR"}},
        {{"bufferView":2,"componentType":5126,"count":4,"type":"VEC3"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}},{{"attributes":{{"POSITION":2}},"mode":6}}]}}]}}"#,
        binary.len()
    );
    let json = format!("{json}{}", " ".repeat((4 - json.len() % 4) % 4));
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend((28 + json.len() as u32 + binary.len() as u32).to_le_bytes());
    file.extend((json.len() as u32).to_le_bytes());
    file.extend(b"JSON");
    file.extend(json.bytes());
    file.extend((binary.len() as u32).to_le_bytes());
    file.extend(b"BIN\0");
    file.extend(binary);
    file
}

fn files() -> [(&'static str, Vec<u8>); 8] {
    [
        ("box.stl", stl()),
        ("ascii.stl", ascii_stl()),
        ("box.obj", obj()),
        ("box.off", off()),
        ("running.off", running_off()),
        ("box.ply", ply("binary_little_endian")),
        ("ascii.ply", ply("ascii")),
        ("box.glb", glb()),
    ]
}

fn scan(name: &str, file: &[u8], mesh: MeshPoints) -> Scan {
    from_bytes(file, name, &ReadOptions { mesh: Some(mesh), ..ReadOptions::default() }).unwrap()
}

#[test]
fn a_box_gives_the_same_points_in_every_format() {
    let first = scan("box.stl", &stl(), MeshPoints::Sampled(500));
    assert_eq!(first.cloud.len(), 500);
    for (name, file) in files() {
        let found = scan(name, &file, MeshPoints::Sampled(500));
        assert_eq!(found.cloud.positions, first.cloud.positions, "{name}");
        let sampled = found.sampled.unwrap();
        assert_eq!((sampled.faces, sampled.folds.len()), (12, 12), "{name}");
        assert!(found.warnings.is_empty(), "{name}: {:?}", found.warnings);
    }
}

#[test]
fn the_vertices_are_there_for_those_who_ask() {
    for (name, file) in files() {
        let whole = from_bytes(&file, name, &ReadOptions::default()).unwrap();
        let vertices = scan(name, &file, MeshPoints::Vertices);
        assert_eq!(vertices.cloud, whole.cloud, "{name}");
        assert_eq!((vertices.sampled, whole.sampled), (None, None), "{name}");
    }
}

#[test]
fn a_plan_tells_what_would_be_sampled_and_takes_the_vertices() {
    for (name, file) in files() {
        let auto = ReadOptions { mesh: Some(MeshPoints::Auto), plan: true, ..ReadOptions::default() };
        let found = from_bytes(&file, name, &auto).unwrap();
        assert_eq!(found.cloud, scan(name, &file, MeshPoints::Vertices).cloud, "{name}");
        let planned = found.planned.unwrap();
        assert_eq!((planned.faces, planned.plan.points, found.sampled), (12, 20_000, None), "{name}");
        // Points are chosen among samples, not among vertices.
        let chosen = from_bytes(&file, name, &ReadOptions { every: Some(2), ..auto }).unwrap();
        assert_eq!((chosen.cloud.len(), chosen.planned), (10_000, None), "{name}");
    }
}

#[test]
fn a_sampled_box_has_twelve_creases_and_eight_junctions() {
    let found = scan("box.stl", &stl(), MeshPoints::Auto);
    assert_eq!(found.cloud.len(), 20_000);
    let folds = &found.sampled.unwrap().folds;
    for folds in [folds.as_slice(), &[]] {
        let lines = extract_sampled(&found.cloud, folds, &Params::default(), &|_| ()).unwrap();
        let network = &lines.network;
        assert_eq!((network.strips.len(), network.count(NodeKind::Junction)), (12, 8));
        lineament::check::network(network).unwrap();
    }
}

#[test]
fn strips_of_triangles_are_faces() {
    // The sides of the box as one strip, then its bottom and its top; the second turns at a corner that is there twice.
    let strips = "19 0 4 1 5 3 7 2 6 0 4 -1 0 1 2 3 -1 4 5 5\n";
    let text = |last: &str| {
        let vertices: String = (0..8).map(|i| line("", corner(i))).collect();
        format!(
            "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
             element tristrips 2\nproperty list int int vertex_indices\nend_header\n{vertices}{strips}{last}\n"
        )
    };
    let found = scan("strips.ply", text("4 4 5 6 7").as_bytes(), MeshPoints::Sampled(500));
    let whole = scan("box.stl", &stl(), MeshPoints::Sampled(500));
    assert_eq!(found.sampled.as_ref().map(|s| (s.faces, s.folds.len())), Some((12, 12)));
    assert!(found.warnings.is_empty() && found.ignored.is_empty(), "{:?}", found.ignored);
    assert_eq!(found.cloud.len(), whole.cloud.len());
    let odd = scan("strips.ply", text("4 4 5 -2 7").as_bytes(), MeshPoints::Sampled(500));
    assert!(odd.warnings[0].starts_with("1 faces without"), "{:?}", odd.warnings);
}

#[test]
fn faces_without_their_vertices_are_left_out_with_a_warning() {
    let text = |name: &str| match name {
        "a.obj" => "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 0 1 2\nf a b c\n",
        "a.off" => "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 1\n3 0 1 x\n",
        _ => {
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
             element face 4\nproperty list uchar int vertex_index\nend_header\n\
             0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 1\n3 0 1 x\n"
        }
    };
    for name in ["a.obj", "a.off", "a.ply"] {
        let found = scan(name, text(name).as_bytes(), MeshPoints::Sampled(50));
        assert_eq!((found.cloud.len(), found.sampled.map(|s| s.faces)), (50, Some(1)), "{name}");
        assert!(found.warnings[0].starts_with("3 faces without vertices"), "{name}: {:?}", found.warnings);
    }
}

#[test]
fn what_a_face_claims_is_not_believed() {
    // A list of four thousand million items in a file of a few bytes.
    let mut file =
        b"ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n"
            .to_vec();
    file.extend(u32::MAX.to_le_bytes());
    let options = ReadOptions { mesh: Some(MeshPoints::Auto), ..ReadOptions::default() };
    let error = from_bytes(&file, "a.ply", &options).unwrap_err().to_string();
    assert!(error.contains("0 of 1 rows"), "{error}");
}
