//! Classified points written, and read back.

use crate::common::from_bytes;
use lineament::{Attribute, Cloud, Column};
use lineament_io::{
    LasFrame, LasRecord, PointFormat, PointTable, ReadOptions, Scan, las_version, write_points,
    write_points_to,
};

fn cloud() -> Cloud {
    let attribute = |name: &str, values| Attribute { name: name.into(), values };
    Cloud {
        positions: vec![[0.1, 5648349.895035, -1e-9], [f64::NAN, 2.0, 3.0]],
        attributes: vec![
            attribute("red", Column::U8(vec![255, 0])),
            attribute("class", Column::I16(vec![-5, 6])),
            attribute("GPS time", Column::F64(vec![0.1, 1e300])),
            attribute("id", Column::U64(vec![1 << 40, 3])),
        ],
    }
}

#[test]
fn npy_is_laid_out_as_numpy_documents_it() {
    for count in [0usize, 1, 1_000_000] {
        let cloud = Cloud::new(vec![[0.0; 3]; count]);
        let classes = vec![2u8; count];
        let mut bytes = Vec::new();
        let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: None };
        write_points_to(&mut bytes, PointFormat::Npy, &table).unwrap();
        let length = u16::from_le_bytes([bytes[8], bytes[9]]) as usize;
        assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
        assert_eq!((10 + length) % 64, 0);
        let header = std::str::from_utf8(&bytes[10..10 + length]).unwrap();
        assert!(header.starts_with("{'descr': '|u1', 'fortran_order': False, 'shape': ("), "{header}");
        assert!(header.contains(&format!("({count},)")) && header.ends_with('\n'));
        assert_eq!(&bytes[10 + length..], classes);
    }
}

#[test]
fn ply_keeps_positions_bit_for_bit_and_every_attribute() {
    let cloud = cloud();
    let table = PointTable { cloud: &cloud, classes: &[0, 3], scores: &[0.25, 1.0], las: None };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, PointFormat::Ply, &table).unwrap();
    let scan = from_bytes(&bytes, "out.ply", &ReadOptions::default()).unwrap();
    for (a, b) in cloud.positions.iter().zip(&scan.cloud.positions) {
        assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits));
    }
    let column = |name: &str| &scan.cloud.attributes.iter().find(|a| a.name == name).unwrap().values;
    assert_eq!(column("class"), &Column::U8(vec![0, 3]));
    assert_eq!(column("score"), &Column::F32(vec![0.25, 1.0]));
    assert_eq!(column("red"), &Column::U8(vec![255, 0]));
    assert_eq!(column("input_class"), &Column::I16(vec![-5, 6]));
    assert_eq!(column("GPS_time"), &Column::F64(vec![0.1, 1e300]));
    assert_eq!(column("id"), &Column::F64(vec![(1u64 << 40) as f64, 3.0]));
}

#[test]
fn columns_of_the_wrong_length_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.npy");
    let cloud = cloud();
    let error =
        write_points(&path, &[], &PointTable { cloud: &cloud, classes: &[0], scores: &[], las: None })
            .unwrap_err();
    assert!(error.to_string().contains("1 classes for 2 points"), "{error}");
    assert!(!path.exists());
}

/// What a written table reads as.
fn again(format: PointFormat, table: &PointTable, name: &str) -> Scan {
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, format, table).unwrap();
    from_bytes(&bytes, name, &ReadOptions::default()).unwrap()
}

#[test]
fn pcd_xyz_and_csv_keep_positions_and_every_attribute() {
    let cloud = cloud();
    let table = PointTable { cloud: &cloud, classes: &[0, 3], scores: &[0.25, 1.0], las: None };
    for (format, name) in
        [(PointFormat::Pcd, "a.pcd"), (PointFormat::Xyz, "a.xyz"), (PointFormat::Csv, "a.csv")]
    {
        let scan = again(format, &table, name);
        for (a, b) in cloud.positions.iter().zip(&scan.cloud.positions) {
            assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits));
        }
        let names: Vec<_> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["class", "score", "red", "input_class", "GPS_time", "id"], "{name}");
        let last = &scan.cloud.attributes[5].values;
        assert!(
            matches!(last, Column::U64(v) if v[0] == 1 << 40)
                || matches!(last, Column::F64(v) if v[0] == (1u64 << 40) as f64)
        );
    }
}

/// Points at map coordinates, on a grid of millimetres.
fn surveyed() -> Cloud {
    let positions = (0..500)
        .map(|i| [665_187.0 + f64::from(i) * 0.001, 5_648_349.0 - f64::from(i) * 0.25, f64::from(i % 7)]);
    let mut cloud = Cloud::new(positions.collect());
    let attribute = |name: &str, values| Attribute { name: name.into(), values };
    cloud.attributes = vec![
        attribute("intensity", Column::U16((0..500).collect())),
        attribute("return_number", Column::U8(vec![2; 500])),
        attribute("red", Column::U8(vec![200; 500])),
        attribute("green", Column::U8(vec![100; 500])),
        attribute("blue", Column::U8(vec![50; 500])),
        attribute("curvature", Column::F64((0..500).map(|i| f64::from(i) / 3.0).collect())),
        attribute("user_data", Column::F32(vec![0.5; 500])),
    ];
    cloud
}

