//! Runs that end at one event: where a contour parts into two, or two become one, one of the runs may show where.

use super::end::{By, End};
use super::search::Search;
use crate::curve::polygon;

/// Gives ends without evidence of their own the height that another run shows there: one that begins where it ends, or the
/// other way round, over or under it. Searches and ends come in pairs, below and above.
pub(super) fn share(searches: &[Search], ends: &mut [Option<End>]) {
    let known: Vec<(usize, End)> = ends
        .iter()
        .enumerate()
        .filter_map(|(k, e)| Some((k, (*e)?)))
        .filter(|(_, e)| matches!(e.by, By::Face | By::Fold | By::Rim))
        .collect();
    for (k, (search, end)) in searches.iter().zip(ends).enumerate().filter(|(_, (_, e))| e.is_none()) {
        let near = known.iter().filter(|(j, other)| {
            j % 2 != k % 2 && search.holds(other.height) && overlap(search, &searches[*j])
        });
        let ahead = |e: &End| search.ahead(e.height);
        *end = near.map(|n| n.1).min_by(|a, b| ahead(a).total_cmp(&ahead(b)));
    }
}

/// Whether the outlines are of one kind, and the middle of one lies within the other.
fn overlap(a: &Search, b: &Search) -> bool {
    let within = |a: &Search, b: &Search| polygon::contains(a.outline.outline.points(), b.outline.centroid);
    a.outline.hole == b.outline.hole && (within(a, b) || within(b, a))
}
