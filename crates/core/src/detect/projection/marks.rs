//! Marks: the points whose measure is above an automatic threshold (Tran 2013, section 2.4).

use crate::math::otsu::{Otsu, otsu, otsu3};
use crate::measure::Class;
use crate::params::ProjectionParams;

/// Share of the points that marks of two classes must stay below: most of a surface is not on lines.
const MINORITY: f64 = 0.5;

/// Values below which a measure is not significant, in its unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Floor {
    /// Values up to this are rounding or noise.
    pub mark: f64,
    /// Points with values up to this are not beside an edge.
    pub beside: f64,
}

/// A score for every point and the threshold above which a point is marked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// `(N)` the measure relative to its greatest value, 0 to 1.
    pub score: Vec<f32>,
    /// The greatest value of the measure, in its own unit.
    pub greatest: f64,
    /// Points with scores above it are marked; infinite if the scores do not form two classes.
    pub threshold: f64,
    /// Separability of the scores into two classes by one cut, 0 to 1 (Otsu's eta).
    pub separability: f64,
}

impl Marks {
    /// Normalises `values`, none of them negative, and cuts their histogram by Otsu's method (Tran 2013, section 2.4).
    ///
    /// Values up to `floor` are never marked. If `params` ask for three classes (on an edge, beside it, smooth), the upper two
    /// are marked, unless the cut between the lower two is within the noise or marks half of the points or more. In that case,
    /// and for two classes, the cut is the paper's.
    pub fn new(mut values: Vec<f32>, floor: Floor, params: &ProjectionParams) -> Marks {
        let greatest = values.iter().fold(0.0f32, |a, &b| a.max(b));
        if greatest > 0.0 {
            values.iter_mut().for_each(|v| *v /= greatest);
        }
        let [least, beside] = [floor.mark, floor.beside].map(|l| l / f64::from(greatest));
        let cut = otsu(&values, params.bins).filter(|_| least < 1.0);
        let three = (params.classes > 2).then(|| otsu3(&values, params.bins)).flatten();
        let lower = three.map(|[lower, _]| lower.max(beside)).filter(|&lower| {
            let above = values.iter().filter(|&&v| f64::from(v) > lower).count() as f64;
            lower > least && above < MINORITY * values.len() as f64
        });
        let threshold = |cut: Otsu| lower.unwrap_or(cut.threshold).min(cut.threshold).max(least);
        Marks {
            score: values,
            greatest: greatest.into(),
            threshold: cut.map_or(f64::INFINITY, threshold),
            separability: cut.map_or(0.0, |c| c.separability),
        }
    }

    /// Whether point `i` is marked.
    ///
    /// # Panics
    /// If there is no such point.
    pub fn is_marked(&self, i: usize) -> bool {
        f64::from(self.score[i]) > self.threshold
    }

    /// The number of points marked.
    pub fn count(&self) -> usize {
        (0..self.score.len()).filter(|&i| self.is_marked(i)).count()
    }

    /// `(N)` crease for the marked points, smooth for the others: the measures do not tell corners from edges.
    pub fn classes(&self) -> Vec<Class> {
        let class = |i| if self.is_marked(i) { Class::Crease } else { Class::Smooth };
        (0..self.score.len()).map(class).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marks(values: Vec<f32>, mark: f64) -> Marks {
        Marks::new(values, Floor { mark, beside: 0.0 }, &ProjectionParams::default())
    }

    #[test]
    fn scores_are_relative_to_the_greatest_and_the_greater_heap_is_marked() {
        let marks = marks(vec![0.0, 0.0, 4.0, 0.0, 3.8], 0.0);
        assert_eq!((marks.score[2], marks.greatest), (1.0, 4.0));
        assert_eq!(marks.count(), 2);
        let [smooth, crease] = [Class::Smooth, Class::Crease];
        assert_eq!(marks.classes(), [smooth, smooth, crease, smooth, crease]);
    }

    #[test]
    fn equal_values_and_values_of_rounding_mark_nothing() {
        assert_eq!(marks(vec![1e-17, 3e-17, 0.0], 1e-9).count(), 0);
        assert_eq!(marks(vec![0.0; 5], 0.0).count(), 0);
        assert_eq!(marks(vec![2.0; 5], 0.0).count(), 0);
        assert_eq!(marks(Vec::new(), 0.0).count(), 0);
    }

    /// Values of points on an edge, beside it and away from it, as many as given.
    fn heaps(counts: [usize; 3]) -> Vec<f32> {
        [0.6, 0.2, 0.0].into_iter().zip(counts).flat_map(|(v, n)| std::iter::repeat_n(v, n)).collect()
    }

    #[test]
    fn points_beside_an_edge_are_marked_where_they_are_no_majority_and_no_noise() {
        assert_eq!(marks(heaps([10, 20, 70]), 0.01).count(), 30);
        assert_eq!(marks(heaps([25, 35, 40]), 0.01).count(), 25);
        assert_eq!(marks(heaps([10, 20, 70]), 0.3).count(), 10);
        let two = ProjectionParams { classes: 2, ..Default::default() };
        let floor = Floor { mark: 0.01, beside: 0.3 };
        assert_eq!(Marks::new(heaps([10, 20, 70]), floor, &two).count(), 10);
        assert_eq!(Marks::new(heaps([10, 20, 70]), floor, &ProjectionParams::default()).count(), 10);
    }

    #[test]
    fn nothing_within_the_noise_is_marked() {
        assert_eq!(marks(heaps([10, 20, 70]), 0.7).count(), 0);
        assert_eq!(marks(vec![0.1, 0.2, 0.0, 0.0, 0.25], 0.22).count(), 1);
    }
}
