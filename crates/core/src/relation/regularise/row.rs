//! One line of the least squares.

/// A linearised observation of unit weight, or a condition as a length.
#[derive(Clone, Debug)]
pub(super) struct Row {
    /// Unknowns with the slope for each.
    pub terms: Vec<(usize, f64)>,
    /// The value, which should be zero.
    pub residual: f64,
}
