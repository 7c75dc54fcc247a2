//! Why some stages do not run over tiles yet, each by its smallest case: see `docs/scale.md`.

use crate::neighbors::Index;

/// Edgelets add up weights in this order.
#[test]
fn sums_around_a_point_run_in_the_order_of_blocks() {
    let near = |k: usize| [(k % 8) as f64, (k / 8) as f64, 0.0];
    let mut points: Vec<[f64; 3]> = (0..40).map(near).collect();
    let order = |points: &[[f64; 3]]| {
        let mut order = Vec::new();
        Index::build(points).around([3.5, 3.0, 0.0], 2.0, |f| order.push(f.index));
        order
    };
    let few = order(&points);
    // A point far from all that is looked at changes where the block is cut.
    points.push([0.0, 100.0, 0.0]);
    let more = order(&points);
    assert_ne!(few, more);
    let sorted = |mut order: Vec<u32>| {
        order.sort_unstable();
        order
    };
    assert_eq!(sorted(few), sorted(more));
}
