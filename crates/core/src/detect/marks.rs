//! A measure's points above its own threshold.

use crate::math::otsu::otsu;
use crate::measure::Class;

/// A score for every point and the threshold above which a point is marked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// `(N)` the measure over its greatest value, 0 to 1.
    pub score: Vec<f32>,
    /// What the measure was divided by: its greatest value, in its own unit.
    pub greatest: f64,
    /// Scores above it are marked; infinite when the scores have no two classes.
    pub threshold: f64,
    /// How well the threshold parts the scores, 0 to 1 (Otsu's eta).
    pub separability: f64,
}

impl Marks {
    /// Normalises `values`, none of them negative, and cuts their histogram of `bins` bins by Otsu's method (Tran 2013,
    /// section 2.4). Where no value is above `least` all are rounding, and there is nothing to mark.
    pub fn new(mut values: Vec<f32>, least: f64, bins: usize) -> Marks {
        let greatest = values.iter().fold(0.0f32, |a, &b| a.max(b));
        if greatest > 0.0 {
            values.iter_mut().for_each(|v| *v /= greatest);
        }
        let cut = otsu(&values, bins).filter(|_| f64::from(greatest) > least);
        Marks {
            score: values,
            greatest: greatest.into(),
            threshold: cut.map_or(f64::INFINITY, |c| c.threshold),
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

    #[test]
    fn scores_are_relative_to_the_greatest_and_the_greater_heap_is_marked() {
        let marks = Marks::new(vec![0.0, 0.1, 4.0, 0.2, 3.8], 0.0, 256);
        assert_eq!((marks.score[2], marks.greatest), (1.0, 4.0));
        assert_eq!(marks.count(), 2);
        let [smooth, crease] = [Class::Smooth, Class::Crease];
        assert_eq!(marks.classes(), [smooth, smooth, crease, smooth, crease]);
    }

    #[test]
    fn equal_values_and_values_of_rounding_mark_nothing() {
        assert_eq!(Marks::new(vec![1e-17, 3e-17, 0.0], 1e-9, 256).count(), 0);
        assert_eq!(Marks::new(vec![0.0; 5], 0.0, 256).count(), 0);
        assert_eq!(Marks::new(vec![2.0; 5], 0.0, 256).count(), 0);
        assert_eq!(Marks::new(Vec::new(), 0.0, 256).count(), 0);
    }
}
