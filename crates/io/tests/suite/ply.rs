//! PLY inputs, whole and broken.

use crate::common::from_bytes;
use lineament::Column;
use lineament_io::{Error, Format, Place, ReadOptions};
use proptest::prelude::*;

fn options() -> ReadOptions {
    ReadOptions::default()
}

fn salvage() -> ReadOptions {
    ReadOptions { salvage: true, ..options() }
}

/// An element before the points, a list among their properties, an element with lists after them.
const ROUND: &str = "element camera 2\nproperty uchar id\nproperty list uchar short path\nelement vertex 2\n\
    property uchar red\nproperty double x\nproperty float y\nproperty list int float weights\nproperty short z\n\
    property int label\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

fn header(format: &str, elements: &str) -> Vec<u8> {
    format!("ply\nformat {format} 1.0\ncomment made for a test\n{elements}").into_bytes()
}

fn round_binary(big: bool) -> Vec<u8> {
    let mut file = header(if big { "binary_big_endian" } else { "binary_little_endian" }, ROUND);
    macro_rules! put {
        ($($value:expr),*) => { $(file.extend(if big { $value.to_be_bytes().to_vec() } else { $value.to_le_bytes().to_vec() });)* };
    }
    put!(7u8, 2u8, 1i16, 2i16, 8u8, 0u8);
    put!(255u8, 0.1f64, 0.5f32, 1i32, 9f32, -3i16, -70000i32);
    put!(1u8, f64::NAN, -2f32, 0i32, 30000i16, 5i32);
    put!(3u8, 0i32, 1i32, 0i32);
    file
}

fn check_round(file: &[u8]) {
    let scan = from_bytes(file, "round.ply", &options()).unwrap();
    assert_eq!(scan.format, Format::Ply);
    assert_eq!(scan.bytes, file.len() as u64);
    assert_eq!(scan.cloud.positions[0], [0.1, 0.5, -3.0]);
    assert!(scan.cloud.positions[1][0].is_nan());
    assert_eq!(scan.cloud.positions[1][1..], [-2.0, 30000.0]);
    let names: Vec<_> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["red", "label"]);
    assert_eq!(scan.cloud.attributes[0].values, Column::U8(vec![255, 1]));
    assert_eq!(scan.cloud.attributes[1].values, Column::I32(vec![-70000, 5]));
    assert_eq!(scan.ignored.len(), 3, "{:?}", scan.ignored);
}

#[test]
fn lists_and_foreign_elements_are_walked_over_in_every_encoding() {
    check_round(&round_binary(false));
    check_round(&round_binary(true));
    let mut ascii = header("ascii", ROUND);
    ascii.extend(b"7 2 1 2\n8 0\n255 0.1 0.5 1 9 -3 -70000\n\n 1\tnan -2 0 30000 5 \n3 0 1 0\n");
    check_round(&ascii);
    let crlf = String::from_utf8(ascii.clone()).unwrap().replace('\n', "\r\n");
    check_round(crlf.as_bytes());
    check_round(crlf.replace("\r\n", "\r").as_bytes());
}

#[test]
fn cut_anywhere_it_is_an_error_and_with_salvage_the_whole_rows() {
    for file in [round_binary(false), round_binary(true)] {
        let body = file.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
        for length in body..file.len() {
            let error = from_bytes(&file[..length], "cut.ply", &options()).unwrap_err();
            let Error::EndsEarly { expected, read, place, .. } = &error else { panic!("{error}") };
            assert!(read < expected && *place == Place::Byte(length as u64), "{error}");
            let scan = from_bytes(&file[..length], "cut.ply", &salvage()).unwrap();
            assert!(scan.missing.is_some());
            assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
        }
        for length in 0..body - 1 {
            assert!(from_bytes(&file[..length], "cut.ply", &salvage()).is_err(), "{length}");
        }
    }
}

#[test]
fn cut_ascii_rows_are_an_error_that_counts_them() {
    let mut file = header(
        "ascii",
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
    );
    file.extend(b"1 2 3\n4 5 6\n7 8");
    let error = from_bytes(&file, "cut.ply", &options()).unwrap_err();
    assert!(error.to_string().contains("2 of 3 points"), "{error}");
    let scan = from_bytes(&file, "cut.ply", &salvage()).unwrap();
    assert_eq!(
        (scan.cloud.len(), scan.missing.unwrap().to_string().as_str()),
        (2, "2 of 3 points read, 1 missing")
    );
}

#[test]
fn a_claim_of_billions_of_points_takes_no_memory() {
    for count in ["4294967296", "9223372036854775808", "18446744073709551615"] {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let elements = format!(
                "element vertex {count}\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
            );
            let mut file = header(format, &elements);
            file.extend(b"1 2 3\n4 5 6\n");
            assert!(
                matches!(from_bytes(&file, "claim.ply", &options()), Err(Error::EndsEarly { .. })),
                "{format}"
            );
        }
    }
}

