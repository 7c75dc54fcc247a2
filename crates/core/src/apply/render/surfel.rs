//! Surfels: points as small discs.

use super::camera::Camera;
use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::math::eigen3::eigen3;
use crate::math::tensor::scatter;
use crate::math::vec3::{add, add_scaled, distance, dot, norm, scale, sub};
use crate::neighbors::{BLOCK, mean_distance, nearest_blocks};
use crate::parallel;

/// A point with the disc that represents its part of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfel {
    /// The index of the point in the input.
    pub source: u32,
    /// World frame.
    pub position: [f64; 3],
    /// Middle of the disc, world frame: the point itself except at borders and edges.
    pub center: [f64; 3],
    /// Unit normal, either sign; zero if none is known, in which case the disc faces the eye.
    pub normal: [f32; 3],
    /// Radius, large enough to close the gaps to the neighbours, in the unit of the points.
    pub radius: f64,
}

/// Number of neighbours to which the normal is fitted.
const NEIGHBORS: usize = 16;
/// Rank of the neighbour up to which the radius reaches: two steps of a square grid; on a surface of random points one place in
/// 20,000 is left uncovered.
const RADIUS_RANK: usize = 10;
/// Distances of the middle of the neighbours from the point, in radii, at which a border becomes possible and certain: half a
/// disc has its middle at 0.42 radii, random points in a whole disc seldom beyond 0.25.
const BORDER_LEAN: [f64; 2] = [0.22, 0.38];
/// The same across the fitted plane: half a disc on either side of a right angle has its middle 0.3 radii below.
const EDGE_LEAN: [f64; 2] = [0.08, 0.2];
/// Greatest radius of a disc, in median radii: larger discs are those of outliers.
const GREATEST_RADIUS: f64 = 4.0;

/// The discs of the finite, distinct points of a cloud, or of `(N, 3)` positions held elsewhere, and their mean spacing (the mean
/// distance to the six nearest). Both in the world frame and its unit.
///
/// # Errors
/// Those of [`Frame::localise`].
pub fn surfels(world: &(impl AsRef<[[f64; 3]]> + ?Sized)) -> Result<(Vec<Surfel>, f64), Error> {
    Ok(all(&Frame::of_points(world.as_ref())?.with_spacing()?))
}

fn all(local: &Localised) -> (Vec<Surfel>, f64) {
    let points = &local.positions;
    let k = NEIGHBORS.min(points.len().saturating_sub(1));
    let blocks = nearest_blocks(points, k, |first, lists| {
        let members = first..points.len().min(first + BLOCK);
        let rows = members.zip(lists.chunks_exact(k));
        rows.map(|(i, near)| (disc(points, i, near), mean_distance(points, i, &near[..near.len().min(6)])))
            .collect::<Vec<_>>()
    });
    let mut discs: Vec<(Surfel, f64)> = blocks.into_iter().flatten().collect();
    if k == 0 {
        discs = points.iter().map(|&position| (disc_alone(position), 1.0)).collect();
    }
    let spacing = discs.iter().map(|d| d.1).sum::<f64>() / discs.len().max(1) as f64;
    let limit = GREATEST_RADIUS * median(discs.iter().map(|d| d.0.radius).collect());
    let to_world = |i: usize, s: &Surfel| Surfel {
        source: local.source[i],
        position: local.frame.to_world(s.position),
        center: local.frame.to_world(s.center),
        radius: s.radius.min(limit) * local.frame.scale,
        ..*s
    };
    (parallel::map(discs.len(), parallel::QUICK, |i| to_world(i, &discs[i].0)), spacing * local.frame.scale)
}

/// The disc of a point without neighbours.
fn disc_alone(position: [f64; 3]) -> Surfel {
    Surfel { source: 0, position, center: position, normal: [0.0; 3], radius: 1.0 }
}

/// The disc of point `i`, in the plane fitted to it and its neighbours. At a border or an edge, where neighbours lie on one side
/// only, the disc moves to their middle and shrinks by the same amount, so that it does not stick out.
fn disc(points: &[[f64; 3]], i: usize, near: &[u32]) -> Surfel {
    let own = points[i];
    let axes = eigen3(&correlation(points, own, near));
    let is_flat = axes.values[1] > 1e-12 * axes.values[2];
    let normal = if is_flat { axes.vectors[0].map(|x| x as f32) } else { [0.0; 3] };
    let close = &near[..RADIUS_RANK.min(near.len())];
    let reach = distance(own, points[close[close.len() - 1] as usize]);
    let lean = mean_offset(points, own, close);
    let across = dot(lean, normal.map(f64::from)).abs();
    let along = (dot(lean, lean) - across * across).max(0.0).sqrt();
    let lean = scale(lean, ramp(along / reach, BORDER_LEAN).max(ramp(across / reach, EDGE_LEAN)));
    let radius = (reach - norm(lean)).max(0.3 * reach);
    Surfel { source: i as u32, position: own, center: add(own, lean), normal, radius }
}

