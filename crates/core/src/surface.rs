//! The stage between neighbours and detection: which points lie on a surface, and how densely each place is sampled.

mod clutter;
mod scales;
mod support;
mod thin;

pub use scales::{Scales, evened, spacings};

use crate::neighbors::Neighbors;
use crate::resolution::Resolution;

/// Clouds of fewer points are too small to tell surface from clutter.
const FEWEST: usize = 100;
/// A cloud of which no more than this share lies on a surface is left as it is: there is nothing to clean it by.
const LEAST_SURFACE: f64 = 0.1;
/// What stands for a point that lies on no surface.
pub const CLUTTER: u32 = u32::MAX;

/// `(N)` the point that stands for each in what follows: itself; another of the row, where rows of a scan are thinned; or [`CLUTTER`]
/// for leaves, stray returns and veils between surfaces. Empty where each stands for itself. `nearest` are the lists of
/// nearest neighbours in order of distance.
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

/// Marks clutter, and has the points that clutter stood for stand for themselves.
fn leave_out(stands: &mut [u32], clutter: &[bool]) {
    for (i, stand) in stands.iter_mut().enumerate() {
        if clutter[i] {
            *stand = CLUTTER;
        } else if clutter[*stand as usize] {
            *stand = i as u32;
        }
    }
}
