//! Islands: pieces of the cloud that are too small for a surface.

use crate::math::union_find::UnionFind;
use crate::math::vec3::distance2;
use crate::neighbors::Neighbors;
use crate::parallel;

/// Fewest points of a piece of surface.
pub(crate) const PIECE: usize = 24;

/// `(N)` whether each point lies in a piece of fewer than 24 points. Points that are `out` belong to no piece; two others belong
/// to the same piece if one lists the other and they lie within the lesser of their reaches.
pub(super) fn islands(points: &[[f64; 3]], nearest: &Neighbors, reach: &[f32], out: &[bool]) -> Vec<bool> {
    let links = Links { points, nearest, reach, out };
    // Nearly every point reaches enough others within two or three steps; for the few others the whole piece is counted.
    let doubtful = parallel::map_with(points.len(), parallel::QUICK, |seen, i| {
        !out[i] && !links.reaches_enough(i, seen)
    });
    if !doubtful.contains(&true) {
        return doubtful;
    }
    let mut sets = UnionFind::new(points.len());
    let joined = parallel::flat_map(points.len(), parallel::QUICK, |i, joined| {
        if !out[i] {
            let doubtful = links.of(i).filter(|&j| doubtful[i] || doubtful[j]);
            joined.extend(doubtful.map(|j| (i as u32, j as u32)));
        }
    });
    for (i, j) in joined {
        sets.union(i, j);
    }
    let (mut size, mut large) = (vec![0_usize; points.len()], vec![false; points.len()]);
    for i in (0..points.len()).filter(|&i| !out[i]) {
        let piece = sets.find(i as u32) as usize;
        size[piece] += 1;
        large[piece] |= !doubtful[i];
    }
    let small = |i: usize| {
        let piece = sets.find(i as u32) as usize;
        doubtful[i] && !large[piece] && size[piece] < PIECE
    };
    (0..points.len()).map(small).collect()
}

/// The links between points of one piece.
pub(super) struct Links<'a> {
    pub(super) points: &'a [[f64; 3]],
    pub(super) nearest: &'a Neighbors,
    pub(super) reach: &'a [f32],
    pub(super) out: &'a [bool],
}

impl Links<'_> {
    /// The points that `i` lists and is linked to.
    pub(super) fn of(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        let linked = move |j: &usize| {
            let reach = f64::from(self.reach[i].min(self.reach[*j]));
            !self.out[*j] && distance2(self.points[i], self.points[*j]) <= reach * reach
        };
        self.nearest.of(i).iter().map(|&j| j as usize).filter(linked)
    }

    /// Whether a walk along the links from `i` meets enough points for a surface. `seen` is room for it.
    fn reaches_enough(&self, i: usize, seen: &mut Vec<u32>) -> bool {
        seen.clear();
        seen.push(i as u32);
        let mut next = 0;
        while let Some(&from) = seen.get(next) {
            for j in self.of(from as usize).map(|j| j as u32) {
                if !seen.contains(&j) {
                    seen.push(j);
                }
            }
            if seen.len() >= PIECE {
                return true;
            }
            next += 1;
        }
        false
    }
}
