//! Tables of numbers, in the many ways they are written.

use crate::common::from_bytes;
use lineament::Column;
use lineament_io::{Format, ReadOptions};

const POINTS: [[f64; 3]; 2] = [[1.5, -2.25, 3.0], [4.0, 5.5, 1e-3]];

fn positions(text: &str) -> Vec<[f64; 3]> {
    let scan = from_bytes(text.as_bytes(), "table.xyz", &ReadOptions::default());
    let scan = scan.unwrap_or_else(|error| panic!("{error} for {text:?}"));
    assert_eq!(scan.format, Format::Table);
    scan.cloud.positions
}

fn refusal(text: &str) -> String {
    let error = from_bytes(text.as_bytes(), "table.xyz", &ReadOptions::default());
    error.map(|scan| panic!("{text:?} gave {scan:?}")).unwrap_err().to_string()
}

#[test]
fn the_same_points_come_from_every_way_of_writing_them() {
    for text in [
        "1.5 -2.25 3\n4 5.5 1e-3\n",
        "1.5 -2.25 3\n4 5.5 1e-3",
        "  1.5   -2.25\t3 \r\n4 5.5 1e-3\r\n\r\n",
        "1.5 -2.25 3\r4 5.5 1e-3\r",
        "\u{feff}1.5,-2.25,3\n4,5.5,1e-3\n",
        "1.5, -2.25, 3\n4, 5.5, 1e-3\n",
        "1.5;-2.25;3;\n4;5.5;1e-3;\n",
        "1.5\t-2.25\t3\n4\t5.5\t1e-3\n",
        "# a comment\n// another\n1.5 -2.25 3\n# between\n4 5.5 1e-3\n",
        "2\n1.5 -2.25 3\n4 5.5 1e-3\n",
        "1\n1.5 -2.25 3\n1\n4 5.5 1e-3\n",
        "x,y,z\n1.5,-2.25,3\n4,5.5,1e-3\n",
        "\"X [m]\",\"Y [m]\",\"Z [m]\"\n\"1.5\",\"-2.25\",\"3\"\n\"4\",\"5.5\",\"1e-3\"\n",
        "//X Y Z\n1.5 -2.25 3\n4 5.5 1e-3\n",
        "Scan of the north wall\nx y z\n1.5 -2.25 3\n4 5.5 1e-3\n",
        "1,5 -2,25 3,0\n4,0 5,5 0,001\n",
        "1,5;-2,25;3\n4;5,5;1e-3\n",
        "1,5\t-2,25\t3\n4\t5,5\t1e-3\n",
        "\"1,5\",\"-2,25\",\"3,0\"\n\"4,0\",\"5,5\",\"0,001\"\n",
    ] {
        if text.starts_with("\"1,5") {
            // Quoted decimal commas between commas: refused, not misread.
            refusal(text);
        } else {
            assert_eq!(positions(text), POINTS, "{text:?}");
        }
    }
}

#[test]
fn named_columns_are_found_in_any_order_and_others_are_kept() {
    let text = "id;Z;name;Easting;Northing;nx\n7;3;wall;1;2;0.5\n8;6;\"floor; old\";4;5;NA\n";
    let scan = from_bytes(text.as_bytes(), "named.csv", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    let names: Vec<_> = scan.cloud.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["id", "nx"]);
    assert_eq!(scan.cloud.attributes[0].values, Column::U8(vec![7, 8]));
    assert!(matches!(&scan.cloud.attributes[1].values, Column::F64(v) if v[0] == 0.5 && v[1].is_nan()));
    assert_eq!(scan.ignored, ["column `name`: text"]);
}

#[test]
fn whole_columns_take_the_smallest_integer_type() {
    let text = "0 0 0 255 -1 65535 70000 3000000000 0.5\n0 0 1 0 200 1 -5 0 1\n";
    let scan = from_bytes(text.as_bytes(), "whole.txt", &ReadOptions::default()).unwrap();
    let kinds: Vec<_> = scan.cloud.attributes.iter().map(|a| &a.values).collect();
    assert_eq!(kinds[0], &Column::U8(vec![255, 0]));
    assert_eq!(kinds[1], &Column::I16(vec![-1, 200]));
    assert_eq!(kinds[2], &Column::U16(vec![65535, 1]));
    assert_eq!(kinds[3], &Column::I32(vec![70000, -5]));
    assert_eq!(kinds[4], &Column::U32(vec![3_000_000_000, 0]));
    assert_eq!(kinds[5], &Column::F64(vec![0.5, 1.0]));
}

