//! The outside or the inside of a thick band: an outline moved to one side of its points.

use crate::curve::polygon::measure;
use crate::math::trees::kd::Tree;
use crate::math::vec2::{along, cross, left, sub, unit};
use crate::section::contour::band::Band;
use crate::section::contour::chain::Chain;

/// Moves each vertex of a closed outline to the side of the band that looks away from (1) or towards (-1) the
/// enclosed area; an open one has no such sides and stays. A share of the samples is left `beyond` it.
pub(crate) fn shifted(band: &Band, chain: Chain, side: f64, beyond: f64) -> Chain {
    if !chain.closed || band.marks.is_empty() {
        return chain;
    }
    let points: Vec<[f64; 2]> = chain.points();
    let area = measure(&points, true).area;
    // Right of a counter-clockwise contour is outside.
    let sign = if area >= 0.0 { -side } else { side };
    let n = points.len();
    let raw: Vec<[f64; 2]> = band.marks.iter().map(|m| m.raw).collect();
    let (tree, mut found) = (Tree::new(&raw), Vec::new());
    let mut vertices = chain.vertices;
    for (k, vertex) in vertices.iter_mut().enumerate() {
        let direction = unit(sub(points[(k + 1) % n], points[(k + n - 1) % n]));
        let outward = left(direction).map(|x| x * sign);
        tree.within(points[k], 1.5 * vertex.spacing, &mut found);
        let off = |&m: &u32| cross(direction, sub(band.marks[m as usize].raw, points[k])) * sign;
        let mut offs: Vec<f64> = found.iter().map(off).collect();
        if offs.len() >= 3 {
            let at = ((offs.len() - 1) as f64 * (1.0 - beyond)) as usize;
            let shift = *offs.select_nth_unstable_by(at, f64::total_cmp).1;
            vertex.at = along(vertex.at, outward, shift.max(0.0));
        }
    }
    Chain { vertices, closed: true }
}
