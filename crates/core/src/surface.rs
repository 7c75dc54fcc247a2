//! The stage `surface`, between neighbours and detection: takes out clutter, thins rows, and gives the spacing at every point.

mod clutter;
mod scales;
mod support;
mod thin;

pub use scales::{Scales, evened, spacings};

use crate::neighbors::Neighbors;
use crate::resolution::Resolution;

/// Fewest points of a cloud in which surface and clutter can be told apart.
const FEWEST: usize = 100;
/// Least share of points on surfaces: a cloud with less is left as it is.
const LEAST_SURFACE: f64 = 0.1;
/// The representative of a point on no surface.
pub const CLUTTER: u32 = u32::MAX;

/// `(N)` representative of each point in the later stages: itself; a point beside it, where rows of a scan are thinned; or
/// [`CLUTTER`] for leaves, stray returns and veils between surfaces. Empty if every point represents itself. `nearest` are the
/// lists of nearest neighbours in order of distance.
pub fn standing(points: &[[f64; 3]], nearest: &Neighbors, mean: Resolution) -> Vec<u32> {
    if points.len() < FEWEST {
        return Vec::new();
    }
    let raw = scales::raw(points, nearest);
    let spacing = scales::smoothed(raw.clone(), nearest);
    let planes = support::planes(points, nearest);
    let (mut stands, in_row) = thin::thin(points, nearest, &planes, &spacing);
    let clutter = clutter::clutter(points, nearest, &planes, &raw, &spacing, &in_row, mean);
    let count = clutter.iter().filter(|&&c| c).count();
    if (points.len() - count) as f64 >= LEAST_SURFACE * points.len() as f64 {
        leave_out(&mut stands, &clutter);
    }
    if stands.iter().zip(0..).all(|(&s, i)| s == i) { Vec::new() } else { stands }
}

/// Marks clutter. Points represented by a point of clutter represent themselves again.
fn leave_out(stands: &mut [u32], clutter: &[bool]) {
    for (i, stand) in stands.iter_mut().enumerate() {
        if clutter[i] {
            *stand = CLUTTER;
        } else if clutter[*stand as usize] {
            *stand = i as u32;
        }
    }
}
