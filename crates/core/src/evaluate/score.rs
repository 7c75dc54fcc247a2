//! Scores lines by their distances from known ones, in spacings.
//!
//! Both are cut into pieces of a fifth of a spacing, and the distance of each piece's end from the other is measured. Weak lines of
//! the truth, such as stretches below its `weak_below_deg`, count neither for nor against.

use super::chamfer::Chamfer;
use super::figures::{Distances, Hits, share};
use super::lines::{LineKind, Lines};
use super::rounded::Rounded;
use super::sides::{Row, Scoring, Sides};
use super::topology::{Graph, Topology};
use super::types::Types;
use super::wireframe::Wireframe;
use crate::network::Network;
use crate::shapes::{Tree, Truth};

/// Ends of found lines nearer than this are one node, spacings.
const SAME_NODE: f64 = 0.25;
/// Ends of known lines nearer than this are one node, shares of the diagonal of their box.
const SAME_KNOWN: f64 = 1e-6;
/// Share of a curve's length that must lie near for it to be found.
const WHOLE: f64 = 0.9;
/// Length from which on a curve counts, spacings.
const SHORTEST: f64 = 3.0;

/// The score of lines: the result of [`score`] and [`against`].
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Shares within one spacing.
    pub at_1h: Hits,
    /// Shares within two spacings.
    pub at_2h: Hits,
    /// The tolerances asked for, in spacings, with the shares within them.
    pub at: Vec<(f64, Hits)>,
    /// From the found lines to the truth.
    pub to_truth: Distances,
    /// From the truth to the found lines.
    pub from_truth: Distances,
    /// Share of the known creases, and of the known borders, within one spacing; NaN where there are none.
    pub recall_by_kind: [f64; 2],
    /// Closed lines that were found, and closed ones of the truth.
    pub loops: [usize; 2],
    /// The graphs of the found lines and of the truth.
    pub topology: [Topology; 2],
    /// Curves of the truth with 90 % of their length within one spacing of the network, and all those that count: curves of at
    /// least 3 spacings.
    pub curves_found: [usize; 2],
    /// Junctions of the truth within two spacings of a line's end, and all junctions.
    pub junctions_hit: [usize; 2],
    /// Length of all found lines in spacings.
    pub length_spacings: f64,
    /// Length of all known lines in spacings.
    pub truth_spacings: f64,
    /// Types of curves; `None` where either side has none.
    pub types: Option<Types>,
    /// Edges that are rounded; `None` where the truth knows none.
    pub rounded: Option<Rounded>,
    /// Chamfer and Hausdorff distance; `None` where either side is empty.
    pub chamfer: Option<Chamfer>,
    /// Corners and edges of the graphs, one to one, within two spacings.
    pub wireframe: Wireframe,
}

/// Scores a network against the truth of a scan; `spacing` is the scan's mean spacing, above 0, in the unit of both.
pub fn against(network: &Network, truth: &Truth, spacing: f64) -> Score {
    let loops = [network.loops(), truth.loops()];
    Score { loops, ..score(&network.into(), &truth.into(), &Scoring::new(spacing)) }
}

/// Scores lines against known ones.
pub fn score(found: &Lines, known: &Lines, scoring: &Scoring) -> Score {
    let sides = Sides::new(found, known, scoring);
    let found_points = sides.found.iter().flat_map(|r| &r.points);
    let known_points = sides.known.iter().flat_map(|r| &r.points);
    let to_truth: Vec<f64> = found_points.filter_map(|&p| sides.to_truth(p)).collect();
    let from_truth: Vec<f64> = known_points.map(|&p| sides.away_from_found(p)).collect();
    let hits = |tolerance: f64| Hits::at(tolerance, &to_truth, &from_truth);
    let node = SAME_NODE * scoring.spacing;
    let graphs = [graph_of(found, node), graph_of(known, SAME_KNOWN * diagonal(known))];
    let closed = |lines: &Lines| lines.sharp().filter(|l| l.closed).count();
    let length = |rows: &[Row]| rows.iter().map(Row::length).sum::<f64>() / scoring.spacing;
    Score {
        at_1h: hits(1.0),
        at_2h: hits(2.0),
        at: scoring.tolerances.iter().map(|&tolerance| (tolerance, hits(tolerance))).collect(),
        to_truth: Distances::of(&to_truth),
        from_truth: Distances::of(&from_truth),
        recall_by_kind: [LineKind::Crease, LineKind::Border].map(|kind| recall(&sides, kind)),
        loops: [closed(found), closed(known)],
        curves_found: curves_found(&sides),
        junctions_hit: junctions_hit(found, known, &graphs[1], scoring.spacing),
        length_spacings: length(&sides.found),
        truth_spacings: length(&sides.known),
        types: Types::of(found, known, scoring.spacing),
        rounded: Rounded::of(found, known, scoring.spacing),
        chamfer: Chamfer::of(found, known),
        wireframe: Wireframe::of(&graphs[0], &graph_of(known, node), 2.0 * scoring.spacing),
        topology: graphs.each_ref().map(Graph::topology),
    }
}

fn graph_of(lines: &Lines, tolerance: f64) -> Graph {
    Graph::new(lines.sharp(), tolerance)
}

fn diagonal(lines: &Lines) -> f64 {
    lines.bounds().map_or(0.0, |[low, high]| crate::math::vec3::distance(low, high))
}

/// The share of the known lines of a kind within one spacing.
fn recall(sides: &Sides, kind: LineKind) -> f64 {
    let rows = sides.known.iter().filter(|r| r.line.kind == kind);
    let far: Vec<f64> = rows.flat_map(|r| &r.points).map(|&p| sides.away_from_found(p)).collect();
    if far.is_empty() { f64::NAN } else { share(&far, 1.0) }
}

fn curves_found(sides: &Sides) -> [usize; 2] {
    let long = sides.known.iter().filter(|r| r.length() >= SHORTEST * sides.scoring.spacing);
    let found = |row: &&Row| {
        let near: Vec<f64> = row.points.iter().map(|&p| sides.away_from_found(p)).collect();
        share(&near, 1.0) >= WHOLE
    };
    [long.clone().filter(found).count(), long.count()]
}

fn junctions_hit(found: &Lines, known: &Lines, graph: &Graph, spacing: f64) -> [usize; 2] {
    let mut ends = Vec::new();
    for line in found.sharp() {
        ends.extend(line.points.first().copied());
        ends.extend(line.points.last().copied().filter(|_| !line.closed));
    }
    let ends = Tree::new(&ends);
    let junctions = known.junctions.clone().unwrap_or_else(|| graph.junctions());
    let near = |p: &&[f64; 3]| ends.nearest(**p).is_some_and(|(_, d2)| d2.sqrt() <= 2.0 * spacing);
    [junctions.iter().filter(near).count(), junctions.len()]
}