/// A ramp: 0 up to the first bound, 1 from the second on.
fn ramp(value: f64, [low, high]: [f64; 2]) -> f64 {
    ((value - low) / (high - low)).clamp(0.0, 1.0)
}

/// Mean offset of the neighbours and of the point itself, whose offset is zero.
fn mean_offset(points: &[[f64; 3]], own: [f64; 3], near: &[u32]) -> [f64; 3] {
    let share = 1.0 / (near.len() + 1) as f64;
    near.iter().fold([0.0; 3], |sum, &j| add_scaled(sum, sub(points[j as usize], own), share))
}

/// Correlation tensor of a point and its neighbours, `[xx, xy, xz, yy, yz, zz]`.
fn correlation(points: &[[f64; 3]], own: [f64; 3], near: &[u32]) -> [f64; 6] {
    let mean = mean_offset(points, own, near);
    let offsets = near.iter().map(|&j| sub(points[j as usize], own));
    scatter(offsets.chain([[0.0; 3]]).map(|d| sub(d, mean)))
}

fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

impl Surfel {
    /// The surfel as `camera` sees it.
    pub(super) fn project(&self, camera: &Camera) -> Projected {
        let [x, y, z] = camera.rotate(self.normal.map(f64::from)).map(|x| x as f32);
        let normal = match z {
            z if z > 0.0 => [x, y, z],
            z if z < 0.0 => [-x, -y, -z],
            _ if x == 0.0 && y == 0.0 => [0.0, 0.0, 1.0],
            _ => [x, y, 0.0],
        };
        let radius = (self.radius * camera.scale) as f32;
        Projected { at: camera.project(self.position), center: camera.project(self.center), normal, radius }
    }
}

/// A surfel on the picture, in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projected {
    /// x to the right, y down, depth towards the eye.
    pub at: [f32; 3],
    /// Middle of the disc, likewise.
    pub center: [f32; 3],
    /// Unit normal in the axes of the picture (y up), turned to the eye.
    pub normal: [f32; 3],
    /// Radius in pixels.
    pub radius: f32,
}

/// Least cosine between the normal of a disc and the direction to the eye as drawn, so that it does not become a needle.
const LEAST_FACING: f32 = 0.15;

impl Projected {
    /// Change of depth on the disc for one pixel to the right and one pixel down.
    pub fn slope(&self) -> [f32; 2] {
        let facing = self.normal[2].max(LEAST_FACING);
        [-self.normal[0] / facing, self.normal[1] / facing]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Cloud;

    fn grid() -> Cloud {
        let row = |y: i32| (0..20).map(move |x| [1e6 + f64::from(x) * 0.5, f64::from(y) * 0.5, 7.0]);
        Cloud::new((0..20).flat_map(row).collect())
    }

    #[test]
    fn discs_of_a_plane_lie_in_it_and_reach_two_steps() {
        let (surfels, _) = surfels(&grid()).unwrap();
        assert_eq!(surfels.len(), 400);
        assert!(surfels.iter().all(|s| (s.normal[2].abs() - 1.0).abs() < 1e-6));
        let inner = surfels.iter().find(|s| s.position == [1e6 + 5.0, 5.0, 7.0]).unwrap();
        assert!((inner.radius - 1.0).abs() < 1e-6);
    }

    #[test]
    fn spacing_of_a_grid_is_its_step_and_a_little_more_for_the_six_nearest() {
        let (_, spacing) = surfels(&grid()).unwrap();
        assert!(spacing > 0.5 && spacing < 0.6, "{spacing}");
    }

    #[test]
    fn few_points_and_lines_have_discs_without_a_normal() {
        for count in 0..4 {
            let cloud = Cloud::new((0..count).map(|x| [f64::from(x), 0.0, 0.0]).collect());
            let (surfels, spacing) = surfels(&cloud).unwrap();
            assert_eq!(surfels.len(), count as usize);
            assert!(surfels.iter().all(|s| s.normal == [0.0; 3] && s.radius > 0.0));
            assert!(spacing.is_finite());
        }
    }
}
