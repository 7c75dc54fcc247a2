//! Outlines that run along a line already drawn: a sharp edge at the rim of the surface is no second line.

use super::silhouette::Outline;
use super::{Layer, Shape};
use crate::apply::render::slices::Page;
use crate::apply::render::stroke::Mask;
use crate::apply::render::style::INK;

/// Distance from a line within which an outline runs along it, in spacings: outlines of points are that rough.
const BESIDE: f32 = 1.25;
/// Length over which an outline that only crosses a line is beside it, and over which a rough one strays from a line that it runs along,
/// in that distance.
const CROSSING: f32 = 3.0;
const STRAYING: f32 = 1.0;
/// Samples more, as lines cover whole pixels.
const ROUNDED: usize = 3;
/// Greatest length over which an outline goes on to a line, in that distance.
const ONWARD: f32 = 3.0;
/// Width of outlines, in widths of a strip.
const WIDTH: f32 = 0.75;
/// Pixels between two samples of an outline.
const SAMPLE: f32 = 1.0;

/// The layer of the outlines, without what runs along the visible lines in `layers`. Where an outline comes to such a line, it leads on
/// up to it. `spacing` and `pen` in pixels of the picture.
pub(in crate::apply::render) fn beside(
    [ground, inside]: [Vec<Outline>; 2],
    layers: &[Layer],
    page: &Page,
    spacing: f32,
    pen: f32,
) -> Layer {
    let reach = BESIDE * spacing;
    let fine = page.fine as f32;
    let mask = || Mask::new(page.surface.width / page.fine, page.surface.height / page.fine);
    let (mut wide, mut narrow, mut thin) = (mask(), mask(), mask());
    for shape in layers.iter().filter(|l| !l.halo).flat_map(|l| &l.shapes) {
        shade(shape, &mut wide, 2.0 * reach);
        shade(shape, &mut narrow, reach);
        shade(shape, &mut thin, 2.0);
    }
    let mut layer = Layer::new("silhouette", INK);
    let grounds = ground.len();
    for (number, outline) in ground.into_iter().chain(inside).enumerate() {
        let line: Outline = outline.iter().map(|p| p.map(|x| x / fine)).collect();
        if number == grounds {
            // The rims of discs behind an outline are no further ones; outlines before the ground meet nowhere.
            layer.shapes.iter().for_each(|shape| shade(shape, &mut wide, 2.0 * reach));
        }
        for mut points in free(&line, &wide, &thin, reach) {
            if points.first() != points.last() {
                for _ in 0..2 {
                    points.reverse();
                    points.extend(onward(&points, &narrow, reach));
                }
            }
            let shape = Shape::Line { points, width: WIDTH * pen, dash: None };
            if number >= grounds {
                shade(&shape, &mut wide, 2.0 * reach);
            }
            layer.shapes.push(shape);
        }
    }
    layer
}

/// Covers a solid line in another width.
fn shade(shape: &Shape, mask: &mut Mask, width: f32) {
    if let Shape::Line { points, dash: None, .. } = shape {
        mask.polyline(points, width);
    }
}

/// Takes what runs along visible lines, within `reach` of them, out of the dashed ones: behind an edge seen from the front lies another.
pub(in crate::apply::render) fn behind(layers: &mut [Layer], width: usize, height: usize, reach: f32) {
    let mut mask = Mask::new(width, height);
    let shapes = layers.iter().filter(|l| !l.halo).flat_map(|l| &l.shapes);
    shapes.for_each(|shape| shade(shape, &mut mask, 2.0 * reach));
    let nothing = Mask::new(width, height);
    for layer in layers {
        let parts = |shape: Shape| match shape {
            Shape::Line { points, width, dash: Some(dash) } => {
                let parts = free(&points, &mask, &nothing, reach).into_iter();
                parts.map(|points| Shape::Line { points, width, dash: Some(dash) }).collect()
            }
            other => vec![other],
        };
        layer.shapes = std::mem::take(&mut layer.shapes).into_iter().flat_map(parts).collect();
    }
}

