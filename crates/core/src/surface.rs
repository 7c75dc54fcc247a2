//! The stage `surface`, between neighbours and detection: takes out clutter, thins points in excess, and gives the spacing at
//! every point.

mod clutter;
mod findings;
mod islands;
mod local;
pub(crate) mod reach;
mod rows;
mod scales;
mod support;
mod thin;

pub(crate) use clutter::{Crowd, links};
pub use findings::Findings;
pub(crate) use islands::PIECE;
pub(crate) use local::{Judged, Local};
pub use scales::{Scales, evened, spacings};

use crate::neighbors::{Neighbors, all_nearest, riemannian};
use crate::params::NeighborParams;
use crate::resolution::Resolution;

/// Fewest points of a cloud in which surface and clutter can be told apart.
pub(crate) const FEWEST: usize = 100;
/// The representative of a point on no surface.
pub const CLUTTER: u32 = u32::MAX;

/// The points that go on to the later stages.
#[derive(Debug, Default)]
pub struct Sorted {
    /// `(N)` representative of each point: itself; a point beside it, where a place is thinned; or [`CLUTTER`] for leaves,
    /// stray returns and veils between surfaces. Empty if every point represents itself.
    pub stands: Vec<u32>,
    /// Counts and figures on the sampling.
    pub findings: Findings,
}

/// Sorts the points of a cloud into surface, clutter and excess. `nearest` are the lists of nearest neighbours in order of
/// distance.
pub fn sort(points: &[[f64; 3]], nearest: &Neighbors, mean: Resolution) -> Sorted {
    if points.len() < FEWEST {
        return Sorted::default();
    }
    let local = Local::new(points, nearest, mean);
    let crowds = clutter::crowds(points, nearest, &local.marks);
    let scattered = crowds.iter().filter(|&&c| c).count();
    let Judged { clutter, mut stands, .. } = local.judged(points, nearest, &crowds);
    let Local { raw, spacing, gaps, .. } = local;
    let count = clutter.iter().filter(|&&c| c).count();
    if points.len() - count < PIECE {
        return Sorted { findings: Findings { none: true, ..Findings::default() }, ..Sorted::default() };
    }
    leave_out(&mut stands, &clutter);
    let thinned = stands.iter().zip(0..).filter(|&(&s, i)| s != i && s != CLUTTER).count();
    let (in_rows, row_ratio, row_distance) = rows::summary(&gaps, &raw);
    let findings = Findings {
        scattered,
        stray: count - scattered,
        thinned,
        in_rows,
        row_ratio,
        row_distance,
        spread: findings::spread(&spacing, &clutter),
        none: false,
    };
    if count + thinned == 0 {
        stands.clear();
    }
    Sorted { stands, findings }
}

/// `(N)` whether each point lies on no surface; empty if all do, or none does. `points` are distinct, in canonical order.
pub fn clutter(points: &[[f64; 3]]) -> Vec<bool> {
    let nearest = all_nearest(points, NeighborParams::default().k);
    let mean = Resolution::estimate(points, &nearest, &riemannian::graph(points, &nearest));
    sort(points, &nearest, mean).stands.iter().map(|&s| s == CLUTTER).collect()
}

/// Marks clutter. Points represented by a point of clutter represent themselves again.
pub(crate) fn leave_out(stands: &mut [u32], clutter: &[bool]) {
    for (i, stand) in stands.iter_mut().enumerate() {
        if clutter[i] {
            *stand = CLUTTER;
        } else if clutter[*stand as usize] {
            *stand = i as u32;
        }
    }
}
