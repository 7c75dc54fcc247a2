//! B-spline curves, clamped or periodic.

/// A B-spline curve in space, or in `D` dimensions, clamped or periodic, of degree 1 to 3.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "[f64; D]: serde::Serialize",
        deserialize = "[f64; D]: serde::Deserialize<'de>"
    ))
)]
pub struct BSpline<const D: usize = 3> {
    /// Polynomial degree; 3 unless the strip is too short for it.
    pub degree: usize,
    /// Non-decreasing knots on the chord-length parameter. Clamped: `controls.len() + degree + 1` of them, the
    /// first and last `degree + 1` equal. Periodic: `controls.len() + 1` of them, one period.
    pub knots: Vec<f64>,
    /// `(C, D)` control points.
    pub controls: Vec<[f64; D]>,
    /// Whether the curve closes smoothly on itself.
    pub periodic: bool,
}

/// The greatest degree.
pub(super) const MAX_DEGREE: usize = 3;

/// A clamped curve's knots: `spans` equal ones over `[0, length]`.
pub(super) fn clamped_knots(degree: usize, spans: usize, length: f64) -> Vec<f64> {
    let inner = (0..=spans).map(|i| length * (i as f64 / spans as f64));
    std::iter::repeat_n(0.0, degree).chain(inner).chain(std::iter::repeat_n(length, degree)).collect()
}

impl<const D: usize> BSpline<D> {
    /// The parameters at which the curve begins and ends (closes, if periodic).
    pub fn domain(&self) -> (f64, f64) {
        if self.periodic {
            (self.knots[0], self.knots[self.controls.len()])
        } else {
            (self.knots[self.degree], self.knots[self.controls.len()])
        }
    }

    /// The point at parameter `t`, clamped to the domain or wrapped into the period.
    pub fn point(&self, t: f64) -> [f64; D] {
        let (controls, weights) = self.basis(t);
        let mut p = [0.0; D];
        for (i, w) in controls.into_iter().zip(weights).take(self.degree + 1) {
            for (x, c) in p.iter_mut().zip(self.controls[i]) {
                *x += w * c;
            }
        }
        p
    }

    /// The indices of the `degree + 1` control points with influence at `t`, with their weights.
    pub fn basis(&self, t: f64) -> ([usize; MAX_DEGREE + 1], [f64; MAX_DEGREE + 1]) {
        let (t, span) = self.locate(t);
        let mut weights = [0.0; MAX_DEGREE + 1];
        weights[0] = 1.0;
        for d in 1..=self.degree {
            let mut carried = 0.0;
            for r in 0..d {
                let right = self.knot(span + 1 + r as isize);
                let left = self.knot(span + 1 + r as isize - d as isize);
                let share = if right > left { weights[r] / (right - left) } else { 0.0 };
                weights[r] = carried + (right - t) * share;
                carried = (t - left) * share;
            }
            weights[d] = carried;
        }
        let mut controls = [0; MAX_DEGREE + 1];
        let count = self.controls.len() as isize;
        for (r, c) in controls.iter_mut().enumerate().take(self.degree + 1) {
            let i = span - self.degree as isize + r as isize;
            *c = if self.periodic { i.rem_euclid(count) as usize } else { i as usize };
        }
        (controls, weights)
    }

    /// The parameter brought into the domain, and the index of the last knot at or below it.
    fn locate(&self, t: f64) -> (f64, isize) {
        let (first, last) = self.domain();
        let t = if self.periodic && last > first {
            first + (t - first).rem_euclid(last - first)
        } else {
            t.clamp(first, last)
        };
        let (low, high) =
            if self.periodic { (0, self.controls.len()) } else { (self.degree, self.controls.len()) };
        let inner = &self.knots[low..=high];
        let at = inner.partition_point(|&k| k <= t).clamp(1, inner.len() - 1) - 1;
        (t, (low + at) as isize)
    }

    /// Knot `i`, continued over the period of a periodic curve.
    fn knot(&self, i: isize) -> f64 {
        if !self.periodic {
            return self.knots[i as usize];
        }
        let count = self.controls.len() as isize;
        let period = self.knots[self.controls.len()] - self.knots[0];
        self.knots[i.rem_euclid(count) as usize] + period * i.div_euclid(count) as f64
    }