/// The place where an outline that goes on straight from its end meets a line: near a face that it comes down to, the step of the depth
/// at it is too small to be seen.
fn onward(points: &[[f32; 2]], lines: &Mask, reach: f32) -> Option<[f32; 2]> {
    let end = *points.last()?;
    let away = |p: &&[f32; 2]| (p[0] - end[0]).hypot(p[1] - end[1]) >= reach;
    let before = points.iter().rev().find(away)?;
    let length = (end[0] - before[0]).hypot(end[1] - before[1]);
    let along = [0, 1].map(|c| (end[c] - before[c]) / length);
    let steps = (ONWARD * reach) as usize;
    (0..=steps).map(|t| [0, 1].map(|c| end[c] + t as f32 * along[c])).find(|&p| lines.holds(p))
}

/// The parts of a line that do not run along others, as `mask` holds these, each led on by `reach` or until it meets one, as `thin`
/// holds these.
fn free(line: &[[f32; 2]], mask: &Mask, thin: &Mask, reach: f32) -> Vec<Outline> {
    let mut samples = sampled(line);
    let covered = |samples: &[([f32; 2], bool)]| samples.iter().map(|s| mask.holds(s.0)).collect::<Vec<_>>();
    let mut beside = covered(&samples);
    let closed = line.len() > 2 && line.first() == line.last();
    if closed && let Some(start) = (1..beside.len()).find(|&i| beside[i] != beside[i - 1]) {
        // From a change on, so that no part is cut where the numbers begin.
        samples.pop();
        samples.rotate_left(start);
        samples.push(samples[0]);
        beside = covered(&samples);
    }
    let long = |length: f32| (length / SAMPLE) as usize;
    fill(&mut beside, false, long(STRAYING * reach));
    fill(&mut beside, true, long(CROSSING * reach) + ROUNDED);
    let lead = long(reach);
    let mut parts = Vec::new();
    let mut from = 0;
    for run in beside.chunk_by(|a, b| a == b) {
        let to = from + run.len();
        let met = |i: &usize| thin.holds(samples[*i].0);
        let first = (from.max(lead) - lead..from).rev().find(met).unwrap_or(from.max(lead) - lead);
        let most = (to + lead).min(samples.len());
        let last = (to..most).find(met).map_or(most, |i| i + 1);
        from = to;
        if !run[0] {
            let part = &samples[first..last];
            let kept = |i: usize| i == 0 || i + 1 == part.len() || part[i].1;
            let points: Outline = (0..part.len()).filter(|&i| kept(i)).map(|i| part[i].0).collect();
            parts.extend((points.len() > 1).then_some(points));
        }
    }
    parts
}

/// The points of a line, which are marked, and others between them.
fn sampled(line: &[[f32; 2]]) -> Vec<([f32; 2], bool)> {
    let mut samples: Vec<([f32; 2], bool)> = line.first().map(|&p| (p, true)).into_iter().collect();
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let steps = ((b[0] - a[0]).hypot(b[1] - a[1]) / SAMPLE).ceil().max(1.0) as usize;
        samples.extend((1..=steps).map(|k| {
            let t = k as f32 / steps as f32;
            ([0, 1].map(|i| a[i] + (b[i] - a[i]) * t), k == steps)
        }));
    }
    samples
}

/// Turns runs of `value` shorter than `least`, between others, into the other value.
fn fill(flags: &mut [bool], value: bool, least: usize) {
    let mut runs = Vec::new();
    for run in flags.chunk_by(|a, b| a == b) {
        let from: usize = runs.last().map_or(0, |&(_, to)| to);
        runs.push((from, from + run.len()));
    }
    if runs.len() > 1 {
        runs.retain(|&(from, to)| flags[from] == value && to - from < least);
        runs.iter().for_each(|&(from, to)| flags[from..to].fill(!value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_runs_along_a_line_is_left_out_and_what_crosses_one_stays() {
        let mut mask = Mask::new(200, 200);
        mask.polyline(&[[20.0, 20.0], [180.0, 20.0]], 8.0);
        mask.polyline(&[[100.0, 100.0], [100.0, 180.0]], 8.0);
        let rim = [[20.0, 22.0], [180.0, 22.0], [180.0, 150.0], [20.0, 150.0], [20.0, 22.0]];
        let parts = free(&rim, &mask, &mask, 4.0);
        assert_eq!(parts.len(), 1, "{parts:?}");
        let [first, last] = [parts[0][0], parts[0][parts[0].len() - 1]];
        assert!([first, last].iter().all(|p| (p[1] - 22.0).abs() < 3.0), "it leads up to the line");
        assert!(parts[0].contains(&[180.0, 150.0]));
    }
}
