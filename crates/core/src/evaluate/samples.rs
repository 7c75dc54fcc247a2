//! Samples along lines, by which their length counts.
//!
//! A segment counts once for every step of its length, rounded up, with its far end as the last sample. A run of segments shorter
//! than a step that has more than twice as many of them as it touches steps is taken as one segment, so that a line counts by its
//! length, and not by how densely its vertices are written. Where they stand as far apart as half a step, every vertex is a sample:
//! rounding up weighs the segments of one step and a little more as much.

use crate::math::vec3::{add_scaled, distance, sub};

/// Segments to each step from which on a run of them is sampled by its length.
const DENSE: usize = 2;

/// Samples along a polyline at most `step` apart, its first point before them. A closed one ends in its first point again.
pub(super) fn samples(points: &[[f64; 3]], closed: bool, step: f64) -> Vec<[f64; 3]> {
    let row: Vec<[f64; 3]> = points.iter().chain(points.first().filter(|_| closed)).copied().collect();
    let lengths: Vec<f64> = row.windows(2).map(|w| distance(w[0], w[1])).collect();
    let mut out: Vec<[f64; 3]> = row.first().copied().into_iter().collect();
    let mut at = 0;
    for run in lengths.chunk_by(|a, b| *a < step && *b < step) {
        let corners = &row[at..=at + run.len()];
        let pieces = pieces(run.iter().sum(), step);
        if run.len() > DENSE * (pieces + 1) {
            evenly(corners, run, pieces, &mut out);
        } else {
            corners.windows(2).zip(run).for_each(|(w, &length)| cut(w[0], w[1], length, step, &mut out));
        }
        at += run.len();
    }
    out
}

fn pieces(length: f64, step: f64) -> usize {
    (length / step).ceil().max(1.0) as usize
}

/// The samples of one segment.
fn cut(a: [f64; 3], b: [f64; 3], length: f64, step: f64, out: &mut Vec<[f64; 3]>) {
    let pieces = pieces(length, step);
    out.extend((1..pieces).map(|k| add_scaled(a, sub(b, a), k as f64 / pieces as f64)));
    out.push(b);
}

/// The ends of equal pieces of the length of a run of segments.
fn evenly(corners: &[[f64; 3]], lengths: &[f64], pieces: usize, out: &mut Vec<[f64; 3]>) {
    let whole: f64 = lengths.iter().sum();
    let (mut segment, mut passed) = (0, 0.0);
    for k in 1..pieces {
        let along = whole * (k as f64 / pieces as f64);
        while segment + 1 < lengths.len() && passed + lengths[segment] < along {
            passed += lengths[segment];
            segment += 1;
        }
        let share = ((along - passed) / lengths[segment]).min(1.0);
        out.push(add_scaled(corners[segment], sub(corners[segment + 1], corners[segment]), share));
    }
    out.extend(corners.last());
}

#[cfg(test)]
mod tests {
    use super::samples;
    use crate::math::vec3::distance;

    fn row(count: u32, apart: f64) -> Vec<[f64; 3]> {
        (0..count).map(|i| [f64::from(i) * apart, 0.0, 0.0]).collect()
    }

    #[test]
    fn a_line_has_as_many_samples_as_its_length_asks_for() {
        assert_eq!(samples(&row(2, 10.0), false, 1.0), row(11, 1.0));
        for (count, apart) in [(10_001, 0.001), (1001, 0.01), (51, 0.2), (26, 0.4)] {
            let dense = samples(&row(count, apart), false, 1.0);
            assert!((11..=12).contains(&dense.len()), "{apart}: {}", dense.len());
            assert!(dense.windows(2).all(|w| distance(w[0], w[1]) < 1.0 + 1e-9));
            assert!(distance(dense[dense.len() - 1], [10.0, 0.0, 0.0]) < 1e-9);
        }
    }

    #[test]
    fn a_dense_stretch_counts_no_more_than_the_rest_of_its_line() {
        let mut mixed = row(1001, 0.001);
        mixed.extend([[9.0, 0.0, 0.0], [9.0, 0.0, 0.0], [10.0, 0.0, 0.0]]);
        assert_eq!(samples(&mixed, false, 1.0).len(), 12);
        let round = |i: u32| (f64::from(i) * 0.001 * std::f64::consts::TAU).sin_cos();
        let circle: Vec<[f64; 3]> = (0..1000).map(round).map(|(y, x)| [x, y, 0.0]).collect();
        let closed = samples(&circle, true, 0.1);
        assert_eq!((closed.len(), closed[63]), (64, circle[0]));
        assert!(closed.iter().all(|p| (distance(*p, [0.0; 3]) - 1.0).abs() < 1e-5));
    }

    #[test]
    fn vertices_half_a_step_apart_or_more_are_samples() {
        assert_eq!(samples(&row(14, 0.6), false, 1.0), row(14, 0.6));
        let once = [[0.0; 3], [0.01, 0.0, 0.0], [5.01, 0.0, 0.0]];
        assert_eq!(samples(&once, false, 1.0).len(), 7);
        assert_eq!(samples(&[], true, 1.0), Vec::<[f64; 3]>::new());
    }
}
