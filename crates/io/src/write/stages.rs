//! The stages of the method `segments`: a file for each graph of Demarsin et al. 2007, figures 1 to 3, and their counts and
//! times as in its tables 1 and 2.

use super::encode::json::{Number, Text, lines};
use super::encode::ply;
use super::points::{PointTable, write_points_to};
use crate::error::Error;
use crate::format::PointFormat;
use crate::output::Output;
use lineament::{Attribute, Cloud, ClusterStages, Column, Extraction, LineGraph};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes into `folder`, which must be there: `segmentation.ply`, the points with the cluster of each and whether that is a large
/// one; for each graph from `G_all` to `G_smooth` a PLY file of that name with vertices and edges, those of large clusters left
/// out; `border.ply`, the borders that creases may end on; `stages.json`, seconds, and counts of what each PLY holds beside those of
/// the whole graph. Returns the names written.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_stages(
    folder: &Path,
    inputs: &[PathBuf],
    cloud: &Cloud,
    found: &Extraction,
) -> Result<Vec<PathBuf>, Error> {
    let none = ClusterStages::default();
    let clusters = found.clusters.as_ref().unwrap_or(&none);
    let mut written = Vec::new();
    let mut file = |name: &str, write: &dyn Fn(&mut dyn Write) -> io::Result<()>| {
        let path = folder.join(name);
        Output::whole(&path, inputs, |out| write(out))?;
        written.push(path);
        Ok::<(), Error>(())
    };
    file("segmentation.ply", &|out| segmentation(out, cloud, found, clusters))?;
    for stage in &clusters.graphs {
        file(&format!("{}.ply", stage.name), &|out| graph(out, found, &stage.lines))?;
    }
    file("border.ply", &|out| graph(out, found, &found.pattern.border))?;
    file("stages.json", &|out| table(out, found, clusters))?;
    Ok(written)
}

fn segmentation(
    out: &mut dyn Write,
    cloud: &Cloud,
    found: &Extraction,
    clusters: &ClusterStages,
) -> io::Result<()> {
    let segments = &clusters.segmented.segments;
    let label = |&c: &u32| segments.label.get(c as usize).copied();
    let cluster = found.canonical.iter().map(|c| label(c).map_or(-1, |l| l as i32)).collect();
    let large =
        found.canonical.iter().map(|c| u8::from(label(c).is_some_and(|l| segments.large[l as usize])));
    let attributes = vec![
        Attribute { name: "cluster".into(), values: Column::I32(cluster) },
        Attribute { name: "large".into(), values: Column::U8(large.collect()) },
    ];
    let cloud = Cloud { positions: cloud.positions.clone(), attributes };
    let classes: Vec<u8> = found.classes().into_iter().map(|class| class as u8).collect();
    let table = PointTable { cloud: &cloud, classes: &classes, scores: &[], las: None };
    write_points_to(out, PointFormat::Ply, &table)
}

/// The vertices that have edges, with the input row of the point that each stands for, and the edges.
fn graph(out: &mut dyn Write, found: &Extraction, lines: &LineGraph) -> io::Result<()> {
    let members: Vec<usize> = (0..lines.edges.len()).filter(|&v| !lines.edges[v].is_empty()).collect();
    let mut number = vec![0usize; lines.edges.len()];
    members.iter().enumerate().for_each(|(n, &v)| number[v] = n);
    let elements = [ply::vertices(members.len(), &[("int", "point")]), ply::edges(lines.edge_count(), &[])];
    ply::header(out, &[], &elements)?;
    for &v in &members {
        let point = found.source[lines.points[v] as usize].to_le_bytes();
        ply::vertex(out, found.frame.to_world(lines.positions[v]), &point)?;
    }
    for &v in &members {
        for &w in lines.edges[v].iter().filter(|&&w| w as usize > v) {
            ply::edge(out, [number[v], number[w as usize]], &[])?;
        }
    }
    Ok(())
}

fn table(out: &mut dyn Write, found: &Extraction, clusters: &ClusterStages) -> io::Result<()> {
    let segments = &clusters.segmented.segments;
    writeln!(out, "{{\n\"points\": {},", found.report.points)?;
    writeln!(out, "\"small_clusters\": {},", segments.small_count())?;
    writeln!(out, "\"mean_small_cluster\": {},", Number(segments.mean_small()))?;
    writeln!(out, "\"large_clusters\": {},", segments.large_count())?;
    write!(out, "\"steps\": [")?;
    lines(out, &clusters.segmented.seconds, |out, _, (name, seconds)| {
        write!(out, "{{\"name\": {}, \"seconds\": {}}}", Text(name), Number(*seconds))
    })?;
    write!(out, "],\n\"graphs\": [")?;
    lines(out, &clusters.graphs, |out, _, g| {
        let ends = degrees(&g.lines, |degree| degree == 1);
        write!(out, "{{\"name\": {}, {}, ", Text(g.name), held(&g.lines))?;
        write!(out, "\"all_vertices\": {}, \"all_edges\": {}, ", g.vertices, g.edges)?;
        write!(out, "\"open_ends\": {ends}, \"seconds\": {}}}", Number(g.seconds))
    })?;
    writeln!(out, "],\n\"border\": {{{}}}\n}}", held(&found.pattern.border))
}

/// What the PLY of a graph holds, as members of JSON.
fn held(lines: &LineGraph) -> String {
    format!("\"vertices\": {}, \"edges\": {}", degrees(lines, |degree| degree > 0), lines.edge_count())
}

/// The number of vertices of some degree.
fn degrees(lines: &LineGraph, is: fn(usize) -> bool) -> usize {
    lines.edges.iter().filter(|e| is(e.len())).count()
}
