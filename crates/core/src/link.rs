//! Linkers: from what the points say to graphs of lines.

mod bridge;
pub mod clusters;
mod corner;
mod dock;
mod judge;
mod prune;
mod rungs;
mod spanning;
mod walk;
mod weight;

pub use bridge::bridge;
pub use corner::corners;
pub use dock::dock;
pub use judge::judge;
pub use prune::prune;
pub use rungs::remove_rungs;
pub use spanning::minimum_spanning_graph;
pub use weight::{Candidate, candidate_edges};

use crate::measure::{Measure, Penalties};
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::{Auto, PenaltyForm, SpanningParams};
use crate::pattern::{LineGraph, Pattern};
use crate::resolution::Resolution;

/// How long is long: what the length of cycles and branches is measured in, and from where on they are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Least length of a cycle; branches shorter than half of it are pruned (Gumhold's rho).
    pub rho: f64,
    /// Whether lengths count edges, as in the paper; otherwise they are spacings along the line.
    pub in_edges: bool,
    /// Graph distance of border candidates that an edge may join: 1 in the paper's form. Only the outermost row of points
    /// sees a border, and its points are often farther apart than neighbours in the graph.
    pub border_hops: usize,
    /// Least ratio of the area that a cycle encloses to its length, spacings: keeps two strands of one band from passing
    /// for a loop. Zero in the paper's form.
    pub openness: f64,
}

/// Length in spacings of the shortest loop that is told from noise when `rho` is left to the data.
const LEAST_LOOP: f64 = 10.0;

/// `rho` as given, in edges; else half the root of the number of points in the paper's form (section 3.2), and a length
/// that small holes still have in the robust form.
pub fn reach(params: &SpanningParams, form: PenaltyForm, points: usize) -> Reach {
    let (openness, border_hops) = if form == PenaltyForm::Paper { (0.0, 1) } else { (0.9, 2) };
    match (params.rho, form) {
        (Auto::Given(rho), _) => Reach { rho: rho as f64, in_edges: true, border_hops, openness },
        (Auto::Auto, PenaltyForm::Paper) => {
            Reach { rho: 0.5 * (points as f64).sqrt(), in_edges: true, border_hops, openness }
        }
        (Auto::Auto, PenaltyForm::Robust) => {
            Reach { rho: LEAST_LOOP, in_edges: false, border_hops, openness }
        }
    }
}

/// Once ends have been led on, longer branches are spurs than before: what was a line has found its other end.
const SPURS: f64 = 1.6;

/// Links the candidates of both kinds into a pattern (Gumhold 2001, sections 3.2 and 3.3).
pub fn link(
    graph: &Neighbors,
    measure: &Measure,
    resolution: Resolution,
    params: &SpanningParams,
    reach: Reach,
) -> Pattern {
    let lines = |wanted: bool, kind: StripKind, penalties: &Penalties| match wanted {
        true => lines_of(graph, measure, penalties, resolution, params.tau, reach, kind),
        false => LineGraph::default(),
    };
    let mut pattern = Pattern {
        crease: lines(params.creases, StripKind::Crease, &measure.crease),
        border: lines(params.borders, StripKind::Border, &measure.border),
    };
    if reach.openness > 0.0 {
        dock(&mut pattern, resolution);
    }
    pattern
}

/// The lines of one kind.
pub(crate) fn lines_of(
    graph: &Neighbors,
    measure: &Measure,
    penalties: &Penalties,
    resolution: Resolution,
    tau: f64,
    reach: Reach,
    kind: StripKind,
) -> LineGraph {
    let hops = if kind == StripKind::Border { reach.border_hops } else { 1 };
    let edges = candidate_edges(graph, measure, penalties, resolution, tau, hops);
    let mut lines = minimum_spanning_graph(penalties, &edges, resolution, reach);
    prune(&mut lines, resolution, reach);
    if reach.openness > 0.0 {
        remove_rungs(&mut lines, resolution);
        judge(&mut lines, resolution, reach);
        bridge(&mut lines, kind, resolution);
        prune(&mut lines, resolution, Reach { rho: SPURS * reach.rho, ..reach });
        remove_rungs(&mut lines, resolution);
        corners(&mut lines, kind, resolution);
    }
    lines
}
