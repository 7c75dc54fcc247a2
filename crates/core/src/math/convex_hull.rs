//! Convex hulls in the plane.

use super::vec2::{cross, distance, sub};

/// The vertices of the convex hull of some points, counter-clockwise (Andrew's monotone chain); `at` gives the position of a
/// point. Of points in one place the lowest index counts. O(n log n).
pub fn convex_hull(points: &[usize], at: impl Fn(usize) -> [f64; 2]) -> Vec<usize> {
    let mut order = points.to_vec();
    order.sort_by(|&a, &b| {
        let (p, q) = (at(a), at(b));
        p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(a.cmp(&b))
    });
    order.dedup_by(|a, b| distance(at(*a), at(*b)) == 0.0);
    if order.len() < 3 {
        return order;
    }
    let mut result = half(&order, &at);
    order.reverse();
    result.extend(half(&order, &at));
    result
}

/// One half of the hull without its last vertex.
fn half(order: &[usize], at: impl Fn(usize) -> [f64; 2]) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for &m in order {
        while let [.., a, b] = chain[..] {
            if cross(sub(at(b), at(a)), sub(at(m), at(b))) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(m);
    }
    chain.pop();
    chain
}

#[cfg(test)]
mod tests {
    use super::convex_hull;

    #[test]
    fn the_hull_of_a_grid_is_its_corners() {
        let at = |i: usize| [(i % 5) as f64, (i / 5) as f64];
        let all: Vec<usize> = (0..25).collect();
        assert_eq!(convex_hull(&all, at), [0, 4, 24, 20]);
        assert_eq!(convex_hull(&[7, 7], at), [7]);
    }
}
