//! PLY, binary little endian (Turk 1994): the header, and rows of vertices and edges.

use std::io::{self, Write};

/// Coordinates of a vertex.
pub(in crate::write) const XYZ: [(&str, &str); 3] = [("double", "x"), ("double", "y"), ("double", "z")];
/// Ends of an edge.
pub(in crate::write) const ENDS: [(&str, &str); 2] = [("int", "vertex1"), ("int", "vertex2")];

/// An element: its name, the number of its rows, and type and name of each property.
pub(in crate::write) struct Element<'a> {
    pub name: &'static str,
    pub count: usize,
    pub properties: Vec<(&'a str, &'a str)>,
}

/// Vertices with further properties after x, y and z.
pub(in crate::write) fn vertices<'a>(count: usize, more: &[(&'a str, &'a str)]) -> Element<'a> {
    Element { name: "vertex", count, properties: [&XYZ, more].concat() }
}

/// Edges with further properties after their ends.
pub(in crate::write) fn edges<'a>(count: usize, more: &[(&'a str, &'a str)]) -> Element<'a> {
    Element { name: "edge", count, properties: [&ENDS, more].concat() }
}

/// Writes the header. The rows of the elements follow in their order.
pub(in crate::write) fn header(
    out: &mut dyn Write,
    comments: &[&str],
    elements: &[Element],
) -> io::Result<()> {
    writeln!(out, "ply\nformat binary_little_endian 1.0")?;
    for comment in comments {
        writeln!(out, "comment {comment}")?;
    }
    for Element { name, count, properties } in elements {
        writeln!(out, "element {name} {count}")?;
        for (kind, property) in properties {
            writeln!(out, "property {kind} {property}")?;
        }
    }
    writeln!(out, "end_header")
}

/// Writes a vertex; `more` holds the bytes of its further properties.
pub(in crate::write) fn vertex(out: &mut dyn Write, position: [f64; 3], more: &[u8]) -> io::Result<()> {
    for coordinate in position {
        out.write_all(&coordinate.to_le_bytes())?;
    }
    out.write_all(more)
}

/// Writes an edge; `more` holds the bytes of its further properties.
///
/// # Errors
/// Vertices beyond 2^31.
pub(in crate::write) fn edge(out: &mut dyn Write, ends: [usize; 2], more: &[u8]) -> io::Result<()> {
    for end in ends {
        out.write_all(&index(end)?.to_le_bytes())?;
    }
    out.write_all(more)
}

/// An index as PLY holds it.
///
/// # Errors
/// One beyond 2^31.
pub(in crate::write) fn index(value: usize) -> io::Result<i32> {
    let large = |_| io::Error::other(format!("vertex {value} is beyond the 32-bit indices of PLY edges"));
    i32::try_from(value).map_err(large)
}
