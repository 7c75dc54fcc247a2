//! Antialiased strokes and dots: the coverage of a pixel follows from its distance to the shape.

use super::picture::{Colour, Picture};

/// Length in pixels of the pieces in which lines are covered.
const PIECE: f32 = 24.0;
/// Length beyond that of any line on a picture.
const FAR: f32 = 1e6;

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
        points.windows(2).for_each(|pair| self.stroke(pair[0], pair[1], 0.5 * width));
    }

    /// Covers dashes of a line: `dash` pixels drawn, `gap` pixels left out, beginning at its first point.
    pub fn dashes(&mut self, points: &[[f32; 2]], width: f32, dash: f32, gap: f32) {
        let period = dash + gap;
        let mut along = 0.0f32;
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            // Longer than the picture, or not finite.
            if !(length > 0.0 && length < FAR) {
                continue;
            }
            let at = |t: f32| [0, 1].map(|i| a[i] + (b[i] - a[i]) * (t / length).clamp(0.0, 1.0));
            let first = (along / period).floor();
            let last = ((along + length) / period).floor();
            for k in first as i64..=last as i64 {
                let from = k as f32 * period - along;
                if from < length && from + dash > 0.0 {
                    self.stroke(at(from), at(from + dash), 0.5 * width);
                }
            }
            along = (along + length) % period;
        }
    }

    /// Covers a rectangle of whole pixels.
    pub fn fill(&mut self, [x, y]: [f32; 2], [width, height]: [f32; 2]) {
        let clip = |v: f32, most: usize| (v.max(0.0) as usize).min(most);
        for row in clip(y, self.height)..clip(y + height, self.height) {
            self.coverage[row * self.width..][clip(x, self.width)..clip(x + width, self.width)].fill(1.0);
        }
    }

    /// Whether a position is covered.
    pub fn holds(&self, [x, y]: [f32; 2]) -> bool {
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f32 && y < self.height as f32;
        inside && self.coverage[y as usize * self.width + x as usize] > 0.5
    }

    /// Covers a straight line, in pieces, as each looks at all pixels of its bounding box.
    fn stroke(&mut self, a: [f32; 2], b: [f32; 2], radius: f32) {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let pieces = if length < FAR { (length / PIECE).ceil().max(1.0) } else { 1.0 };
        let at = |k: f32| [0, 1].map(|i| a[i] + (b[i] - a[i]) * (k / pieces));
        for k in 0..pieces as usize {
            self.segment(at(k as f32), at(k as f32 + 1.0), radius);
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

    /// Draws the covered pixels over the picture in one colour; with `halo` over what is drawn there alone, not over the ground.
    pub fn paint(&self, picture: &mut Picture, colour: Colour, opacity: f32, halo: bool) {
        for (i, &cover) in self.coverage.iter().enumerate() {
            if cover > 0.0 && halo {
                picture.lighten(i, colour, cover * opacity);
            } else if cover > 0.0 {
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

/// The distance of `p` from the segment from `a` to `b`.
pub(super) fn distance_to_segment(p: [f32; 2], a: [f32; 2], b: [f32; 2]) -> f32 {
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
