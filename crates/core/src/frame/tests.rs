use super::*;

fn random(n: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut s = seed;
    let mut next = || {
        s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (s >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..n).map(|_| [next(), next(), next()]).collect()
}

fn localise(points: &[[f64; 3]]) -> Localised {
    Frame::localise(&Cloud::new(points.to_vec())).unwrap()
}

#[test]
fn order_is_that_of_the_set() {
    let mut points = random(1000, 3);
    let a = localise(&points);
    points.reverse();
    let b = localise(&points);
    assert_eq!(a.positions, b.positions);
    assert_eq!((a.dropped, a.merged), (0, 0));
}
