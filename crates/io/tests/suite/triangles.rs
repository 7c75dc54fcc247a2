//! Meshes as files, and read back.

use crate::common::from_bytes;
use lineament::Class;
use lineament::apply::SurfaceMesh;
use lineament_io::{MeshFormat, ReadOptions, write_mesh, write_mesh_to};

/// A tetrahedron far from the origin.
fn mesh() -> SurfaceMesh {
    let place = |[x, y, z]: [f64; 3]| [x + 1000.0, y - 500.0, z + 0.25];
    SurfaceMesh {
        vertices: [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.5]].map(place).to_vec(),
        kinds: vec![Class::Corner, Class::Crease, Class::Smooth, Class::Smooth],
        triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
    }
}

fn bytes(format: MeshFormat, mesh: &SurfaceMesh) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, format, mesh).unwrap();
    bytes
}

#[test]
fn every_format_is_read_back_with_its_vertices() {
    let formats = [
        (MeshFormat::Ply, "m.ply"),
        (MeshFormat::Obj, "m.obj"),
        (MeshFormat::Off, "m.off"),
        (MeshFormat::Stl, "m.stl"),
        (MeshFormat::Glb, "m.glb"),
    ];
    for (format, name) in formats {
        let scan = from_bytes(&bytes(format, &mesh()), name, &ReadOptions::default()).unwrap();
        let mut read = scan.cloud.positions;
        // GLB is turned so that z points up; its sizes are enough here.
        if format != MeshFormat::Glb {
            for vertex in mesh().vertices {
                assert!(read.contains(&vertex), "{name}: {vertex:?} in {read:?}");
            }
        }
        read.sort_by(|a, b| a.partial_cmp(b).unwrap());
        read.dedup();
        assert_eq!(read.len(), 4, "{name}");
    }
}

#[test]
fn faces_keep_their_sense_and_vertices_their_kind() {
    let text = |format| String::from_utf8(bytes(format, &mesh())).unwrap();
    assert!(text(MeshFormat::Obj).ends_with("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
    assert!(text(MeshFormat::Off).ends_with("3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"));
    assert!(text(MeshFormat::Off).starts_with("OFF\n4 4 0\n1000.0 -500.0 0.25\n"));
    let stl = bytes(MeshFormat::Stl, &mesh());
    assert_eq!((stl.len(), &stl[80..84]), (84 + 4 * 50, &4u32.to_le_bytes()[..]));
    // The normal of the first face points down.
    assert_eq!(stl[84..96], [0f32, 0.0, -1.0].map(f32::to_le_bytes).concat()[..]);
    let ply = bytes(MeshFormat::Ply, &mesh());
    assert!(String::from_utf8_lossy(&ply).contains("property uchar kind"));
    let rows = ply.len() - 4 * (1 + 12) - 4 * 25;
    assert_eq!([0, 1, 2, 3].map(|v| ply[rows + 25 * v + 24]), [3, 1, 0, 0]);
}

#[test]
fn an_empty_mesh_is_a_file_and_a_corner_that_is_not_there_is_refused() {
    for format in [MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Off, MeshFormat::Stl, MeshFormat::Glb] {
        assert!(!bytes(format, &SurfaceMesh::default()).is_empty() || format == MeshFormat::Obj);
    }
    let broken = SurfaceMesh { triangles: vec![[0, 1, 4]], ..mesh() };
    let path = std::env::temp_dir().join(format!("lineament-mesh-{}.obj", std::process::id()));
    let message = write_mesh(&path, &[], &broken).unwrap_err().to_string();
    assert!(message.contains("corner 4 of 4"), "{message}");
    assert!(!path.exists());
}
