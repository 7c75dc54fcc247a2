//! The search structure: leaves of 16 points under a 16-wide implicit hierarchy of bounding boxes.
//!
//! Blocks of consecutive points, which Morton order keeps together, are divided into leaves like a k-d tree (`split`).
//! That costs 30 ns a point; leaves of sixteen consecutive points, tried first, have looser boxes, and searching them
//! costs 70 ns a point more.

use super::found::Found;
use super::leaf::{Aabb, BLOCK, Leaf, Node, WIDTH};
use super::split;
use crate::parallel;

/// A search structure over a set of points, for queries anywhere.
#[derive(Clone, Debug, Default)]
pub struct Index {
    pub(super) count: usize,
    pub(crate) leaves: Vec<Leaf>,
    /// `[0]` are the nodes over the leaves, the last level is one node: child `c` of node `n` is the entry
    /// `16 n + c` of the level below.
    pub(super) levels: Vec<Vec<Node>>,
}

impl Index {
    /// Builds the structure over `positions`, `(N, 3)` f64, finite, less than 1e150 apart. In canonical order leaves are compact
    /// and searches fast; any other order gives the same results.
    pub fn build(positions: &[[f64; 3]]) -> Index {
        let count = positions.len().div_ceil(WIDTH);
        let mut leaves = parallel::filled(count, &Leaf::EMPTY);
        let mut boxes = vec![Aabb::EMPTY; count];
        let blocks = positions.chunks(BLOCK).zip(leaves.chunks_mut(BLOCK / WIDTH));
        let blocks = blocks.zip(boxes.chunks_mut(BLOCK / WIDTH));
        parallel::each(blocks, |b, ((points, leaves), boxes)| {
            split::leaves(points, (b * BLOCK) as u32, leaves, boxes);
        });
        let mut levels: Vec<Vec<Node>> = Vec::new();
        while boxes.len() > 1 || levels.is_empty() {
            let below: Vec<&[Aabb]> = boxes.chunks(WIDTH).collect();
            let nodes = parallel::map(below.len(), parallel::QUICK, |n| Node::new(below[n]));
            boxes = parallel::map(below.len(), parallel::QUICK, |n| Aabb::union(below[n]));
            levels.push(nodes);
            if boxes.is_empty() {
                break;
            }
        }
        Index { count: positions.len(), leaves, levels }
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Fills `out` with the `min(k, N)` points nearest to `query`, sorted by (distance, index). A point at the query itself
    /// counts like any other.
    pub fn nearest(&self, query: [f64; 3], k: usize, out: &mut Vec<Found>) {
        out.clear();
        if k == 0 {
            return;
        }
        self.visit(query, f64::INFINITY, |found| {
            if out.len() == k {
                if out[k - 1].order(&found).is_lt() {
                    return out[k - 1].distance2;
                }
                out.pop();
            }
            let place = out.partition_point(|o| o.order(&found).is_lt());
            out.insert(place, found);
            if out.len() == k { out[k - 1].distance2 } else { f64::INFINITY }
        });
    }

    /// Fills `out` with all points within `radius` of `query`, the bound included, sorted by (distance, index).
    pub fn within(&self, query: [f64; 3], radius: f64, out: &mut Vec<Found>) {
        out.clear();
        let bound = radius * radius;
        self.visit(query, bound, |found| {
            if found.distance2 <= bound {
                out.push(found);
            }
            bound
        });
        out.sort_unstable_by(Found::order);
    }

    /// Passes all points within `radius` of `query`, the bound included, to `take`, in an order that depends on the points alone.
    pub fn around(&self, query: [f64; 3], radius: f64, mut take: impl FnMut(Found)) {
        if !self.is_empty() {
            self.descend(query, radius * radius, self.levels.len(), 0, &mut |found| {
                take(found);
                true
            });
        }
    }

    /// As `around`, but ends where there are more than `most` points, and then is false.
    pub(crate) fn around_at_most(
        &self,
        query: [f64; 3],
        radius: f64,
        most: usize,
        mut take: impl FnMut(Found),
    ) -> bool {
        let mut left = most;
        let mut take = |found| {
            let more = left > 0;
            if more {
                left -= 1;
                take(found);
            }
            more
        };
        self.is_empty() || self.descend(query, radius * radius, self.levels.len(), 0, &mut take)
    }

    /// Passes the points within the squared distance `bound` below an entry of a level to `take`, until it is false: then this is
    /// false, too. Level 0 are the leaves.
    fn descend(
        &self,
        query: [f64; 3],
        bound: f64,
        level: usize,
        entry: usize,
        take: &mut impl FnMut(Found) -> bool,
    ) -> bool {
        let Some(below) = level.checked_sub(1) else {
            let leaf = &self.leaves[entry];
            let mut lanes = leaf.distances2(query).into_iter().zip(leaf.id);
            return lanes.all(|(distance2, index)| {
                !(distance2 <= bound && distance2 < f64::INFINITY) || take(Found { distance2, index })
            });
        };
        let mut children = self.levels[below][entry].distances2(query).into_iter().enumerate();
        children.all(|(child, d)| {
            !(d <= bound && d < f64::INFINITY)
                || self.descend(query, bound, below, entry * WIDTH + child, take)
        })
    }

    /// Passes every point that can be within the squared distance `bound` to `take`, near boxes first; `take` returns the new
    /// bound.
    fn visit(&self, query: [f64; 3], mut bound: f64, mut take: impl FnMut(Found) -> f64) {
        let top = self.levels.len().saturating_sub(1);
        let mut stack: Vec<(f64, usize, u32)> = vec![(0.0, top + 1, 0)];
        while let Some((distance2, level, entry)) = stack.pop() {
            if distance2 > bound {
                continue;
            }
            if level == 0 {
                let Some(leaf) = self.leaves.get(entry as usize) else { continue };
                let near = leaf.distances2(query);
                for (lane, &distance2) in near.iter().enumerate() {
                    if distance2 <= bound && distance2 < f64::INFINITY {
                        bound = take(Found { distance2, index: leaf.id[lane] });
                    }
                }
                continue;
            }
            let Some(node) = self.levels.get(level - 1).and_then(|l| l.get(entry as usize)) else { continue };
            let near = node.distances2(query);
            let first = stack.len();
            for (child, &d) in near.iter().enumerate() {
                if d <= bound && d < f64::INFINITY {
                    stack.push((d, level - 1, entry * WIDTH as u32 + child as u32));
                }
            }
            stack[first..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(b.2.cmp(&a.2)));
        }
    }
}
