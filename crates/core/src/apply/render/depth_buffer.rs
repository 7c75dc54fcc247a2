//! The depth of the nearest surfel at every pixel.

use super::surfel::Projected;
use crate::parallel;

/// Depth and surfel of the front surface, one value for each pixel.
pub(super) struct DepthBuffer {
    pub width: usize,
    pub height: usize,
    /// Depth in pixels, greater nearer; minus infinity where there is no surface.
    pub depth: Vec<f32>,
    /// Index of the visible surfel, `u32::MAX` where there is none.
    pub surfel: Vec<u32>,
}

/// Rows that one task fills.
const BAND: usize = 32;
/// Greatest radius of a disc in pixels, however sparse the cloud.
const GREATEST_RADIUS: f32 = 400.0;
/// Least radius of a disc in pixels: less would leave pixels between the centres of close points.
const LEAST_RADIUS: f32 = 0.75;

impl DepthBuffer {
    /// Draws the disc of every surfel; at each pixel the nearest counts, the lower index among equals.
    pub fn draw(surfels: &[Projected], width: usize, height: usize) -> Self {
        let mut surface = Self {
            width,
            height,
            depth: vec![f32::NEG_INFINITY; width * height],
            surfel: vec![u32::MAX; width * height],
        };
        let bands = bands_of(surfels, height);
        let depths = surface.depth.chunks_mut(BAND * width);
        let pixels = depths.zip(surface.surfel.chunks_mut(BAND * width));
        parallel::each(pixels.zip(&bands), |band, ((depth, ids), members)| {
            for &id in members {
                draw_disc(&surfels[id as usize], id, band * BAND, width, depth, ids);
            }
        });
        surface
    }

    /// Depth at a position on the picture; minus infinity outside and where there is no surface.
    pub fn at(&self, x: f32, y: f32) -> f32 {
        self.index(x, y).map_or(f32::NEG_INFINITY, |i| self.depth[i])
    }

    /// The pixel at a position; `None` outside the picture.
    pub fn index(&self, x: f32, y: f32) -> Option<usize> {
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f32 && y < self.height as f32;
        inside.then(|| y as usize * self.width + x as usize)
    }
}

/// The surfels that reach into each band of rows, in order.
fn bands_of(surfels: &[Projected], height: usize) -> Vec<Vec<u32>> {
    let count = height.div_ceil(BAND);
    let reach = |s: &Projected| {
        let radius = radius_of(s);
        let band = |y: f32| ((y / BAND as f32).floor().max(-1.0) as i64).clamp(-1, count as i64);
        (band(s.center[1] - radius).max(0), band(s.center[1] + radius).min(count as i64 - 1))
    };
    let mut bands = vec![Vec::new(); count];
    for (id, surfel) in surfels.iter().enumerate() {
        let (first, last) = reach(surfel);
        for band in first..=last {
            bands[band as usize].push(id as u32);
        }
    }
    bands
}

fn radius_of(surfel: &Projected) -> f32 {
    surfel.radius.clamp(LEAST_RADIUS, GREATEST_RADIUS)
}

/// Fills the pixels of one disc in a band that begins at row `top`.
fn draw_disc(s: &Projected, id: u32, top: usize, width: usize, depth: &mut [f32], ids: &mut [u32]) {
    let [cx, cy, cz] = s.center;
    let radius = radius_of(s);
    let [sx, sy] = s.slope();
    let bottom = top + depth.len() / width;
    let rows = span(cy, radius, top, bottom);
    let columns = span(cx, radius, 0, width);
    for y in rows {
        let dy = y as f32 + 0.5 - cy;
        let row = (y - top) * width;
        for x in columns.clone() {
            let dx = x as f32 + 0.5 - cx;
            let dz = sx * dx + sy * dy;
            let i = row + x;
            if dx * dx + dy * dy + dz * dz <= radius * radius && cz + dz > depth[i] {
                depth[i] = cz + dz;
                ids[i] = id;
            }
        }
    }
}

/// Pixels from `low` to `high` whose centres may lie within `radius` of `center`.
fn span(center: f32, radius: f32, low: usize, high: usize) -> std::ops::Range<usize> {
    let first = ((center - radius - 0.5).ceil().max(low as f32) as usize).min(high);
    let last = ((center + radius + 0.5).floor().max(low as f32) as usize).clamp(first, high);
    first..last
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facing(x: f32, y: f32, z: f32, radius: f32) -> Projected {
        Projected { at: [x, y, z], center: [x, y, z], normal: [0.0, 0.0, 1.0], radius }
    }

    #[test]
    fn the_nearer_disc_is_seen_whatever_the_order() {
        let near = facing(20.0, 40.0, 5.0, 4.0);
        let far = facing(20.0, 40.0, 1.0, 8.0);
        for surfels in [[near, far], [far, near]] {
            let surface = DepthBuffer::draw(&surfels, 64, 80);
            assert_eq!(surface.at(20.5, 40.5), 5.0);
            assert_eq!(surface.at(26.5, 40.5), 1.0);
            assert_eq!(surface.at(40.5, 40.5), f32::NEG_INFINITY);
        }
    }

    #[test]
    fn a_tilted_disc_is_an_ellipse_that_follows_its_plane() {
        let half = 0.5f32.sqrt();
        let tilted = Projected {
            at: [30.0, 30.0, 0.0],
            center: [30.0, 30.0, 0.0],
            normal: [half, 0.0, half],
            radius: 10.0,
        };
        let surface = DepthBuffer::draw(&[tilted], 64, 64);
        assert_eq!(surface.at(34.5, 30.5), -4.5);
        assert_eq!(surface.at(39.5, 30.5), f32::NEG_INFINITY, "foreshortened to 7 pixels");
        assert_eq!(surface.at(30.5, 38.5), -0.5, "not foreshortened along the axis of the tilt");
    }

    #[test]
    fn discs_outside_the_picture_or_not_finite_leave_it_alone() {
        let out =
            [facing(-50.0, 5.0, 0.0, 4.0), facing(5.0, 900.0, 0.0, 4.0), facing(f32::NAN, 5.0, 0.0, 4.0)];
        let surface = DepthBuffer::draw(&out, 32, 32);
        assert!(surface.depth.iter().all(|&d| d == f32::NEG_INFINITY));
    }
}
