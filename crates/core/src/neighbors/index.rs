//! The search structure: leaves of 16 points under a 16-wide implicit hierarchy of bounding boxes.
//!
//! Blocks of consecutive points, which Morton order keeps together, are divided into leaves like a k-d tree (`split`).
//! That costs 30 ns a point; leaves of sixteen consecutive points, tried first, have looser boxes, and searching them
//! costs 70 ns a point more.

use rayon::prelude::*;

use super::{BLOCK, Found, split};

/// Points in a leaf and children of a node.
pub(crate) const WIDTH: usize = 16;

/// A search structure over a set of points, for queries at any place.
#[derive(Clone, Debug, Default)]
pub struct Index {
    pub(super) count: usize,
    pub(crate) leaves: Vec<Leaf>,
    /// `[0]` are the nodes over the leaves, the last level is one node: child `c` of node `n` is the entry
    /// `16 n + c` of the level below.
    pub(super) levels: Vec<Vec<Node>>,
}

/// Sixteen points, coordinate by coordinate. Places that no point fills are infinitely far.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Leaf {
    pub(crate) at: [[f64; WIDTH]; 3],
    pub(super) id: [u32; WIDTH],
}

/// The bounding boxes of sixteen children. Those without a child are empty: infinitely far from everything.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(super) struct Node {
    pub(super) min: [[f64; WIDTH]; 3],
    pub(super) max: [[f64; WIDTH]; 3],
}

/// An axis-aligned box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aabb {
    pub(super) min: [f64; 3],
    pub(super) max: [f64; 3],
}

impl Index {
    /// Over `positions`, `(N, 3)` f64, finite, less than 1e150 apart. In canonical order leaves are compact and
    /// searches fast; any other order gives the same results.
    pub fn build(positions: &[[f64; 3]]) -> Index {
        let count = positions.len().div_ceil(WIDTH);
        // Filled by all threads, since the first touch of new memory is what costs.
        let mut leaves: Vec<Leaf> = (0..count).into_par_iter().map(|_| Leaf::EMPTY).collect();
        let mut boxes = vec![Aabb::EMPTY; count];
        let blocks = positions.par_chunks(BLOCK).zip(leaves.par_chunks_mut(BLOCK / WIDTH));
        let blocks = blocks.zip(boxes.par_chunks_mut(BLOCK / WIDTH)).enumerate();
        blocks.for_each(|(b, ((points, leaves), boxes))| {
            split::leaves(points, (b * BLOCK) as u32, leaves, boxes);
        });
        let mut levels: Vec<Vec<Node>> = Vec::new();
        while boxes.len() > 1 || levels.is_empty() {
            let nodes: Vec<Node> = boxes.par_chunks(WIDTH).map(Node::new).collect();
            boxes = boxes.par_chunks(WIDTH).map(Aabb::union).collect();
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

    /// The `min(k, N)` points nearest to `query`, sorted by (distance, index), into `out`. A point at the query
    /// itself counts like any other.
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

    /// All points within `radius` of `query`, the bound included, sorted by (distance, index), into `out`.
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

    /// Hands every point that can be within the squared distance `bound` to `take`, near boxes first; `take`
    /// returns the bound from then on.
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

impl Leaf {
    pub(super) const EMPTY: Leaf = Leaf { at: [[f64::INFINITY; WIDTH]; 3], id: [u32::MAX; WIDTH] };

    /// Fills its places with points and their indices; returns the box around them.
    pub(super) fn fill(&mut self, points: impl Iterator<Item = (u32, [f64; 3])>) -> Aabb {
        let mut around = Aabb::EMPTY;
        for (lane, (id, at)) in points.enumerate() {
            (0..3).for_each(|a| self.at[a][lane] = at[a]);
            self.id[lane] = id;
            around = around.join(&Aabb { min: at, max: at });
        }
        around
    }

    /// The indices of its points, place by place.
    pub(crate) fn ids(&self) -> impl Iterator<Item = u32> + Clone {
        self.id.iter().copied().take_while(|&id| id != u32::MAX)
    }

    /// Its points with their indices, place by place.
    pub(crate) fn points(&self) -> impl Iterator<Item = (u32, [f64; 3])> + Clone {
        self.ids().enumerate().map(|(lane, id)| (id, self.point(lane)))
    }

    /// The number of its points.
    pub(crate) fn len(&self) -> usize {
        // Nearly all are full.
        if self.id[WIDTH - 1] != u32::MAX { WIDTH } else { self.ids().count() }
    }

    /// The components of its points along a vector, place by place; those of empty places mean nothing.
    #[inline]
    pub(crate) fn along(&self, vector: [f64; 3]) -> [f64; WIDTH] {
        let ([x, y, z], [u, v, w]) = (&self.at, vector);
        let mut out = [0.0; WIDTH];
        for i in 0..WIDTH {
            out[i] = u * x[i] + v * y[i] + w * z[i];
        }
        out
    }

    /// The point in place `lane`.
    pub(super) fn point(&self, lane: usize) -> [f64; 3] {
        [0, 1, 2].map(|a| self.at[a][lane])
    }

    /// Squared distances of the points from `q`; infinite in empty places.
    #[inline(always)]
    pub(crate) fn distances2(&self, q: [f64; 3]) -> [f64; WIDTH] {
        let [x, y, z] = &self.at;
        let mut out = [0.0; WIDTH];
        for i in 0..WIDTH {
            let (dx, dy, dz) = (x[i] - q[0], y[i] - q[1], z[i] - q[2]);
            out[i] = dx * dx + dy * dy + dz * dz;
        }
        out
    }
}

impl Node {
    fn new(children: &[Aabb]) -> Node {
        let mut node = Node { min: [[f64::INFINITY; WIDTH]; 3], max: [[f64::NEG_INFINITY; WIDTH]; 3] };
        for (c, child) in children.iter().enumerate() {
            for a in 0..3 {
                node.min[a][c] = child.min[a];
                node.max[a][c] = child.max[a];
            }
        }
        node
    }

    /// Squared distances of the children's boxes from `q`, never above that of a point inside: every step is
    /// monotone, rounding included.
    #[inline]
    pub(super) fn distances2(&self, q: [f64; 3]) -> [f64; WIDTH] {
        let gap = |a: usize, i: usize| {
            let (below, above) = (self.min[a][i] - q[a], q[a] - self.max[a][i]);
            let gap = if below > above { below } else { above };
            if gap > 0.0 { gap } else { 0.0 }
        };
        std::array::from_fn(|i| {
            let (dx, dy, dz) = (gap(0, i), gap(1, i), gap(2, i));
            dx * dx + dy * dy + dz * dz
        })
    }
}

impl Aabb {
    pub(super) const EMPTY: Aabb = Aabb { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    fn union(boxes: &[Aabb]) -> Aabb {
        boxes.iter().fold(Aabb::EMPTY, |b, c| b.join(c))
    }

    pub(super) fn join(self, other: &Aabb) -> Aabb {
        let less = |a: f64, b: f64| if b < a { b } else { a };
        let more = |a: f64, b: f64| if b > a { b } else { a };
        Aabb {
            min: std::array::from_fn(|a| less(self.min[a], other.min[a])),
            max: std::array::from_fn(|a| more(self.max[a], other.max[a])),
        }
    }
}
