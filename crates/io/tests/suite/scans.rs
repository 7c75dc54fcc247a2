//! Inputs of scanners: E57, PTX and PTS.

use crate::common::e57::two_scans;
use crate::common::{from_bytes, shared};
use lineament::Column;
use lineament_io::{Format, ReadOptions, read};
use proptest::prelude::*;

fn options() -> ReadOptions {
    ReadOptions::default()
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

#[test]
fn e57_scans_are_moved_by_their_poses_and_invalid_points_left_out() {
    let scan = from_bytes(&two_scans(1000), "two.e57", &options()).unwrap();
    assert_eq!((scan.format, scan.cloud.len()), (Format::E57, 752));
    assert!(near(scan.cloud.positions[0], [98.0, 1.0, 3.0]), "{:?}", scan.cloud.positions[0]);
    assert!(near(scan.cloud.positions[750], [2.0, 0.0, 0.0]));
    assert!(near(scan.cloud.positions[751], [0.0, 2.0, 0.0]));
    assert!(scan.ignored[0].starts_with("250 points"), "{:?}", scan.ignored);
    let column = |name: &str| &scan.cloud.attributes.iter().find(|a| a.name == name).unwrap().values;
    assert!(matches!(column("intensity"), Column::F32(v) if v[1] == 2.0 && v[750].is_nan()));
    assert!(matches!(column("red"), Column::F32(v) if v[1] == 2.0 && v[750].is_nan()));
    assert!(matches!(column("scan"), Column::U16(v) if v[749] == 1 && v[750] == 2));
}

#[test]
fn one_e57_scan_can_be_chosen() {
    let one = |scan| from_bytes(&two_scans(1000), "two.e57", &ReadOptions { scan: Some(scan), ..options() });
    assert_eq!(one(2).unwrap().cloud.len(), 2);
    let error = one(3).unwrap_err().to_string();
    assert!(error.contains("no scan 3 of 2"), "{error}");
}

#[test]
fn a_cut_or_damaged_e57_is_an_error() {
    let whole = two_scans(1000);
    for length in (0..whole.len()).step_by(97) {
        assert!(from_bytes(&whole[..length], "cut.e57", &options()).is_err(), "{length}");
    }
    for at in (0..whole.len()).step_by(61) {
        let mut damaged = whole.clone();
        damaged[at] ^= 0x55;
        // Whatever a checksum covers is noticed; a name in the header is not.
        if let Ok(scan) = from_bytes(&damaged, "damaged.e57", &options()) {
            assert_eq!(scan.cloud.len(), 752);
        }
    }
}

const PTX: &str = "2\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n\
    1 0 0 0.5 255 0 1\n0 0 0 0.5 0 0 0\n0 1 0 0.25 1 2 3\n0 0 1 0 9 9 9\n0 0 0 0.5 0 0 0\n1 1 1 1 0 0 0\n";

#[test]
fn ptx_cells_are_transformed_and_empty_ones_left_out() {
    for text in [PTX.to_string(), PTX.replace('\n', "\r\n"), PTX.replace("1 0 0 0.5", "1.0 0.0 0.0 0.5")] {
        let scan = from_bytes(text.as_bytes(), "a.ptx", &options()).unwrap();
        assert_eq!(scan.format, Format::Ptx);
        assert_eq!(
            scan.cloud.positions,
            [[10.0, 21.0, 30.0], [9.0, 20.0, 30.0], [10.0, 20.0, 31.0], [9.0, 21.0, 31.0]]
        );
        assert_eq!(scan.ignored, ["2 cells without a return"]);
        assert_eq!(scan.cloud.attributes[0].values, Column::F64(vec![0.5, 0.25, 0.0, 1.0]));
        assert_eq!(scan.cloud.attributes[1].values, Column::U8(vec![255, 1, 9, 0]));
    }
    let twice = format!("{PTX}{PTX}");
    assert_eq!(from_bytes(twice.as_bytes(), "a.ptx", &options()).unwrap().cloud.len(), 8);
}

#[test]
fn a_cut_ptx_is_an_error_that_counts_its_cells() {
    let cut = PTX.strip_suffix("1 1 1 1 0 0 0\n").unwrap();
    let error = from_bytes(cut.as_bytes(), "a.ptx", &options()).unwrap_err().to_string();
    assert!(error.contains("5 of 6 cells of scan 1"), "{error}");
    let scan = from_bytes(cut.as_bytes(), "a.ptx", &ReadOptions { salvage: true, ..options() }).unwrap();
    assert_eq!(scan.cloud.len(), 3);
    let claim = PTX.replacen("2\n3\n", "4294967296\n4294967296\n", 1);
    assert!(from_bytes(claim.as_bytes(), "a.ptx", &options()).is_err());
}

#[test]
fn pts_columns_have_their_usual_names() {
    let scan = from_bytes(b"2\n1 2 3 -5 255 0 1\n4 5 6 7 0 0 0\n", "a.pts", &options()).unwrap();
    let names: Vec<_> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!((scan.format, names), (Format::Table, vec!["intensity", "red", "green", "blue"]));
}

#[test]
fn e57_files_of_other_programs_read_whole() {
    for (name, count, first) in [
        ("formats/bunnyInt19.e57", 30571, [-0.07063, 0.04015, 0.001226]),
        ("formats/tiny_spherical.e57", 180, [1.0, 0.0, 0.0]),
    ] {
        let Some(path) = shared(name) else { continue };
        let scan = read(&path, &options()).unwrap();
        assert_eq!((scan.format, scan.cloud.len()), (Format::E57, count));
        assert!(near(scan.cloud.positions[0], first), "{:?}", scan.cloud.positions[0]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn any_change_of_a_ptx_is_read_or_refused(at in 0usize..200, value in any::<u8>()) {
        let mut bytes = PTX.as_bytes().to_vec();
        let at = at % bytes.len();
        bytes[at] = value;
        if let Ok(scan) = from_bytes(&bytes, "changed.ptx", &options()) {
            prop_assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
        }
    }
}
