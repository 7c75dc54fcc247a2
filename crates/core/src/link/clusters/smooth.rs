//! `G_smooth`: smooths lines without shrinking them (Demarsin et al. 2007, section 2.8).
//!
//! The paper's own smoothing (Volodine, Vanderstraeten and Roose, report TW 451) needs a basis of the whole graph. Here it is
//! Taubin's low-pass filter (G. Taubin, "A signal processing approach to fair surface design", SIGGRAPH 1995, section 3):
//! each step moves a vertex towards the middle of its two neighbours by `lambda`, then away by `mu`. Vertices of any other
//! degree stay, and so does a vertex where the line turns sharply.

use crate::math::vec3::{add_scaled, dot, sub, unit};
use crate::pattern::LineGraph;

/// Taubin's factors for a pass band of 0.1: `1 / lambda + 1 / mu = 0.1`.
const LAMBDA: f64 = 0.5;
const MU: f64 = -1.0 / (1.0 / LAMBDA - 0.1);
/// Turn of a line at a vertex above which the vertex is a corner and stays.
const CORNER_TURN_DEG: f64 = 60.0;

/// Smooths all lines by `steps` of the filter.
pub fn smooth(lines: &mut LineGraph, steps: usize) {
    let moving: Vec<Option<[u32; 2]>> = (0..lines.edges.len()).map(|v| pair(lines, v)).collect();
    for _ in 0..steps {
        for factor in [LAMBDA, MU] {
            let from = lines.positions.clone();
            for (v, pair) in moving.iter().enumerate() {
                if let Some([a, b]) = *pair {
                    let middle =
                        add_scaled(sub(from[a as usize], from[v]), sub(from[b as usize], from[v]), 1.0);
                    lines.positions[v] = add_scaled(from[v], middle, 0.5 * factor);
                }
            }
        }
    }
}

/// The two neighbours of a vertex within a line.
fn pair(lines: &LineGraph, v: usize) -> Option<[u32; 2]> {
    let &[a, b] = lines.edges[v].as_slice() else { return None };
    let at = lines.positions[v];
    let before = unit(sub(at, lines.positions[a as usize]));
    let after = unit(sub(lines.positions[b as usize], at));
    (dot(before, after) > CORNER_TURN_DEG.to_radians().cos()).then_some([a, b])
}
