//! Antialiased strokes and dots: the coverage of a pixel follows from its distance to the shape.

use super::picture::{Colour, Picture};

/// Coverage of each pixel by one colour, 0 to 1. Overlapping shapes cover once, so joints do not darken.
pub(super) struct Mask {
    width: usize,
    height: usize,
    coverage: Vec<f32>,
}

impl Mask {
    /// A mask without any coverage.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, coverage: vec![0.0; width * height] }
    }

    /// Covers a line of this many pixels in width, with round ends.
    pub fn polyline(&mut self, points: &[[f32; 2]], width: f32) {
        points.windows(2).for_each(|pair| self.segment(pair[0], pair[1], 0.5 * width));
    }

    /// Covers dashes of a line: `dash` pixels drawn, `gap` pixels left out, beginning at its first point.
    pub fn dashes(&mut self, points: &[[f32; 2]], width: f32, dash: f32, gap: f32) {
        let mut along = 0.0;
        for pair in points.windows(2) {
            if along % (dash + gap) < dash {
                self.segment(pair[0], pair[1], 0.5 * width);
            }
            along += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        }
    }

    /// Covers a disc.
    pub fn disc(&mut self, center: [f32; 2], radius: f32) {
        self.segment(center, center, radius);
    }

    fn segment(&mut self, a: [f32; 2], b: [f32; 2], radius: f32) {
        if !a.iter().chain(&b).all(|x| x.is_finite()) {
            return;
        }
        let rows = range(a[1].min(b[1]) - radius, a[1].max(b[1]) + radius, self.height);
        let columns = range(a[0].min(b[0]) - radius, a[0].max(b[0]) + radius, self.width);
        for y in rows {
            for x in columns.clone() {
                let distance = distance_to_segment([x as f32 + 0.5, y as f32 + 0.5], a, b);
                let cover = (radius + 0.5 - distance).clamp(0.0, 1.0);
                let pixel = &mut self.coverage[y * self.width + x];
                *pixel = pixel.max(cover);
            }
        }
    }

    /// Draws the covered pixels over the picture in one colour.
    pub fn paint(&self, picture: &mut Picture, colour: Colour, opacity: f32) {
        for (i, &cover) in self.coverage.iter().enumerate() {
            if cover > 0.0 {
                picture.blend(i, colour, cover * opacity);
            }
        }
    }
}

/// Pixels whose centres may lie between two coordinates, within the picture.
fn range(low: f32, high: f32, size: usize) -> std::ops::Range<usize> {
    let first = (low - 1.0).max(0.0) as usize;
    let last = ((high + 2.0).max(0.0) as usize).min(size);
    first.min(last)..last
}

fn distance_to_segment(p: [f32; 2], a: [f32; 2], b: [f32; 2]) -> f32 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let [px, py] = [p[0] - a[0], p[1] - a[1]];
    let length2 = dx * dx + dy * dy;
    let t = if length2 > 0.0 { ((px * dx + py * dy) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (px - t * dx).hypot(py - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_covers_its_width_times_its_length() {
        let mut mask = Mask::new(64, 64);
        mask.polyline(&[[10.3, 20.7], [40.1, 52.2]], 3.0);
        let area: f32 = mask.coverage.iter().sum();
        let length = 29.8f32.hypot(31.5);
        let expected = 3.0 * length + std::f32::consts::PI * 1.5 * 1.5;
        assert!((area - expected).abs() < 0.03 * expected, "{area} {expected}");
    }

    #[test]
    fn strokes_beyond_the_picture_or_not_finite_are_clipped() {
        let mut mask = Mask::new(16, 16);
        mask.polyline(&[[-100.0, -90.0], [-20.0, 1e9]], 2.0);
        mask.polyline(&[[f32::NAN, 1.0], [3.0, 3.0]], 2.0);
        assert!(mask.coverage.iter().all(|&c| c == 0.0));
    }

    #[test]
    fn dashes_leave_gaps() {
        let line: Vec<[f32; 2]> = (0..60).map(|x| [x as f32, 8.0]).collect();
        let mut mask = Mask::new(64, 16);
        mask.dashes(&line, 2.0, 6.0, 6.0);
        assert_eq!(mask.coverage[8 * 64 + 3], 1.0);
        assert_eq!(mask.coverage[8 * 64 + 9], 0.0);
    }
}
