//! Outlines of the surface: where it ends before what lies behind it.
//!
//! They are read off the depths of the pixels, so that they need no oriented normals and are the same for points and for meshes: a crack
//! between two pixels is part of an outline if one of them shows the ground, or a surface farther away than the slope and the roughness
//! of a surface explain.

use super::sharpen::sharpened;
use super::trace::{Crack, chains, joined};
use crate::apply::render::depth_buffer::DepthBuffer;
use crate::apply::render::stroke::distance_to_segment;
use crate::apply::render::surfel::Projected;

/// Least step of the depth at a piece of an outline, in spacings and in pixels: a facet seen at 80 degrees falls by six pixels from one
/// to the next.
const STEP: f32 = 1.0;
const STEP_PIXELS: f32 = 7.0;
/// Share of the pieces of an outline at which the step is greater by what the discs on both sides span: at the rims of rough discs on one
/// surface it hardly ever is.
const SHARE: f32 = 0.3;
/// Half the width of the fringe of disc rims at an outline, in spacings.
const FRAYED: f32 = 0.3;
/// Greatest gap between pieces, in spacings: where the rims of several discs lie at an outline, each step may be too small.
const GAP: f32 = 2.0;
/// Length of the shortest outline, in spacings and in pixels.
const LEAST: f32 = 8.0;
const LEAST_PIXELS: f32 = 16.0;
/// Standard deviation of the weights by which the staircase of pixels is smoothed: a share of the spacing between two bounds, pixels.
const SMOOTHED: f32 = 0.6;
const SMOOTHING: [f32; 2] = [2.0, 8.0];
/// Greatest distance of points that are left out from the line, pixels.
const TOLERANCE: f32 = 0.25;

/// A line on the grid of the surface; closed if its last point is its first.
pub(in crate::apply::render) type Outline = Vec<[f32; 2]>;

/// The outlines of a surface of `facets` whose points are `spacing` pixels apart: those before the ground, each whole whatever ends on
/// it, and those before other surface, the longest first.
pub(in crate::apply::render) fn lines(
    surface: &DepthBuffer,
    facets: &[Projected],
    spacing: f32,
) -> [Vec<Outline>; 2] {
    let least = (LEAST * spacing).max(LEAST_PIXELS) as usize;
    let sigma = (SMOOTHED * spacing).clamp(SMOOTHING[0], SMOOTHING[1]);
    let step = STEP * spacing + STEP_PIXELS;
    let reach = ((FRAYED * spacing) as usize).clamp(1, 6);
    let [ground, inside] = cracks(surface, &sharpened(surface, reach, step), facets, step);
    let inside = joined(chains(inside), (GAP * spacing).max(2.0));
    let clear = |chain: &[Crack]| {
        let high = chain.iter().filter(|c| c.high).count();
        chain.len() >= least && high as f32 >= SHARE * chain.len() as f32
    };
    let line = |(chain, closed): (Vec<Crack>, bool)| {
        let middles: Vec<[f32; 2]> = chain.iter().map(Crack::middle).collect();
        let mut line = smoothed(&middles, closed, sigma);
        if closed {
            line.extend(line.first().copied());
        }
        simplified(&line, TOLERANCE)
    };
    [chains(ground), inside].map(|mut chains| {
        chains.retain(|(chain, _)| clear(chain));
        chains.sort_by_key(|(chain, _)| std::cmp::Reverse(chain.len()));
        chains.into_iter().map(line).collect()
    })
}

