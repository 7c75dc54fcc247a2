//! The part of the space that pictures and reports show: a stray point far away would leave the rest a dot.

use crate::math::quantile::quantile;

/// Share of the points on each side, coordinate by coordinate, that may lie far from the others; three points at least.
const FAR: f64 = 1e-3;

/// Points that may lie far away, whatever their number.
const FEW: f64 = 3.0;

/// Greatest share of the points that may.
const MOST: f64 = 0.1;

/// A box around nearly all points, and room around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    low: [f64; 3],
    high: [f64; 3],
}

impl Shown {
    /// The box around finite points: that of all but a thousandth of them on each side, with its longest side as room around it.
    pub fn around(points: &[[f64; 3]]) -> Shown {
        // Of few points all are shown.
        let few =
            Some(FEW / points.len().max(1) as f64).filter(|&few| few <= MOST).map_or(0.0, |few| few.max(FAR));
        let axis = |k: usize| {
            let mut values: Vec<f64> = points.iter().map(|p| p[k]).collect();
            [quantile(&mut values, few), quantile(&mut values, 1.0 - few)]
        };
        let most = [axis(0), axis(1), axis(2)];
        let longest = most.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        Shown { low: most.map(|[low, _]| low - longest), high: most.map(|[_, high]| high + longest) }
    }

    /// Whether a point lies in the box.
    pub fn holds(&self, point: [f64; 3]) -> bool {
        (0..3).all(|k| (self.low[k]..=self.high[k]).contains(&point[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_points_far_away_are_not_shown_and_all_others_are() {
        let near: Vec<[f64; 3]> =
            (0..400).map(|i| [f64::from(i % 20), f64::from(i / 20), f64::from(i % 3)]).collect();
        for far in [100.0, 1e38] {
            let points: Vec<[f64; 3]> =
                near.iter().copied().chain([[far, 0.0, 0.0], [0.0, -far, 1.0]]).collect();
            let shown = Shown::around(&points);
            assert_eq!(points.iter().filter(|&&p| !shown.holds(p)).count(), 2);
        }
        let line: Vec<[f64; 3]> = (0..10).map(|i| [f64::from(i), 7.0, 7.0]).collect();
        for part in [&near[..], &line[..], &line[..2], &line[..1]] {
            let shown = Shown::around(part);
            assert!(part.iter().all(|&p| shown.holds(p)), "{part:?}");
        }
    }
}
