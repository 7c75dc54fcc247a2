//! Which scale suits a point (Tran 2013, section 2.3, figure 4).
//!
//! The paper divides the projected distance of each scale by that of the one before, and takes the scale before the first
//! ratio above epsilon; without such a jump, 16. On an exact plane both distances are rounding, 1e-19, and their ratio means
//! nothing; on a scanned one both are noise. So distances count as no less than a floor.

use super::scales::{AtScale, SCALES};
use crate::params::ProjectionParams;
use crate::resolution::Resolution;

/// Index of the scale 16, taken where no jump is seen.
const STANDARD: usize = 2;
/// Share of the spacing below which a projected distance is as good as none.
const FLOOR_SPACINGS: f64 = 0.05;
/// Standard deviations of the noise below which it is noise: the point's own is all in the distance.
const FLOOR_NOISE: f64 = 1.0;

/// The floor as given, or what suits spacing and noise; local frame.
pub fn floor(resolution: Resolution, params: &ProjectionParams) -> f64 {
    let noise = resolution.noise / resolution.spacing;
    params.floor_spacings.or(|| FLOOR_SPACINGS + FLOOR_NOISE * noise) * resolution.spacing
}

/// Index into [`SCALES`] of the best scale: the one before the first rise by more than a factor of `jump`.
pub fn best_scale(scales: &[AtScale; 7], floor: f64, jump: f64) -> usize {
    let at_least = |k: usize| scales[k].distance.max(floor);
    let peak = (0..SCALES.len() - 1).find(|&k| at_least(k + 1) > jump * at_least(k));
    peak.unwrap_or(STANDARD)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choose(distances: [f64; 7]) -> usize {
        let scales = distances.map(|distance| AtScale { distance, ..AtScale::default() });
        SCALES[best_scale(&scales, 0.001, 3.0)]
    }

    /// The three points of the paper's table 1, to the digit.
    #[test]
    fn table_1_gives_16_at_the_smooth_and_the_sharp_point_and_12_near_the_edge() {
        assert_eq!(choose([1.75e-19, 2.78e-19, 2.17e-19, 9.62e-20, 8.92e-20, 2.46e-19, 3.08e-19]), 16);
        assert_eq!(choose([1.75e-19, 2.78e-19, 0.028, 0.023, 0.038, 0.076, 0.089]), 12);
        assert_eq!(choose([0.518, 0.683, 0.554, 0.621, 0.622, 0.676, 0.668]), 16);
    }

    #[test]
    fn rounding_and_exact_zeros_are_no_jump() {
        assert_eq!(choose([0.0, 1e-19, 1e-17, 1e-18, 0.0, 1e-16, 1e-15]), 16);
    }
}