    /// The same curve in the clamped form, which every program reads: its ends are its first and its last control point, and it has
    /// `controls + degree + 1` knots.
    pub fn clamped(&self) -> BSpline<D> {
        if !self.periodic {
            return self.clone();
        }
        let (degree, count) = (self.degree, self.controls.len());
        let (from, to) = self.domain();
        let inner = self.knots[1..count].iter().copied();
        let ends = |t: f64| std::iter::repeat_n(t, degree + 1);
        let knots: Vec<f64> = ends(from).chain(inner).chain(ends(to)).collect();
        let control = |j: usize| {
            // Any stretch of the curve that the control point has influence on.
            let span = (j.max(degree)..=j + degree).find(|&m| knots[m] < knots[m + 1]).unwrap_or(degree);
            self.blossom(span as isize - degree as isize, &knots[j + 1..=j + degree])
        };
        let controls = (0..count + degree).map(control).collect();
        BSpline { degree, controls, knots, periodic: false }
    }

    /// The polar form of the polynomial from knot `span` to the next, one argument for each degree.
    fn blossom(&self, span: isize, arguments: &[f64]) -> [f64; D] {
        let (degree, count) = (self.degree as isize, self.controls.len() as isize);
        let own = |i: isize| self.controls[i.rem_euclid(count) as usize];
        let mut points: Vec<[f64; D]> = (span - degree..=span).map(own).collect();
        for (round, &t) in (1..).zip(arguments) {
            for i in (round..=degree).rev() {
                let left = self.knot(span - degree + i);
                let right = self.knot(span + i + 1 - round);
                let share = if right > left { (t - left) / (right - left) } else { 0.0 };
                let [a, b] = [i - 1, i].map(|i| points[i as usize]);
                points[i as usize] = std::array::from_fn(|k| a[k] + share * (b[k] - a[k]));
            }
        }
        points[self.degree]
    }

    /// The curve with every control point mapped by an affine `map` and its parameter scaled by `scale`.
    pub fn mapped<const E: usize>(&self, map: impl Fn([f64; D]) -> [f64; E], scale: f64) -> BSpline<E> {
        BSpline {
            degree: self.degree,
            knots: self.knots.iter().map(|k| k * scale).collect(),
            controls: self.controls.iter().map(|&c| map(c)).collect(),
            periodic: self.periodic,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_a_partition_of_one_and_ends_are_the_end_controls() {
        let controls: Vec<[f64; 3]> = (0..7).map(|i| [i as f64, (i * i) as f64, 1.0]).collect();
        let curve = BSpline { degree: 3, knots: clamped_knots(3, 4, 8.0), controls, periodic: false };
        for i in 0..=80 {
            let sum: f64 = curve.basis(i as f64 * 0.1).1.iter().sum();
            assert!((sum - 1.0).abs() < 1e-14);
        }
        assert_eq!(curve.point(0.0), curve.controls[0]);
        assert_eq!(curve.point(8.0), curve.controls[6]);
    }

    #[test]
    fn a_periodic_curve_closes_with_continuous_slope() {
        let controls =
            vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.5, -0.5, 0.3]];
        let knots = vec![0.0, 1.0, 2.5, 3.0, 4.0, 5.0];
        let curve = BSpline { degree: 3, knots, controls, periodic: true };
        let slope = |t: f64| {
            let (a, b) = (curve.point(t - 1e-6), curve.point(t + 1e-6));
            [b[0] - a[0], b[1] - a[1], b[2] - a[2]].map(|x| x / 2e-6)
        };
        for (a, b) in slope(1e-5).iter().zip(slope(5.0 - 1e-5)) {
            assert!((a - b).abs() < 1e-3, "{a} {b}");
        }
        assert_eq!(curve.point(0.0), curve.point(5.0));
    }

    #[test]
    fn the_clamped_form_of_a_periodic_curve_is_the_same_curve() {
        let controls: Vec<[f64; 3]> =
            (0..5).map(|i| [i as f64, (i * i) as f64, 1.0 / (i + 1) as f64]).collect();
        for (degree, knots) in [1, 2, 3, 3]
            .into_iter()
            .zip([[0.0, 1.0, 2.5, 3.0, 4.0, 5.0]; 3].into_iter().chain([[0.0, 1.0, 1.0, 1.5, 4.0, 5.0]]))
        {
            let curve = BSpline { degree, knots: knots.to_vec(), controls: controls.clone(), periodic: true };
            let clamped = curve.clamped();
            assert_eq!(clamped.knots.len(), clamped.controls.len() + degree + 1);
            assert_eq!((clamped.domain(), clamped.periodic), (curve.domain(), false));
            for t in (0..=50).map(|i| 0.1 * f64::from(i)) {
                let (a, b) = (curve.point(t), clamped.point(t));
                assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12), "{a:?} {b:?} at {t}, degree {degree}");
            }
        }
    }
}
