//! Least-squares lines in the plane.

use crate::math::vec2::{along, cross, dot, mean, sub};

/// A straight line through a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    /// The mean of the points.
    pub at: [f64; 2],
    /// Unit direction, from the first point towards the last.
    pub direction: [f64; 2],
}

impl Line {
    /// The line of least squared distances; `None` for fewer than two points or coincident ones.
    pub(crate) fn fit(points: &[[f64; 2]]) -> Option<Self> {
        let (first, last) = (points.first()?, points.last()?);
        let at = mean(points);
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for &p in points {
            let [x, y] = sub(p, at);
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        if xx + yy <= 0.0 {
            return None;
        }
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        let direction = [angle.cos(), angle.sin()];
        let forward = dot(sub(*last, *first), direction) >= 0.0;
        Some(Self { at, direction: if forward { direction } else { direction.map(|x| -x) } })
    }

    /// Distance of a point from the line.
    pub(crate) fn off(&self, p: [f64; 2]) -> f64 {
        cross(self.direction, sub(p, self.at)).abs()
    }

    /// The point of the line nearest to `p`.
    pub(crate) fn foot(&self, p: [f64; 2]) -> [f64; 2] {
        along(self.at, self.direction, dot(self.direction, sub(p, self.at)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_a_line_give_it() {
        let line = Line::fit(&[[0.0, 1.0], [1.0, 2.0], [2.0, 3.0]]).unwrap();
        assert!(line.off([5.0, 6.0]) < 1e-12);
        assert!(Line::fit(&[[1.0, 1.0]; 3]).is_none());
    }
}
