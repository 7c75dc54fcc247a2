//! Optimal neighborhood size of a point (Tran 2013, section 2.3, figure 4).
//!
//! The paper divides the projected distance of each scale by that of the one before, the rate of change, and takes the scale before the first
//! ratio above epsilon; without such a jump any would do, and it takes 16. Three things are said more closely here.
//! * On an exact plane both distances are rounding, 1e-19, and their ratio means nothing; on a scanned one both are noise. So
//!   distances count as no less than a floor.
//! * A jump from 8 to 12 is none. Eight points are the first ring: an edge that comes into sight right behind it is one
//!   spacing off, and whether the eight just keep off it is chance, in a grid even a matter of ties. The paper's own example
//!   jumps from 12 to 16.
//! * Without a jump, noise makes the choice: the more of it, the larger the scale, as an edge stands out with the radius and
//!   the noise does not. Up to the 2 % of the spacing that the paper looks at it is the paper's 16.

use super::scales::{AtScale, SCALES};
use crate::params::ProjectionParams;
use crate::resolution::Resolution;

/// Index of the scale 16, taken where neither a jump nor noise is seen.
const STANDARD: usize = 2;
/// Index of the least scale that a jump can choose.
const FIRST_CHOICE: usize = 1;
/// Noise, in spacings, that takes one scale more.
const NOISE_STEP: f64 = 0.05;
/// Share of the spacing below which a projected distance is as good as none.
const FLOOR_SPACINGS: f64 = 0.01;
/// Standard deviations of the noise below which it is noise: the point's own is all in the distance.
const FLOOR_NOISE: f64 = 2.0;
/// Spacings above which the floor does not rise, whatever the noise: edges have no more than this or little more.
const FLOOR_LIMIT: f64 = 0.5;

/// The floor as given, or what suits spacing and noise; local frame.
pub fn floor(resolution: Resolution, params: &ProjectionParams) -> f64 {
    let noise = resolution.noise / resolution.spacing;
    let derived = (FLOOR_SPACINGS + FLOOR_NOISE * noise).min(FLOOR_LIMIT);
    params.floor_spacings.or(|| derived) * resolution.spacing
}

/// Index into [`SCALES`] of the scale that is taken where there is no jump.
pub fn standard(resolution: Resolution) -> usize {
    let steps = (resolution.noise / resolution.spacing / NOISE_STEP).round() as usize;
    (STANDARD + steps.min(SCALES.len())).min(SCALES.len() - 1)
}

/// Index into [`SCALES`] of the best scale: the one before the first rise by more than a factor of `jump`, else `standard`.
pub fn best_scale(scales: &[AtScale; 7], floor: f64, jump: f64, standard: usize) -> usize {
    let at_least = |k: usize| scales[k].distance.max(floor);
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
