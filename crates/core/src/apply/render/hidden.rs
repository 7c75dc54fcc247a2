//! The hidden parts of a line: those behind the surface.

use super::depth_buffer::DepthBuffer;

/// A part of a line that is visible, or hidden, as a whole.
pub(super) struct Stretch {
    pub visible: bool,
    /// Positions on the surface's pixel grid, in order; at least two: its ends, and the points of the line between them.
    pub points: Vec<[f32; 2]>,
}

/// Pixels of the surface between two tests.
const STEP: f32 = 1.5;
/// Greatest length of a visible end of a hidden line, in biases: it seems visible up to there where the surface above it rises by half.
const STUB: f32 = 2.0;
/// Number of samples on either side of a sample whose majority, with its own value, decides: so single pixels do not flicker.
const MAJORITY_REACH: usize = 5;

/// Cuts a line of projected points where it passes behind the surface by more than `bias` pixels of depth.
pub(super) fn stretches(line: &[[f32; 3]], surface: &DepthBuffer, bias: f32) -> Vec<Stretch> {
    let samples = resample(line);
    let seen: Vec<bool> = samples.iter().map(|s| is_visible(s.at, surface, bias)).collect();
    let mut seen = majority(&seen);
    absorb(&samples, &mut seen, false, bias);
    absorb(&samples, &mut seen, true, STUB * bias);
    let mut stretches: Vec<Stretch> = Vec::new();
    for (i, (sample, &visible)) in samples.iter().zip(&seen).enumerate() {
        let point = [sample.at[0], sample.at[1]];
        let cut = i > 0 && seen[i - 1] != visible;
        let kept = sample.vertex || seen.get(i + 1).is_none_or(|&next| next != visible);
        match stretches.last_mut() {
            Some(stretch) if cut => {
                stretch.points.push(point);
                stretches.push(Stretch { visible, points: vec![point] });
            }
            Some(stretch) if kept => stretch.points.push(point),
            Some(_) => {}
            None => stretches.push(Stretch { visible, points: vec![point] }),
        }
    }
    stretches.retain(|stretch| stretch.points.len() > 1);
    stretches
}

/// Gives stretches that are `visible`, and shorter than `length` pixels, the value of the others beside them: the bias of the depth
/// cannot tell about these. Where a line behind the surface meets an edge that is seen, its end lies less than the bias below; and
/// the discs that make up a rough surface cover a visible edge here and there.
fn absorb(samples: &[Sample], seen: &mut [bool], visible: bool, length: f32) {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for run in seen.chunk_by(|a, b| a == b) {
        let from = runs.last().map_or(0, |last| last.1);
        runs.push((from, from + run.len()));
    }
    if runs.len() < 2 {
        return;
    }
    let long = |&(from, to): &(usize, usize)| samples[to - 1].along - samples[from].along;
    runs.retain(|run| seen[run.0] == visible && long(run) < length);
    runs.iter().for_each(|&(from, to)| seen[from..to].fill(!visible));
}

/// Whether nothing lies more than `bias` pixels nearer to the eye.
pub(super) fn is_visible([x, y, z]: [f32; 3], surface: &DepthBuffer, bias: f32) -> bool {
    surface.at(x, y) <= z + bias
}

/// A place on a line.
struct Sample {
    at: [f32; 3],
    /// Length from the beginning of the line on the picture.
    along: f32,
    /// Whether it is a point of the line itself.
    vertex: bool,
}

/// The points of the line, and others between them, at most [`STEP`] apart.
fn resample(line: &[[f32; 3]]) -> Vec<Sample> {
    let first = line.first().map(|&at| Sample { at, along: 0.0, vertex: true });
    let mut samples: Vec<Sample> = first.into_iter().collect();
    let mut along = 0.0;
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let steps = (length / STEP).ceil().max(1.0) as usize;
        samples.extend((1..=steps).map(|k| {
            let t = k as f32 / steps as f32;
            let at = std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t);
            Sample { at, along: along + t * length, vertex: k == steps }
        }));
        along += length;
    }
    samples
}

/// The values, each replaced by the majority of its neighbourhood; unchanged where that is even.
fn majority(seen: &[bool]) -> Vec<bool> {
    let mut sums = vec![0i64];
    for &s in seen {
        sums.push(sums[sums.len() - 1] + if s { 1 } else { -1 });
    }
    (0..seen.len())
        .map(|i| {
            let reach = MAJORITY_REACH.min(i).min(seen.len() - 1 - i);
            let sum = sums[i + reach + 1] - sums[i - reach];
            sum > 0
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::surfel::Projected;
    use super::*;

    fn disc() -> Projected {
        let at = [50.0, 50.0, 10.0];
        Projected { at, center: at, normal: [0.0, 0.0, 1.0], radius: 20.0 }
    }

    #[test]
    fn a_line_behind_a_disc_is_cut_into_three() {
        let surface = DepthBuffer::draw(&[disc()], 100, 100);
        let stretches = stretches(&[[2.0, 50.5, 0.0], [98.0, 50.5, 0.0]], &surface, 2.0);
        assert_eq!(stretches.iter().map(|r| r.visible).collect::<Vec<_>>(), [true, false, true]);
        let hidden = &stretches[1].points;
        assert!((hidden[0][0] - 30.0).abs() < 2.0 && (hidden[hidden.len() - 1][0] - 70.0).abs() < 2.0);
    }

    #[test]
    fn a_line_on_the_surface_is_seen_whole() {
        let surface = DepthBuffer::draw(&[disc()], 100, 100);
        let stretches = stretches(&[[2.0, 50.5, 9.0], [98.0, 50.5, 9.0]], &surface, 2.0);
        assert_eq!(stretches.iter().map(|r| r.visible).collect::<Vec<_>>(), [true]);
    }

    #[test]
    fn one_point_or_none_gives_no_run() {
        let surface = DepthBuffer::draw(&[], 8, 8);
        assert!(stretches(&[], &surface, 1.0).is_empty());
        assert!(stretches(&[[1.0, 1.0, 0.0]], &surface, 1.0).is_empty());
    }
}
