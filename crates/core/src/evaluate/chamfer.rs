//! Chamfer and Hausdorff distance of curves, as the code of PI3DETR and NerVE computes them: samples of both against each other, in
//! coordinates in which the longest side of the box is 2.
//!
//! PI3DETR (Oberweger et al., 2026) samples every 0.01 and scales the box of the points to [-1, 1]; here the box is that of the known
//! lines. NerVE (Zhu et al., 2023) has the same two formulas over vertices and middles of segments, so that its figure depends on how
//! densely either side is written; it is not taken from there.

use super::lines::Lines;
use super::{samples, sides};
use crate::shapes::Tree;

/// Distance of the samples, in the coordinates of the measure.
const STEP: f64 = 0.01;
/// Most samples of either side.
const MOST: f64 = 5e6;

/// The two distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chamfer {
    /// Chamfer distance: the mean squared distances of both directions, added.
    pub cd: f64,
    /// Hausdorff distance: the mean of the greatest distances of both directions.
    pub hd: f64,
    /// The greater of these two greatest distances, which is Hausdorff's own.
    pub hausdorff: f64,
}

impl Chamfer {
    /// `None` where either side is empty, or so long beside the box of the known lines that it has more than five million samples.
    pub(super) fn of(found: &Lines, known: &Lines) -> Option<Self> {
        let [low, high] = known.bounds()?;
        let half = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max) / 2.0;
        if half <= 0.0 {
            return None;
        }
        let length = |lines: &Lines| lines.sharp().map(|l| sides::length(&l.points)).sum::<f64>();
        if length(found).max(length(known)) > MOST * STEP * half {
            return None;
        }
        let samples = |lines: &Lines| -> Vec<[f64; 3]> {
            lines.sharp().flat_map(|l| samples::samples(&l.points, l.closed, STEP * half)).collect()
        };
        let (found, known) = (samples(found), samples(known));
        let [mean_a, max_a] = directed(&found, &known, half)?;
        let [mean_b, max_b] = directed(&known, &found, half)?;
        Some(Self { cd: mean_a + mean_b, hd: (max_a + max_b) / 2.0, hausdorff: max_a.max(max_b) })
    }
}

/// Mean squared and greatest distance from points to others.
fn directed(from: &[[f64; 3]], to: &[[f64; 3]], half: f64) -> Option<[f64; 2]> {
    let tree = Tree::new(to);
    let squares: Option<Vec<f64>> =
        from.iter().map(|&p| tree.nearest(p).map(|n| n.1 / (half * half))).collect();
    let squares = squares.filter(|all| !all.is_empty())?;
    let most = squares.iter().copied().fold(0.0, f64::max);
    Some([squares.iter().sum::<f64>() / squares.len() as f64, most.sqrt()])
}