/// The cracks before the ground, and those before a surface farther away by more than `step`, by these depths; the nearer pixel on the right hand.
fn cracks(surface: &DepthBuffer, depths: &[f32], facets: &[Projected], step: f32) -> [Vec<Crack>; 2] {
    let (width, height) = (surface.width as i32, surface.height as i32);
    let spans: Vec<f32> =
        facets.iter().map(|f| f.radius * (1.0 - f.normal[2] * f.normal[2]).max(0.0).sqrt()).collect();
    let pixel = |y: i32, x: i32| {
        let inside = y >= 0 && x >= 0 && y < height && x < width;
        let at = inside.then(|| (y * width + x) as usize)?;
        let span = spans.get(surface.surfel[at] as usize)?;
        Some((depths[at], *span))
    };
    let mut cracks = [Vec::new(), Vec::new()];
    // The first of two pixels lies on the right hand of the way from one corner to the other.
    let mut add = |pixels: [Option<(f32, f32)>; 2], [from, to]: [[i32; 2]; 2]| match pixels {
        [Some(_), None] => cracks[0].push(Crack { from, to, high: true }),
        [None, Some(_)] => cracks[0].push(Crack { from: to, to: from, high: true }),
        [Some((a, span_a)), Some((b, span_b))] if (a - b).abs() > step => {
            let [from, to] = if a > b { [from, to] } else { [to, from] };
            cracks[1].push(Crack { from, to, high: (a - b).abs() > step + span_a + span_b });
        }
        _ => {}
    };
    for y in 0..=height {
        for x in 0..=width {
            let own = pixel(y, x);
            add([pixel(y, x - 1), own], [[y, x], [y + 1, x]]);
            add([own, pixel(y - 1, x)], [[y, x], [y, x + 1]]);
        }
    }
    cracks
}

/// Each point replaced by the mean about it with normal weights. At the ends of an open line fewer points count, as many on either
/// side, so that these stay.
fn smoothed(points: &[[f32; 2]], closed: bool, sigma: f32) -> Vec<[f32; 2]> {
    let n = points.len();
    let widest = ((3.0 * sigma) as usize).min(n.saturating_sub(1) / 2);
    let weights: Vec<f32> = (0..=widest).map(|k| (-0.5 * (k as f32 / sigma).powi(2)).exp()).collect();
    (0..n)
        .map(|i| {
            let reach = if closed { widest } else { widest.min(i).min(n - 1 - i) };
            let mut sum = points[i];
            let mut total = 1.0;
            for (k, &weight) in weights.iter().enumerate().take(reach + 1).skip(1) {
                let (before, after) = (points[(i + n - k) % n], points[(i + k) % n]);
                sum = [0, 1].map(|c| sum[c] + weight * (before[c] + after[c]));
                total += 2.0 * weight;
            }
            sum.map(|s| s / total)
        })
        .collect()
}

/// The line without the points that lie within `tolerance` of it (Ramer 1972; Douglas and Peucker 1973).
fn simplified(line: &[[f32; 2]], tolerance: f32) -> Vec<[f32; 2]> {
    let mut kept = vec![false; line.len()];
    let mut open = vec![(0, line.len().saturating_sub(1))];
    while let Some((from, to)) = open.pop() {
        if let Some(k) = kept.get_mut(from) {
            *k = true;
        }
        if let Some(k) = kept.get_mut(to) {
            *k = true;
        }
        let far = |i: usize| distance_to_segment(line[i], line[from], line[to]);
        let most = (from + 1..to).max_by(|&a, &b| far(a).total_cmp(&far(b)));
        if let Some(middle) = most.filter(|&i| far(i) > tolerance) {
            open.extend([(from, middle), (middle, to)]);
        }
    }
    line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(&p, _)| p).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(at: [f32; 3], radius: f32) -> Projected {
        Projected { at, center: at, normal: [0.0, 0.0, 1.0], radius }
    }

    #[test]
    fn a_disc_before_another_has_an_outline_of_its_own() {
        let far = disc([100.0, 100.0, 0.0], 80.0);
        let outlines = |z: f32| {
            let near = disc([100.0, 100.0, z], 40.0);
            lines(&DepthBuffer::draw(&[far, near], 200, 200), &[far, near], 2.0).concat()
        };
        assert_eq!(outlines(1.0).len(), 1);
        let two = outlines(60.0);
        assert_eq!(two.len(), 2);
        for line in two {
            assert_eq!(line.first(), line.last());
            let from_middle = |p: &[f32; 2]| (p[0] - 100.0).hypot(p[1] - 100.0);
            let radius = if from_middle(&line[0]) > 60.0 { 80.0 } else { 40.0 };
            assert!(line.iter().all(|p| (from_middle(p) - radius).abs() < 0.8));
            assert!(line.len() < 80, "{}", line.len());
        }
    }
}