#[test]
fn las_and_laz_keep_map_coordinates_and_every_attribute() {
    let cloud = surveyed();
    let (classes, scores) = (vec![3u8; 500], vec![0.75f32; 500]);
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &scores, las: None };
    for (format, name) in [(PointFormat::Las, "a.las"), (PointFormat::Laz, "a.laz")] {
        let scan = again(format, &table, name);
        for (a, b) in cloud.positions.iter().zip(&scan.cloud.positions) {
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6), "{a:?} {b:?}");
        }
        let column = |name: &str| &scan.cloud.attributes.iter().find(|a| a.name == name).unwrap().values;
        assert_eq!(column("intensity"), &Column::U16((0..500).collect()));
        assert_eq!(column("return_number"), &Column::U8(vec![2; 500]));
        assert_eq!(column("red"), &Column::U16(vec![200; 500]));
        assert_eq!(column("curvature"), &cloud.attributes[5].values);
        assert_eq!(column("class"), &Column::U8(classes.clone()));
        assert_eq!(column("score"), &Column::F32(scores.clone()));
        // The format's own user data is a byte: what does not fit it goes beside it.
        let user: Vec<_> = scan.cloud.attributes.iter().filter(|a| a.name == "user_data").collect();
        assert_eq!((user.len(), &user[1].values), (2, &Column::F32(vec![0.5; 500])));
    }
}

#[test]
fn las_outputs_are_like_their_inputs() {
    let cloud = surveyed();
    let frame = LasFrame {
        minor: 4,
        scale: [0.001, 0.01, 0.5],
        offset: [665_000.0, 5_648_000.0, 0.0],
        point_format: 2,
        records: vec![LasRecord {
            user: "LASF_Projection".into(),
            id: 2112,
            data: b"PROJCS[\"here\"]\0".to_vec(),
        }],
        ..LasFrame::default()
    };
    let table = PointTable { cloud: &cloud, classes: &[1; 500], scores: &[], las: Some(&frame) };
    let scan = again(PointFormat::Laz, &table, "a.laz");
    let las = scan.las.unwrap();
    assert_eq!((las.scale, las.offset, las.point_format), (frame.scale, frame.offset, 2));
    assert_eq!(scan.crs.as_deref(), Some("here"));
}

#[test]
fn las_refuses_points_without_a_place() {
    let cloud = cloud();
    let table = PointTable { cloud: &cloud, classes: &[0, 3], scores: &[], las: None };
    let error = write_points_to(&mut Vec::new(), PointFormat::Las, &table).unwrap_err().to_string();
    assert!(error.contains("NaN"), "{error}");
}

/// Bytes of LAS: the version behind its point, the day it was made, the numbers of points by return in the fields of old, and in those
/// of 1.4.
fn header(bytes: &[u8]) -> (u8, [u16; 2], Vec<u32>, Vec<u64>) {
    let short = |at: usize| u16::from_le_bytes(*bytes[at..].first_chunk().unwrap());
    let old = (0..5).map(|i| u32::from_le_bytes(*bytes[111 + 4 * i..].first_chunk().unwrap()));
    let new = (0..15).map(|i| u64::from_le_bytes(*bytes[255 + 8 * i..].first_chunk().unwrap()));
    let new = if bytes[25] == 4 { new.collect() } else { Vec::new() };
    (bytes[25], [short(90), short(92)], old.collect(), new)
}

#[test]
fn las_headers_count_points_by_return_and_keep_version_and_day_of_the_input() {
    let mut cloud = Cloud::new((0..9).map(|i| [f64::from(i), 0.0, 1.0]).collect());
    let column = |name: &str, values| Attribute { name: name.into(), values };
    cloud.attributes = vec![
        column("return_number", Column::U8(vec![1, 1, 1, 1, 1, 2, 2, 2, 3])),
        column("gps_time", Column::F64(vec![0.5; 9])),
    ];
    let scale = [0.01; 3];
    let frame = LasFrame {
        minor: 2,
        scale,
        point_format: 1,
        encoding: 1,
        created: [41, 2019],
        ..LasFrame::default()
    };
    let written = |las: &LasFrame, classes: &[u8]| {
        let table = PointTable { cloud: &cloud, classes, scores: &[], las: Some(las) };
        let mut bytes = Vec::new();
        write_points_to(&mut bytes, PointFormat::Las, &table).unwrap();
        let scan = from_bytes(&bytes, "a.las", &ReadOptions::default()).unwrap();
        assert_eq!(scan.las.unwrap().encoding & 1, 1);
        assert_eq!(scan.cloud.positions, cloud.positions);
        assert_eq!(las_version(&table), Some(bytes[25]));
        header(&bytes)
    };
    assert_eq!(written(&frame, &[]), (2, [41, 2019], vec![5, 3, 1, 0, 0], vec![]));
    // A column of classes has a place in 1.4 alone.
    let counts: Vec<u64> = [5, 3, 1].into_iter().chain([0; 12]).collect();
    assert_eq!(written(&frame, &[0; 9]), (4, [41, 2019], vec![5, 3, 1, 0, 0], counts.clone()));
    let current = LasFrame { minor: 4, point_format: 6, ..frame };
    assert_eq!(written(&current, &[]), (4, [41, 2019], vec![0; 5], counts));
}
