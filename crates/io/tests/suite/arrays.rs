//! NPZ and Parquet: columns with names, written and read.

use crate::common::from_bytes;
use crate::common::parquet::{MIX, codecs, file};
use ::parquet::basic::Compression;
use ::parquet::file::properties::WriterVersion;
use lineament::{Attribute, Cloud, Column};
use lineament_io::{Format, PointFormat, PointTable, ReadOptions, Scan, write_points_to};

/// Points at map coordinates with an attribute of every type.
fn cloud() -> Cloud {
    let attribute = |name: &str, values| Attribute { name: name.into(), values };
    Cloud {
        positions: vec![[0.1, 5648349.895035, -1e-9], [f64::NAN, 2.0, 3.0], [1.0 / 3.0, -0.0, 1e300]],
        attributes: vec![
            attribute("a", Column::I8(vec![-128, 0, 127])),
            attribute("b", Column::U8(vec![0, 1, 255])),
            attribute("c", Column::I16(vec![i16::MIN, 0, i16::MAX])),
            attribute("d", Column::U16(vec![0, 1, u16::MAX])),
            attribute("e", Column::I32(vec![i32::MIN, 0, i32::MAX])),
            attribute("f", Column::U32(vec![0, 1, u32::MAX])),
            attribute("g", Column::I64(vec![i64::MIN, 0, i64::MAX])),
            attribute("h", Column::U64(vec![0, 1, u64::MAX])),
            attribute("i", Column::F32(vec![0.1, -1.5, f32::MAX])),
            attribute("class", Column::F64(vec![0.1, 1e300, -0.0])),
        ],
    }
}

fn written(format: PointFormat) -> Vec<u8> {
    let cloud = cloud();
    let table = PointTable { cloud: &cloud, classes: &[0, 3, 1], scores: &[0.25, 1.0, 0.5], las: None };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, format, &table).unwrap();
    bytes
}

fn read(bytes: &[u8]) -> Scan {
    from_bytes(bytes, "input", &ReadOptions::default()).unwrap()
}

#[test]
fn positions_and_attributes_of_every_type_come_back_bit_for_bit() {
    for (written_as, read_as) in [(PointFormat::Npz, Format::Npz), (PointFormat::Parquet, Format::Parquet)] {
        let scan = read(&written(written_as));
        assert_eq!((scan.format, scan.ignored.len()), (read_as, 0), "{:?}", scan.ignored);
        let expected = cloud();
        for (a, b) in expected.positions.iter().zip(&scan.cloud.positions) {
            assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits));
        }
        let attributes = &scan.cloud.attributes;
        assert_eq!(attributes[0], Attribute { name: "class".into(), values: Column::U8(vec![0, 3, 1]) });
        assert_eq!(attributes[1].values, Column::F32(vec![0.25, 1.0, 0.5]));
        for (a, b) in expected.attributes.iter().zip(&attributes[2..]) {
            assert_eq!(a.values, b.values, "{}", a.name);
        }
        assert_eq!(attributes[11].name, "input_class");
    }
}

#[test]
fn parquet_of_every_codec_page_version_and_encoding_reads_the_same() {
    for codec in codecs() {
        for version in [WriterVersion::PARQUET_1_0, WriterVersion::PARQUET_2_0] {
            for dictionary in [false, true] {
                let scan = read(&file(codec, version, dictionary, 2000));
                let mixed = f64::from_bits(1999u64.wrapping_mul(MIX) >> 2);
                assert_eq!(scan.cloud.positions[1999], [49.0, mixed, 12.25], "{codec} {version:?}");
                let Column::F64(values) = &scan.cloud.attributes[0].values else { panic!("no f64") };
                // Without a sign, as the schema says, even where nulls make doubles of integers.
                assert_eq!((values[1], values[1999]), (4_294_967_295.0, 998.0), "{codec} {version:?}");
                assert!(values.iter().step_by(2).all(|value| value.is_nan()));
            }
        }
    }
}

#[test]
fn parquet_that_unpacks_beyond_the_bound_is_refused_and_read_with_a_wider_one() {
    let bytes = file(Compression::ZSTD(Default::default()), WriterVersion::PARQUET_2_0, true, 1_000_000);
    assert!(bytes.len() < 12 << 20, "{}", bytes.len());
    let narrow = ReadOptions { memory: Some(16 << 20), ..ReadOptions::default() };
    let error = from_bytes(&bytes, "large.parquet", &narrow).unwrap_err().to_string();
    assert!(error.contains("--memory") && error.contains("byte "), "{error}");
    let wide = ReadOptions { memory: Some(1 << 30), ..ReadOptions::default() };
    assert_eq!(from_bytes(&bytes, "large.parquet", &wide).unwrap().cloud.len(), 1_000_000);
}

#[test]
fn without_attributes_only_the_positions_are_read() {
    let options = ReadOptions { attributes: false, ..ReadOptions::default() };
    for format in [PointFormat::Npz, PointFormat::Parquet] {
        let scan = from_bytes(&written(format), "input", &options).unwrap();
        assert_eq!((scan.cloud.len(), scan.cloud.attributes.len()), (3, 0));
    }
}

