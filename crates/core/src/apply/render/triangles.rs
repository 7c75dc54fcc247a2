//! Triangles of a mesh as the surface.

use super::camera::Camera;
use super::depth_buffer::DepthBuffer;
use super::scene::Triangles;
use super::surfel::Projected;
use crate::math::vec3::{cross, sub, unit};
use crate::parallel;

/// Rows that one task fills.
const BAND: usize = 32;

/// The triangles as `camera` sees them, and the depth of the nearest at every pixel, the lower index among equals.
pub(super) fn draw(
    mesh: Triangles,
    camera: &Camera,
    width: usize,
    height: usize,
) -> (Vec<Projected>, DepthBuffer) {
    let corners = parallel::map(mesh.triangles.len(), parallel::QUICK, |i| {
        mesh.triangles[i].map(|v| camera.project(mesh.vertices[v as usize]))
    });
    let facets = parallel::map(mesh.triangles.len(), parallel::QUICK, |i| {
        let [a, b, c] = mesh.triangles[i].map(|v| mesh.vertices[v as usize]);
        facet(corners[i], camera.rotate(unit(cross(sub(b, a), sub(c, a)))))
    });
    let mut surface = DepthBuffer::draw(&[], width, height);
    let mut bands = vec![Vec::new(); height.div_ceil(BAND)];
    for (id, triangle) in corners.iter().enumerate() {
        if let Some([first, last]) = rows(triangle, 0, height) {
            bands[first / BAND..=last / BAND].iter_mut().for_each(|band| band.push(id as u32));
        }
    }
    let depths = surface.depth.chunks_mut(BAND * width);
    let pixels = depths.zip(surface.surfel.chunks_mut(BAND * width));
    parallel::each(pixels.zip(&bands), |band, ((depth, ids), members)| {
        for &id in members {
            fill(&corners[id as usize], id, band * BAND, width, depth, ids);
        }
    });
    (facets, surface)
}

/// A triangle for the shading: its middle, and its normal turned to the eye.
fn facet(corners: [[f32; 3]; 3], normal: [f64; 3]) -> Projected {
    let at = std::array::from_fn(|i| corners.iter().map(|c| c[i]).sum::<f32>() / 3.0);
    let sign = if normal[2] < 0.0 { -1.0 } else { 1.0 };
    Projected { at, center: at, normal: normal.map(|x| (sign * x) as f32), radius: 0.0 }
}

/// The first and the last row from `top` to before `bottom` whose middles may lie in a triangle.
fn rows(corners: &[[f32; 3]; 3], top: usize, bottom: usize) -> Option<[usize; 2]> {
    let [low, high] = range(corners.map(|c| c[1]));
    let first = (low - 0.5).ceil().max(top as f32);
    let last = (high - 0.5).floor().min(bottom as f32 - 1.0);
    (first <= last).then_some([first as usize, last as usize])
}

fn range(values: [f32; 3]) -> [f32; 2] {
    values.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], &v| [low.min(v), high.max(v)])
}

/// Fills the pixels of a triangle in a band that begins at row `top`.
fn fill(corners: &[[f32; 3]; 3], id: u32, top: usize, width: usize, depth: &mut [f32], ids: &mut [u32]) {
    let Some([first, last]) = rows(corners, top, top + depth.len() / width) else { return };
    let heights = range(corners.map(|c| c[2]));
    for y in first..=last {
        let Some([from, to]) = chord(corners, y as f32 + 0.5) else { continue };
        let start = (from[0] - 0.5).ceil().max(0.0) as usize;
        let end = ((to[0] + 0.5).floor().max(0.0) as usize).min(width);
        let slope = if to[0] > from[0] { (to[1] - from[1]) / (to[0] - from[0]) } else { 0.0 };
        for x in start..end {
            let z = from[1] + slope * (x as f32 + 0.5 - from[0]);
            let z = z.clamp(heights[0], heights[1]);
            let i = (y - top) * width + x;
            if z > depth[i] {
                (depth[i], ids[i]) = (z, id);
            }
        }
    }
}

/// The ends, from the left to the right, of what a triangle covers of the row at `y`: x and depth of each.
fn chord(corners: &[[f32; 3]; 3], y: f32) -> Option<[[f32; 2]; 2]> {
    let mut ends: Option<[[f32; 2]; 2]> = None;
    for k in 0..3 {
        // From the upper end to the lower one, so that triangles that share an edge find the same place on it.
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        let [a, b] = if a[1] <= b[1] { [a, b] } else { [b, a] };
        if !(a[1] <= y && y < b[1]) {
            continue;
        }
        let t = (y - a[1]) / (b[1] - a[1]);
        let at = [a[0] + t * (b[0] - a[0]), a[2] + t * (b[2] - a[2])];
        ends = Some(match ends {
            None => [at, at],
            Some([from, to]) if at[0] < from[0] => [at, to],
            Some([from, _]) => [from, at],
        });
    }
    ends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_of_two_triangles_covers_each_pixel_at_its_depth() {
        let vertices = [[0.0, 0.0, 0.0], [10.0, 0.0, 5.0], [10.0, 10.0, 5.0], [0.0, 10.0, 0.0]];
        let mesh = Triangles { vertices: &vertices, triangles: &[[0, 1, 2], [2, 0, 3]] };
        let camera = Camera::looking([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
        let camera = camera.fitted(vertices.into_iter(), 24.0, 24.0, 2.0);
        let (facets, surface) = draw(mesh, &camera, 24, 24);
        assert!(facets.iter().all(|f| f.normal[2] > 0.8));
        let covered = surface.surfel.iter().filter(|&&id| id != u32::MAX).count();
        assert_eq!(covered, 20 * 20);
        let slope = surface.at(15.5, 9.5) - surface.at(5.5, 9.5);
        assert!((slope - 5.0).abs() < 1e-4, "{slope}");
    }
}
