//! Cubes: exact, on the papers' grid, and Gumhold's random one.

use super::blocks::cuboid;
use crate::shapes::random::Rng;
use crate::shapes::sampling::{Noise, Sampled, Sampling, Scan};
use crate::shapes::shape::Shape;

/// A cube centred at the origin.
pub fn cube(edge: f64) -> Shape {
    Shape { name: "cube", ..cuboid([edge; 3]) }
}

/// The unit cube on a grid of 9 by 9 points on each face, shared along the edges: 386 points, 92 of them on edges.
pub fn cube_386() -> Sampled {
    cube(1.0).sample(&Scan::new(Sampling::Grid { step: 0.125 }))
}

/// Gumhold's random cube (2001, section 4.1 and table 1, where `count` is 10,000): points uniform in the volume
/// between the cubes of edge 2 and 1.6 about the origin. The truth is the cube of edge 1.8 halfway, `faces` those of
/// the nearest sides, and `clean` the points themselves: as there is no noise-free cloud, the spacing is theirs.
pub fn random_cube(seed: u64, count: usize) -> Sampled {
    let mut rng = Rng::new(seed);
    let mut points = Vec::with_capacity(count);
    while points.len() < count {
        let p = [(); 3].map(|()| rng.between(-1.0, 1.0));
        if p.iter().any(|x| x.abs() > 0.8) {
            points.push(p);
        }
    }
    let faces = points.iter().map(side).collect();
    Sampled::new(points, faces, cube(1.8).network, Noise::None, &mut rng)
}

/// The face of a cube about the origin nearest to a point, in the order of `cuboid`: -x, x, -y, y, -z, z.
fn side(p: &[f64; 3]) -> u32 {
    let axis = (1..3).fold(0, |best, k| if p[k].abs() > p[best].abs() { k } else { best });
    2 * axis as u32 + u32::from(p[axis] > 0.0)
}