#[test]
fn commas_that_could_mean_two_things_are_refused() {
    assert!(refusal("1,5,2,5,3,5\n4,5,6,5,7,5\n").contains("decimal signs"));
    assert!(refusal("1,5, 2,5, 3,5\n").contains("decimal signs"));
    assert!(refusal("1,234.5 2,345.5 3,456.5\n").contains("`234.5 2`"));
    assert!(refusal("1.5;2,5;3.5\n").contains("neither"));
    assert!(refusal("1 2.5 3\n4 5 6,5\n").contains("neither"));
}

#[test]
fn a_line_that_is_no_row_is_named_with_its_remedy() {
    let rows = "1.5,2.5,3.5\n".repeat(300);
    let total = format!("x,y,z\n{rows}Total points: 20000\n");
    let error = refusal(&total);
    assert!(error.contains("line 302: column 1 is `Total points: 20000`"), "{error}");
    assert!(error.contains("--salvage reads the rows before it"), "{error}");
    let salvage = ReadOptions { salvage: true, ..ReadOptions::default() };
    assert_eq!(from_bytes(total.as_bytes(), "total.csv", &salvage).unwrap().cloud.len(), 300);
    let middle = refusal(&format!("{rows}error 7,2.5,3.5\n{rows}"));
    assert!(middle.contains("line 301") && middle.contains("put `#` before it"), "{middle}");
    assert_eq!(positions(&format!("{rows}# error 7,2.5,3.5\n{rows}")).len(), 600);
}

#[test]
fn a_clean_table_is_read_whatever_its_name_suggests() {
    let read = |text: &str, name: &str| from_bytes(text.as_bytes(), name, &ReadOptions::default());
    for text in ["1 2 3\n4 5 6\n", "x,y,z\n1.5,2.5,3.5\n4,5,6\n7,8,9", "# a note\n1;2;3;9\n4;5;6;9\n"] {
        for (name, format) in [("friend.ply", "PLY"), ("friend.las", "LAS"), ("friend.npz", "NPZ")] {
            let scan = read(text, name).unwrap();
            assert_eq!(scan.format, Format::Table, "{name}");
            assert!(scan.warnings[0].contains(format) && scan.warnings[0].contains("a table of numbers"));
        }
        assert!(read(text, "friend.csv").unwrap().warnings.is_empty());
    }
    for text in ["1 2 3\n4 5\n", "1 2\n3 4\n", "1 2 3\n", "1 2 3\n4 5 6\nand so on\n"] {
        let error = read(text, "friend.las").unwrap_err().to_string();
        assert!(error.contains("the name suggests LAS") && error.contains("--input-format"), "{error}");
    }
}

#[test]
fn a_row_that_does_not_fit_is_refused_with_its_line() {
    let mut many = "1 2 3\n".repeat(300);
    let error = refusal(&(many.clone() + "1 2,5 3\n"));
    assert!(error.contains("line 301: column 2 is `2,5`"), "{error}");
    let error = refusal(&(many.clone() + "1 2 3 4\n"));
    assert!(error.contains("line 301: 4 columns where the first rows have 3"), "{error}");
    many += "1 2";
    let error = refusal(&many);
    assert!(error.contains("line 301: 2 columns"), "{error}");
    let salvage = ReadOptions { salvage: true, ..ReadOptions::default() };
    let scan = from_bytes(many.as_bytes(), "cut.xyz", &salvage).unwrap();
    assert_eq!((scan.cloud.len(), scan.missing.unwrap().read), (300, 300));
}

#[test]
fn a_count_line_must_agree_with_the_rows() {
    assert!(refusal("3\n1 2 3\n4 5 6\n").contains("2 of 3 rows"));
    assert!(refusal("1\n1 2 3\n4 5 6\n").contains("2 rows where the count line announces 1"));
    assert!(refusal("3\n1 2 3\n4 5 6\n1\n7 8 9\n").contains("a new count line after 2 rows"));
    assert!(refusal("18446744073709551615\n1 2 3\n").contains("1 of 18446744073709551615 rows"));
}

