//! One-rings of a cloud without a mesh (Demarsin et al. 2007, section 2.2, after Floater and Reimers 2001).
//!
//! The `k` nearest neighbours are projected on their least-squares plane; the one-ring of the point is its star in the planar
//! Delaunay triangulation of the projections. Only that star is computed: the neighbours whose bisectors bound the point's
//! Voronoi cell. Where four projections lie on one circle the triangulation is free to choose; here a bisector that only
//! touches the cell in a corner gives no neighbour, so a grid has rings of four whichever way it is turned.

use super::leaf::BLOCK;
use super::rows::Neighbors;
use crate::math::tensor::plane_normal;
use crate::math::vec3::{cross, dot, perpendicular, sub};
use crate::parallel;

/// Relative distance up to which a bisector touches a corner of the cell without cutting it off.
const TOUCH: f64 = 1e-9;
/// Half the side of the square from which the cell is clipped, in units of the farthest projection's distance: beyond all
/// bisectors.
const BOX: f64 = 64.0;

/// The cell of one point while it is clipped.
#[derive(Clone, Debug, Default)]
struct Cell {
    /// Corners in order round the point.
    corners: Vec<[f64; 2]>,
    /// The neighbour whose bisector runs from each corner to the next; `u32::MAX` for a side of the square.
    sides: Vec<u32>,
    next_corners: Vec<[f64; 2]>,
    next_sides: Vec<u32>,
    /// Projections with squared length and neighbour.
    around: Vec<(f64, u32, [f64; 2])>,
}

/// Lengths of the rings of a block of points, the rings one after the other, and the normals.
type Block = (Vec<u32>, Vec<u32>, Vec<[f32; 3]>);

/// For each point its one-ring among `nearest`, in ascending order of index, and `(N, 3)` the unit normal, without
/// orientation, of the least-squares plane through the ring and the point.
pub fn one_rings(points: &[[f64; 3]], nearest: &Neighbors) -> (Neighbors, Vec<[f32; 3]>) {
    let blocks = points.len().div_ceil(BLOCK);
    let rings: Vec<Block> = parallel::map_with(blocks, parallel::TASK, |cell: &mut Cell, b| {
        let range = b * BLOCK..points.len().min((b + 1) * BLOCK);
        let (mut counts, mut indices, mut normals) = (Vec::new(), Vec::new(), Vec::new());
        for i in range {
            let before = indices.len();
            cell.ring(points, i, nearest.of(i), &mut indices);
            counts.push((indices.len() - before) as u32);
            normals.push(plane_normal(points, i, &indices[before..]).map(|x| x as f32));
        }
        (counts, indices, normals)
    });
    let mut all = Neighbors { offsets: vec![0], indices: Vec::new() };
    let mut normals = Vec::with_capacity(points.len());
    let mut end = 0;
    for (counts, indices, block) in rings {
        for count in counts {
            end += u64::from(count);
            all.offsets.push(end);
        }
        all.indices.extend(indices);
        normals.extend(block);
    }
    (all, normals)
}

impl Cell {
    /// Appends the one-ring of point `i` among `near`.
    fn ring(&mut self, points: &[[f64; 3]], i: usize, near: &[u32], ring: &mut Vec<u32>) {
        let normal = plane_normal(points, i, near);
        let u = perpendicular(normal);
        let v = cross(normal, u);
        self.around.clear();
        for &j in near {
            let d = sub(points[j as usize], points[i]);
            let q = [dot(d, u), dot(d, v)];
            let length2 = q[0] * q[0] + q[1] * q[1];
            if length2 > 0.0 {
                self.around.push((length2, j, q));
            }
        }
        self.around.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let Some(&(farthest, ..)) = self.around.last() else { return };
        let half = BOX * farthest.sqrt();
        self.corners.clear();
        self.corners.extend([[half, half], [-half, half], [-half, -half], [half, -half]]);
        self.sides.clear();
        self.sides.extend([u32::MAX; 4]);
        for n in 0..self.around.len() {
            let (length2, j, q) = self.around[n];
            // A bisector lies half as far as its projection; beyond all corners it cuts nothing off.
            let reach = self.corners.iter().map(|c| c[0] * c[0] + c[1] * c[1]).fold(0.0, f64::max);
            if 0.25 * length2 > reach {
                break;
            }
            self.clip(q, 0.5 * length2, j);
        }
        let first = ring.len();
        ring.extend(self.sides.iter().filter(|&&s| s != u32::MAX));
        ring[first..].sort_unstable();
    }

