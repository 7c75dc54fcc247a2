//! The nesting of contours: which lies within which.

use crate::curve::polygon::{contains, measure};

/// For each contour the smallest closed one around it, by a point inside of its extent. Open contours have a
/// surrounding contour too, but surround nothing.
pub(crate) fn parents(contours: &[(Vec<[f64; 2]>, bool)]) -> Vec<Option<usize>> {
    let areas: Vec<f64> = contours.iter().map(|(p, c)| measure(p, *c).area.abs()).collect();
    let boxes: Vec<[f64; 4]> = contours.iter().map(|(p, _)| bounds(p)).collect();
    let inside = |i: usize, j: usize| {
        let (b, o) = (boxes[i], boxes[j]);
        let apart = b[0] < o[0] || b[1] < o[1] || b[2] > o[2] || b[3] > o[3];
        contours[j].1 && !apart && mostly_inside(&contours[i].0, &contours[j].0)
    };
    let around = |i: usize| {
        let larger = |&j: &usize| j != i && (areas[j] > areas[i] || (areas[j] == areas[i] && j < i));
        let mut candidates: Vec<usize> = (0..contours.len()).filter(larger).collect();
        candidates.sort_by(|&a, &b| areas[a].total_cmp(&areas[b]).then(a.cmp(&b)));
        candidates.into_iter().find(|&j| inside(i, j))
    };
    (0..contours.len()).map(around).collect()
}

fn bounds(points: &[[f64; 2]]) -> [f64; 4] {
    let start = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    points.iter().fold(start, |b, p| [b[0].min(p[0]), b[1].min(p[1]), b[2].max(p[0]), b[3].max(p[1])])
}

/// Several vertices vote, as touching contours may cross by the noise.
fn mostly_inside(inner: &[[f64; 2]], outer: &[[f64; 2]]) -> bool {
    let step = (inner.len() / 9).max(1);
    let votes: Vec<bool> = inner.iter().step_by(step).map(|&p| contains(outer, p)).collect();
    votes.iter().filter(|&&v| v).count() * 2 > votes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(half: f64) -> Vec<[f64; 2]> {
        vec![[-half, -half], [half, -half], [half, half], [-half, half]]
    }

    #[test]
    fn squares_nest_by_size() {
        let contours = vec![(square(1.0), true), (square(3.0), true), (square(2.0), true)];
        assert_eq!(parents(&contours), [Some(2), None, Some(1)]);
    }
}