#[test]
fn a_last_field_may_be_missing_behind_its_separator() {
    let text = "I,Z,Y,X\n7,3,2,1\n8,6,5,\n9,6,5,4\n";
    let scan = from_bytes(text.as_bytes(), "open.csv", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions[0], [1.0, 2.0, 3.0]);
    assert!(scan.cloud.positions[1][0].is_nan());
    let text = "z;y;x;note\n3;2;1;\n6;5;4;\n";
    let scan = from_bytes(text.as_bytes(), "open.csv", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    let text = "3 names\n1.5,2,3,\n1.5,5,6,4\n";
    assert_eq!(from_bytes(text.as_bytes(), "open.csv", &ReadOptions::default()).unwrap().cloud.len(), 2);
}

#[test]
fn two_quotes_within_quotes_are_one_and_close_nothing() {
    let text = "part,x,y,z\n\"the \"\"big\"\", old\",1,2,3\n\"\",4,5,6\n";
    let scan = from_bytes(text.as_bytes(), "quoted.csv", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
}

#[test]
fn names_that_do_not_fit_the_columns_are_refused() {
    let error = refusal("id x y z\n1 1.5 2.5 3.5 4.5\n2 1.5 2.5 3.5 4.5\n");
    assert!(error.contains("5 columns under the 4 names id, x, y, z"), "{error}");
    assert_eq!(positions("X [m] Y [m] Z [m]\n1.5 -2.25 3\n4 5.5 1e-3\n"), POINTS);
}

#[test]
fn columns_without_names_for_the_coordinates_are_refused() {
    let error = refusal("a,b,c\n1,2,3\n");
    assert!(
        error.contains("a, b, c") && error.contains("rechtswert,hochwert") && error.contains("--columns"),
        "{error}"
    );
}

#[test]
fn coordinates_are_known_by_the_names_that_surveyors_use() {
    for names in [
        "E,N,H",
        "East;North;Up",
        "Ost;Nord;Höhe",
        "RECHTSWERT;HOCHWERT;HÖHE",
        "POINT_X,POINT_Y,POINT_Z",
        "x_coord y_coord z_coord",
        "Easting [m],Northing [m],Height [m]",
        "h,n,e",
    ] {
        let separator = if names.contains(';') {
            ';'
        } else if names.contains(',') {
            ','
        } else {
            ' '
        };
        let rows = |p: [f64; 3]| p.map(|c| c.to_string()).join(&separator.to_string());
        let turned = names == "h,n,e";
        let body: Vec<String> =
            POINTS.iter().map(|&[x, y, z]| rows(if turned { [z, y, x] } else { [x, y, z] })).collect();
        assert_eq!(positions(&format!("{names}\n{}\n", body.join("\n"))), POINTS, "{names}");
    }
}

#[test]
fn latin_text_is_read_and_shown_as_such() {
    let table = |names: &[u8]| [names, b"\n1.5;2.5;3.5\n4.5;5.5;6.5\n"].concat();
    let read = |bytes: &[u8]| from_bytes(bytes, "table.csv", &ReadOptions::default());
    assert_eq!(read(&table(b"Ost;Nord;H\xf6he")).unwrap().cloud.positions[1], [4.5, 5.5, 6.5]);
    let error = read(&table(b"L\xe4nge;Breite;Ma\xdf")).unwrap_err().to_string();
    assert!(error.contains("Länge, Breite, Maß"), "{error}");
}

#[test]
fn columns_that_are_asked_for_are_taken_by_number_or_name() {
    let read = |text: &str, columns: [&str; 3]| {
        let columns = Some(columns.map(String::from));
        from_bytes(text.as_bytes(), "table.csv", &ReadOptions { columns, ..ReadOptions::default() })
    };
    let bare = "7 1.5 -2.25 3\n8 4 5.5 1e-3\n";
    let scan = read(bare, ["2", "3", "4"]).unwrap();
    assert_eq!((&scan.cloud.positions[..], scan.cloud.attributes.len()), (&POINTS[..], 1));
    let named = "Nr;Lage rechts;Lage hoch;Kote\n7;1.5;-2.25;3\n8;4;5.5;1e-3\n";
    assert_eq!(read(named, ["lage rechts", "Lage hoch", "KOTE"]).unwrap().cloud.positions, POINTS);
    assert_eq!(read(named, ["2", "3", "4"]).unwrap().cloud.positions, POINTS);
    for (columns, part) in
        [(["2", "3", "5"], "no column `5` among the 4"), (["2", "2", "3"], "a column twice")]
    {
        let error = read(named, columns).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
    let stl = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    let columns = Some(["1", "2", "3"].map(String::from));
    let error =
        from_bytes(stl, "a.stl", &ReadOptions { columns, ..ReadOptions::default() }).unwrap_err().to_string();
    assert!(error.contains("without --columns"), "{error}");
}

#[test]
fn point_numbers_in_the_first_of_four_columns_are_a_warning() {
    let rows = |row: fn(u32) -> [f64; 4]| -> String {
        (0..20).map(|i| row(i).map(|c| c.to_string()).join(" ") + "\n").collect()
    };
    let told =
        |text: &str| from_bytes(text.as_bytes(), "table.xyz", &ReadOptions::default()).unwrap().warnings;
    let numbered = told(&rows(|i| [f64::from(i + 1), 0.1 * f64::from(i * i), 5.0, 0.5 * f64::from(i % 3)]));
    assert!(numbered.len() == 1 && numbered[0].contains("--columns 2,3,4"), "{numbered:?}");
    // Rows of a grid count too, and three columns are coordinates whatever they look like.
    assert_eq!(told(&rows(|i| [f64::from(i), 7.0, 0.1 * f64::from(i % 7), 9.0])), [""; 0]);
    let three: String = (0..20).map(|i| format!("{i} {} 1\n", i * i)).collect();
    assert_eq!(told(&three), [""; 0]);
    assert_eq!(told(&format!("x y z i\n{}", rows(|i| [f64::from(i), f64::from(i * i), 0.0, 1.0]))), [""; 0]);
}

#[test]
fn text_that_is_no_table_is_refused() {
    assert!(refusal("Dear reader,\nthere is nothing here.\n").contains("no row of three numbers"));
    assert!(refusal("1 2\n3 4\n").contains("rows of 2 columns"));
    assert!(refusal("1 2\n3 4 5\n").contains("line 1"));
    assert!(refusal("\0\0\0\0").contains("format not recognised"));
    assert!(refusal("").contains("empty"));
}

#[test]
fn missing_and_non_finite_coordinates_are_kept_as_such() {
    let points = positions("x,y,z\n1,nan,3\n,inf,6\n7,8,9\n");
    assert!(points[0][1].is_nan() && points[1][0].is_nan() && points[1][1].is_infinite());
    assert_eq!(points[2], [7.0, 8.0, 9.0]);
}

#[test]
fn heights_of_a_grid_lie_in_the_middles_of_its_cells_from_the_north() {
    let grid = |header: &str, rows: &str| {
        let text = format!("ncols 3\nnrows 2\n{header}cellsize 10\nNODATA_value -9999\n{rows}");
        from_bytes(text.as_bytes(), "a.asc", &ReadOptions::default())
    };
    let corner = "xllcorner 3500000\nyllcorner 5400000\n";
    let scan = grid(corner, "1 2 3\n4 -9999 6\n").unwrap();
    let wanted = [[5.0, 15.0, 1.0], [15.0, 15.0, 2.0], [25.0, 15.0, 3.0], [5.0, 5.0, 4.0], [25.0, 5.0, 6.0]];
    assert_eq!(scan.cloud.positions, wanted.map(|[x, y, z]| [3_500_000.0 + x, 5_400_000.0 + y, z]));
    assert_eq!(scan.ignored, ["1 cells without a height"]);
    let centre = grid("XLLCENTER 3500005\nYLLCENTER 5400005\n", "1 2 3\n4 5 6\n").unwrap();
    assert_eq!(centre.cloud.positions[0], scan.cloud.positions[0]);
    for (header, rows, expected) in [
        (corner, "1 2 3\n4 5\n", "5 of 6 heights"),
        (corner, "1 2 3\n4 5 6 7\n", "more heights than the 3 times 2"),
        ("xllcorner 0\n", "1 2 3\n4 5 6\n", "without `yllcorner`"),
        (corner, "1 2 3\n4 high 6\n", "height 5 of 6"),
    ] {
        let message = grid(header, rows).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    }
}
