//! Leaves of sixteen points, nodes of sixteen boxes, and the boxes.

/// Points that are searched together; the last block of a cloud may have fewer.
pub const BLOCK: usize = 1024;

/// Points in a leaf and children of a node.
pub(crate) const WIDTH: usize = 16;

/// Sixteen points, coordinate by coordinate. Empty places are infinitely far.
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

    /// The components of its points along a vector, place by place; those of empty places are arbitrary.
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
    pub(super) fn new(children: &[Aabb]) -> Node {
        let mut node = Node { min: [[f64::INFINITY; WIDTH]; 3], max: [[f64::NEG_INFINITY; WIDTH]; 3] };
        for (c, child) in children.iter().enumerate() {
            for a in 0..3 {
                node.min[a][c] = child.min[a];
                node.max[a][c] = child.max[a];
            }
        }
        node
    }

    /// Squared distances of the children's boxes from `q`, never greater than the distance of a point inside: every step is
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

    pub(super) fn union(boxes: &[Aabb]) -> Aabb {
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
