//! Otsu's method: the cut of a histogram with the greatest variance between its two classes.
//!
//! N. Otsu, *A Threshold Selection Method from Gray-Level Histograms*, IEEE Transactions on Systems, Man, and Cybernetics
//! 9 (1979), 62-66: for two classes, and in [`otsu3`] for three (section V). Counts are integers, so that the order of the
//! values does not matter.

/// The cut of a histogram, with its separability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Otsu {
    /// Values above this belong to the upper class. It lies on the border of two bins.
    pub threshold: f64,
    /// Share of the variance that the two classes explain, 0 to 1 (Otsu's eta).
    pub separability: f64,
}

/// Cuts the histogram of `values` over `[0, 1]` in `bins` equal bins. Values outside count in the outer bins; values that are
/// not finite do not count. If several cuts are equally good, as in a gap of the histogram, the middle one is taken.
///
/// `None` if all values fall into one bin.
pub fn otsu(values: &[f32], bins: usize) -> Option<Otsu> {
    let counts = histogram(values, bins);
    let bins = counts.len();
    let total = counts.iter().sum::<u64>() as f64;
    let centre = |b: usize| (b as f64 + 0.5) / bins as f64;
    let mean = counts.iter().enumerate().map(|(b, &n)| n as f64 * centre(b)).sum::<f64>() / total;
    let (mut below, mut moment) = (0.0, 0.0);
    let (mut first, mut last, mut best) = (0, 0, 0.0);
    for (b, &count) in counts.iter().enumerate() {
        below += count as f64 / total;
        moment += count as f64 / total * centre(b);
        let share = below * (1.0 - below);
        // Zero but for rounding: all values are on one side.
        let between = if share > 1e-12 { (mean * below - moment).powi(2) / share } else { 0.0 };
        if between > best * (1.0 + 1e-9) {
            (first, last, best) = (b, b, between);
        } else if between > best * (1.0 - 1e-9) {
            last = b;
        }
    }
    let variance =
        counts.iter().enumerate().map(|(b, &n)| n as f64 * (centre(b) - mean).powi(2)).sum::<f64>();
    (best > 0.0).then(|| Otsu {
        threshold: (0.5 * (first + last) as f64 + 1.0) / bins as f64,
        separability: best * total / variance,
    })
}

/// The two cuts, the lower first, of the histogram of `values` with the greatest variance between its three classes; values,
/// bins and ties as in [`otsu`]. Takes `bins` squared steps.
///
/// `None` if the values fall into fewer than three bins.
pub fn otsu3(values: &[f32], bins: usize) -> Option<[f64; 2]> {
    let counts = histogram(values, bins);
    if counts.iter().filter(|&&n| n > 0).count() < 3 {
        return None;
    }
    let bins = counts.len();
    // Number of values and sum of their bins below each border; both whole, so that differences are exact.
    let mut sums = vec![[0.0; 2]];
    for (b, &count) in counts.iter().enumerate() {
        let [number, moment] = sums[b];
        sums.push([number + count as f64, moment + count as f64 * b as f64]);
    }
    // The variance between the classes is the sum of these, apart from a constant.
    let class = |from: usize, to: usize| {
        let [number, moment] = [0, 1].map(|k| sums[to][k] - sums[from][k]);
        if number > 0.0 { moment * moment / number } else { 0.0 }
    };
    let (mut best, mut least, mut most) = (0.0, [0; 2], [0; 2]);
    for lower in 1..bins - 1 {
        let below = class(0, lower);
        for upper in lower + 1..bins {
            let between = below + class(lower, upper) + class(upper, bins);
            if between > best * (1.0 + 1e-9) {
                (best, least, most) = (between, [lower, upper], [lower, upper]);
            } else if between > best * (1.0 - 1e-9) {
                least = [least[0].min(lower), least[1].min(upper)];
                most = [most[0].max(lower), most[1].max(upper)];
            }
        }
    }
    Some([0, 1].map(|k| 0.5 * (least[k] + most[k]) as f64 / bins as f64))
}

/// Counts of the finite values in equal bins over `[0, 1]`, at least two.
pub fn histogram(values: &[f32], bins: usize) -> Vec<u64> {
    let mut counts = vec![0; bins.max(2)];
    let bins = counts.len();
    for &value in values.iter().filter(|v| v.is_finite()) {
        counts[bin(value, bins)] += 1;
    }
    counts
}

fn bin(value: f32, bins: usize) -> usize {
    // The cast takes values below zero to zero.
    ((f64::from(value) * bins as f64) as usize).min(bins - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_heaps_are_cut_in_the_middle_of_the_gap() {
        let values: Vec<f32> = (0..90).map(|_| 0.1).chain((0..10).map(|_| 0.7)).collect();
        let cut = otsu(&values, 256).unwrap();
        assert!((cut.threshold - 0.4).abs() < 1.0 / 256.0, "{cut:?}");
        assert!((cut.separability - 1.0).abs() < 1e-9, "{cut:?}");
    }

    #[test]
    fn the_cut_is_the_best_of_all_by_trying_them() {
        let mut state = 3u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 40) as f32 / (1u64 << 24) as f32
        };
        let values: Vec<f32> =
            (0..500).map(|i| if i % 5 == 0 { 0.5 + 0.5 * next() } else { 0.6 * next() }).collect();
        let within = |t: f64| {
            let sides = [true, false].map(|up| {
                let side: Vec<f64> = values
                    .iter()
                    .map(|&v| (bin(v, 64) as f64 + 0.5) / 64.0)
                    .filter(|&c| (c > t) == up)
                    .collect();
                let mean = side.iter().sum::<f64>() / side.len().max(1) as f64;
                side.iter().map(|x| (x - mean).powi(2)).sum::<f64>()
            });
            sides[0] + sides[1]
        };
        let least = (1..64).map(|b| within(b as f64 / 64.0)).fold(f64::INFINITY, f64::min);
        assert!((within(otsu(&values, 64).unwrap().threshold) - least).abs() < 1e-9);
    }

    #[test]
    fn three_heaps_are_cut_in_the_middle_of_both_gaps() {
        let heap = |at: f32, count: usize| std::iter::repeat_n(at, count);
        let values: Vec<f32> = heap(0.1, 700).chain(heap(0.3, 200)).chain(heap(0.8, 100)).collect();
        let [lower, upper] = otsu3(&values, 256).unwrap();
        assert!((lower - 0.2).abs() < 0.01 && (upper - 0.55).abs() < 0.01, "{lower} {upper}");
        assert_eq!(otsu3(&values[..900], 256), None, "two heaps have no three classes");
        assert_eq!(otsu3(&[], 256), None);
        assert_eq!(otsu3(&[0.0, 0.3, 0.9], 2), None);
    }

    #[test]
    fn values_in_one_bin_and_values_that_are_no_numbers_have_no_cut() {
        assert_eq!(otsu(&[], 256), None);
        assert_eq!(otsu(&[0.25; 10], 256), None);
        assert_eq!(otsu(&[f32::NAN, f32::INFINITY, 0.5], 256), None);
    }

    #[test]
    fn values_outside_count_in_the_outer_bins() {
        let cut = otsu(&[-3.0, -2.0, 1.0, 7.0], 16).unwrap();
        assert_eq!((cut.threshold, cut.separability), (0.5, 1.0));
    }
}
