//! Repair of a spanning graph by what its lines show as wholes: ours, in the robust forms.
//!
//! Strips that are round go (`judge`), and so do links between two rims (`rungs`); loose ends are led on (`bridge`, and over
//! weak ground `reroute`); a strip that turns has a node (`corner`); creases end on borders (`dock`).

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

/// Once ends have been led on, branches this many times as long as before are spurs: a line has found its other end.
const SPURS: f64 = 1.6;

/// Mends the lines of one kind.
pub(super) fn repair(
    lines: &mut LineGraph,
    kind: StripKind,
    scales: Scales,
    rule: CycleRule,
    params: &RepairParams,
) {
    remove_rungs(lines, scales, params);
    judge(lines, scales, rule, params);
    bridge(lines, kind, scales, params);
    prune(lines, CycleRule { rho: SPURS * rule.rho, ..rule });
    remove_rungs(lines, scales, params);
    corners(lines, kind, scales, params);
}
