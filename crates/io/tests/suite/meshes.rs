//! Vertices of meshes, and arrays: STL, OFF, NPY and Expe point sets.

use crate::common::{from_bytes, shared};
use lineament::Column;
use lineament_io::{Format, ReadOptions, read};
use proptest::prelude::*;

fn options() -> ReadOptions {
    ReadOptions::default()
}

fn salvage() -> ReadOptions {
    ReadOptions { salvage: true, ..options() }
}

fn binary_stl(header: &[u8]) -> Vec<u8> {
    let mut file = header.to_vec();
    file.resize(80, 0);
    file.extend(2u32.to_le_bytes());
    for triangle in 0..2 {
        for value in 0..12 {
            file.extend(((triangle * 12 + value) as f32).to_le_bytes());
        }
        file.extend([0, 0]);
    }
    file
}

const ASCII_STL: &str = "solid part\n facet normal 0 0 1\n  outer loop\n   vertex 3 4 5\n   vertex 6 7 8\n   vertex 9 10 11\n  endloop\n endfacet\n\
    facet normal 0 0 1\nouter loop\nvertex 15 16 17\nvertex 18 19 20\nvertex 21 22 2.3e1\nendloop\nendfacet\nendsolid part\n";

#[test]
fn stl_gives_the_corners_of_its_triangles_however_it_begins() {
    let expected: Vec<[f64; 3]> =
        [3, 6, 9, 15, 18, 21].map(|v| [f64::from(v), f64::from(v + 1), f64::from(v + 2)]).into();
    for file in [
        binary_stl(b""),
        binary_stl(b"solid of facets"),
        ASCII_STL.into(),
        ASCII_STL.replace('\n', "\r\n").into(),
    ] {
        let scan = from_bytes(&file, "part.stl", &options()).unwrap();
        assert_eq!((scan.format, scan.cloud.positions), (Format::Stl, expected.clone()));
    }
}

#[test]
fn a_cut_stl_is_an_error() {
    let binary = binary_stl(b"made up");
    for length in 84..binary.len() {
        let error = from_bytes(&binary[..length], "cut.stl", &options()).unwrap_err().to_string();
        assert!(error.contains("of 2 triangles"), "{error}");
        let whole = 3 * ((length - 84) / 50);
        assert_eq!(from_bytes(&binary[..length], "cut.stl", &salvage()).unwrap().cloud.len(), whole);
    }
    let cut = &ASCII_STL[..ASCII_STL.len() - 15];
    assert!(from_bytes(cut.as_bytes(), "cut.stl", &options()).is_err());
    assert_eq!(from_bytes(cut.as_bytes(), "cut.stl", &salvage()).unwrap().cloud.len(), 6);
}

const OFF: &str = "OFF # a comment\n\n3 1 0\n0 0 0\n# between\n1 0 0.5\n0 1 0 255 0 0\n3 0 1 2\n";

#[test]
fn off_gives_its_vertices() {
    let one_line = OFF.replace("OFF # a comment\n\n3 1 0", "COFF 3 1 0");
    for text in [OFF.to_string(), OFF.replace('\n', "\r\n"), one_line] {
        let scan = from_bytes(text.as_bytes(), "part.off", &options()).unwrap();
        assert_eq!(scan.format, Format::Off);
        assert_eq!(scan.cloud.positions, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [0.0, 1.0, 0.0]]);
    }
}

/// Its numbers are words with white space between: where the lines show no order, their order alone counts.
#[test]
fn off_may_run_on_without_regard_to_lines() {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [0.0, 1.0, 0.0], [2.0, 2.0, 2.0], [3.0, 1.0, 4.0]];
    let numbers = "0 0 0 1 0 .5 0 1 0 2 2 2 3 1 4";
    let one_each = format!("OFF 5 2 0\n{} 3 0 1 2 3 0 1 4\n", numbers)
        .replace(' ', "\n")
        .replace("OFF\n5\n2\n", "OFF 5 2 ");
    let one_line = format!("OFF\n5 2 0\n{numbers}\n3 0 1 2 3 0 1 4\n");
    let uneven = "OFF\n5 2 0\n0 0\n0 1 0 .5 # comment\n0 1 0 2 2\n2 3 1 4 3 0 1 2\n3 0 1 4";
    for text in [one_each.as_str(), one_line.as_str(), uneven] {
        let scan =
            from_bytes(text.as_bytes(), "part.off", &options()).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(scan.cloud.positions, points, "{text}");
        assert_eq!(scan.ignored, ["2 faces"]);
    }
    let cut = from_bytes(&uneven.as_bytes()[..40], "cut.off", &options()).unwrap_err().to_string();
    assert!(cut.contains("of 5 vertices"), "{cut}");
    // Six numbers may be two vertices, or one with a normal: they are one, and the message says so.
    let six = "OFF\n4 1 0\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 1 2\n";
    let error = from_bytes(six.as_bytes(), "six.off", &options()).unwrap_err().to_string();
    assert!(error.contains("3 of 4 vertices (lines of 6 numbers)"), "{error}");
}

