//! The edge of two faces as fitted, and how well it is known.

use super::profile::Profile;
use super::sweep::{POSE, Sweep};
use crate::curve::pieces::Sigma;

/// Unknowns of the fit: the pose, the shift of the edge, angle and bend of each face.
pub(in crate::recover) const UNKNOWNS: usize = POSE + 6;

/// The edge as fitted.
#[derive(Clone, Debug)]
pub(in crate::recover) struct Fitted {
    /// Its path.
    pub sweep: Sweep,
    /// The faces across it.
    pub profile: Profile,
    /// Points on each face.
    pub counts: [usize; 2],
    /// Covariance of the pose, the shift, and the faces.
    pub covariance: [[f64; UNKNOWNS]; UNKNOWNS],
    /// The sine of the fold.
    pub fold_sine: f64,
    /// Standard deviation of the points.
    pub spread: f64,
}

impl Fitted {
    /// Standard deviations of the path's parameters.
    pub(in crate::recover) fn sigma(&self) -> Option<Sigma> {
        let c = &self.covariance;
        match &self.sweep {
            Sweep::Line { half, .. } => Some(Sigma::Line {
                offset: (0.5 * (c[POSE][POSE] + c[POSE + 1][POSE + 1])).sqrt(),
                direction: (0.5 * (c[0][0] + c[1][1])).sqrt() / half,
            }),
            Sweep::Round { round, .. } => {
                let [u, v] = self.sweep.axes();
                // The centre moves along these axes with the first two of the pose and the shift along the axis; the other shift is the radius.
                let axes = [(u, 0), (v, 1), (round.normal, POSE + 1)];
                let mut covariance = [[0.0; 4]; 4];
                for i in 0..3 {
                    let with = |k: usize| axes.iter().map(|(a, m)| a[i] * c[*m][k]).sum::<f64>();
                    for j in 0..3 {
                        covariance[i][j] = axes.iter().map(|(a, m)| a[j] * with(*m)).sum();
                    }
                    (covariance[i][3], covariance[3][i]) = (with(POSE), with(POSE));
                }
                covariance[3][3] = c[POSE][POSE];
                let radius = c[POSE][POSE].sqrt();
                Some(Sigma::Round { radius, normal: (c[2][2] + c[3][3]).sqrt() / round.radius, covariance })
            }
        }
        .filter(|_| c.iter().flatten().all(|x| x.is_finite()))
    }
}
