//! The steps from penalties to lines for viewers: the weighed edges, the minimum spanning graph and the pruned graph (Gumhold 2001,
//! figure 5), made again by the functions that the linker calls.

use super::lines::{LineRules, Step, pruned};
use super::spanning::{Candidate, CycleRule, length_term};
use crate::math::vec3::distance;
use crate::measure::{Measure, Penalties};
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::Params;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// An edge that may enter a graph of lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeighedEdge {
    /// Its vertices in the spanning graph, the lesser first.
    pub ends: [u32; 2],
    /// Penalty share plus length term (`w_c` or `w_b`), by which the edges are queued.
    pub weight: f64,
    /// The penalty share alone, below `spanning.tau`.
    pub penalty: f64,
}

/// The steps by which lines of one kind were made, canonical indices, local frame.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSteps {
    /// The kind of line.
    pub kind: StripKind,
    /// The queue of edges, the lightest first.
    pub edges: Vec<WeighedEdge>,
    /// The minimum spanning graph.
    pub spanning: LineGraph,
    /// The same without its short branches.
    pub pruned: LineGraph,
}

/// The steps of each kind of line that is asked for.
pub(crate) fn steps(
    graph: &Neighbors,
    measure: &Measure,
    scales: Scales,
    params: &Params,
    rule: CycleRule,
) -> Vec<LineSteps> {
    let Params { spanning, repair, .. } = params;
    let rules = LineRules { tau: spanning.tau, cycle: rule, repair };
    let kinds = [
        (spanning.creases, StripKind::Crease, &measure.crease),
        (spanning.borders, StripKind::Border, &measure.border),
    ];
    let wanted = kinds.into_iter().filter(|(wanted, ..)| *wanted);
    wanted
        .map(|(_, kind, penalties)| {
            let (mut edges, mut spanning) = (Vec::new(), LineGraph::default());
            let density = &measure.density;
            let pruned = pruned(graph, density, penalties, scales, rules, kind, |step| match step {
                Step::Edges(queue) => edges = weighed(queue, penalties, density),
                Step::Spanning(lines) => spanning = lines.clone(),
            });
            LineSteps { kind, edges, spanning, pruned }
        })
        .collect()
}

fn weighed(queue: &[Candidate], penalties: &Penalties, density: &[f32]) -> Vec<WeighedEdge> {
    let edge = |&Candidate { weight, a, b }: &Candidate| {
        let ends = [a, b].map(|v| v as usize);
        let mu = ends.map(|v| f64::from(density[penalties.points[v] as usize]));
        let length = distance(penalties.foot[ends[0]], penalties.foot[ends[1]]);
        WeighedEdge { ends: [a, b], weight, penalty: (weight - length_term(length, mu)).max(0.0) }
    };
    queue.iter().map(edge).collect()
}