#[test]
fn a_cut_off_is_an_error() {
    for (cut, expected) in [("3 0 1 2\n", "0 of 1 faces"), ("0 1 0 255 0 0\n3 0 1 2\n", "2 of 3 vertices")] {
        let text = OFF.strip_suffix(cut).unwrap();
        let error = from_bytes(text.as_bytes(), "cut.off", &options()).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
        assert!(from_bytes(text.as_bytes(), "cut.off", &salvage()).unwrap().missing.is_some());
    }
    let claim = OFF.replace("3 1 0", "18446744073709551615 1 0");
    assert!(from_bytes(claim.as_bytes(), "claim.off", &options()).is_err());
    assert!(from_bytes(b"4OFF\n1 0 0\n1 2 3 4\n", "four.off", &options()).is_err());
}

fn npy(descr: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}          \n");
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend((text.len() as u16).to_le_bytes());
    file.extend(text.as_bytes());
    file.extend(data);
    file
}

#[test]
fn npy_arrays_are_read_in_either_order_and_endianness() {
    let rows: Vec<u8> = (0..8).flat_map(|v: u8| f64::from(v).to_le_bytes()).collect();
    let columns: Vec<u8> = [0, 4, 1, 5, 2, 6, 3, 7].into_iter().flat_map(|v: i16| v.to_be_bytes()).collect();
    for file in [npy("'<f8'", "False", "(2, 4)", &rows), npy("'>i2'", "True", "(2, 4)", &columns)] {
        let scan = from_bytes(&file, "a.npy", &options()).unwrap();
        assert_eq!(
            (scan.format, scan.cloud.positions),
            (Format::Npy, vec![[0.0, 1.0, 2.0], [4.0, 5.0, 6.0]])
        );
        assert_eq!(scan.cloud.attributes[0].name, "column_4");
    }
}

#[test]
fn npy_arrays_of_half_precision_are_read() {
    // 1, -2, 0.5, 65504, the least above zero, infinity, 0, -0.
    let halves = [0x3c00u16, 0xc000, 0x3800, 0x7bff, 0x0001, 0x7c00, 0, 0x8000];
    let rows: Vec<u8> = halves.into_iter().flat_map(u16::to_le_bytes).collect();
    let columns: Vec<u8> =
        [0, 4, 1, 5, 2, 6, 3, 7].into_iter().flat_map(|i: usize| halves[i].to_be_bytes()).collect();
    for file in [npy("'<f2'", "False", "(2, 4)", &rows), npy("'>f2'", "True", "(2, 4)", &columns)] {
        let cloud = from_bytes(&file, "a.npy", &options()).unwrap().cloud;
        assert_eq!(cloud.positions, [[1.0, -2.0, 0.5], [2f64.powi(-24), f64::INFINITY, 0.0]]);
        assert_eq!(cloud.attributes[0].values, Column::F32(vec![65504.0, -0.0]));
    }
    let descr = "[('x', '<f2'), ('y', '<f2'), ('w', '<f2'), ('z', '<f8')]";
    let data = [&rows[..6], &7f64.to_le_bytes(), &rows[6..12], &8f64.to_le_bytes()].concat();
    let cloud = from_bytes(&npy(descr, "False", "(2,)", &data), "a.npy", &options()).unwrap().cloud;
    assert_eq!(cloud.positions, [[1.0, -2.0, 7.0], [65504.0, 2f64.powi(-24), 8.0]]);
    assert_eq!(cloud.attributes[0].values, Column::F32(vec![0.5, f32::INFINITY]));
}

#[test]
fn npy_structures_are_read_by_their_names() {
    let mut data = Vec::new();
    for row in 0..2u8 {
        data.push(row);
        data.extend([1.5f32, 2.5, 3.5].into_iter().flat_map(f32::to_le_bytes));
    }
    let descr = "[('label', '|u1'), ('z', '<f4'), ('x', '<f4'), ('y', '<f4')]";
    let scan = from_bytes(&npy(descr, "False", "(2,)", &data), "a.npy", &options()).unwrap();
    assert_eq!(scan.cloud.positions, [[2.5, 3.5, 1.5]; 2]);
    assert_eq!(scan.cloud.attributes[0].values, Column::U8(vec![0, 1]));
}

