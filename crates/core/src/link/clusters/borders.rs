//! The borders on which creases end, in both forms.

use super::open::remove_short;
use crate::link::lines::{LineRules, lines_of};
use crate::link::spanning::CycleRule;
use crate::measure::Measure;
use crate::neighbors::Neighbors;
use crate::network::StripKind;
use crate::params::RepairParams;
use crate::pattern::LineGraph;
use crate::resolution::Resolution;

/// Open pieces of border shorter than this, in spacings, are dropped.
const OPEN_BORDER: f64 = 20.0;
/// Greatest penalty share of an edge: Gumhold's 1 (2001, section 3.2).
const TAU: f64 = 1.0;

/// The borders of the default method. A short open piece does not bound a surface and is dropped; a long one is part of a
/// loop whose rest was not found.
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
