//! A network, and small inputs in every format: what damaged inputs and the fuzz targets begin with.

use ::parquet::file::properties::WriterVersion;
use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::curve::{BSpline, Ellipse, Round};
use lineament::{Attribute, Blend, Cloud, Column, Network, Node, NodeKind, Strip, StripKind};
use lineament_io::{NetworkFormat, PointFormat, PointTable, write_network_to, write_points_to};

/// A line over the first step and one curve of each other kind over the rest.
fn curves(points: &[[f64; 3]]) -> Vec<Piece> {
    let [from, to] = [points[1], points[points.len() - 1]];
    let round = Round { centre: [1.0, -2.0, 0.5], normal: [0.0, 0.0, 1.0], radius: 1.0 / 3.0 };
    let spline =
        BSpline { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], controls: vec![from, to], periodic: false };
    let covariance = [[1e-6; 4]; 4];
    let known = Sigma::Round { radius: 1e-3, normal: 0.25, covariance };
    let straight = Sigma::Line { offset: 1e-3, direction: 0.125 };
    let wide = Sigma::Ellipse { turn: 0.5, normal: 0.25, covariance: [[1e-6; 5]; 5] };
    let major = [0.0, 2.0 / 3.0, 0.0];
    let ellipse = Ellipse { centre: [1.0, -2.0, 0.5], normal: [0.0, 0.0, 1.0], major, minor: 1.0 / 3.0 };
    let piece =
        |shape, first, from, to, sigma| Piece { shape, from, to, first, last: 1, deviation: 1e-3, sigma };
    vec![
        piece(Shape::Line, 0, points[0], from, Some(straight)),
        piece(Shape::Arc { round, sweep: 1.5 }, 1, from, to, Some(known)),
        piece(Shape::Circle(round), 1, to, to, None),
        piece(Shape::Ellipse { ellipse, sweep: 0.75 }, 1, from, to, Some(wide)),
        piece(Shape::Spline(spline), 1, from, to, None),
    ]
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
        evidence: None,
        curves: curves(points),
        deviation: 1e-7,
        confidence: 0.875,
        sigma: vec![[0.5, 0.25, 0.125]; points.len()],
        blend: (kind == StripKind::Rounded).then_some(Blend { radius: 2.5, sigma: 0.125 }),
    };
    let node =
        |position, kind, degree| Node { position, kind, degree, source: 4, sigma: Some([0.25, 0.5, 0.0]) };
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

/// The name and the bytes of a small input.
type Seed = (String, Vec<u8>);

/// Small clouds in every format that points are written in, and samples of the other formats: seeds to damage.
pub fn seeds() -> Vec<Seed> {
    [points(), lines(), gltf(), texts(), binary_stl(), packed_pcd(), npy(), parquet()]
        .into_iter()
        .flatten()
        .chain([("octree.laz".into(), super::copc::file(60)), ("two.e57".into(), super::e57::two_scans(40))])
        .chain(las())
        .chain(gps_times())
        .chain(expe())
        .collect()
}

/// Points in every format but NPY.
fn points() -> Vec<Seed> {
    let positions =
        (0..60).map(|i| [f64::from(i) * 0.5, f64::from(i % 7), f64::from(i % 3) * 0.25]).collect();
    let values = Column::U16((0..60).collect());
    let attributes = vec![Attribute { name: "intensity".into(), values }];
    let cloud = Cloud { positions, attributes };
    let table = PointTable { cloud: &cloud, classes: &[1; 60], scores: &[0.5; 60], las: None };
    let formats = [
        (PointFormat::Ply, "ply"),
        (PointFormat::Npz, "npz"),
        (PointFormat::Parquet, "parquet"),
        (PointFormat::Pcd, "pcd"),
        (PointFormat::Xyz, "xyz"),
        (PointFormat::Csv, "csv"),
        (PointFormat::Las, "las"),
        (PointFormat::Laz, "laz"),
    ];
    let written = formats.map(|(format, extension)| {
        let mut bytes = Vec::new();
        write_points_to(&mut bytes, format, &table).unwrap();
        (format!("seed.{extension}"), bytes)
    });
    written.into()
}

/// Networks in formats that are read as well.
fn lines() -> Vec<Seed> {
    let mut seeds = Vec::new();
    for format in [NetworkFormat::Ply, NetworkFormat::Obj, NetworkFormat::Glb] {
        let mut bytes = Vec::new();
        write_network_to(&mut bytes, format, &network(), &Default::default()).unwrap();
        seeds.push((format!("lines.{format}"), bytes));
    }
    seeds
}