#[test]
fn cut_anywhere_they_are_an_error_that_names_a_place() {
    for format in [PointFormat::Npz, PointFormat::Parquet] {
        let bytes = written(format);
        for length in (4..bytes.len()).step_by(13) {
            let error = from_bytes(&bytes[..length], "cut", &ReadOptions::default()).unwrap_err().to_string();
            assert!(error.contains("byte "), "{error}");
        }
    }
}

#[test]
fn a_changed_byte_is_noticed_by_the_checksum_of_an_archive() {
    let mut bytes = written(PointFormat::Npz);
    let at = bytes.windows(8).position(|w| w == 5648349.895035f64.to_le_bytes()).unwrap();
    bytes[at] ^= 1;
    let error = from_bytes(&bytes, "changed.npz", &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("xyz.npy") && error.contains("checksum"), "{error}");
}

/// An archive of stored arrays: name, type, shape, bytes.
fn archive(arrays: &[(&str, &str, &str, Vec<u8>)]) -> Vec<u8> {
    let number = |value: u32| value.to_le_bytes();
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, kind, shape, content) in arrays {
        let text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}\n");
        let mut array = b"\x93NUMPY\x01\x00".to_vec();
        array.extend((text.len() as u16).to_le_bytes());
        array.extend(text.bytes().chain(content.iter().copied()));
        let (name, size, start) = (format!("{name}.npy"), array.len() as u32, bytes.len() as u32);
        let mut common = vec![20, 0, 0, 0, 0, 0, 0, 0, 0x21, 0];
        let sum = crc32fast::hash(&array);
        common.extend([sum, size, size, name.len() as u32].into_iter().flat_map(number));
        bytes.extend([b"PK\x03\x04", common.as_slice(), name.as_bytes(), &array].concat());
        directory.extend(
            [b"PK\x01\x02\x14\x00", common.as_slice(), &[0; 10], &number(start), name.as_bytes()].concat(),
        );
    }
    let (start, size, count) = (bytes.len() as u32, directory.len() as u32, arrays.len() as u16);
    bytes.extend(directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend(count.to_le_bytes().into_iter().chain(count.to_le_bytes()));
    bytes.extend(number(size).into_iter().chain(number(start)).chain([0, 0]));
    bytes
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

#[test]
fn points_of_an_archive_are_found_by_name_by_shape_or_as_three_arrays() {
    let six = || floats(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let pair = |a, b| floats(&[a, b]);
    let expected = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
    let halves = [0x3c00u16, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600].map(u16::to_le_bytes).concat();
    let mut cases = vec![
        archive(&[("normals", "<f4", "2, 3", six()), ("points", "<f4", "2, 3", six())]),
        archive(&[("cloud", "<f4", "2, 3", six()), ("label", "|u1", "2,", vec![7, 8])]),
        archive(&[("half", "<f2", "2, 3", halves), ("label", "<f2", "2,", vec![0, 0x3e, 0, 0xbe])]),
        archive(&[
            ("x", "<f4", "2,", pair(1.0, 4.0)),
            ("z", "<f4", "2,", pair(3.0, 6.0)),
            ("y", "<f4", "2,", pair(2.0, 5.0)),
        ]),
    ];
    for bytes in &cases {
        assert_eq!(read(bytes).cloud.positions, expected);
    }
    let labelled = read(&cases[1]);
    assert_eq!(labelled.cloud.attributes[0].values, Column::U8(vec![7, 8]));
    assert_eq!(read(&cases[2]).cloud.attributes[0].values, Column::F32(vec![1.5, -1.5]));
    assert_eq!(read(&cases[0]).cloud.attributes[2].name, "normals_2");
    cases = vec![
        archive(&[("a", "<f4", "2, 3", six()), ("b", "<f4", "2, 3", six())]),
        archive(&[("a", "<f4", "6,", six())]),
        archive(&[("points", "<f4", "2000000000, 3", six())]),
    ];
    for bytes in &cases {
        let error = from_bytes(bytes, "odd.npz", &ReadOptions::default()).unwrap_err().to_string();
        assert!(error.contains("byte "), "{error}");
    }
}

/// More rows than a row group, and more numbers than go out at a time.
#[test]
fn a_large_cloud_is_written_in_parts_none_of_which_is_the_whole() {
    struct Largest(usize, Vec<u8>);
    impl std::io::Write for Largest {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0 = self.0.max(bytes.len());
            self.1.write(bytes)
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let count = (1 << 20) + 5000;
    let cloud = Cloud::new((0..count).map(|i| [f64::from(i).sqrt(), f64::from(i % 77), 0.5]).collect());
    let classes: Vec<u8> = (0..count).map(|i| i as u8 % 4).collect();
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: None };
    for format in [PointFormat::Npz, PointFormat::Parquet] {
        let mut out = Largest(0, Vec::new());
        write_points_to(&mut out, format, &table).unwrap();
        let Largest(largest, bytes) = out;
        assert!(largest < bytes.len(), "{format}: {largest} of {} bytes at once", bytes.len());
        let scan = from_bytes(&bytes, "large", &ReadOptions { memory: Some(1 << 30), ..Default::default() });
        assert_eq!(scan.unwrap().cloud.positions, cloud.positions, "{format}");
    }
}
