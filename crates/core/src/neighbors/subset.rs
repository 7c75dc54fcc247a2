//! The nearest neighbours that are left when some points are taken out.

use super::all_nearest;
use super::index::Index;
use super::leaf::BLOCK;
use super::rows::Neighbors;
use crate::parallel;

/// The lists of [`all_nearest`] for the points that stay, from those for all points, in their room: a list of which every point
/// stays is the same; others are searched for anew.
///
/// `all` are the lists of all points, of `k` neighbours each or as many as there are; `number` is `(N)` the new index of each point,
/// `u32::MAX` if it does not stay, ascending; `positions` are those of the `(M)` points that stay.
pub fn among(all: Neighbors, k: usize, number: &[u32], positions: &[[f64; 3]]) -> Neighbors {
    if k == 0 || positions.len() <= k {
        return all_nearest(positions, k);
    }
    let Neighbors { mut offsets, mut indices } = all;
    let stay = (0..number.len()).filter(|&old| number[old] != u32::MAX);
    for (new, old) in stay.enumerate() {
        // A list never moves up, so that none is overwritten before it is read.
        for c in 0..k {
            indices[new * k + c] = number[indices[old * k + c] as usize];
        }
    }
    indices.truncate(positions.len() * k);
    offsets.truncate(positions.len() + 1);
    let index = Index::build(positions);
    parallel::each(indices.chunks_mut(BLOCK * k), |b, lists| {
        let mut found = Vec::new();
        for (new, list) in (b * BLOCK..).zip(lists.chunks_mut(k)).filter(|(_, list)| list.contains(&u32::MAX))
        {
            index.nearest(positions[new], k + 1, &mut found);
            let others = found.iter().map(|f| f.index).filter(|&j| j as usize != new);
            list.iter_mut().zip(others).for_each(|(place, j)| *place = j);
        }
    });
    Neighbors { offsets, indices }
}

#[cfg(test)]
mod tests {
    use super::among;
    use crate::neighbors::all_nearest;
    use crate::shapes::Rng;

    #[test]
    fn lists_among_the_points_that_stay_are_those_of_a_search() {
        let mut rng = Rng::new(8);
        // Coordinates of few values, so that many distances are equal.
        let points: Vec<[f64; 3]> = (0..800)
            .map(|k| [rng.below(9) as f64, rng.below(9) as f64, 0.001 * f64::from(k % 400)])
            .collect();
        for share in [0.02, 0.5, 0.99] {
            let stays: Vec<bool> = points.iter().map(|_| rng.uniform() >= share).collect();
            let mut next = 0;
            let number: Vec<u32> = stays
                .iter()
                .map(|&s| {
                    next += u32::from(s);
                    if s { next - 1 } else { u32::MAX }
                })
                .collect();
            let left: Vec<[f64; 3]> =
                points.iter().zip(&stays).filter(|&(_, &s)| s).map(|(p, _)| *p).collect();
            assert_eq!(
                among(all_nearest(&points, 12), 12, &number, &left),
                all_nearest(&left, 12),
                "{share}"
            );
        }
    }
}
