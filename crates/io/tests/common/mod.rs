//! What the tests of this crate share.
#![allow(dead_code)] // every test binary uses a part

use lineament::curve::BSpline;
use lineament::{Network, Node, NodeKind, Strip, StripKind};
use lineament_io::{Error, ReadOptions, Scan, read_from};
use std::io::{Cursor, Read};
use std::path::PathBuf;

/// Reads bytes as an input of unknown length, a few bytes a call, as a pipe might give them.
pub fn from_pipe(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Scan, Error> {
    struct Trickle(Cursor<Vec<u8>>);
    impl Read for Trickle {
        fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
            let some = out.len().min(1 + (self.0.position() as usize * 7) % 1000);
            self.0.read(&mut out[..some])
        }
    }
    read_from(Box::new(Trickle(Cursor::new(bytes.to_vec()))), name, options)
}

/// Reads bytes as a file, and as a pipe, which must agree.
pub fn from_bytes(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Scan, Error> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    let file = lineament_io::read(&path, options);
    let pipe = from_pipe(bytes, name, options);
    match (&file, &pipe) {
        (Ok(file), Ok(pipe)) => {
            assert_eq!(bits(file), bits(pipe));
            // As text, since NaN differs from itself.
            assert_eq!(format!("{:?}", file.cloud.attributes), format!("{:?}", pipe.cloud.attributes));
            assert_eq!((&file.ignored, &file.missing), (&pipe.ignored, &pipe.missing));
        }
        (Err(file), Err(pipe)) => {
            assert_eq!(file.to_string().replace(&path.display().to_string(), name), pipe.to_string());
        }
        _ => panic!("a file gives {file:?}, a pipe {pipe:?}"),
    }
    file
}

/// Coordinates as bits, so that NaN equals itself.
pub fn bits(scan: &Scan) -> Vec<[u64; 3]> {
    scan.cloud.positions.iter().map(|p| p.map(f64::to_bits)).collect()
}

/// A file of the evaluation data, or `None` with a note where they are absent.
pub fn shared(path: &str) -> Option<PathBuf> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(path);
    if root.exists() {
        return Some(root);
    }
    println!("skipped: there is no {}", root.display());
    None
}

/// Two creases and a border loop: a junction-like node with an open strip, a strip back to its own node, a loop.
pub fn network() -> Network {
    let strip = |kind, start: Option<u32>, end, points: &[[f64; 3]]| Strip {
        kind,
        closed: start.is_none(),
        start,
        end,
        points: points.to_vec(),
        curve: BSpline {
            degree: 1,
            knots: vec![0.0, 0.0, 1.0, 1.0],
            controls: vec![points[0], points[points.len() - 1]],
            periodic: start.is_none(),
        },
        sources: vec![0, 1],
        fold_deg: None,
        evidence: 0.0,
        deviation: 1e-7,
        confidence: 0.875,
    };
    let node = |position, kind, degree| Node { position, kind, degree, source: 4 };
    let (a, b) = ([0.1, 0.2, 0.3], [1.0 / 3.0, 5648349.895035, -1e-9]);
    Network {
        nodes: vec![node(a, NodeKind::Junction, 3), node(b, NodeKind::End, 1)],
        strips: vec![
            strip(StripKind::Crease, Some(0), Some(1), &[a, [0.5, 0.5, 0.5], b]),
            strip(StripKind::Crease, Some(0), Some(0), &[a, [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], a]),
            strip(
                StripKind::Border,
                None,
                None,
                &[[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 1.0, 0.0], [5.0, 1.0, 0.0]],
            ),
        ],
    }
}

/// An example program of this crate, which cargo builds beside the tests; `None`, with a note, if it did not.
pub fn example(name: &str) -> Option<PathBuf> {
    let test = std::env::current_exe().unwrap();
    let path = test.parent()?.parent()?.join("examples").join(name);
    if path.exists() {
        return Some(path);
    }
    println!("skipped: {} is not built; `cargo test -p lineament-io` builds it", path.display());
    None
}

/// Small clouds in every format that points are written in, and what other formats look like: seeds to damage.
pub fn seeds() -> Vec<(String, Vec<u8>)> {
    use lineament::{Attribute, Cloud, Column};
    use lineament_io::{PointFormat, PointTable, write_points_to};
    let positions =
        (0..60).map(|i| [f64::from(i) * 0.5, f64::from(i % 7), f64::from(i % 3) * 0.25]).collect();
    let values = Column::U16((0..60).collect());
    let attributes = vec![Attribute { name: "intensity".into(), values }];
    let cloud = Cloud { positions, attributes };
    let table = PointTable { cloud: &cloud, classes: &[1; 60], scores: &[0.5; 60], las: None };
    let formats = [
        (PointFormat::Ply, "ply"),
        (PointFormat::Pcd, "pcd"),
        (PointFormat::Xyz, "xyz"),
        (PointFormat::Csv, "csv"),
        (PointFormat::Las, "las"),
        (PointFormat::Laz, "laz"),
    ];
    let mut seeds: Vec<(String, Vec<u8>)> = Vec::new();
    for (format, extension) in formats {
        let mut bytes = Vec::new();
        write_points_to(&mut bytes, format, &table).unwrap();
        seeds.push((format!("seed.{extension}"), bytes));
    }
    use lineament_io::NetworkFormat;
    for format in [NetworkFormat::Ply, NetworkFormat::Obj, NetworkFormat::Glb] {
        let mut bytes = Vec::new();
        lineament_io::write_network_to(&mut bytes, format, &network(), &Default::default()).unwrap();
        seeds.push((format!("lines.{format}"), bytes));
    }
    let text = [
        ("seed.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"),
        (
            "seed.stl",
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
        ),
        (
            "seed.ptx",
            "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n0 0 0 0.5\n",
        ),
        ("seed.pts", "2\n1 2 3 4 5 6 7\n8 9 10 11 12 13 14\n"),
        (
            "ascii.pcd",
            "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n",
        ),
        (
            "ascii.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar int n\nend_header\n1 2 3 2 1 1\n4 5 6 0\n",
        ),
    ];
    seeds.extend(text.map(|(name, text)| (name.into(), text.as_bytes().to_vec())));
    let mut stl = vec![0u8; 80];
    stl.extend(2u32.to_le_bytes());
    stl.resize(184, 0x3f);
    seeds.push(("binary.stl".into(), stl));
    let mut packed =
        b"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 8\nHEIGHT 1\nDATA binary_compressed\n".to_vec();
    packed.extend(4u32.to_le_bytes().into_iter().chain(96u32.to_le_bytes()).chain([0, 1, 7 << 5, 86]));
    packed.push(0);
    packed[75] += 1;
    seeds.push(("packed.pcd".into(), packed));
    let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3), }\n";
    let mut npy = b"\x93NUMPY\x01\x00".to_vec();
    npy.extend((header.len() as u16).to_le_bytes());
    npy.extend(header.as_bytes());
    npy.resize(npy.len() + 48, 0);
    seeds.push(("seed.npy".into(), npy));
    seeds
}
