//! Sine, cosine and logarithm by series, so that a sampled point has the same bits on every machine.
//!
//! Angles are in turns: reducing a turn to an eighth is exact, which reducing a radian is not.

use std::f64::consts::{LN_2, TAU};

/// `[cos, sin]` of an angle in turns, to about 2 units in the last place. Quarter turns are exact.
pub fn sin_cos(turns: f64) -> [f64; 2] {
    let quarter = (turns * 4.0).round();
    let x = (turns - quarter / 4.0) * TAU; // at most pi/4 in size
    let [c, s] = [cos_series(x), sin_series(x)];
    match quarter.rem_euclid(4.0) as u8 {
        0 => [c, s],
        1 => [-s, c],
        2 => [-c, -s],
        _ => [s, -c],
    }
}

/// Natural logarithm of a positive finite number, to about 2 units in the last place.
pub fn ln(x: f64) -> f64 {
    let (mut exponent, mut m) = (0.0, x);
    while m > std::f64::consts::SQRT_2 {
        m *= 0.5;
        exponent += 1.0;
    }
    while m < std::f64::consts::FRAC_1_SQRT_2 {
        m *= 2.0;
        exponent -= 1.0;
    }
    let z = (m - 1.0) / (m + 1.0); // below 0.172: ln m = 2 artanh z
    let series = (0..12).rev().fold(0.0, |sum, k| sum * z * z + 1.0 / f64::from(2 * k + 1));
    exponent * LN_2 + 2.0 * z * series
}

fn sin_series(x: f64) -> f64 {
    x * (1..10).rev().fold(1.0, |sum, k| 1.0 - sum * x * x / f64::from(2 * k * (2 * k + 1)))
}

fn cos_series(x: f64) -> f64 {
    (1..11).rev().fold(1.0, |sum, k| 1.0 - sum * x * x / f64::from(2 * k * (2 * k - 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_agree_with_the_platform() {
        for i in -4000..4000 {
            let turns = f64::from(i) * 0.000_731;
            let [c, s] = sin_cos(turns);
            assert!(
                (c - (turns * TAU).cos()).abs() < 4e-15 && (s - (turns * TAU).sin()).abs() < 4e-15,
                "{turns}"
            );
            let x = (f64::from(i) * 0.004).exp();
            assert!((ln(x) - x.ln()).abs() <= 1e-15 * x.ln().abs().max(1.0), "{x}");
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(sin_cos(0.25), [0.0, 1.0]);
        assert_eq!(sin_cos(-0.5), [-1.0, 0.0]);
        assert_eq!(sin_cos(7.75), [0.0, -1.0]);
    }
}
