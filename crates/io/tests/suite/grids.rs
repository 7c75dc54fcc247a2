//! ESRI grids.

use crate::common::from_bytes;
use lineament_io::{Format, ReadOptions, Scan};

const HEADER: &str = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n";

fn scan(text: &str) -> Scan {
    let scan = from_bytes(text.as_bytes(), "a.asc", &ReadOptions::default()).unwrap();
    assert_eq!(scan.format, Format::Raster);
    scan
}

#[test]
fn heights_are_points_in_the_middle_of_their_cells_from_the_north() {
    let found = scan(&format!("{HEADER}NODATA_value -1\n1 2 3\n4 -1 6\n"));
    let expected =
        [[11.0, 23.0, 1.0], [13.0, 23.0, 2.0], [15.0, 23.0, 3.0], [11.0, 21.0, 4.0], [15.0, 21.0, 6.0]];
    assert_eq!(found.cloud.positions, expected);
    assert_eq!(found.ignored, ["1 cells without a height"]);
}

#[test]
fn a_grid_may_have_nan_for_no_height_even_in_its_first_cells() {
    for word in ["nan", "NaN"] {
        let found = scan(&format!("{HEADER}NODATA_value {word}\n{word} {word} 1\n4 {word} 6\n"));
        assert_eq!(found.cloud.positions.iter().map(|p| p[2]).collect::<Vec<f64>>(), [1.0, 4.0, 6.0]);
        assert_eq!(found.ignored, ["3 cells without a height"]);
    }
}

#[test]
fn cells_of_minus_9999_have_no_height_where_the_header_names_no_value() {
    let found = scan(&format!("{HEADER}1 2 -9999\n4 5 6\n"));
    assert_eq!(found.cloud.positions.iter().map(|p| p[2]).collect::<Vec<f64>>(), [1.0, 2.0, 4.0, 5.0, 6.0]);
    let given = scan(&format!("{HEADER}nodata_value 0\n1 2 -9999\n4 5 0\n"));
    assert_eq!(
        given.cloud.positions.iter().map(|p| p[2]).collect::<Vec<f64>>(),
        [1.0, 2.0, -9999.0, 4.0, 5.0]
    );
}

#[test]
fn a_grid_may_begin_with_a_byte_order_mark() {
    assert_eq!(scan(&format!("\u{feff}{HEADER}1 2 3\n4 5 6\n")).cloud.len(), 6);
}
