//! Classified points written, and read back.

mod common;
use common::from_bytes;
use lineament::{Attribute, Cloud, Column};
use lineament_io::{PointFormat, PointTable, ReadOptions, write_points, write_points_to};

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
        let table = PointTable { cloud: &cloud, classes: &classes, scores: &[] };
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
    let table = PointTable { cloud: &cloud, classes: &[0, 3], scores: &[0.25, 1.0] };
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
        write_points(&path, &[], &PointTable { cloud: &cloud, classes: &[0], scores: &[] }).unwrap_err();
    assert!(error.to_string().contains("1 classes for 2 points"), "{error}");
    assert!(!path.exists());
}
