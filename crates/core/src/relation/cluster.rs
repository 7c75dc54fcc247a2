//! Numbers that are the same within their variances: one after the other, the surest first, joins the likeliest mean beside it. The means are
//! kept in order, so that `n` numbers cost `O(n log n)` comparisons.

use super::odds;

/// Numbers that are the same.
#[derive(Clone, Debug)]
pub(super) struct Cluster {
    /// Their indices, ascending.
    pub members: Vec<usize>,
    /// Their weighted mean.
    pub mean: f64,
    /// Probability of the least likely of them; 1 of one alone.
    pub likelihood: f64,
    weight: f64,
}

/// The clusters of numbers, each with its variance, ascending. By chance they lie anywhere over the length `extent`; members are at least
/// `least` likely.
pub(super) fn clusters(numbers: &[(f64, f64)], extent: f64, least: f64) -> Vec<Cluster> {
    let mut order: Vec<usize> = (0..numbers.len()).filter(|&i| numbers[i].1.is_finite()).collect();
    order.sort_by(|&a, &b| numbers[a].1.total_cmp(&numbers[b].1).then(numbers[a].0.total_cmp(&numbers[b].0)));
    let mut found: Vec<Cluster> = Vec::new();
    for i in order {
        let (value, variance) = numbers[i];
        let next = found.partition_point(|c| c.mean < value);
        let chance = found.len() as f64 / extent.max(f64::MIN_POSITIVE);
        let likelihood = |c: &Cluster| odds::of_number(value - c.mean, variance + 1.0 / c.weight, chance);
        let beside = [next.checked_sub(1), Some(next)].into_iter().flatten().filter(|&k| k < found.len());
        let best = beside.map(|k| (k, likelihood(&found[k]))).max_by(|a, b| a.1.total_cmp(&b.1));
        match best.filter(|b| b.1 >= least) {
            Some((k, likelihood)) => {
                let cluster = &mut found[k];
                cluster.weight += 1.0 / variance;
                cluster.mean += (value - cluster.mean) / variance / cluster.weight;
                cluster.likelihood = cluster.likelihood.min(likelihood);
                cluster.members.push(i);
            }
            None => {
                let alone =
                    Cluster { members: vec![i], mean: value, likelihood: 1.0, weight: 1.0 / variance };
                found.insert(next, alone);
            }
        }
    }
    found.iter_mut().for_each(|c| c.members.sort_unstable());
    found
}

/// Root mean square distance of the members from the mean.
pub(super) fn deviation(cluster: &Cluster, numbers: &[(f64, f64)]) -> f64 {
    let squares: f64 = cluster.members.iter().map(|&i| (numbers[i].0 - cluster.mean).powi(2)).sum();
    (squares / cluster.members.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_within_their_deviations_are_one_and_others_are_not() {
        let numbers =
            [(1.0, 1e-4), (5.0, 1e-4), (1.02, 4e-4), (4.99, 1e-4), (1.2, 1e-4), (3.0, f64::INFINITY)];
        let found = clusters(&numbers, 60.0, 0.9);
        let members: Vec<Vec<usize>> = found.iter().map(|c| c.members.clone()).collect();
        assert_eq!(members, [vec![0, 2], vec![4], vec![1, 3]]);
        assert!((found[0].mean - 1.004).abs() < 1e-12, "{}", found[0].mean);
    }
}
