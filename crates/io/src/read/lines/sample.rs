//! Curves as rows of points.

use lineament::math::vec3::{add_scaled, cross, unit};

/// Angle between neighbouring points of an arc: a chord leaves it by at most 1e-5 of the radius.
const ARC_STEP: f64 = std::f64::consts::PI / 360.0;
/// Points on each span of a spline.
const SPAN: usize = 48;
/// The greatest degree of a spline.
const MAX_DEGREE: usize = 24;
/// Turns of an arc beyond which it is none.
const MOST_TURNS: f64 = 2.0;

/// Points of an ellipse from one parameter to another, both included; of a circle if the half axes `x` and `y`, which are across each
/// other, have one length. `None` for angles that are not finite, or beyond two turns.
pub(super) fn ellipse(
    centre: [f64; 3],
    x: [f64; 3],
    y: [f64; 3],
    [from, to]: [f64; 2],
) -> Option<Vec<[f64; 3]>> {
    let sweep = to - from;
    if !(sweep.abs() <= MOST_TURNS * std::f64::consts::TAU) {
        return None;
    }
    let count = (sweep.abs() / ARC_STEP).ceil().max(1.0) as usize;
    let at = |i: usize| {
        let (sin, cos) = (from + sweep * (i as f64 / count as f64)).sin_cos();
        add_scaled(add_scaled(centre, x, cos), y, sin)
    };
    let mut points: Vec<[f64; 3]> = (0..=count).map(at).collect();
    if (sweep.abs() - std::f64::consts::TAU).abs() < 1e-9 {
        points[count] = points[0];
    }
    Some(points)
}

/// The x and y axes of the plane across `normal` in which DXF has the coordinates of plane entities (the arbitrary axis algorithm).
pub(super) fn object_axes(normal: [f64; 3]) -> [[f64; 3]; 3] {
    let z = unit(normal);
    let near = z[0].abs() < 1.0 / 64.0 && z[1].abs() < 1.0 / 64.0;
    let x = unit(cross(if near { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] }, z));
    [x, cross(z, x), z]
}

/// A B-spline, rational where it has weights.
#[derive(Debug)]
pub(super) struct Spline {
    pub degree: usize,
    pub knots: Vec<f64>,
    pub controls: Vec<[f64; 3]>,
    /// As many as controls, or none.
    pub weights: Vec<f64>,
}

impl Spline {
    /// Points along its whole domain.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn points(&self) -> Result<Vec<[f64; 3]>, String> {
        self.check()?;
        let (p, n) = (self.degree, self.controls.len());
        let mut points = Vec::new();
        for span in p..n {
            let [low, high] = [self.knots[span], self.knots[span + 1]];
            if low >= high {
                continue;
            }
            let count = if p == 1 { 1 } else { SPAN };
            let from = usize::from(!points.is_empty());
            let at = |i: usize| low + (high - low) * (i as f64 / count as f64);
            points.extend((from..=count).map(|i| self.point(span, at(i))));
        }
        Ok(points)
    }

    fn check(&self) -> Result<(), String> {
        let Self { degree, knots, controls, weights } = self;
        if !(1..=MAX_DEGREE).contains(degree) || controls.len() <= *degree {
            return Err(format!("a spline of degree {degree} with {} controls", controls.len()));
        }
        if knots.len() != controls.len() + degree + 1 {
            return Err(format!(
                "a spline of degree {degree} with {} controls and {} knots",
                controls.len(),
                knots.len()
            ));
        }
        if knots.windows(2).any(|w| !(w[0] <= w[1])) || knots.iter().any(|k| !k.is_finite()) {
            return Err("a spline whose knots do not ascend".into());
        }
        if !(weights.is_empty() || weights.len() == controls.len() && weights.iter().all(|&w| w > 0.0)) {
            return Err(format!("a spline of {} controls with {} weights", controls.len(), weights.len()));
        }
        Ok(())
    }

    /// The point at `t` of the span that begins with knot `span` (de Boor's algorithm).
    fn point(&self, span: usize, t: f64) -> [f64; 3] {
        let p = self.degree;
        let weighted = |i: usize| {
            let w = self.weights.get(i).copied().unwrap_or(1.0);
            let [x, y, z] = self.controls[i];
            [x * w, y * w, z * w, w]
        };
        let mut d: Vec<[f64; 4]> = (span - p..=span).map(weighted).collect();
        for round in 1..=p {
            for j in (round..=p).rev() {
                let i = span - p + j;
                let (left, right) = (self.knots[i], self.knots[i + 1 + p - round]);
                let share = if right > left { (t - left) / (right - left) } else { 0.0 };
                d[j] = std::array::from_fn(|k| d[j - 1][k] + share * (d[j][k] - d[j - 1][k]));
            }
        }
        let [x, y, z, w] = d[p];
        [x / w, y / w, z / w]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lineament::math::vec3::norm;

    #[test]
    fn a_rational_spline_is_the_circle_that_it_stands_for() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let quarter = Spline {
            degree: 2,
            knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            controls: vec![[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            weights: vec![1.0, half, 1.0],
        };
        let points = quarter.points().unwrap();
        assert!(points.len() > 40 && points.iter().all(|&p| (norm(p) - 1.0).abs() < 1e-12));
        assert_eq!((points[0], points[points.len() - 1]), ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
        let plain = Spline { weights: Vec::new(), ..quarter };
        assert!(plain.points().unwrap().iter().any(|&p| norm(p) > 1.01));
    }

    #[test]
    fn splines_that_are_none_are_refused() {
        let bad = |knots: &[f64]| {
            let controls = vec![[0.0; 3]; 3];
            Spline { degree: 2, knots: knots.to_vec(), controls, weights: Vec::new() }.points().is_err()
        };
        assert!(bad(&[0.0, 0.0, 1.0, 1.0]));
        assert!(bad(&[0.0, 0.0, 0.0, 1.0, 0.5, 1.0]));
        assert!(bad(&[0.0, 0.0, f64::NAN, 1.0, 1.0, 1.0]));
    }

    #[test]
    fn a_whole_circle_ends_where_it_begins() {
        let circle =
            ellipse([5.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.3, 0.3 + std::f64::consts::TAU]);
        let circle = circle.unwrap();
        assert_eq!(circle.first(), circle.last());
        assert_eq!(circle.len(), 721);
        assert!(ellipse([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, f64::NAN]).is_none());
    }
}