/// Formats of text.
fn texts() -> Vec<Seed> {
    let text = [
        ("lines.off", "OFF\n4 2 0\n0 0\n0 1 0 0\n0 1 0 0 0 1\n3 0 1 2 3 0 1 3\n"),
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
    text.map(|(name, text)| (name.into(), text.as_bytes().to_vec())).into()
}

fn gltf() -> Vec<Seed> {
    let data = format!("data:;base64,{}", "AACAPwAAAEAAAEBA".repeat(4));
    let json = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"mesh\":0,\"scale\":[2,2,2]}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}}}]}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}}],\"buffers\":[{{\"byteLength\":48,\"uri\":\"{data}\"}}]}}"
    );
    vec![("seed.gltf".into(), json.into_bytes())]
}

/// Two triangles.
fn binary_stl() -> Vec<Seed> {
    let mut seeds = Vec::new();
    let mut stl = vec![0u8; 80];
    stl.extend(2u32.to_le_bytes());
    stl.resize(184, 0x3f);
    seeds.push(("binary.stl".into(), stl));
    seeds
}

/// Eight points, compressed.
fn packed_pcd() -> Vec<Seed> {
    let mut seeds = Vec::new();
    let mut packed =
        b"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 8\nHEIGHT 1\nDATA binary_compressed\n".to_vec();
    packed.extend(4u32.to_le_bytes().into_iter().chain(96u32.to_le_bytes()).chain([0, 1, 7 << 5, 86]));
    packed.push(0);
    packed[75] += 1;
    seeds.push(("packed.pcd".into(), packed));
    seeds
}

/// Arrays of half and of single precision.
fn npy() -> Vec<Seed> {
    let mut seeds = Vec::new();
    let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3), }\n";
    let mut npy = b"\x93NUMPY\x01\x00".to_vec();
    npy.extend((header.len() as u16).to_le_bytes());
    npy.extend(header.as_bytes());
    let half = header.replace("f4", "f2");
    seeds.push(("half.npy".into(), [&npy[..10], half.as_bytes(), &[0; 24]].concat()));
    npy.resize(npy.len() + 48, 0);
    seeds.push(("seed.npy".into(), npy));
    seeds
}

/// Every codec, in both versions of pages.
fn parquet() -> Vec<Seed> {
    let mut seeds = Vec::new();
    for (index, codec) in super::parquet::codecs().into_iter().enumerate() {
        let version = if index % 2 == 0 { WriterVersion::PARQUET_1_0 } else { WriterVersion::PARQUET_2_0 };
        seeds.push((format!("{index}.parquet"), super::parquet::file(codec, version, index % 4 < 2, 60)));
    }
    seeds
}

/// Point formats with and without chunks.
fn las() -> Vec<Seed> {
    let mut seeds = Vec::new();
    for (format, chunk, name) in
        [(3, None, "3.las"), (10, None, "10.las"), (3, Some(10), "3.laz"), (7, Some(10), "7.laz")]
    {
        seeds.push((name.into(), super::las::file(format, 40, chunk)));
    }
    seeds
}

/// GPS times that jump, and changes of their sequence.
fn gps_times() -> Vec<Seed> {
    let mut seeds = Vec::new();
    for (format, count, name) in [(1, 30, "times1.laz"), (6, 60, "times6.laz")] {
        let times: Vec<f64> =
            (0..count).map(|i| [3e5, -7e3, 1e-3][i / 3 % 3] + (i / 9) as f64 * 1e-4).collect();
        let records = super::gps::with_times(format, &times);
        seeds.push((name.into(), super::las::file_of(format, records, Some(20), None)));
    }
    seeds.push(("changes6.laz".into(), super::gps::layered(4)));
    seeds.push(("changes1.laz".into(), super::gps::pointwise(vec![0, 4, 1, 2, 0, 3])));
    seeds
}

/// Three points with colours.
fn expe() -> Vec<Seed> {
    let mut seeds = Vec::new();
    let mut expe =
        b"[Expe/PointSet/Binary/0.1]\nproperty position 12\nproperty color 4\nnofpoints 3\ndata\n".to_vec();
    expe.resize(expe.len() + 48, 0x3f);
    seeds.push(("seed.expe".into(), expe));
    seeds
}
