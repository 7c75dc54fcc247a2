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
