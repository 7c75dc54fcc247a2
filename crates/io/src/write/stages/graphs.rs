//! Graphs of lines: their vertices with the point that each stands for, and the edges between them.

use crate::write::encode::ply;
use crate::write::encode::polyline::Polylines;
use lineament::{Extraction, LineGraph, LineSteps, Network, StripKind};
use std::io::{self, Write};

/// The vertices that have edges, with the input row of the point that each stands for, and the edges.
pub(super) fn graph(out: &mut dyn Write, found: &Extraction, lines: &LineGraph) -> io::Result<()> {
    let members: Vec<usize> = (0..lines.edges.len()).filter(|&v| !lines.edges[v].is_empty()).collect();
    let mut number = vec![0usize; lines.edges.len()];
    members.iter().enumerate().for_each(|(n, &v)| number[v] = n);
    let elements = [ply::vertices(members.len(), &[("int", "point")]), ply::edges(lines.edge_count(), &[])];
    ply::header(out, &[], &elements)?;
    for &v in &members {
        vertex(out, found, lines, v)?;
    }
    for &v in &members {
        for &w in lines.edges[v].iter().filter(|&&w| w as usize > v) {
            ply::edge(out, [number[v], number[w as usize]], &[])?;
        }
    }
    Ok(())
}

/// The weighed edges: all candidates that have one, and for each edge its weight and the penalty in it.
pub(super) fn edges(out: &mut dyn Write, found: &Extraction, steps: &LineSteps) -> io::Result<()> {
    let lines = &steps.spanning;
    let number = numbers(steps);
    let members = number.iter().flatten().count();
    let elements = [
        ply::vertices(members, &[("int", "point")]),
        ply::edges(steps.edges.len(), &[("float", "weight"), ("float", "penalty")]),
    ];
    ply::header(out, &[], &elements)?;
    for (v, _) in number.iter().enumerate().filter(|(_, n)| n.is_some()) {
        vertex(out, found, lines, v)?;
    }
    for edge in &steps.edges {
        let [a, b] = edge.ends.map(|v| number[v as usize].unwrap_or_default());
        let more = [edge.weight, edge.penalty].map(|x| (x as f32).to_le_bytes()).concat();
        ply::edge(out, [a, b], &more)?;
    }
    Ok(())
}

/// The row of each candidate among those that have an edge.
fn numbers(steps: &LineSteps) -> Vec<Option<usize>> {
    let mut number = vec![None; steps.spanning.points.len()];
    steps.edges.iter().flat_map(|e| e.ends).for_each(|v| number[v as usize] = Some(0));
    number.iter_mut().flatten().enumerate().for_each(|(row, n)| *n = row);
    number
}

/// The number of candidates that have an edge.
pub(super) fn ends(steps: &LineSteps) -> usize {
    numbers(steps).iter().flatten().count()
}

fn vertex(out: &mut dyn Write, found: &Extraction, lines: &LineGraph, v: usize) -> io::Result<()> {
    let point = ply::index(found.source[lines.points[v] as usize] as usize)?.to_le_bytes();
    ply::vertex(out, found.frame.to_world(lines.positions[v]), &point)
}

/// A network that is still in the local frame, as polylines: nodes, then the points of the strips; edges with the strip and its kind.
pub(super) fn splines(out: &mut dyn Write, found: &Extraction, network: &Network) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    let elements = [
        ply::vertices(vertices.len(), &[]),
        ply::edges(segments(&paths), &[("uchar", "kind"), ("int", "strip")]),
    ];
    ply::header(out, &["edge kind: 0 crease, 1 border"], &elements)?;
    for &position in &vertices {
        ply::vertex(out, found.frame.to_world(position), &[])?;
    }
    for (id, (strip, path)) in network.strips.iter().zip(&paths).enumerate() {
        let kind = u8::from(strip.kind == StripKind::Border);
        let more = [&[kind], &ply::index(id)?.to_le_bytes()[..]].concat();
        for pair in path.windows(2) {
            ply::edge(out, [pair[0], pair[1]], &more)?;
        }
    }
    Ok(())
}

/// The numbers of vertices and edges that [`splines`] writes.
pub(super) fn spline_counts(network: &Network) -> [usize; 2] {
    let Polylines { vertices, paths } = Polylines::of(network);
    [vertices.len(), segments(&paths)]
}

fn segments(paths: &[Vec<usize>]) -> usize {
    paths.iter().map(|path| path.len().saturating_sub(1)).sum()
}

/// The number of vertices of some degree.
pub(super) fn degrees(lines: &LineGraph, is: fn(usize) -> bool) -> usize {
    lines.edges.iter().filter(|e| is(e.len())).count()
}
