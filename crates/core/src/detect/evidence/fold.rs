//! Whether a cross-section is sharp or smooth: the residual of a wedge against those of smooth shapes.
//!
//! Curvature alone cannot tell a crease from a fillet, as both turn within a few spacings. But the shapes of their
//! cross-sections differ: a hinge `|s - s0|` is compared with a parabola, a circle and one-sided parabolas (a face that runs
//! tangentially into a round). Each is fitted together with a straight line, so all have the same number of coefficients.
//! This goes beyond Gumhold 2001, whose curvature penalty accepts both.

/// Points of a cross-section: `s` across the line, `z` along the bisector of the faces, spacings.
#[derive(Clone, Debug, Default)]
pub struct CrossSection {
    s: Vec<f64>,
    z: Vec<f64>,
}

/// The comparison of a wedge with smooth shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fold {
    /// Residual of the best smooth shape less that of the best wedge, in variances of the noise: positive values indicate a
    /// crease.
    pub evidence: f64,
    /// The evidence expected of this wedge without noise.
    pub expected: f64,
    /// Angle between the sides of the best wedge, radians, signed by its sense.
    pub angle: f64,
}

/// Positions tried for the edge of the wedge, spacings from the foot.
const HINGES: [f64; 7] = [-0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9];
/// Positions tried for the beginning of a one-sided round, spacings from the foot.
const ROUNDS: [f64; 4] = [-1.5, -0.5, 0.5, 1.5];
/// Fewest points by which the shapes can be told apart.
const FEWEST_POINTS: usize = 8;

impl CrossSection {
    /// Removes all points.
    pub fn clear(&mut self) {
        self.s.clear();
        self.z.clear();
    }

    /// Adds a point.
    pub fn push(&mut self, s: f64, z: f64) {
        self.s.push(s);
        self.z.push(z);
    }

    /// Compares wedge and smooth shapes; `variance` is the variance of the noise along `z`. `None` for too few points.
    pub fn fold(&self, variance: f64) -> Option<Fold> {
        if self.s.len() < FEWEST_POINTS {
            return None;
        }
        let line = Line::fit(&self.s, &self.z);
        let (hinge, wedge) = HINGES
            .iter()
            .map(|&h| (h, self.residual(&line, |s| (s - h).abs())))
            .min_by(|a, b| a.1.squares.total_cmp(&b.1.squares))?;
        let smooth = self.smooth(&line);
        let ideal = CrossSection {
            s: self.s.clone(),
            z: self.s.iter().map(|s| wedge.coefficient * (s - hinge).abs()).collect(),
        };
        let expected = ideal.smooth(&Line::fit(&ideal.s, &ideal.z));
        let slope = line.slope - wedge.coefficient * wedge.slope;
        let angle = (slope + wedge.coefficient).atan() - (slope - wedge.coefficient).atan();
        Some(Fold { evidence: (smooth - wedge.squares) / variance, expected: expected / variance, angle })
    }

    /// The least residual of the smooth shapes.
    fn smooth(&self, line: &Line) -> f64 {
        let parabola = self.residual(line, |s| s * s);
        let mut best = parabola.squares;
        let mut curvature = 2.0 * parabola.coefficient;
        for _ in 0..2 {
            // A circle of the curvature found so far, which goes on straight at 70 degrees.
            let round = self.residual(line, |s| circle(s, curvature));
            best = best.min(round.squares);
            curvature *= round.coefficient.clamp(0.5, 2.0);
        }
        for r in ROUNDS {
            best = best.min(self.residual(line, |s| (s - r).max(0.0).powi(2)).squares);
            best = best.min(self.residual(line, |s| (r - s).max(0.0).powi(2)).squares);
        }
        best
    }

