//! The apex of a taper.

use super::end::{By, End};
use super::ground::Spot;
use super::search::Search;
use super::size::Size;

/// The apex that a taper runs out to, if points show its wall up to there.
pub(super) fn apex(search: &Search, spots: &[Spot], size: &Size, h: f64) -> Option<End> {
    let apex = size.apex();
    let ahead = search.ahead(apex);
    let last = spots.iter().map(|s| search.ahead(s.height)).fold(f64::NEG_INFINITY, f64::max);
    // Rows of points come a spacing apart along the wall; the outline there is a few points wide.
    let reached = ahead >= 0.0 && search.ahead(search.outer) >= ahead - h && last >= ahead - 2.0 * h;
    reached.then_some(End { height: apex, error: 0.1 * h, by: By::Apex })
}
