//! Cholesky factorisation of a sparse symmetric positive definite matrix, row by row along the elimination tree (Davis 2006, Direct Methods for
//! Sparse Linear Systems, section 4.8). The structure of the factor is found once, for all matrices of one pattern.

/// No row.
const NONE: usize = usize::MAX;

/// The lower triangle of a sparse symmetric matrix, by rows, with room for its factor, by columns.
#[derive(Clone, Debug)]
pub struct Sparse {
    /// Where each row of the matrix begins, and its columns, ascending; the last is the diagonal.
    start: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    /// The first row below each row in the elimination tree.
    parent: Vec<usize>,
    /// Where each column of the factor begins, and its rows, ascending; the first is the diagonal.
    factor_start: Vec<usize>,
    factor_rows: Vec<usize>,
    factor: Vec<f64>,
}

impl Sparse {
    /// A zero matrix. Row `i` has entries in `rows[i]`, ascending columns of which the last is `i`.
    pub fn zeros(rows: &[Vec<usize>]) -> Self {
        let mut start = vec![0];
        rows.iter().for_each(|row| start.push(start[start.len() - 1] + row.len()));
        let columns: Vec<usize> = rows.concat();
        let mut matrix = Self {
            values: vec![0.0; columns.len()],
            parent: tree(rows),
            start,
            columns,
            factor_start: vec![0],
            factor_rows: Vec::new(),
            factor: Vec::new(),
        };
        let mut counts = vec![1; rows.len()];
        let (mut mark, mut reach) = (vec![NONE; rows.len()], Vec::new());
        for i in 0..rows.len() {
            matrix.reach(i, &mut mark, &mut reach);
            reach.iter().for_each(|&j: &usize| counts[j] += 1);
        }
        counts.iter().for_each(|n| matrix.factor_start.push(matrix.factor_start.last().unwrap_or(&0) + n));
        let size = matrix.factor_start[rows.len()];
        (matrix.factor_rows, matrix.factor) = (vec![0; size], vec![0.0; size]);
        matrix
    }

    /// Sets all entries to zero.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Adds `x` to the entry of row and column `i`, `j` (either order), which must be in the pattern.
    pub fn add(&mut self, i: usize, j: usize, x: f64) {
        let (row, column) = if i >= j { (i, j) } else { (j, i) };
        let at = self.columns[self.start[row]..self.start[row + 1]].binary_search(&column);
        debug_assert!(at.is_ok(), "({row}, {column}) is not in the pattern");
        if let Ok(at) = at {
            self.values[self.start[row] + at] += x;
        }
    }

    /// The columns left of the diagonal in which row `i` of the factor has entries, descendants before their parents.
    fn reach(&self, i: usize, mark: &mut [usize], reach: &mut Vec<usize>) {
        reach.clear();
        mark[i] = i;
        let mut path = Vec::new();
        for &column in &self.columns[self.start[i]..self.start[i + 1] - 1] {
            let mut j = column;
            while mark[j] != i {
                mark[j] = i;
                path.push(j);
                j = self.parent[j];
            }
            // Paths found later come before: they end on those found so far.
            reach.extend(path.drain(..).rev());
        }
        reach.reverse();
    }

    /// Factorises; false if a pivot is not positive, that is, if the matrix is singular to rounding.
    pub fn factorise(&mut self) -> bool {
        let n = self.parent.len();
        let mut next: Vec<usize> = self.factor_start[..n].to_vec();
        let (mut mark, mut reach, mut x) = (vec![NONE; n], Vec::new(), vec![0.0; n]);
        for i in 0..n {
            self.reach(i, &mut mark, &mut reach);
            let (from, to) = (self.start[i], self.start[i + 1]);
            for (&j, &value) in self.columns[from..to].iter().zip(&self.values[from..to]) {
                x[j] = value;
            }
            let (diagonal, mut pivot) = (x[i], x[i]);
            x[i] = 0.0;
            for &j in &reach {
                let begin = self.factor_start[j];
                let l = x[j] / self.factor[begin];
                x[j] = 0.0;
                let above = begin + 1..next[j];
                for (&k, &value) in self.factor_rows[above.clone()].iter().zip(&self.factor[above]) {
                    x[k] -= value * l;
                }
                pivot -= l * l;
                (self.factor_rows[next[j]], self.factor[next[j]]) = (i, l);
                next[j] += 1;
            }
            if pivot.is_nan() || pivot <= 1e-14 * diagonal {
                return false;
            }
            (self.factor_rows[next[i]], self.factor[next[i]]) = (i, pivot.sqrt());
            next[i] += 1;
        }
        true
    }

    /// Solves with the factor for one right-hand side, in place.
    pub fn solve(&self, b: &mut [f64]) {
        let column = |j: usize| {
            let (begin, end) = (self.factor_start[j], self.factor_start[j + 1]);
            let below = self.factor_rows[begin + 1..end].iter().zip(&self.factor[begin + 1..end]);
            (self.factor[begin], below)
        };
        for j in 0..b.len() {
            let (diagonal, below) = column(j);
            b[j] /= diagonal;
            let x = b[j];
            below.for_each(|(&i, l)| b[i] -= l * x);
        }
        for j in (0..b.len()).rev() {
            let (diagonal, below) = column(j);
            let sum: f64 = below.map(|(&i, l)| l * b[i]).sum();
            b[j] = (b[j] - sum) / diagonal;
        }
    }
}

/// The elimination tree (Liu 1990), with paths shortened on the way.
fn tree(rows: &[Vec<usize>]) -> Vec<usize> {
    let (mut parent, mut ancestor) = (vec![NONE; rows.len()], vec![NONE; rows.len()]);
    for (i, row) in rows.iter().enumerate() {
        for &column in &row[..row.len() - 1] {
            let mut j = column;
            while j != NONE && j < i {
                let above = ancestor[j];
                ancestor[j] = i;
                if above == NONE {
                    parent[j] = i;
                }
                j = above;
            }
        }
    }
    parent
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::uniform::uniform;

    #[test]
    fn a_sparse_matrix_is_solved_and_a_singular_one_refused() {
        let (n, mut uniform) = (40, uniform(5));
        let rows: Vec<Vec<usize>> =
            (0..n).map(|i| (0..=i).filter(|&j| j == i || uniform() < 0.1).collect()).collect();
        let mut matrix = Sparse::zeros(&rows);
        for round in 0..2 {
            matrix.clear();
            let mut dense = vec![vec![0.0; n]; n];
            for (i, row) in rows.iter().enumerate() {
                for &j in row {
                    let x = if i == j { 20.0 } else { uniform() - 0.5 };
                    matrix.add(j, i, x);
                    (dense[i][j], dense[j][i]) = (x, x);
                }
            }
            let truth: Vec<f64> = (0..n).map(|_| uniform()).collect();
            let product = |row: &Vec<f64>| row.iter().zip(&truth).map(|(a, x)| a * x).sum();
            let mut b: Vec<f64> = dense.iter().map(product).collect();
            assert!(matrix.factorise());
            matrix.solve(&mut b);
            assert!(b.iter().zip(&truth).all(|(x, y)| (x - y).abs() < 1e-13), "{round}");
        }
        matrix.clear();
        rows.iter().enumerate().for_each(|(i, row)| row.iter().for_each(|&j| matrix.add(i, j, 1.0)));
        assert!(!matrix.factorise());
    }
}
