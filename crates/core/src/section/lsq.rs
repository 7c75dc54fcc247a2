//! The least-squares polyline of a band with its knots at given feature points: the middle of a thick band.
//!
//! Position is piecewise linear in the arc between knots, so the normal equations are tridiagonal, cyclic for a
//! closed contour.

use super::band::Band;
use super::chain::{Chain, Vertex};
use super::vec2::along;

/// Pull of a knot towards its own feature point: holds knots that no mark lies near.
const HOLD: f64 = 0.05;

/// The polyline with one vertex for each feature (ascending indices into `band.marks`).
pub(crate) fn polyline(band: &Band, features: &[usize]) -> Chain {
    let vertex = |at: [f64; 2], f: usize| Vertex::new(at, band.marks[f].spacing);
    let closed = band.chain.closed && features.len() >= 3;
    let mut system = System::new(band, features, closed);
    for (m, mark) in band.marks.iter().enumerate() {
        let next = features.partition_point(|&f| f <= m);
        system.add(next, mark.arc, mark.raw);
    }
    let solved = system.solve();
    Chain { vertices: solved.iter().zip(features).map(|(&at, &f)| vertex(at, f)).collect(), closed }
}

struct System {
    knots: Vec<f64>,
    length: f64,
    closed: bool,
    diagonal: Vec<f64>,
    /// Coefficient between knot k and the next; the last leads back to the first.
    upper: Vec<f64>,
    right: Vec<[f64; 2]>,
}

impl System {
    fn new(band: &Band, features: &[usize], closed: bool) -> Self {
        let mark = |&f: &usize| band.marks[f];
        Self {
            knots: features.iter().map(|f| mark(f).arc).collect(),
            length: band.length,
            closed,
            diagonal: vec![HOLD; features.len()],
            upper: vec![0.0; features.len()],
            right: features.iter().map(|f| mark(f).raw.map(|x| HOLD * x)).collect(),
        }
    }

    /// Adds a point whose arc lies between the knots before and at `next`.
    fn add(&mut self, next: usize, arc: f64, point: [f64; 2]) {
        let n = self.knots.len();
        if !self.closed && (next == 0 || next == n) {
            return;
        }
        let (a, b) = ((next + n - 1) % n, next % n);
        let (mut from, mut to) = (self.knots[a], self.knots[b]);
        if next == 0 {
            from -= self.length;
        } else if next == n {
            to += self.length;
        }
        let share = if to > from { ((arc - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let weights = [1.0 - share, share];
        self.diagonal[a] += weights[0] * weights[0];
        self.diagonal[b] += weights[1] * weights[1];
        self.upper[a] += weights[0] * weights[1];
        self.right[a] = along(self.right[a], point, weights[0]);
        self.right[b] = along(self.right[b], point, weights[1]);
    }

    /// Thomas elimination; the cyclic corner by the Sherman-Morrison formula.
    fn solve(&self) -> Vec<[f64; 2]> {
        let n = self.knots.len();
        let corner = if self.closed { self.upper[n - 1] } else { 0.0 };
        if corner == 0.0 || n < 3 {
            return thomas(&self.diagonal, &self.upper, &self.right);
        }
        let gamma = -self.diagonal[0];
        let mut diagonal = self.diagonal.clone();
        diagonal[0] -= gamma;
        diagonal[n - 1] -= corner * corner / gamma;
        let plain = thomas(&diagonal, &self.upper, &self.right);
        let mut unit = vec![[0.0; 2]; n];
        unit[0] = [gamma; 2];
        unit[n - 1] = [corner; 2];
        let bent = thomas(&diagonal, &self.upper, &unit);
        let ratio = corner / gamma;
        let share = |axis: usize| {
            let top = plain[0][axis] + ratio * plain[n - 1][axis];
            top / (1.0 + bent[0][axis] + ratio * bent[n - 1][axis])
        };
        let shares = [share(0), share(1)];
        (0..n).map(|k| [plain[k][0] - shares[0] * bent[k][0], plain[k][1] - shares[1] * bent[k][1]]).collect()
    }
}

/// Solves a symmetric tridiagonal positive definite system for two right sides.
fn thomas(diagonal: &[f64], upper: &[f64], right: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = diagonal.len();
    let mut pivots = diagonal.to_vec();
    let mut solved = right.to_vec();
    for k in 1..n {
        let factor = upper[k - 1] / pivots[k - 1];
        pivots[k] -= factor * upper[k - 1];
        solved[k] = along(solved[k], solved[k - 1], -factor);
    }
    for k in (0..n).rev() {
        let later = if k + 1 < n { along(solved[k], solved[k + 1], -upper[k]) } else { solved[k] };
        solved[k] = later.map(|x| x / pivots[k]);
    }
    solved
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cyclic_systems_are_solved() {
        let n = 7;
        let system = System {
            knots: vec![0.0; n],
            length: 1.0,
            closed: true,
            diagonal: (0..n).map(|k| 3.0 + k as f64).collect(),
            upper: (0..n).map(|k| 0.5 + 0.1 * k as f64).collect(),
            right: (0..n).map(|k| [k as f64, 1.0]).collect(),
        };
        let x = system.solve();
        for k in 0..n {
            let (before, after) = ((k + n - 1) % n, (k + 1) % n);
            for axis in 0..2 {
                let sum = system.upper[before] * x[before][axis]
                    + system.diagonal[k] * x[k][axis]
                    + system.upper[k] * x[after][axis];
                assert!((sum - system.right[k][axis]).abs() < 1e-12);
            }
        }
    }
}
