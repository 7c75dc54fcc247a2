//! Optimal neighborhood size of a point (Tran 2013, section 2.3, figure 4).
//!
//! The paper divides the projected distance at each scale by that at the scale before, the "rate of change", and takes the scale
//! before the first ratio above epsilon. Without such a peak any scale would do, and the paper takes 16. Three points are more
//! exact here.
//! * On an exact plane both distances are rounding, 1e-19, and their ratio means nothing; on a scanned plane both are noise. So
//!   lesser distances are raised to a floor.
//! * A rise from 8 to 12 does not count. Eight points are the first ring: an edge right behind it is one spacing away, and
//!   whether the eight points just avoid it depends on chance, in a grid even on ties. In the paper's own example the peak is
//!   from 12 to 16.
//! * Without a peak, the noise decides: the more noise, the larger the scale, as an edge grows clearer with the radius. Up to a
//!   noise of 2 % of the spacing, the greatest in the paper, it is the paper's 16.

use super::scales::{AtScale, SCALES};
use crate::params::ProjectionParams;
use crate::resolution::Resolution;

/// Index of the scale 16, which is taken without a peak and without noise.
const STANDARD: usize = 2;
/// Index of the least scale at which a peak counts.
const FIRST_CHOICE: usize = 1;
/// Noise that raises the choice by one scale, spacings.
const NOISE_STEP: f64 = 0.05;
/// Floor of the projected distance without noise, spacings.
const FLOOR_SPACINGS: f64 = 0.01;
/// Standard deviations of the noise that are added to the floor: the noise of the point itself enters the distance fully.
const FLOOR_NOISE: f64 = 2.0;
/// Greatest floor, whatever the noise, spacings: the projected distance of edges is not much greater.
const FLOOR_LIMIT: f64 = 0.5;

/// The floor as given, or derived from spacing and noise; local frame.
pub fn floor(resolution: Resolution, params: &ProjectionParams) -> f64 {
    floor_spacings(resolution, params) * resolution.spacing
}

/// The same in spacings.
pub(crate) fn floor_spacings(resolution: Resolution, params: &ProjectionParams) -> f64 {
    let noise = resolution.noise / resolution.spacing;
    params.floor_spacings.or(|| (FLOOR_SPACINGS + FLOOR_NOISE * noise).min(FLOOR_LIMIT))
}

/// Index into [`SCALES`] of the scale that is taken without a peak.
pub fn standard(resolution: Resolution) -> usize {
    let steps = (resolution.noise / resolution.spacing / NOISE_STEP).round() as usize;
    (STANDARD + steps.min(SCALES.len())).min(SCALES.len() - 1)
}

/// Index into [`SCALES`] of the best scale (figure 4): the one before the first rate of change above `jump`, the paper's
/// epsilon; `standard` without such a peak.
pub fn best_scale(scales: &[AtScale; 7], floor: f64, jump: f64, standard: usize) -> usize {
    let at_least = |k: usize| scales[k].distance.max(floor);
    // The rate of change is the ratio of the two, multiplied out as a floor of zero allows zero distances.
    let peak = (FIRST_CHOICE..SCALES.len() - 1).find(|&k| at_least(k + 1) > jump * at_least(k));
    peak.unwrap_or(standard)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choose(distances: [f64; 7]) -> usize {
        let scales = distances.map(|distance| AtScale { distance, ..AtScale::default() });
        SCALES[best_scale(&scales, 0.01, 2.0, STANDARD)]
    }

    /// The three points of the paper's table 1, to the digit.
    #[test]
    fn table_1_gives_16_at_the_smooth_and_the_sharp_point_and_12_near_the_edge() {
        assert_eq!(choose([1.75e-19, 2.78e-19, 2.17e-19, 9.62e-20, 8.92e-20, 2.46e-19, 3.08e-19]), 16);
        assert_eq!(choose([1.75e-19, 2.78e-19, 0.028, 0.023, 0.038, 0.076, 0.089]), 12);
        assert_eq!(choose([0.518, 0.683, 0.554, 0.621, 0.622, 0.676, 0.668]), 16);
    }

    #[test]
    fn rounding_and_exact_zeros_are_no_jump_and_neither_is_the_first_ring() {
        assert_eq!(choose([0.0, 1e-19, 1e-17, 1e-18, 0.0, 1e-16, 1e-15]), 16);
        assert_eq!(choose([0.0, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45]), 16);
    }

    #[test]
    fn noise_takes_the_standard_scale_from_16_to_32() {
        let at = |noise: f64| SCALES[standard(Resolution { spacing: 1.0, noise })];
        assert_eq!([0.0, 0.02, 0.03, 0.1, 0.2, 5.0].map(at), [16, 16, 20, 24, 32, 32]);
        assert_eq!(SCALES[standard(Resolution { spacing: 0.0, noise: 0.0 })], 16);
    }
}
