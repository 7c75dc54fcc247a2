//! Repair of a spanning graph by the evidence of its lines as wholes: ours, in the robust forms.
//!
//! Links between two rims (`rungs`) and strips along rounds (`judge`) are removed; loose ends are led on (`bridge`, and over
//! weak ground `reroute`); a strip gets a node where it turns sharply (`corner`); creases end on borders (`dock`).

mod bridge;
mod corner;
mod dock;
mod judge;
mod reroute;
mod rungs;

pub(super) use bridge::bridge;
pub(super) use corner::corners;
pub(super) use dock::dock;
pub(super) use judge::judge;
pub(super) use reroute::reroute;
pub(super) use rungs::remove_rungs;

use super::spanning::{CycleRule, prune};
use crate::network::StripKind;
use crate::params::RepairParams;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Branches up to this many times the usual limit are pruned as spurs once loose ends have been led on: by then a real line has
/// found its other end.
const SPURS: f64 = 1.6;

/// Repairs the lines of one kind.
pub(super) fn repair(
    lines: &mut LineGraph,
    kind: StripKind,
    scales: Scales,
    rule: CycleRule,
    params: &RepairParams,
) {
    remove_rungs(lines, scales, params);
    judge(lines, scales, params);
    bridge(lines, kind, scales, params);
    prune(lines, CycleRule { branch: SPURS * rule.branch, ..rule });
    remove_rungs(lines, scales, params);
    corners(lines, kind, scales, params);
}
