//! The stages of the method `segments`: a file for each graph of Demarsin et al. 2007, figures 1 to 3, and their counts and
//! times as in its tables 1 and 2.

use super::files::Files;
use super::graphs::{degrees, graph};
use crate::error::Error;
use crate::format::PointFormat;
use crate::write::encode::json::{Number, Text, lines};
use crate::write::points::{PointTable, write_points_to};
use lineament::{Attribute, Cloud, ClusterStages, Column, Extraction, LineGraph};
use std::io::{self, Write};

pub(super) fn write(files: &mut Files, cloud: &Cloud, found: &Extraction) -> Result<(), Error> {
    let none = ClusterStages::default();
    let clusters = found.clusters.as_ref().unwrap_or(&none);
    files.write("segmentation.ply", |out| segmentation(out, cloud, found, clusters))?;
    for stage in &clusters.graphs {
        files.write(&format!("{}.ply", stage.name), |out| graph(out, found, &stage.lines))?;
    }
    files.write("border.ply", |out| graph(out, found, &found.pattern.border))?;
    files.write("stages.json", |out| table(out, found, clusters))
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
