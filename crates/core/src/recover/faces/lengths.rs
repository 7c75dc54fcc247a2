//! Lengths that the fit of two faces goes by.

use crate::resolution::Resolution;

/// In the unit of the points.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Lengths {
    /// Mean spacing of the points.
    pub spacing: f64,
    /// Points nearer to the edge are left out: they may belong to either face.
    pub clear: f64,
    /// Points farther away are left out: a face bends.
    pub reach: f64,
    /// Least standard deviation of a point: faces are not quite what the fit takes them for.
    pub floor: f64,
    /// Standard deviation of the path before the fit.
    pub prior: f64,
    /// Standard deviation of a face's curvature, one over a length.
    pub bend: f64,
    /// Standard deviation of a point before the fit.
    pub gate: f64,
    /// Greatest standard deviation of the points after it: with more, they lie on other faces than two about the edge.
    pub loose: f64,
    /// How far the fit may move the path.
    pub far: f64,
}

impl Lengths {
    /// For the spacing and the noise of a place.
    pub(in crate::recover) fn of(Resolution { spacing, noise }: Resolution) -> Self {
        let gate = noise.max(0.2 * spacing);
        Self {
            spacing,
            clear: noise.max(0.5 * spacing),
            reach: 4.0 * spacing,
            floor: 0.01 * spacing,
            prior: 0.3 * spacing,
            bend: 0.15 / spacing,
            gate,
            loose: 1.5 * gate,
            far: 1.5 * spacing,
        }
    }

    /// Whether a place across the path is far enough from the edge, and near enough, to say where the faces lie.
    pub(in crate::recover) fn on_faces(&self, [x, y]: [f64; 2]) -> bool {
        (self.clear..=self.reach).contains(&x.hypot(y))
    }
}
