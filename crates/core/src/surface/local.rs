//! The points of a cloud as far as lists of nearest neighbours tell, and what becomes of them once crowds are judged.

use super::clutter::{self, Marks};
use super::support::{self, Plane};
use super::{islands, rows, scales, thin};
use crate::neighbors::Neighbors;
use crate::resolution::Resolution;

/// What is known of every point before crowds are judged as wholes.
pub(crate) struct Local {
    /// Mean distance of the six nearest, and the same smoothed.
    pub(super) raw: Vec<f32>,
    pub(super) spacing: Vec<f32>,
    pub(super) planes: Vec<Plane>,
    pub(super) gaps: Vec<f32>,
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
    pub(super) drawn: Vec<bool>,
    pub(crate) clutter: Vec<bool>,
    /// The representative, clutter not yet counted.
    pub(crate) stands: Vec<u32>,
}
