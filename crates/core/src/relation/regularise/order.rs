//! An order of the unknowns in which their normal equations stay sparse, and where these have entries.

use super::row::Row;
use crate::math::degree;
use crate::math::sparse::Sparse;
use std::collections::BTreeSet;

/// The place of each unknown, and a matrix with room for the products of the rows, each a set of blocks that it meets.
pub(super) fn order(blocks: &[(usize, usize)], count: usize, rows: &[Row]) -> (Vec<usize>, Sparse) {
    let mut block_of = vec![0; count];
    for (b, &(start, len)) in blocks.iter().enumerate() {
        block_of[start..start + len].fill(b);
    }
    let mut met: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); blocks.len()];
    let mut of_row = Vec::new();
    for row in rows {
        of_row.clear();
        of_row.extend(row.terms.iter().map(|t| block_of[t.0]));
        of_row.sort_unstable();
        of_row.dedup();
        for &a in &of_row {
            met[a].extend(of_row.iter().filter(|&&b| b != a));
        }
    }
    let near: Vec<Vec<usize>> = met.into_iter().map(|m| m.into_iter().collect()).collect();
    let sizes: Vec<usize> = blocks.iter().map(|b| b.1).collect();
    let mut place = vec![0; count];
    let mut next = 0..;
    for b in degree::order(&near, &sizes) {
        let (start, len) = blocks[b];
        place[start..start + len].iter_mut().zip(&mut next).for_each(|(p, at)| *p = at);
    }
    let mut pattern = vec![Vec::new(); count];
    for (b, near) in near.iter().enumerate() {
        let (start, len) = blocks[b];
        let first = place[start];
        let earlier = near.iter().map(|&c| blocks[c]).filter(|c| place[c.0] < first);
        let mut columns: Vec<usize> = earlier.flat_map(|(at, len)| place[at]..place[at] + len).collect();
        columns.sort_unstable();
        for k in 0..len {
            columns.push(first + k);
            pattern[first + k].clone_from(&columns);
        }
    }
    (place, Sparse::zeros(&pattern))
}
