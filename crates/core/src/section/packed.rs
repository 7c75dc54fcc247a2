//! A tree over points that come in runs beside each other, as the samples of a slab do tile by tile: eight in a row are a
//! leaf, eight leaves in a row a node, so that nothing needs to be sorted.

/// Points of a leaf and children of a node.
const WIDTH: usize = 8;

/// Points in the plane; queries report indices into the slice it was built from. Any order gives the same points found; the
/// farther apart points in a row lie, the slower.
pub(crate) struct Packed {
    count: usize,
    leaves: Vec<Leaf>,
    /// `[0]` are the nodes over the leaves, the last level is one node: child `c` of node `n` is the entry `8 n + c` of the
    /// level below.
    levels: Vec<Vec<Node>>,
}

/// Eight points, coordinate by coordinate; empty places are infinitely far.
struct Leaf([[f64; WIDTH]; 2]);

/// The boxes of eight children; those without a child are infinitely far.
struct Node {
    min: [[f64; WIDTH]; 2],
    max: [[f64; WIDTH]; 2],
}

/// Least and greatest coordinates.
#[derive(Clone, Copy)]
struct Bounds {
    min: [f64; 2],
    max: [f64; 2],
}

impl Packed {
    /// Over finite points.
    pub(crate) fn new(points: &[[f64; 2]]) -> Self {
        let leaves = points.chunks(WIDTH).map(Leaf::new).collect();
        let mut bounds: Vec<Bounds> = points.chunks(WIDTH).map(Bounds::of).collect();
        let mut levels: Vec<Vec<Node>> = Vec::new();
        while bounds.len() > 1 || levels.is_empty() {
            levels.push(bounds.chunks(WIDTH).map(Node::new).collect());
            bounds = bounds.chunks(WIDTH).map(Bounds::union).collect();
        }
        Self { count: points.len(), leaves, levels }
    }

    /// Fills `found` with every point within `radius` of `centre`, the border included, ascending.
    pub(crate) fn within(&self, centre: [f64; 2], radius: f64, found: &mut Vec<u32>) {
        found.clear();
        if self.count > 0 {
            self.descend(self.levels.len() - 1, 0, centre, radius * radius, found);
        }
    }

    fn descend(&self, level: usize, entry: usize, centre: [f64; 2], radius2: f64, found: &mut Vec<u32>) {
        let mut near = self.levels[level][entry].within(centre, radius2);
        while near != 0 {
            let child = entry * WIDTH + near.trailing_zeros() as usize;
            near &= near - 1;
            if level > 0 {
                self.descend(level - 1, child, centre, radius2, found);
            } else {
                self.leaves[child].find(child * WIDTH, centre, radius2, found);
            }
        }
    }
}

impl Leaf {
    fn new(points: &[[f64; 2]]) -> Self {
        let mut leaf = Self([[f64::INFINITY; WIDTH]; 2]);
        for (place, point) in points.iter().enumerate() {
            (0..2).for_each(|axis| leaf.0[axis][place] = point[axis]);
        }
        leaf
    }

    fn find(&self, first: usize, centre: [f64; 2], radius2: f64, found: &mut Vec<u32>) {
        let [x, y] = &self.0;
        // Without a branch for each point, which no processor would guess.
        let (mut near, mut count) = ([0; WIDTH], 0);
        for place in 0..WIDTH {
            let (dx, dy) = (x[place] - centre[0], y[place] - centre[1]);
            near[count] = (first + place) as u32;
            count += usize::from(dx * dx + dy * dy <= radius2);
        }
        found.extend_from_slice(&near[..count]);
    }
}

impl Node {
    fn new(children: &[Bounds]) -> Self {
        let mut node = Node { min: [[f64::INFINITY; WIDTH]; 2], max: [[f64::INFINITY; WIDTH]; 2] };
        for (c, child) in children.iter().enumerate() {
            for axis in 0..2 {
                node.min[axis][c] = child.min[axis];
                node.max[axis][c] = child.max[axis];
            }
        }
        node
    }

    /// The children whose boxes reach within the radius, a bit each. Every step is monotone, rounding included, so that no box
    /// is farther than a point in it.
    fn within(&self, centre: [f64; 2], radius2: f64) -> u32 {
        let gap = |axis: usize, c: usize| {
            let (below, above) = (self.min[axis][c] - centre[axis], centre[axis] - self.max[axis][c]);
            let gap = if below > above { below } else { above };
            if gap > 0.0 { gap } else { 0.0 }
        };
        let apart: [f64; WIDTH] = std::array::from_fn(|c| {
            let (dx, dy) = (gap(0, c), gap(1, c));
            dx * dx + dy * dy
        });
        apart.iter().enumerate().fold(0, |near, (c, &d)| near | u32::from(d <= radius2) << c)
    }
}

impl Bounds {
    fn of(points: &[[f64; 2]]) -> Self {
        let all = points.iter().map(|&p| Bounds { min: p, max: p });
        all.reduce(Bounds::join).expect("a chunk is not empty")
    }

    fn union(bounds: &[Bounds]) -> Self {
        bounds.iter().copied().reduce(Bounds::join).expect("a chunk is not empty")
    }

    fn join(self, other: Bounds) -> Bounds {
        let join = |f: fn(f64, f64) -> f64, a: [f64; 2], b: [f64; 2]| [f(a[0], b[0]), f(a[1], b[1])];
        Bounds { min: join(f64::min, self.min, other.min), max: join(f64::max, self.max, other.max) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_a_plain_search_finds() {
        for count in [0, 1, 8, 9, 64, 65, 500, 5000] {
            let point = |i: usize| [(i * 7919 % 101) as f64, (i / 7) as f64];
            let points: Vec<[f64; 2]> = (0..count).map(point).collect();
            let (packed, mut found) = (Packed::new(&points), Vec::new());
            for centre in [[50.0, 3.0], [-3.0, 0.0], [20.0, 200.0]] {
                for radius in [0.0, 11.0, 1e3] {
                    packed.within(centre, radius, &mut found);
                    let apart = |p: [f64; 2]| {
                        (p[0] - centre[0]) * (p[0] - centre[0]) + (p[1] - centre[1]) * (p[1] - centre[1])
                    };
                    let near = |&i: &u32| apart(points[i as usize]) <= radius * radius;
                    assert_eq!(found, (0..count as u32).filter(near).collect::<Vec<u32>>());
                }
            }
        }
    }
}
