//! OBJ inputs.

use crate::common::from_bytes;
use lineament::Column;
use lineament_io::{Format, ReadOptions};

#[test]
fn vertices_are_read_and_other_statements_counted() {
    let text =
        "# made by hand\r\nmtllib a.mtl\r\no one\r\nv 1 2 3\r\nv 4 5 \\\r\n6 1.0\r\nvn 0 0 1\r\nf 1 2 1\r\n";
    let scan = from_bytes(text.as_bytes(), "part.obj", &ReadOptions::default()).unwrap();
    assert_eq!(scan.format, Format::Obj);
    assert_eq!(scan.cloud.positions, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    assert_eq!(scan.ignored, ["4 statements other than `v`"]);
}

#[test]
fn colours_are_kept_if_every_vertex_has_one() {
    let scan = from_bytes(b"v 1 2 3 0.5 0 1\nv 4 5 6 1 1 1\n", "c.obj", &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.attributes[0].values, Column::F64(vec![0.5, 1.0]));
    for partial in ["v 1 2 3 0.5 0 1\nv 4 5 6\n", "v 4 5 6\nv 1 2 3 0.5 0 1\n"] {
        let scan = from_bytes(partial.as_bytes(), "c.obj", &ReadOptions::default()).unwrap();
        assert!(scan.cloud.attributes.is_empty());
        assert_eq!(scan.ignored, ["vertex colours: not every vertex has one"]);
    }
}

#[test]
fn a_bad_vertex_is_refused_with_its_line() {
    for (text, expected) in [
        ("v 1 2\nv 1 2 3\n", "line 1: a vertex of 2 numbers"),
        ("v 1 2 3\nv 1 2 z\n", "line 2: vertex coordinate `z`"),
        ("v 1 2,5 3\n", "`2,5`"),
    ] {
        let error = from_bytes(text.as_bytes(), "bad.obj", &ReadOptions::default()).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}