    /// Clips the cell to the near side of the bisector `x . q = offset`.
    fn clip(&mut self, q: [f64; 2], offset: f64, neighbor: u32) {
        let beyond = |c: [f64; 2]| c[0] * q[0] + c[1] * q[1] - offset;
        if self.corners.iter().all(|&c| beyond(c) <= TOUCH * offset) {
            return;
        }
        self.next_corners.clear();
        self.next_sides.clear();
        for n in 0..self.corners.len() {
            let (a, b) = (self.corners[n], self.corners[(n + 1) % self.corners.len()]);
            let (over_a, over_b) = (beyond(a), beyond(b));
            let t = over_a / (over_a - over_b);
            let crossing = || [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            let inside = |over: f64| over <= TOUCH * offset;
            match (inside(over_a), inside(over_b)) {
                (true, true) => self.push(a, self.sides[n]),
                (true, false) => {
                    self.push(a, self.sides[n]);
                    // The new side begins at a corner on the bisector itself.
                    if over_a >= -TOUCH * offset {
                        self.next_sides.pop();
                        self.next_sides.push(neighbor);
                    } else {
                        self.push(crossing(), neighbor);
                    }
                }
                (false, true) if over_b < -TOUCH * offset => self.push(crossing(), self.sides[n]),
                _ => {}
            }
        }
        std::mem::swap(&mut self.corners, &mut self.next_corners);
        std::mem::swap(&mut self.sides, &mut self.next_sides);
    }

    fn push(&mut self, corner: [f64; 2], side: u32) {
        self.next_corners.push(corner);
        self.next_sides.push(side);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbors::all_nearest;

    #[test]
    fn a_grid_has_rings_of_four_and_a_turned_grid_too() {
        for (c, s) in [(1.0, 0.0), (0.8, 0.6)] {
            let points: Vec<[f64; 3]> = (0..15 * 15)
                .map(|i| (f64::from(i % 15), f64::from(i / 15)))
                .map(|(x, y)| [c * x - s * y, s * x + c * y, 0.0])
                .collect();
            let (rings, normals) = one_rings(&points, &all_nearest(&points, 20));
            for i in (0..15 * 15).filter(|i| (3..12).contains(&(i % 15)) && (3..12).contains(&(i / 15))) {
                let i = i as usize;
                assert_eq!(rings.of(i), [i as u32 - 15, i as u32 - 1, i as u32 + 1, i as u32 + 15]);
                assert!(normals[i][2].abs() > 0.999_999);
            }
        }
    }

    #[test]
    fn rings_of_scattered_points_are_those_of_empty_circles() {
        let mut rng = crate::shapes::Rng::new(5);
        let points: Vec<[f64; 3]> =
            (0..400).map(|_| [rng.between(0.0, 20.0), rng.between(0.0, 20.0), 0.0]).collect();
        let (rings, _) = one_rings(&points, &all_nearest(&points, 30));
        let mut seen = 0;
        for (i, p) in
            points.iter().enumerate().filter(|(_, p)| p[..2].iter().all(|x| (5.0..15.0).contains(x)))
        {
            for j in 0..points.len() as u32 {
                let near = sub(points[j as usize], *p);
                if j as usize == i || dot(near, near) > 1.5 {
                    continue;
                }
                assert_eq!(rings.of(i).contains(&j), delaunay(&points, i, j as usize), "{i} {j}");
                seen += 1;
            }
        }
        assert!(seen > 300, "{seen}");
    }

    /// Whether some circle through both points holds no other: the bounds of its centre along their bisector.
    fn delaunay(points: &[[f64; 3]], i: usize, j: usize) -> bool {
        let d = sub(points[j], points[i]);
        let side = [-d[1], d[0], 0.0];
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (k, p) in points.iter().enumerate().filter(|(k, _)| *k != i && *k != j) {
            let q = sub(*p, points[i]);
            let (a, b) = (dot(q, side), 0.5 * (dot(q, q) - dot(q, d)));
            assert!(a != 0.0, "{k}");
            if a > 0.0 { high = high.min(b / a) } else { low = low.max(b / a) }
        }
        low < high
    }
}