    /// Least squares of `z` by `1, s, g(s)`: both `z` and `g` are regressed on the line, then the residual of `z` on that of
    /// `g`.
    fn residual(&self, line: &Line, g: impl Fn(f64) -> f64) -> Shape {
        let n = self.s.len() as f64;
        let (mut sum, mut with_s, mut square, mut with_z) = (0.0, 0.0, 0.0, 0.0);
        for (&s, &z) in self.s.iter().zip(&self.z) {
            let value = g(s);
            sum += value;
            with_s += value * (s - line.mean_s);
            square += value * value;
            with_z += value * (z - line.mean_z);
        }
        let slope = if line.ss > 0.0 { with_s / line.ss } else { 0.0 };
        let own = square - sum * sum / n - slope * with_s;
        let shared = with_z - slope * line.sz;
        if own <= 1e-12 * square {
            return Shape { squares: line.squares, coefficient: 0.0, slope };
        }
        let coefficient = shared / own;
        Shape { squares: (line.squares - coefficient * shared).max(0.0), coefficient, slope }
    }
}

/// Rise of a circle of the given curvature over its tangent at zero.
fn circle(s: f64, curvature: f64) -> f64 {
    const STEEP: f64 = 0.94;
    let k = curvature.abs();
    if k < 1e-6 {
        return 0.5 * s * s * curvature;
    }
    let x = (s * k).abs();
    let within = x.min(STEEP);
    let rise = 1.0 - (1.0 - within * within).sqrt();
    let beyond = (x - within) * within / (1.0 - within * within).sqrt();
    (rise + beyond) / curvature
}

/// The straight line through the cross-section and its sums.
struct Line {
    mean_s: f64,
    mean_z: f64,
    ss: f64,
    sz: f64,
    slope: f64,
    squares: f64,
}

impl Line {
    fn fit(s: &[f64], z: &[f64]) -> Line {
        let n = s.len() as f64;
        let (mean_s, mean_z) = (s.iter().sum::<f64>() / n, z.iter().sum::<f64>() / n);
        let (mut ss, mut sz, mut zz) = (0.0, 0.0, 0.0);
        for (&s, &z) in s.iter().zip(z) {
            ss += (s - mean_s).powi(2);
            sz += (s - mean_s) * (z - mean_z);
            zz += (z - mean_z).powi(2);
        }
        let slope = if ss > 0.0 { sz / ss } else { 0.0 };
        Line { mean_s, mean_z, ss, sz, slope, squares: zz - slope * sz }
    }
}

/// A fitted shape: its residual, its coefficient and its slope relative to the line.
struct Shape {
    squares: f64,
    coefficient: f64,
    slope: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section(f: impl Fn(f64) -> f64) -> CrossSection {
        let mut section = CrossSection::default();
        for i in 0..41 {
            let s = (i as f64 - 20.0) * 0.15;
            section.push(s, f(s));
        }
        section
    }

    #[test]
    fn a_right_angle_is_sharp_with_its_angle() {
        let fold = section(f64::abs).fold(0.0025).unwrap();
        assert!(fold.evidence > 100.0);
        assert!((fold.evidence - fold.expected).abs() < 1e-6 * fold.expected);
        assert!((fold.angle.to_degrees() - 90.0).abs() < 1e-6);
    }

    #[test]
    fn a_blunt_fold_off_the_middle_is_sharp() {
        let fold = section(|s| 0.3 * (s - 0.3).abs() + 0.1 * s).fold(0.0025).unwrap();
        assert!(fold.evidence > 5.0, "{fold:?}");
    }

    #[test]
    fn circles_parabolas_and_rounds_are_smooth() {
        for radius in [3.2, 4.0, 6.0, 10.0, 30.0] {
            let fold = section(|s: f64| radius - (radius * radius - s * s).sqrt()).fold(0.0025).unwrap();
            assert!(fold.evidence < 0.0, "{radius} {fold:?}");
        }
        assert!(section(|s: f64| 0.1 * (s - 0.5).max(0.0).powi(2)).fold(0.0025).unwrap().evidence < 0.0);
    }

    #[test]
    fn too_few_points_say_nothing() {
        let mut section = CrossSection::default();
        for i in 0..7 {
            section.push(i as f64, 0.0);
        }
        assert_eq!(section.fold(1.0), None);
    }
}
