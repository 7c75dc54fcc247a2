//! Steps of the depth made sharp.

use crate::apply::render::depth_buffer::DepthBuffer;
use crate::parallel;

/// Depths in which a step that takes several pixels, as at the outline of a rough surface, lies between two of them: where the depths up
/// to `reach` pixels away differ by more than `step`, the least or the greatest of them, whichever is nearer (Kramer and Bruckner 1975).
/// The ground stays as it is.
pub(super) fn sharpened(surface: &DepthBuffer, reach: usize, step: f32) -> Vec<f32> {
    let (width, height) = (surface.width, surface.height);
    // The least and the greatest depth along the row about each pixel, and then about it on all sides.
    let about = |of: &dyn Fn(usize) -> [f32; 2], from: usize, to: usize, stride: usize, base: usize| {
        let all = (from..to).map(|k| of(base + k * stride));
        all.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], [l, h]| [low.min(l), high.max(h)])
    };
    let alone = |at: usize| match surface.depth[at] {
        depth if depth.is_finite() => [depth, depth],
        _ => [f32::INFINITY, f32::NEG_INFINITY],
    };
    let mut rows = vec![[0.0; 2]; width * height];
    parallel::each(rows.chunks_mut(width), |y, row| {
        for (x, range) in row.iter_mut().enumerate() {
            *range = about(&alone, x.saturating_sub(reach), (x + reach + 1).min(width), 1, y * width);
        }
    });
    let of_row = |at: usize| rows[at];
    let mut depths = surface.depth.clone();
    parallel::each(depths.chunks_mut(width), |y, row| {
        for (x, depth) in row.iter_mut().enumerate().filter(|(_, depth)| depth.is_finite()) {
            let [low, high] = about(&of_row, y.saturating_sub(reach), (y + reach + 1).min(height), width, x);
            if high - low > step {
                *depth = if high - *depth < *depth - low { high } else { low };
            }
        }
    });
    depths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_of_four_pixels_becomes_one_of_two_and_a_slope_stays() {
        let mut surface = DepthBuffer::draw(&[], 10, 1);
        surface.depth = vec![90.0, 90.0, 90.0, 80.0, 50.0, 10.0, 0.0, 0.0, 0.0, f32::NEG_INFINITY];
        let sharp = sharpened(&surface, 2, 60.0);
        assert_eq!(sharp[..5], [90.0, 90.0, 90.0, 90.0, 90.0]);
        assert_eq!(sharp[5..], [0.0, 0.0, 0.0, 0.0, f32::NEG_INFINITY]);
        assert_eq!(sharpened(&surface, 2, 200.0), surface.depth);
    }
}
