//! Cholesky factorisation of a symmetric positive definite matrix stored by its skyline.
//!
//! The normal equations of a B-spline fit are banded; those of a periodic one have a few full rows besides. Storing each
//! row from its first non-zero column on serves both: Cholesky fills nothing outside the skyline.

/// The lower triangle of a symmetric matrix; row `i` holds the columns `first[i]..=i`.
#[derive(Clone, Debug)]
pub struct Skyline {
    first: Vec<usize>,
    start: Vec<usize>,
    values: Vec<f64>,
}

/// Length from which rows are multiplied in lanes.
const LONG: usize = 64;
/// Sums that run beside each other.
const LANES: usize = 8;

/// The scalar product of long rows, in sums beside each other, which the processor adds at once.
fn long(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (x, y) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = x.remainder().iter().zip(y.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in x.zip(y) {
        (0..LANES).for_each(|k| sums[k] += x[k] * y[k]);
    }
    rest + sums.iter().sum::<f64>()
}

impl Skyline {
    /// A zero matrix whose row `i` begins at column `first[i] <= i`.
    pub fn zeros(first: Vec<usize>) -> Self {
        let mut start = Vec::with_capacity(first.len() + 1);
        let mut total = 0;
        for (i, &f) in first.iter().enumerate() {
            debug_assert!(f <= i);
            start.push(total);
            total += i - f + 1;
        }
        start.push(total);
        Self { first, start, values: vec![0.0; total] }
    }

    /// Adds `x` to the entry of row and column `i`, `j` (either order). The entry must lie inside the skyline.
    pub fn add(&mut self, i: usize, j: usize, x: f64) {
        let (row, column) = if i >= j { (i, j) } else { (j, i) };
        self.values[self.start[row] + column - self.first[row]] += x;
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.first.len()
    }

    /// Factorises in place to `L L^t`; false if a pivot is not positive, that is, if the matrix is singular to rounding.
    pub fn factorise(&mut self) -> bool {
        for i in 0..self.len() {
            let diagonal = self.values[self.start[i + 1] - 1];
            for j in self.first[i]..=i {
                let sum = self.inner(i, j);
                let at = self.start[i] + j - self.first[i];
                if j == i {
                    let pivot = self.values[at] - sum;
                    if pivot.is_nan() || pivot <= 1e-14 * diagonal {
                        return false;
                    }
                    self.values[at] = pivot.sqrt();
                } else {
                    self.values[at] = (self.values[at] - sum) / self.values[self.start[j + 1] - 1];
                }
            }
        }
        true
    }

    /// The scalar product of the rows `i` and `j <= i` of the factor, left of column `j`.
    fn inner(&self, i: usize, j: usize) -> f64 {
        let from = self.first[i].max(self.first[j]);
        let a = &self.values[self.start[i] + from - self.first[i]..self.start[i] + j - self.first[i]];
        let b = &self.values[self.start[j] + from - self.first[j]..self.start[j] + j - self.first[j]];
        if a.len() < LONG { a.iter().zip(b).map(|(x, y)| x * y).sum() } else { long(a, b) }
    }

    /// Solves with the factor for one right-hand side of `D` columns, in place.
    pub fn solve<const D: usize>(&self, b: &mut [[f64; D]]) {
        for i in 0..self.len() {
            let mut x = b[i];
            for j in self.first[i]..i {
                let l = self.values[self.start[i] + j - self.first[i]];
                for (x, y) in x.iter_mut().zip(b[j]) {
                    *x -= l * y;
                }
            }
            let d = self.values[self.start[i + 1] - 1];
            b[i] = x.map(|x| x / d);
        }
        for i in (0..self.len()).rev() {
            let d = self.values[self.start[i + 1] - 1];
            let x = b[i].map(|x| x / d);
            b[i] = x;
            for j in self.first[i]..i {
                let l = self.values[self.start[i] + j - self.first[i]];
                for (y, x) in b[j].iter_mut().zip(x) {
                    *y -= l * x;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A diagonally dominant matrix with a band of two and a full last row, and a known solution.
    #[test]
    fn a_banded_matrix_with_a_full_row_is_solved() {
        let n = 9;
        let first =
            (0..n).map(|i: usize| if i == n - 1 { 0 } else { i.saturating_sub(2) }).collect::<Vec<_>>();
        let mut m = Skyline::zeros(first.clone());
        let mut dense = vec![vec![0.0; n]; n];
        for i in 0..n {
            for j in first[i]..=i {
                let x = if i == j { 10.0 + i as f64 } else { 1.0 / (1.0 + i as f64 + 2.0 * j as f64) };
                m.add(j, i, x);
                dense[i][j] = x;
                dense[j][i] = x;
            }
        }
        let truth: Vec<[f64; 3]> = (0..n).map(|i| [i as f64, 1.0, -(i as f64) * 0.5]).collect();
        let mut b: Vec<[f64; 3]> = (0..n)
            .map(|i| std::array::from_fn(|c| (0..n).map(|j| dense[i][j] * truth[j][c]).sum()))
            .collect();
        assert!(m.factorise());
        m.solve(&mut b);
        for (x, y) in b.iter().flatten().zip(truth.iter().flatten()) {
            assert!((x - y).abs() < 1e-12);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let mut m = Skyline::zeros(vec![0, 0]);
        for (i, j) in [(0, 0), (1, 0), (1, 1)] {
            m.add(i, j, 1.0);
        }
        assert!(!m.factorise());
    }
}
