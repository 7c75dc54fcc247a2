use super::*;

fn random(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut s = seed;
    let mut next = || {
        s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (s >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..n).map(|_| [next(), next(), next()]).collect()
}

fn brute(points: &[[f64; 3]], k: usize) -> Neighbors {
    let k = k.min(points.len().saturating_sub(1));
    let mut indices = Vec::new();
    for (i, p) in points.iter().enumerate() {
        let mut all: Vec<(f64, u32)> = (0..points.len())
            .filter(|&j| j != i)
            .map(|j| (crate::math::vec3::distance2(points[j], *p), j as u32))
            .collect();
        all.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        indices.extend(all[..k].iter().map(|a| a.1));
    }
    Neighbors { offsets: (0..=points.len() as u64).map(|i| i * k as u64).collect(), indices }
}

#[test]
fn lists_of_random_points_are_those_of_brute_force() {
    for n in [0, 1, 2, 3, 15, 16, 17, 100, 1000] {
        let points = random(n, 7);
        for k in [0, 1, 2, 10, 16, 33] {
            assert_eq!(all_nearest(&points, k), brute(&points, k), "n {n} k {k}");
        }
    }
}

#[test]
fn instructions_agree() {
    let points = random(20_000, 9);
    for k in [5, 10, 16, 24] {
        let a = all_nearest(&points, k);
        assert_eq!(a, all_nearest_with(&points, k, Instructions::Narrow));
        assert_eq!(a, all_nearest_with(&points, k, Instructions::Baseline));
    }
}
