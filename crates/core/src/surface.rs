//! The stage `surface`, between neighbours and detection: takes out clutter, thins points in excess, and gives the spacing at
//! every point.

mod clutter;
mod findings;
mod islands;
pub(crate) mod reach;
mod rows;
mod scales;
mod support;
mod thin;

pub use findings::Findings;
pub use scales::{Scales, evened, spacings};

use crate::neighbors::{Neighbors, all_nearest, riemannian};
use crate::params::NeighborParams;
use crate::resolution::Resolution;
pub(crate) use clutter::{Crowd, Marks, links};
use support::Plane;

/// Fewest points of a cloud in which surface and clutter can be told apart.
pub(crate) const FEWEST: usize = 100;
/// Fewest points of a piece of surface.
pub(crate) const PIECE: usize = 24;
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

/// What is known of every point before crowds are judged as wholes.
pub(crate) struct Local {
    /// Mean distance of the six nearest, and the same smoothed.
    raw: Vec<f32>,
    spacing: Vec<f32>,
    planes: Vec<Plane>,
    gaps: Vec<f32>,
    /// Distance between kept points; zero where nothing is thinned.
    pub(crate) apart: Vec<f64>,
    pub(crate) marks: Marks,
}

impl Local {
    pub(crate) fn new(points: &[[f64; 3]], nearest: &Neighbors, mean: Resolution) -> Local {
        let raw = scales::raw(points, nearest);
        let spacing = scales::smoothed(raw.clone(), nearest);
        let planes = support::planes(points, nearest);
        let gaps = rows::gaps(points, nearest, &planes, &spacing);
        let apart = thin::apart(&gaps, &spacing, mean);
        let marks = Marks::new(points, nearest, &planes, (&raw, &spacing, &gaps), mean);
        Local { raw, spacing, planes, gaps, apart, marks }
    }

    /// Judges the points by the crowds that are clutter.
    pub(crate) fn judged(&self, points: &[[f64; 3]], nearest: &Neighbors, crowds: &[bool]) -> Judged {
        let drawn = clutter::grown(nearest, &self.marks, crowds);
        let small = islands::islands(points, nearest, &self.marks.reach, &drawn);
        let clutter = drawn.iter().zip(small).map(|(drawn, small)| *drawn || small).collect();
        Judged { drawn, clutter, stands: thin::thin(points, &self.apart) }
    }
}

/// What becomes of every point.
pub(crate) struct Judged {
    /// Whether it is clutter, apart from islands in it; and with them.
    drawn: Vec<bool>,
    pub(crate) clutter: Vec<bool>,
    /// The representative, clutter not yet counted.
    pub(crate) stands: Vec<u32>,
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
