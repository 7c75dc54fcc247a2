//! Blocks with rectangular pockets and holes: prisms over more than one outline.

use super::polyhedron::polyhedron;
use crate::shapes::shape::Shape;

/// A rectangle taken out of the top of a block, down by `depth`.
struct Pocket {
    low: [f64; 2],
    high: [f64; 2],
    depth: f64,
}

/// A block of 5 by 3 by 2 with two like pockets, mirrored in its middle, 1.2 deep.
pub fn pocketed_block() -> Shape {
    let depth = 1.2;
    let left = Pocket { low: [0.5, 0.8], high: [1.9, 2.3], depth };
    let right = Pocket { low: [3.1, 0.8], high: [4.5, 2.3], depth };
    pocketed("pocketed block", [5.0, 3.0, 2.0], &[left, right])
}

/// A plate of 4 by 3 by 0.9 with a square hole of edge 1.3.
pub fn punched_plate() -> Shape {
    pocketed("punched plate", [4.0, 3.0, 0.9], &[Pocket { low: [1.2, 0.9], high: [2.5, 2.2], depth: 0.9 }])
}

/// A block from the origin with pockets that keep clear of each other and of the rim; one as deep as the block is a hole.
fn pocketed(name: &'static str, size: [f64; 3], pockets: &[Pocket]) -> Shape {
    let mut corners = ring([0.0; 2], [size[0], size[1]], 0.0);
    corners.extend(ring([0.0; 2], [size[0], size[1]], size[2]));
    let mut faces: Vec<Vec<u32>> = (0..4).map(|i| vec![i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i]).collect();
    // Seams lead from a corner of the rim to each pocket and back.
    let (mut top, mut bottom) = (vec![4], vec![0]);
    for (pocket, base) in pockets.iter().zip((8..).step_by(8)) {
        let floor = size[2] - pocket.depth;
        corners.extend(ring(pocket.low, pocket.high, floor));
        corners.extend(ring(pocket.low, pocket.high, size[2]));
        faces.extend((0..4).map(|i| (base + i, base + (i + 1) % 4)).map(|(a, b)| vec![b, a, a + 4, b + 4]));
        top.extend([4, 7, 6, 5, 4].map(|i| base + i).into_iter().chain([4]));
        if floor > 0.0 {
            faces.push((base..base + 4).collect());
        } else {
            bottom.extend([0, 1, 2, 3, 0].map(|i| base + i).into_iter().chain([0]));
        }
    }
    top.extend([5, 6, 7]);
    bottom.extend([3, 2, 1]);
    faces.extend([top, bottom]);
    let outlines: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    polyhedron(name, &corners, &outlines)
}

/// The corners of a rectangle at one height, turning left.
fn ring(low: [f64; 2], high: [f64; 2], z: f64) -> Vec<[f64; 3]> {
    vec![[low[0], low[1], z], [high[0], low[1], z], [high[0], high[1], z], [low[0], high[1], z]]
}
