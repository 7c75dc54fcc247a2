//! The crease and border patterns (Gumhold 2001, sections 3.2 and 3.3), repaired in the robust form.

use super::blends;
use super::chains::{Known, chains, lay, rounded};
use super::flat;
use super::handles;
use super::passing;
use super::repair::{bridge, dock, repair};
use super::spanning::{Candidate, CycleRule, candidate_edges, minimum_spanning_graph, prune};
use super::triples;
use crate::measure::{Measure, Penalties};
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::{Params, PenaltyForm, RepairParams};
use crate::pattern::{LineGraph, Pattern};
use crate::surface::Scales;

/// Greatest graph distance between border candidates that an edge may join, in the robust form. Only the outermost row of
/// points lies on a border, and successive points of this row are often not direct neighbours in the graph.
const ROBUST_BORDER_HOPS: usize = 2;

/// Least length of a rounded edge, spacings, and the least evidence that it is one.
const BLEND: (f64, f64) = (4.0, 4.0);

/// Links the candidates of both kinds into a pattern.
pub(crate) fn link(
    graph: &Neighbors,
    measure: &Measure,
    scales: Scales,
    params: &Params,
    rule: CycleRule,
    known: &Known,
) -> Pattern {
    let Params { spanning, repair, .. } = params;
    let rules = LineRules { tau: spanning.tau, cycle: rule, repair };
    let lines = |wanted: bool, kind: StripKind, penalties: &Penalties| match wanted {
        true => lines_of(graph, &measure.density, penalties, scales, rules, kind),
        false => LineGraph::default(),
    };
    let mut pattern = Pattern {
        crease: lines(spanning.creases, StripKind::Crease, &measure.crease),
        border: lines(spanning.borders, StripKind::Border, &measure.border),
        rounded: LineGraph::default(),
    };
    match rule.form {
        PenaltyForm::Paper => {}
        PenaltyForm::Robust => {
            if spanning.creases && !measure.edgelets.is_empty() {
                let (length, evidence) = (params.edgelets.chain_spacings, repair.evidence);
                let mut strips = std::mem::take(&mut pattern.crease);
                flat::remove(&mut strips, &measure.flat, &measure.edgelets, scales);
                pattern.crease = chains(strips, &measure.edgelets, length, evidence, scales);
                bridge(&mut pattern.crease, StripKind::Crease, scales, repair);
                handles::remove(&mut pattern.crease, scales);
                triples::gather(&mut pattern.crease, scales);
                passing::unmark(&mut pattern.crease, scales);
            }
            if spanning.creases && !measure.blends.is_empty() {
                let (lines, blends) = rounded(&measure.blends, BLEND.0, BLEND.1, known.points, scales);
                blends::remove(&mut pattern.crease, &blends);
                pattern.rounded = lines;
            }
            if spanning.creases && !known.folds.is_empty() {
                pattern.crease = lay(std::mem::take(&mut pattern.crease), known, scales);
            }
            dock(&mut pattern, scales);
        }
    }
    pattern
}

/// The parameters by which lines of one kind are made.
#[derive(Clone, Copy)]
pub(super) struct LineRules<'a> {
    /// Greatest penalty share of an edge (the paper's `tau`).
    pub(super) tau: f64,
    pub(super) cycle: CycleRule<'a>,
    pub(super) repair: &'a RepairParams,
}

/// The lines of one kind. `density` is that of every point.
pub(super) fn lines_of(
    graph: &Neighbors,
    density: &[f32],
    penalties: &Penalties,
    scales: Scales,
    rules: LineRules,
    kind: StripKind,
) -> LineGraph {
    let LineRules { cycle, repair: params, .. } = rules;
    let rule = cycle.of(kind);
    let mut lines = pruned(graph, density, penalties, scales, rules, kind, |_| ());
    match rule.form {
        PenaltyForm::Paper => {}
        PenaltyForm::Robust => repair(&mut lines, kind, scales, rule, params),
    }
    lines
}

/// What a viewer sees on the way to the pruned graph.
pub(super) enum Step<'a> {
    /// The queue of edges, the lightest first.
    Edges(&'a [Candidate]),
    /// The minimum spanning graph.
    Spanning(&'a LineGraph),
}

/// The pruned minimum spanning graph of one kind of line; `see` is shown each step before it.
pub(super) fn pruned(
    graph: &Neighbors,
    density: &[f32],
    penalties: &Penalties,
    scales: Scales,
    LineRules { tau, cycle, .. }: LineRules,
    kind: StripKind,
    mut see: impl FnMut(Step),
) -> LineGraph {
    let rule = cycle.of(kind);
    let hops = match (kind, rule.form) {
        (StripKind::Border, PenaltyForm::Robust) => ROBUST_BORDER_HOPS,
        _ => 1,
    };
    let edges = candidate_edges(graph, density, penalties, scales, tau, hops);
    see(Step::Edges(&edges));
    let mut lines = minimum_spanning_graph(penalties, &edges, scales, rule);
    see(Step::Spanning(&lines));
    prune(&mut lines, rule);
    lines
}
