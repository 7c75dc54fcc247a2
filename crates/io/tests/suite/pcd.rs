//! PCD inputs, whole and broken.

use crate::common::{bits, from_bytes, from_pipe, shared};
use lineament::Column;
use lineament_io::{Error, Format, ReadOptions, read};
use proptest::prelude::*;

const HEADER: &str = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y _ z rgb normal label\n\
    SIZE 4 8 1 4 4 4 2\nTYPE F F U F F F U\nCOUNT 1 1 3 1 1 3 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n";

fn options() -> ReadOptions {
    ReadOptions::default()
}

fn ascii() -> Vec<u8> {
    let mut text = format!("{HEADER}DATA ascii\n");
    let rgb = f32::from_bits(0x00ff_8001);
    for (x, z, label) in [("1.5", "3", 7), ("nan", "-3", 8), ("0.25", "1e-3", 65535)] {
        text += &format!("{x} 5648349.895035 0 0 0 {z} {rgb:e} 0 0 1 {label}\n");
    }
    text.into_bytes()
}

/// The rows of `ascii` as bytes, row by row.
fn rows() -> Vec<Vec<Vec<u8>>> {
    let point = |x: f32, z: f32, label: u16| {
        let mut fields = vec![x.to_le_bytes().to_vec(), 5648349.895035f64.to_le_bytes().to_vec()];
        fields.extend([vec![0], vec![0], vec![0], z.to_le_bytes().to_vec()]);
        fields.push(0x00ff_8001u32.to_le_bytes().to_vec());
        fields.extend([0f32, 0.0, 1.0].map(|n| n.to_le_bytes().to_vec()));
        fields.push(label.to_le_bytes().to_vec());
        fields
    };
    vec![point(1.5, 3.0, 7), point(f32::NAN, -3.0, 8), point(0.25, 1e-3, 65535)]
}

fn binary() -> Vec<u8> {
    let mut file = format!("{HEADER}DATA binary\n").into_bytes();
    file.extend(rows().concat().concat());
    file
}

/// Columns one after the other, packed with runs of literals and one copy of zeros.
fn compressed() -> Vec<u8> {
    let rows = rows();
    let plain: Vec<u8> =
        (0..rows[0].len()).flat_map(|field| rows.iter().flat_map(move |row| row[field].clone())).collect();
    let mut packed = Vec::new();
    let mut at = 0;
    while at < plain.len() {
        let run = plain[at..].iter().take_while(|&&b| b == 0).count();
        if run >= 6 && at > 0 && plain[at - 1] == 0 {
            // A long copy from one byte back, which overlaps what it writes.
            let length = run.min(200);
            if length > 8 {
                packed.extend([7 << 5, (length - 9) as u8, 0])
            } else {
                packed.extend([((length - 2) as u8) << 5, 0])
            }
            at += length;
        } else {
            let count = (plain.len() - at).min(5);
            packed.push(count as u8 - 1);
            packed.extend(&plain[at..at + count]);
            at += count;
        }
    }
    let mut file = format!("{HEADER}DATA binary_compressed\n").into_bytes();
    file.extend((packed.len() as u32).to_le_bytes());
    file.extend((plain.len() as u32).to_le_bytes());
    file.extend(packed);
    file
}

#[test]
fn ascii_binary_and_compressed_give_the_same() {
    for file in [ascii(), binary(), compressed()] {
        let scan = from_bytes(&file, "cloud.pcd", &options()).unwrap();
        assert_eq!((scan.format, scan.cloud.len(), scan.ignored.len()), (Format::Pcd, 3, 0));
        assert_eq!(scan.cloud.positions[0], [1.5, 5648349.895035, 3.0]);
        assert!(scan.cloud.positions[1][0].is_nan());
        let names: Vec<_> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["red", "green", "blue", "normal_0", "normal_1", "normal_2", "label"]);
        assert_eq!(scan.cloud.attributes[0].values, Column::U8(vec![255; 3]));
        assert_eq!(scan.cloud.attributes[1].values, Column::U8(vec![128; 3]));
        assert_eq!(scan.cloud.attributes[2].values, Column::U8(vec![1; 3]));
        assert_eq!(scan.cloud.attributes[6].values, Column::U16(vec![7, 8, 65535]));
    }
}

#[test]
fn cut_anywhere_it_is_an_error() {
    for file in [ascii(), binary(), compressed()] {
        let body = file.windows(5).position(|w| w == b"\nDATA").unwrap();
        for length in (0..body).step_by(11).chain(body..file.len() - 7) {
            assert!(from_bytes(&file[..length], "cut.pcd", &options()).is_err(), "{length}");
        }
    }
    let file = binary();
    let salvage = ReadOptions { salvage: true, ..options() };
    let scan = from_bytes(&file[..file.len() - 1], "cut.pcd", &salvage).unwrap();
    assert_eq!((scan.cloud.len(), scan.missing.unwrap().read), (2, 2));
}

#[test]
fn a_claim_of_billions_of_points_takes_no_memory() {
    for data in ["ascii", "binary", "binary_compressed"] {
        for count in ["4294967296", "18446744073709551615"] {
            let text = format!(
                "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH {count}\nHEIGHT 1\nPOINTS {count}\nDATA {data}\n1 2 3\n"
            );
            let error = from_bytes(text.as_bytes(), "claim.pcd", &options()).unwrap_err();
            assert!(error.to_string().contains(count), "{error}");
        }
    }
}

