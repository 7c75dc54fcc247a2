//! What a run of contours has in common: the same outline, one that moves evenly, circles about one line.
//!
//! Any smooth object looks like an extrusion or a taper over a few close slices. What tells is how the run ends and how
//! its wall stands: a wall that is one begins and ends at once, and its slices have the slope that their outlines show.
//! A slice may stray where it cuts a face, and does so beside a fold; a few that stray little break no run.

mod extrusion;
pub(crate) mod outlines;
mod revolution;
mod taper;

use outlines::{Outlines, Reached};

/// The runs of the track, ascending. Extrusions come first, as they are the strictest, then tapers between them, then
/// revolutions in what is left.
pub(crate) fn runs(outlines: &Outlines) -> Vec<Reached> {
    let mut found = outlines.extrusions();
    for kind in [Outlines::tapers, Outlines::revolutions] {
        let more: Vec<Reached> =
            gaps(outlines, &found).into_iter().flat_map(|(first, end)| kind(outlines, first, end)).collect();
        found.extend(more);
        found.sort_by_key(|r| r.first);
    }
    found
}

/// The stretches (first, end) that runs leave.
fn gaps(outlines: &Outlines, runs: &[Reached]) -> Vec<(usize, usize)> {
    let firsts = std::iter::once(0).chain(runs.iter().map(|r| r.last + 1));
    let ends = runs.iter().map(|r| r.first).chain([outlines.all.len()]);
    firsts.zip(ends).filter(|(first, end)| first < end).collect()
}
