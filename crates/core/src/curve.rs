//! Curves that strips are fitted with.

/// A B-spline curve in space, clamped or periodic.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BSpline {
    /// Polynomial degree; 3 unless the strip is too short for it.
    pub degree: usize,
    /// Non-decreasing knots on the chord-length parameter. Clamped: `controls.len() + degree + 1` of them, the
    /// first and last `degree + 1` equal. Periodic: `controls.len() + 1` of them, one period.
    pub knots: Vec<f64>,
    /// `(C, 3)` control points.
    pub controls: Vec<[f64; 3]>,
    /// Whether the curve closes smoothly on itself.
    pub periodic: bool,
}
