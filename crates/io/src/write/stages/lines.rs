//! The stages of the methods that link by a minimum spanning graph: ellipsoids, penalties, weighed edges, graphs, splines, and the
//! recovery of creases and corners (Gumhold 2001, figures 2, 5, 6, 8, 10 and 11); and the projected distances (Tran 2013).

use super::files::Files;
use super::graphs::{degrees, edges, ends, graph, spline_counts, splines};
use super::measures::{ellipsoids, penalties};
use super::projection::{cuts, projection};
use super::recovery::{groups, recovered};
use super::table::Table;
use crate::error::Error;
use crate::write::encode::json::Text;
use lineament::params::ParamValue;
use lineament::{Cloud, Extraction, LineGraph, LineSteps, Recovery, Stages};

pub(super) fn write(
    files: &mut Files,
    cloud: &Cloud,
    found: &Extraction,
    stages: &Stages,
) -> Result<(), Error> {
    let mut table = Table::new(files);
    let points = cloud.len();
    if !stages.ellipsoids.is_empty() {
        let held = [("vertices", points), ("ellipsoids", stages.ellipsoids.len())];
        table.add("ellipsoids", &held, |out| ellipsoids(out, cloud, found, &stages.ellipsoids))?;
    }
    if let Some(steps) = &stages.projection {
        let held = [("vertices", points), ("projected", steps.distances.len())];
        table.add("projection", &held, |out| projection(out, cloud, found, steps))?;
    }
    let [crease, border] = [&found.measure.crease, &found.measure.border].map(|p| p.len());
    let held = [("vertices", points), ("crease_candidates", crease), ("border_candidates", border)];
    table.add("penalties", &held, |out| penalties(out, cloud, found))?;
    for steps in &stages.lines {
        linked(&mut table, found, steps, stages.repaired)?;
    }
    let network = &stages.splines;
    let [vertices, segments] = spline_counts(network);
    let held = [
        ("vertices", vertices),
        ("edges", segments),
        ("nodes", network.nodes.len()),
        ("strips", network.strips.len()),
    ];
    table.add("splines", &held, |out| splines(out, found, network))?;
    if let Some(recovery) = &stages.recovery {
        recover(&mut table, cloud, found, recovery)?;
    }
    let (method, points) = (stages.method.show(), found.report.points);
    table.finish(|out| {
        writeln!(out, "\"method\": {},\n\"points\": {points},", Text(&method))?;
        stages.projection.iter().try_for_each(|steps| cuts(out, steps))
    })
}

/// The graphs of one kind of line.
fn linked(table: &mut Table, found: &Extraction, steps: &LineSteps, repaired: bool) -> Result<(), Error> {
    let kind = steps.kind.name();
    let held = [("vertices", ends(steps)), ("edges", steps.edges.len())];
    table.add(&format!("{kind}_edges"), &held, |out| edges(out, found, steps))?;
    let repaired = repaired.then(|| ("repaired", found.pattern.of(steps.kind)));
    let graphs = [("spanning", &steps.spanning), ("pruned", &steps.pruned)];
    for (name, lines) in graphs.into_iter().chain(repaired) {
        table.add(&format!("{kind}_{name}"), &held_by(lines), |out| graph(out, found, lines))?;
    }
    Ok(())
}

fn held_by(lines: &LineGraph) -> [(&'static str, usize); 4] {
    [
        ("vertices", degrees(lines, |degree| degree > 0)),
        ("edges", lines.edge_count()),
        ("open_ends", degrees(lines, |degree| degree == 1)),
        ("junctions", degrees(lines, |degree| degree > 2)),
    ]
}

/// The groups and the places recovered.
fn recover(table: &mut Table, cloud: &Cloud, found: &Extraction, recovery: &Recovery) -> Result<(), Error> {
    let Recovery { beside, around, places } = recovery;
    for (name, of, list) in [("strip_groups", "strip", beside), ("node_groups", "node", around)] {
        let mut numbers: Vec<u32> = list.iter().map(|g| g.of).collect();
        numbers.dedup();
        let whose = if of == "strip" { "strips" } else { "nodes" };
        let held = [("vertices", list.len()), (whose, numbers.len())];
        table.add(name, &held, |out| groups(out, cloud, found, of, list))?;
    }
    let corners = places.iter().filter(|p| p.node.is_some()).count();
    let held = [("vertices", places.len()), ("crease_points", places.len() - corners), ("corners", corners)];
    table.add("recovered", &held, |out| recovered(out, found, places))
}
