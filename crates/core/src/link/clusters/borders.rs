//! The borders that lines end on, of either form.

use super::open::remove_short;
use crate::link::lines::{LineRules, lines_of};
use crate::link::spanning::CycleRule;
use crate::measure::Measure;
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::RepairParams;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// Pieces of border that stay open are dropped if they are shorter than this, spacings.
const OPEN_BORDER: f64 = 20.0;
/// Bound of the penalty share of an edge; the paper of the default method takes 1.
const TAU: f64 = 1.0;

/// The borders of the default method. A short piece that stays open is no end of a surface; of a long one the rest was not
/// found.
pub(crate) fn borders(
    graph: &Neighbors,
    measure: &Measure,
    resolution: Resolution,
    rule: CycleRule,
    repair: &RepairParams,
) -> LineGraph {
    let kind = StripKind::Border;
    let rules = LineRules { tau: TAU, cycle: rule, repair };
    let mut border = lines_of(graph, &measure.density, &measure.border, resolution.into(), rules, kind);
    remove_short(&mut border, OPEN_BORDER * resolution.unit());
    border.nodes.retain(|&v| !border.edges[v as usize].is_empty());
    border
}
