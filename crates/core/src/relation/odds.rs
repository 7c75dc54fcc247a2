//! How likely a relation is: the density of its deviation where it holds, against that where it does not.
//!
//! Where a relation holds, its deviation is normal about zero with the covariance of the fits; where it does not, any deviation is as good as
//! another, and each of the others may agree by chance: their density is that of all of them together. With even odds beforehand, Bayes' rule
//! gives the probability of the relation. A deviation that the covariance hardly
//! allows, one in a thousand, is none however much chance speaks against it.

/// Squared deviation, in variances, that is exceeded once in a thousand times, for 1 to 6 dimensions (chi squared).
const ONCE_IN_A_THOUSAND: [f64; 6] = [10.83, 13.82, 16.27, 18.47, 20.52, 22.46];

/// The greatest squared deviation in variances that the noise explains.
pub(super) fn bound(dimensions: usize) -> f64 {
    ONCE_IN_A_THOUSAND[dimensions - 1]
}

/// Probability that a number of this variance is zero, if others lie anywhere with the density `chance`. 0 where the variance does not
/// explain it.
pub(super) fn of_number(deviation: f64, variance: f64, chance: f64) -> f64 {
    let squares = deviation * deviation / variance;
    odds(squares, (std::f64::consts::TAU * variance).sqrt().recip(), chance, 1)
}

/// As [`of_number`], of two numbers with their covariance.
pub(super) fn of_pair([x, y]: [f64; 2], [[a, b], [_, c]]: [[f64; 2]; 2], chance: f64) -> f64 {
    let determinant = a * c - b * b;
    let squares = (c * x * x - 2.0 * b * x * y + a * y * y) / determinant;
    odds(squares, (std::f64::consts::TAU * determinant.sqrt()).recip(), chance, 2)
}

fn odds(squares: f64, peak: f64, chance: f64, dimensions: usize) -> f64 {
    let density = peak * (-0.5 * squares).exp();
    if squares <= bound(dimensions) && density.is_finite() { density / (density + chance) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_well_and_agrees_is_likely_and_what_is_known_badly_is_not() {
        assert!(of_number(0.001, 1e-6, 0.5) > 0.99);
        assert!(of_number(0.0, 4.0, 0.5) < 0.5);
        assert_eq!(of_number(0.01, 1e-6, 0.5), 0.0);
        let turned = [[2e-6, 1e-6], [1e-6, 2e-6]];
        assert!(of_pair([0.001, 0.001], turned, 0.16) > of_pair([0.001, -0.001], turned, 0.16));
        assert_eq!(of_pair([0.01, -0.01], turned, 0.16), 0.0);
    }
}
