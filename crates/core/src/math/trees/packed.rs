//! A tree over points in an order that keeps neighbours together, such as the samples of a slab tile by tile: eight points in a
//! row are a leaf, eight leaves in a row a node, so that nothing needs to be sorted.

/// Points of a leaf and children of a node.
const WIDTH: usize = 8;

/// Points in the plane under a tree; queries report indices into the slice from which it was built. Any order gives the same
/// results; the farther apart successive points lie, the slower the search.
pub(crate) struct Packed {
    count: usize,
    leaves: Vec<Leaf>,
    /// `[0]` are the nodes over the leaves, the last level is one node: child `c` of node `n` is the entry `8 n + c` of the
    /// level below.
    levels: Vec<Vec<Node>>,
}

/// Eight points, coordinate by coordinate; empty places are infinitely far.
struct Leaf([[f64; WIDTH]; 2]);

/// The boxes of eight children in single precision, rounded outwards: half the memory, and twice as many compared at a time.
/// Boxes without a child are infinitely far.
struct Node {
    min: [[f32; WIDTH]; 2],
    max: [[f32; WIDTH]; 2],
}

/// Least and greatest coordinates.
#[derive(Clone, Copy)]
struct Bounds {
    min: [f64; 2],
    max: [f64; 2],
}

impl Packed {
    /// Builds the tree over finite points.
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
            self.descend(self.levels.len() - 1, 0, &Ball::new(centre, radius), found);
        }
    }

    /// Whether the box of any leaf reaches within `radius` of `centre`; if not, no point lies there.
    pub(crate) fn any(&self, centre: [f64; 2], radius: f64) -> bool {
        self.count > 0 && self.reaches(self.levels.len() - 1, 0, &Ball::new(centre, radius))
    }

    fn descend(&self, level: usize, entry: usize, ball: &Ball, found: &mut Vec<u32>) {
        for child in self.near(level, entry, ball) {
            if level > 0 {
                self.descend(level - 1, child, ball, found);
            } else if let Some(leaf) = self.leaves.get(child) {
                leaf.find(child * WIDTH, ball, found);
            }
        }
    }

    fn reaches(&self, level: usize, entry: usize, ball: &Ball) -> bool {
        self.near(level, entry, ball).any(|child| level == 0 || self.reaches(level - 1, child, ball))
    }

    /// The children of a node whose boxes reach into a ball, as entries of the level below.
    fn near(&self, level: usize, entry: usize, ball: &Ball) -> impl Iterator<Item = usize> + use<> {
        let mut near = self.levels[level].get(entry).map_or(0, |node| node.within(ball));
        std::iter::from_fn(move || {
            let child = (near != 0).then(|| entry * WIDTH + near.trailing_zeros() as usize);
            near &= near.wrapping_sub(1);
            child
        })
    }
}

/// The region searched: points within a radius, and the same for boxes, with room for rounding.
struct Ball {
    centre: [f64; 2],
    radius2: f64,
    middle: [f32; 2],
    reach2: f32,
}

impl Ball {
    fn new(centre: [f64; 2], radius: f64) -> Self {
        let middle = centre.map(|x| x as f32);
        // An f32 lies within 2^-24 of a number, and every step below rounds as much.
        let reach = radius as f32 + (radius as f32 + middle[0].abs() + middle[1].abs()) * 4e-7;
        Self { centre, radius2: radius * radius, middle, reach2: reach * reach * 1.000_001 }
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

    fn find(&self, first: usize, ball: &Ball, found: &mut Vec<u32>) {
        let ([x, y], [u, v]) = (&self.0, ball.centre);
        // Without a branch for each point, which no processor would guess.
        let (mut near, mut count) = ([0; WIDTH], found.len());
        for place in 0..WIDTH {
            let (dx, dy) = (x[place] - u, y[place] - v);
            near[count - found.len()] = (first + place) as u32;
            count += usize::from(dx * dx + dy * dy <= ball.radius2);
        }
        // All of them, as to copy a number that is known takes no loop.
        found.extend_from_slice(&near);
        found.truncate(count);
    }
}

impl Node {
    fn new(children: &[Bounds]) -> Self {
        let mut node = Node { min: [[f32::INFINITY; WIDTH]; 2], max: [[f32::INFINITY; WIDTH]; 2] };
        for (c, child) in children.iter().enumerate() {
            for axis in 0..2 {
                node.min[axis][c] = (child.min[axis] as f32).next_down();
                node.max[axis][c] = (child.max[axis] as f32).next_up();
            }
        }
        node
    }

    /// The children whose boxes reach into a ball, a bit each, and perhaps some that miss it by rounding.
    fn within(&self, ball: &Ball) -> u32 {
        let gap = |axis: usize, c: usize| {
            let (below, above) =
                (self.min[axis][c] - ball.middle[axis], ball.middle[axis] - self.max[axis][c]);
            let gap = if below > above { below } else { above };
            if gap > 0.0 { gap } else { 0.0 }
        };
        let mut apart = [0.0; WIDTH];
        for c in 0..WIDTH {
            let (dx, dy) = (gap(0, c), gap(1, c));
            apart[c] = dx * dx + dy * dy;
        }
        apart.iter().enumerate().fold(0, |near, (c, &d)| near | u32::from(d <= ball.reach2) << c)
    }
}

impl Bounds {
    const EMPTY: Bounds = Bounds { min: [f64::INFINITY; 2], max: [f64::NEG_INFINITY; 2] };

    fn of(points: &[[f64; 2]]) -> Self {
        let all = points.iter().map(|&p| Bounds { min: p, max: p });
        all.fold(Bounds::EMPTY, Bounds::join)
    }

    fn union(bounds: &[Bounds]) -> Self {
        bounds.iter().copied().fold(Bounds::EMPTY, Bounds::join)
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
                for radius in [0.0, 11.0, 1e3, 1e25] {
                    packed.within(centre, radius, &mut found);
                    let apart = |p: [f64; 2]| {
                        (p[0] - centre[0]) * (p[0] - centre[0]) + (p[1] - centre[1]) * (p[1] - centre[1])
                    };
                    let near = |&i: &u32| apart(points[i as usize]) <= radius * radius;
                    assert_eq!(found, (0..count as u32).filter(near).collect::<Vec<u32>>());
                    assert!(found.is_empty() || packed.any(centre, radius));
                }
            }
        }
    }
}
