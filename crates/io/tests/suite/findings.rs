//! What fuzzing found: the smallest input of each finding.

use crate::common::{from_bytes, from_pipe, spent};
use lineament::{Attribute, Cloud, Column};
use lineament_io::{Format, PointFormat, PointTable, ReadOptions, read_from, write_points_to};
use std::io::Cursor;

fn error(bytes: &[u8], name: &str) -> String {
    from_bytes(bytes, name, &ReadOptions::default()).unwrap_err().to_string()
}

#[test]
fn a_message_that_lists_fields_stays_short_and_printable() {
    let pcd = b"VERSION 0.7\nFIELDS x y s\xff\x1b[2J\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 900\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n";
    let long = [b"VERSION 0.7\nFIELDS x y ", "\u{7f}".repeat(900).as_bytes(), b"\nSIZE 4\n"].concat();
    let table = b"a,\x1b[31m\xff\xff,c\n1.5,2.5,3.5\n";
    for (bytes, name) in [(pcd.as_slice(), "long.pcd"), (&long, "odd.pcd"), (table, "escape.csv")] {
        let message = error(bytes, name);
        assert!(message.len() < 1000, "{message}");
        assert!(!message.contains('\x1b') && !message.contains('\u{fffd}'), "{message:?}");
    }
}

#[test]
fn a_byte_order_mark_before_the_first_word_is_named() {
    let header = "format ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
    let message = error(format!("\u{feff}ply\n{header}").as_bytes(), "marked.ply");
    assert!(message.contains("save the file without it"), "{message}");
}

#[test]
fn a_binary_stl_without_magic_is_recognised_in_a_pipe_too() {
    let mut stl = vec![0u8; 80];
    stl.extend(2u32.to_le_bytes());
    stl.resize(184, 0x3f);
    let scan = read_from(Box::new(Cursor::new(stl.clone())), "pipe", &ReadOptions::default()).unwrap();
    assert_eq!((scan.format, scan.cloud.len()), (Format::Stl, 6));
    assert_eq!(from_pipe(&stl, "pipe", &ReadOptions::default()).unwrap().cloud, scan.cloud);
}

#[test]
fn gps_times_of_both_signs_are_packed_and_come_back() {
    let times = vec![-1e9, 3e8, f64::MIN, f64::MAX, -0.0, 0.0];
    let values = Column::F64(times);
    let attributes = vec![Attribute { name: "gps_time".into(), values }];
    let cloud = Cloud { positions: vec![[0.5, 0.25, 0.125]; 6], attributes };
    let table = PointTable { cloud: &cloud, classes: &[1; 6], scores: &[], las: None };
    let mut bytes = Vec::new();
    write_points_to(&mut bytes, PointFormat::Laz, &table).unwrap();
    let scan = from_bytes(&bytes, "times.laz", &ReadOptions::default()).unwrap();
    assert!(scan.cloud.attributes.contains(&cloud.attributes[0]), "{:?}", scan.cloud.attributes);
}

/// Lists of booleans take no bytes, so that a few of them inside each other are any amount of work.
#[test]
fn metadata_of_parquet_that_counts_what_takes_no_bytes_is_refused_at_once() {
    let list = [0xf1, 0xff, 0xff, 0xff, 0xff, 0x07];
    for count in [1, 5] {
        // Field 9 of the metadata, which does not exist: a list of lists.
        let metadata = [&[0x99, count << 4 | 9], list.repeat(usize::from(count)).as_slice(), &[0]].concat();
        let length = (metadata.len() as u32).to_le_bytes();
        let bytes = [b"PAR1", metadata.as_slice(), &length, b"PAR1"].concat();
        let start = spent();
        assert!(error(&bytes, "lists.parquet").contains("metadata that is no whole structure"));
        let took = spent() - start;
        assert!(took < std::time::Duration::from_secs(5), "{took:?}");
    }
}

#[test]
fn a_chunk_table_at_the_end_of_all_numbers_is_refused() {
    let mut laz = crate::common::las::file(7, 40, Some(10));
    let points_at = u32::from_le_bytes(laz[96..100].try_into().unwrap()) as usize;
    let length = laz.len();
    // Before the points -1 says that the place stands at the end of the file.
    laz[points_at..points_at + 8].fill(0xff);
    laz[length - 8..].fill(0xff);
    assert!(error(&laz, "table.laz").contains("a chunk table at byte 18446744073709551615"));
}