#[test]
fn refusals_name_the_line_and_the_value() {
    for (from, to, expected) in [
        ("FIELDS x y", "FIELDS u y", "no field `x`"),
        ("SIZE 4", "SIZE 3", "size 3"),
        ("TYPE F", "TYPE Q", "`Q`"),
        ("SIZE 4 8", "SIZE 4", "6 SIZE"),
        ("COUNT 1 1 3", "COUNT 1 1 4000000000", "4000000000"),
        ("POINTS 3", "POINTS 4", "WIDTH times HEIGHT is 3"),
        ("POINTS 3", "POINTS -3", "`-3`"),
        ("DATA ascii", "DATA zipped", "DATA zipped"),
        ("1.5 5648349.895035", "1,5 5648349.895035", "line 12: field `x` is `1,5`"),
        (" 65535\n", " 65536\n", "65536"),
    ] {
        let text = String::from_utf8(ascii()).unwrap();
        assert!(text.contains(from), "{from}");
        let error =
            from_bytes(text.replacen(from, to, 1).as_bytes(), "bad.pcd", &options()).unwrap_err().to_string();
        assert!(
            error.contains(expected)
                && error.contains(if to.ends_with("4000000000") { "byte " } else { "line " }),
            "{error}"
        );
    }
}

#[test]
fn a_header_line_that_is_too_long_is_refused_and_not_cut() {
    let blanks = " ".repeat(1 << 20);
    let text = String::from_utf8(ascii()).unwrap().replacen("FIELDS x y", &format!("FIELDS x{blanks} y"), 1);
    let error = from_bytes(text.as_bytes(), "long.pcd", &options()).unwrap_err().to_string();
    assert!(error.contains("a header line of 1048"), "{error}");
}

#[test]
fn a_copy_from_before_the_beginning_is_refused() {
    let mut file = compressed();
    let body = file.windows(11).position(|w| w == b"compressed\n").unwrap() + 11;
    file[body + 8] = 0x20;
    let error = from_bytes(&file, "bad.pcd", &options()).unwrap_err().to_string();
    assert!(error.contains("bytes back"), "{error}");
}

#[test]
fn what_unpacks_beyond_the_bound_is_refused_and_the_bound_can_be_raised() {
    let count = 4_000_000u32;
    let mut file = format!("FIELDS x y z\nSIZE 1 1 1\nTYPE I I I\nWIDTH {count}\nHEIGHT 1\nPOINTS {count}\nDATA binary_compressed\n").into_bytes();
    let mut packed = vec![0, 5];
    let mut left = count * 3 - 1;
    while left > 0 {
        let length = left.min(264).max(if left < 9 { 9 } else { 0 });
        packed.extend([7 << 5, (length - 9) as u8, 0]);
        left = left.saturating_sub(length);
    }
    file.extend((packed.len() as u32).to_le_bytes());
    file.extend((count * 3).to_le_bytes());
    file.extend(packed);
    let error = from_pipe(&file, "bomb.pcd", &options()).unwrap_err().to_string();
    assert!(error.contains("--memory"), "{error}");
    let scan = from_pipe(&file, "bomb.pcd", &ReadOptions { memory: Some(1 << 30), ..options() }).unwrap();
    assert!(scan.cloud.len() == count as usize && scan.cloud.positions.iter().all(|p| *p == [5.0; 3]));
}

#[test]
fn packed_bytes_that_are_announced_and_missing_are_refused_in_a_file_and_in_a_pipe() {
    let mut file = compressed();
    let sizes = file.windows(11).position(|w| w == b"compressed\n").unwrap() + 11;
    let packed = u32::from_le_bytes(file[sizes..sizes + 4].try_into().unwrap());
    file[sizes..sizes + 4].copy_from_slice(&(packed + 9).to_le_bytes());
    for read in [from_bytes, from_pipe] {
        let error = read(&file, "cut.pcd", &options()).unwrap_err().to_string();
        assert!(error.contains("the input ends early"), "{error}");
    }
    file.extend([0; 9]);
    // Fewer bytes than a row has, which are told with what is left out.
    for read in [from_bytes, from_pipe] {
        let scan = read(&file, "longer.pcd", &options()).unwrap();
        assert!(scan.ignored.iter().any(|i| i.contains("9 bytes after the last")), "{:?}", scan.ignored);
    }
}

#[test]
fn files_of_the_library_itself_read_whole() {
    for (name, count) in
        [("formats/pcl_lamppost_ascii.pcd", 1771), ("formats/pcl_samp21_bincompressed.pcd", 12960)]
    {
        let Some(path) = shared(name) else { continue };
        let scan = read(&path, &options()).unwrap();
        assert_eq!(scan.format, Format::Pcd);
        assert_eq!(scan.cloud.len(), count, "{name}: {:?} {:?}", scan.ignored, &scan.cloud.positions[..2]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    #[test]
    fn any_change_of_a_byte_is_read_or_refused(at in 0usize..600, value in any::<u8>(), which in 0usize..3) {
        let mut file = [ascii(), binary(), compressed()][which].clone();
        let at = at % file.len();
        file[at] = value;
        match from_bytes(&file, "changed.pcd", &options()) {
            Ok(scan) => prop_assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == bits(&scan).len())),
            Err(Error::Io { .. }) => prop_assert!(false),
            Err(_) => {}
        }
    }
}
