//! The least-squares polyline of a band with its knots at given feature points: the middle of a thick band.
//!
//! Position is piecewise linear in the arc between knots, so the normal equations are tridiagonal, cyclic for a
//! closed contour.

use crate::math::tridiagonal::{cyclic, open};
use crate::math::vec2::along;
use crate::section::contour::band::Band;
use crate::section::contour::chain::{Chain, Vertex};

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
    let System { diagonal, upper, right, .. } = system;
    let solved = if closed { cyclic(&diagonal, &upper, &right) } else { open(&diagonal, &upper, &right) };
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
}
