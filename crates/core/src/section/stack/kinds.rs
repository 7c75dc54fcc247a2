//! The kinds of runs: contours of the same outline, of one that moves evenly, circles about one line.
//!
//! Any smooth object looks like an extrusion or a taper over a few close slices. The difference is in how the run ends
//! and how its wall stands: a true wall begins and ends at once, and its slices have the slope that their outlines show.
//! A slice may stray where it cuts a face, and does beside a fold; a few that stray a little do not break a run.

mod extrusion;
pub(crate) mod outlines;
mod revolution;
mod taper;

use outlines::{Outlines, Reached};

/// The runs of the track, ascending. Extrusions come first, as they are the strictest, then tapers between them, then
/// revolutions in the rest.
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
