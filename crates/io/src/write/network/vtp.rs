//! A network as VTK polygonal data (`.vtp`), ascii, with double coordinates: a polyline for each strip, a vertex for each node.

use crate::write::encode::polyline::Polylines;
use lineament::{Network, NodeKind, StripKind};
use std::fmt::Display;
use std::io::{self, Write};

/// Writes the strips as lines and the nodes as vertices. Cell data, vertices first: `kind` (0 crease, 1 border; 2
/// junction, 3 corner, 4 end, 5 apex), `id`, `closed`, `confidence` and `deviation`, which nodes have as NaN.
pub(super) fn write(out: &mut dyn Write, network: &Network) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    let lines: Vec<(usize, &Vec<usize>)> =
        paths.iter().enumerate().filter(|(_, path)| path.len() > 1).collect();
    let nodes = network.nodes.len();
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(
        out,
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
    )?;
    writeln!(out, "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{nodes}\" ", vertices.len())?;
    writeln!(out, "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">", lines.len())?;
    writeln!(out, "<Points>")?;
    array(
        out,
        "Float64",
        "Points\" NumberOfComponents=\"3",
        vertices.iter().flatten().map(|c| format!("{c:?}")),
    )?;
    writeln!(out, "</Points>\n<Verts>")?;
    array(out, "Int64", "connectivity", 0..nodes)?;
    array(out, "Int64", "offsets", 1..=nodes)?;
    writeln!(out, "</Verts>\n<Lines>")?;
    array(out, "Int64", "connectivity", lines.iter().flat_map(|(_, path)| path.iter()))?;
    let mut end = 0;
    let ends = lines.iter().map(|(_, path)| {
        end += path.len();
        end
    });
    array(out, "Int64", "offsets", ends)?;
    writeln!(out, "</Lines>\n<CellData>")?;
    cells(out, network, &lines)?;
    writeln!(out, "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>")
}

fn cells(out: &mut dyn Write, network: &Network, lines: &[(usize, &Vec<usize>)]) -> io::Result<()> {
    let strips = || lines.iter().map(|(id, _)| &network.strips[*id]);
    let of_node = |kind| match kind {
        NodeKind::Junction => 2,
        NodeKind::Corner => 3,
        NodeKind::End => 4,
        NodeKind::Apex => 5,
    };
    let of_strip = |kind| match kind {
        StripKind::Crease => 0,
        StripKind::Border => 1,
        StripKind::Rounded => 6,
    };
    let nodes = &network.nodes;
    array(
        out,
        "UInt8",
        "kind",
        nodes.iter().map(|n| of_node(n.kind)).chain(strips().map(|s| of_strip(s.kind))),
    )?;
    array(out, "Int64", "id", (0..nodes.len()).chain(lines.iter().map(|(id, _)| *id)))?;
    array(out, "UInt8", "closed", nodes.iter().map(|_| 0).chain(strips().map(|s| u8::from(s.closed))))?;
    let none = || nodes.iter().map(|_| "nan".to_string());
    array(out, "Float64", "confidence", none().chain(strips().map(|s| format!("{:?}", s.confidence))))?;
    array(out, "Float64", "deviation", none().chain(strips().map(|s| format!("{:?}", s.deviation))))
}

fn array<T: Display>(
    out: &mut dyn Write,
    kind: &str,
    name: &str,
    values: impl Iterator<Item = T>,
) -> io::Result<()> {
    writeln!(out, "<DataArray type=\"{kind}\" Name=\"{name}\" format=\"ascii\">")?;
    for (index, value) in values.enumerate() {
        write!(
            out,
            "{}{value}",
            if index == 0 {
                ""
            } else if index % 12 == 0 {
                "\n"
            } else {
                " "
            }
        )?;
    }
    writeln!(out, "\n</DataArray>")
}