#[test]
fn refusals_name_the_line_and_the_value() {
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let cases = [
        (
            "ascii",
            "element vertex 1\nproperty float x\nproperty float y\nend_header\n".into(),
            "property `z`",
        ),
        (
            "ascii",
            "element vertex 1\nproperty list uchar int x\nproperty float y\nproperty float z\nend_header\n"
                .into(),
            "is a list",
        ),
        ("ascii", format!("element vertex 1\n{xyz}property float x\nend_header\n"), "twice"),
        ("ascii", format!("element vertex -1\n{xyz}end_header\n"), "`-1`"),
        ("ascii", format!("element vertex 1\n{xyz}property half w\nend_header\n"), "`half`"),
        ("ascii", format!("element vertex 1\n{xyz}property list float int w\nend_header\n"), "`float`"),
        (
            "ascii",
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n".into(),
            "element `vertex`",
        ),
        ("binary_middle_endian", format!("element vertex 1\n{xyz}end_header\n"), "`binary_middle_endian`"),
        (
            "ascii",
            format!("element vertex 1\n{xyz}end_header\n1 2 3,5\n"),
            "line 9: property `z` of row 0 is `3,5`",
        ),
        (
            "ascii",
            format!("element vertex 1\n{xyz}end_header\n1 2\n3 4 5\n"),
            "line 9: row 0 of element `vertex` ends before",
        ),
        ("ascii", format!("element vertex 1\n{xyz}end_header\n1 2 3 4\n"), "goes on with `4`"),
        ("ascii", format!("element vertex 1\n{xyz}property uchar r\nend_header\n1 2 3 256\n"), "is 256"),
        ("ascii", format!("element vertex 1\n{xyz}"), "`end_header` is missing"),
    ];
    for (format, elements, expected) in cases {
        let error = from_bytes(&header(format, &elements), "bad.ply", &options()).unwrap_err().to_string();
        assert!(error.contains(expected), "{error} should contain {expected}");
        assert!(error.contains("line ") && error.contains("bad.ply"), "{error}");
    }
}

#[test]
fn a_large_file_that_threads_share_gives_every_row_in_its_place() {
    let count = 700_000u32;
    let elements = format!(
        "element vertex {count}\nproperty double z\nproperty uint id\nproperty double x\nproperty double y\nend_header\n"
    );
    let point = |i: u32| [f64::from(i) / 7.0, -f64::from(i), f64::from(i % 11)];
    for big in [false, true] {
        let mut file = header(if big { "binary_big_endian" } else { "binary_little_endian" }, &elements);
        for i in 0..count {
            let [x, y, z] = point(i);
            let double = |value: f64| if big { value.to_be_bytes() } else { value.to_le_bytes() };
            file.extend(double(z));
            file.extend(if big { i.to_be_bytes() } else { i.to_le_bytes() });
            file.extend([double(x), double(y)].concat());
        }
        let scan = from_bytes(&file, "large.ply", &options()).unwrap();
        assert!(scan.cloud.positions.iter().copied().eq((0..count).map(point)));
        assert_eq!(scan.cloud.attributes[0].values, Column::U32((0..count).collect()));
    }
}

#[test]
fn a_negative_list_length_is_refused() {
    let elements = "element vertex 1\nproperty list char float w\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    let mut file = header("binary_little_endian", elements);
    file.extend([0xff; 20]);
    let error = from_bytes(&file, "negative.ply", &options()).unwrap_err().to_string();
    assert!(error.contains("list `w` has -1 items"), "{error}");
}

#[test]
fn positions_alone_are_read_on_request_and_the_rest_is_named() {
    let scan = from_bytes(&round_binary(false), "round.ply", &ReadOptions { attributes: false, ..options() })
        .unwrap();
    assert!(scan.cloud.attributes.is_empty());
    assert_eq!(scan.cloud.positions[0], [0.1, 0.5, -3.0]);
}

#[test]
fn the_hash_is_that_of_all_bytes() {
    // As sha256sum gives it.
    let file = b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
    let scan = from_bytes(file, "hash.ply", &ReadOptions { hash: true, ..options() }).unwrap();
    assert_eq!(
        scan.sha256.as_deref(),
        Some("b53d4b67c6fd7ee3e726042c60d19fcd334fde7bab582586e774dcb6fb09e9f6")
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_bytes_after_the_magic_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let mut file = b"ply\nformat ".to_vec();
        file.extend(bytes);
        let _ = from_bytes(&file, "any.ply", &salvage());
    }

    #[test]
    fn any_change_of_a_byte_is_read_or_refused(at in 0usize..400, value in any::<u8>(), big in any::<bool>()) {
        let mut file = round_binary(big);
        let at = at % file.len();
        file[at] = value;
        if let Ok(scan) = from_bytes(&file, "changed.ply", &salvage()) {
            prop_assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
        }
    }
}
