//! Light and shade of the surface, and the dots on it.

use super::depth_buffer::DepthBuffer;
use super::picture::{Colour, Picture, WHITE};
use super::surfel::Projected;
use crate::parallel;

/// Towards the light: over the left shoulder of the viewer. Unit length.
const LIGHT: [f32; 3] = [-0.42, 0.50, 0.757];
/// Tone of a surface that faces away from the light, and of one that faces it; 1 is the white of the paper.
const DARKEST: f32 = 0.42;
const LIGHTEST: f32 = 0.86;
/// Share by which the farthest surface fades towards the paper.
const FADE: f32 = 0.30;
/// Distance of neighbours in fine pixels above which points are drawn as dots on a paler surface.
const DOTS_FROM: f32 = 8.0;
/// Greatest radius of a dot in fine pixels.
const GREATEST_DOT: f32 = 9.0;
/// Tone of a dot as a share of the surface's.
const DOT_TONE: f32 = 0.62;
/// Colour of tone 0; tone 1 is white.
const INK: Colour = [0.10, 0.13, 0.17];

/// The tone of each pixel of the surface: 1 where there is none.
pub(super) fn shaded(surfels: &[Projected], surface: &DepthBuffer, spacing: f32) -> Vec<f32> {
    let range = depth_range(surface);
    let dotted = spacing >= DOTS_FROM;
    let tones = parallel::map(surfels.len(), parallel::QUICK, |i| tone(&surfels[i], range));
    let mut fine = parallel::map(surface.surfel.len(), parallel::QUICK, |at| {
        match tones.get(surface.surfel[at] as usize) {
            Some(&tone) if dotted => 1.0 - 0.55 * (1.0 - tone),
            Some(&tone) => tone,
            None => 1.0,
        }
    });
    if dotted {
        let radius = (0.22 * spacing).min(GREATEST_DOT);
        for (surfel, tone) in surfels.iter().zip(&tones) {
            draw_dot(surfel, radius, DOT_TONE * tone, surface, &mut fine);
        }
    }
    fine
}

/// Depths of the farthest and the nearest pixel.
fn depth_range(surface: &DepthBuffer) -> [f32; 2] {
    let seen = surface.depth.iter().filter(|d| d.is_finite());
    seen.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], &d| [low.min(d), high.max(d)])
}

fn tone(s: &Projected, [far, near]: [f32; 2]) -> f32 {
    let lit = s.normal.iter().zip(LIGHT).map(|(n, l)| n * l).sum::<f32>().max(0.0);
    let tone = DARKEST + (LIGHTEST - DARKEST) * lit;
    let away = if near > far { ((near - s.at[2]) / (near - far)).clamp(0.0, 1.0) } else { 0.0 };
    tone + (1.0 - tone) * FADE * away
}

/// Draws a small disc in the tangent plane, where the surface does not hide it.
fn draw_dot(s: &Projected, radius: f32, tone: f32, surface: &DepthBuffer, fine: &mut [f32]) {
    let [sx, sy] = s.slope();
    let reach = radius.ceil() as i32;
    for dy in -reach..=reach {
        for dx in -reach..=reach {
            let [px, py] = [dx as f32, dy as f32];
            let dz = sx * px + sy * py;
            let Some(i) = surface.index(s.at[0] + px, s.at[1] + py) else { continue };
            let inside = px * px + py * py + dz * dz <= radius * radius;
            if inside && surface.depth[i] <= s.at[2] + s.radius {
                fine[i] = tone;
            }
        }
    }
}

/// The colour of each surfel, if they are not all white.
pub(super) type Tints<'a> = Option<&'a [Colour]>;

/// The picture of tones averaged over blocks of `factor` x `factor`, in the tints of the surfels; where the ground is transparent, it
/// shows where there is no surface.
pub(super) fn averaged(
    fine: &[f32],
    surface: &DepthBuffer,
    tints: Tints,
    factor: usize,
    transparent: bool,
) -> Picture {
    let (width, height) = (surface.width / factor, surface.height / factor);
    let mut picture = Picture::empty(width, height, transparent);
    let block = |x: usize, y: usize| {
        let rows = (0..factor).map(move |dy| (y * factor + dy) * surface.width + x * factor);
        rows.flat_map(move |start| start..start + factor)
    };
    let share = 1.0 / (factor * factor) as f32;
    let covered = |x, y| block(x, y).filter(|&at| surface.surfel[at] != u32::MAX).count() as f32 * share;
    parallel::each(picture.rgb.chunks_mut(3 * width), |y, row| {
        for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
            let over = if transparent { covered(x, y) } else { 1.0 };
            let places = block(x, y).filter(|&at| !transparent || surface.surfel[at] != u32::MAX);
            let mut sum = [0.0; 3];
            for at in places {
                let tint = tints.and_then(|t| t.get(surface.surfel[at] as usize)).unwrap_or(&WHITE);
                for c in 0..3 {
                    sum[c] += (INK[c] + (tint[c] - INK[c]) * fine[at]) * share;
                }
            }
            if over > 0.0 {
                for (byte, sum) in pixel.iter_mut().zip(sum) {
                    *byte = super::picture::to_byte(sum / over);
                }
            }
        }
    });
    if let Some(alpha) = &mut picture.alpha {
        parallel::each(alpha.chunks_mut(width), |y, row| {
            row.iter_mut().enumerate().for_each(|(x, a)| *a = super::picture::to_byte(covered(x, y)));
        });
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_towards_the_light_is_lighter_than_one_away_from_it() {
        let facing = |normal| Projected { at: [0.0; 3], center: [0.0; 3], normal, radius: 1.0 };
        let light = tone(&facing(LIGHT), [0.0, 0.0]);
        let dark = tone(&facing([0.8, -0.6, 0.0]), [0.0, 0.0]);
        assert!(light > dark + 0.3);
    }

    #[test]
    fn averaging_keeps_the_mean() {
        let surface = DepthBuffer::draw(&[], 4, 2);
        let picture = averaged(&[1.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0], &surface, None, 2, false);
        let middle = super::super::picture::to_byte(INK[0] + (1.0 - INK[0]) * 0.5);
        assert_eq!(picture.rgb[0], middle);
        assert_eq!(picture.rgb[3..6], [255; 3]);
    }
}
