//! Shared parts of the checks.

/// `Ok` without faults.
pub(super) fn verdict(faults: Vec<String>) -> Result<(), Vec<String>> {
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

pub(super) fn finite(p: &[f64; 3]) -> bool {
    p.iter().all(|x| x.is_finite())
}

/// Whether standard deviations on three axes are lengths.
pub(super) fn deviations(sigma: &[f64; 3]) -> bool {
    sigma.iter().all(|s| s.is_finite() && *s >= 0.0)
}