#[test]
fn npy_fields_that_are_no_numbers_are_stepped_over_and_named() {
    let mut data = Vec::new();
    for row in 0..2u8 {
        data.extend([row, 0, 0, 0]);
        data.extend("wall".chars().flat_map(|c| u32::from(c).to_le_bytes()));
        data.extend([1.5f32, 2.5, 3.5].into_iter().flat_map(f32::to_le_bytes));
    }
    let descr = "[('label', '|u1'), ('', '|V3'), ('part', '<U4'), ('x', '<f4'), ('y', '<f4'), ('z', '<f4')]";
    let scan = from_bytes(&npy(descr, "False", "(2,)", &data), "a.npy", &options()).unwrap();
    assert_eq!(scan.cloud.positions, [[1.5, 2.5, 3.5]; 2]);
    assert_eq!((scan.cloud.attributes.len(), scan.ignored), (1, vec!["field `part`: no number".into()]));
    let descr = "[('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('blob', '|V4294967295')]";
    let error = from_bytes(&npy(descr, "False", "(2,)", &data), "a.npy", &options()).unwrap_err().to_string();
    assert!(error.contains("rows of 4294967307 bytes"), "{error}");
}

#[test]
fn an_npy_array_that_lies_on_its_side_is_refused() {
    let data: Vec<u8> = (0..120u8).flat_map(|v| f32::from(v).to_le_bytes()).collect();
    let error = from_bytes(&npy("'<f4'", "False", "(3, 40)", &data), "a.npy", &options()).unwrap_err();
    assert!(error.to_string().contains("shape [3, 40], wider than long: transpose it"), "{error}");
    assert_eq!(
        from_bytes(&npy("'<f4'", "False", "(40, 3)", &data), "a.npy", &options()).unwrap().cloud.len(),
        40
    );
}

#[test]
fn npy_claims_are_compared_with_the_bytes() {
    for shape in ["(4294967296, 3)", "(9223372036854775808, 3)", "(3, 3)", "(18446744073709551615, 4096)"] {
        for order in ["True", "False"] {
            let file = npy("'<f4'", order, shape, &[0; 24]);
            assert!(from_bytes(&file, "claim.npy", &options()).is_err(), "{shape}");
        }
    }
    for (descr, shape) in [
        ("'<f16'", "(2, 3)"),
        ("'<f4'", "(6,)"),
        ("'<f4'", "(3, 2)"),
        ("'|O'", "(2, 3)"),
        ("[('x', '<f4', (3,))]", "(2,)"),
    ] {
        let error =
            from_bytes(&npy(descr, "False", shape, &[0; 24]), "odd.npy", &options()).unwrap_err().to_string();
        assert!(error.contains("expected an array"), "{error}");
    }
}

#[test]
fn expe_point_sets_are_read() {
    let mut file = b"[Expe/PointSet/Binary/0.1]\nproperty position 12\nproperty radius 4\nproperty color 4\nnofpoints 2\ndata\n".to_vec();
    for _ in 0..2 {
        file.extend([1f32, 2.0, 3.0, 0.5].into_iter().flat_map(f32::to_le_bytes));
        file.extend([10, 20, 30, 255]);
    }
    let scan = from_bytes(&file, "a.pts", &options()).unwrap();
    assert_eq!((scan.format, scan.cloud.positions), (Format::Expe, vec![[1.0, 2.0, 3.0]; 2]));
    assert_eq!(scan.cloud.attributes[1].values, Column::U8(vec![10; 2]));
    assert!(from_bytes(&file[..file.len() - 1], "a.pts", &options()).is_err());
}

#[test]
fn meshes_of_other_programs_read_whole() {
    for (name, format, count) in [
        ("models/screwdriver.off", Format::Off, 27152),
        ("models/trim-star.off", Format::Off, 5192),
        ("formats/chameleon4k.pts", Format::Expe, 4594),
    ] {
        let Some(path) = shared(name) else { continue };
        let scan = read(&path, &options()).unwrap();
        assert_eq!((scan.format, scan.cloud.len()), (format, count), "{name}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]
    #[test]
    fn any_change_of_a_byte_is_read_or_refused(at in 0usize..400, value in any::<u8>(), which in 0usize..4) {
        let data = [0u8; 24];
        let files = [
            (binary_stl(b"x"), "a.stl"),
            (ASCII_STL.as_bytes().to_vec(), "a.stl"),
            (OFF.as_bytes().to_vec(), "a.off"),
            (npy("'<f4'", "False", "(2, 3)", &data), "a.npy"),
        ];
        let (mut bytes, name) = files[which].clone();
        let at = at % bytes.len();
        bytes[at] = value;
        if let Ok(scan) = from_bytes(&bytes, name, &salvage()) {
            prop_assert!(scan.cloud.attributes.iter().all(|a| a.values.len() == scan.cloud.len()));
        }
    }
}
