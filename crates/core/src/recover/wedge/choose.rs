//! The window and the surface of a face: the largest window, and the plain form, that the points bear out.
//!
//! Small windows and quadrics err by noise, large ones and planes by the bend of the face. The candidates are taken in the order of
//! falling variance at the edge; one counts if it agrees there with all that count before it, to within what their noise explains
//! (Lepski 1990; Goldenshluger and Nemirovski 1997, the intersection of confidence intervals), and if its points scatter no more. The
//! last that counts is chosen.

use super::surface::{Axes, Fit, fit};
use crate::resolution::Resolution;

/// Half sizes of the windows, units of the place.
const WINDOWS: [f64; 5] = [3.5, 5.0, 7.0, 10.0, 14.0];
/// Coefficients of a plane and of a quadric.
const FORMS: [usize; 2] = [3, 6];
/// Standard deviations of the difference of two fits that noise explains.
const AGREE: f64 = 3.5;
/// Ratio of the variances of points that chance explains.
const SCATTER: f64 = 1.5;
/// Least share of the points in a window that must lie on the face.
const WHOLE: f64 = 0.85;
/// Greatest standard deviation of a point before the fits, spacings; less than it the noise.
const GATE: f64 = 0.2;

/// The greatest half size of a window.
pub(super) const WIDEST: f64 = WINDOWS[WINDOWS.len() - 1];

/// The fit of a face to its `points` at a crease point; those nearer to the edge than `clear` are left out.
pub(super) fn choose(
    axes: &Axes,
    points: &[[f64; 3]],
    clear: f64,
    resolution: Resolution,
    floor: f64,
) -> Option<Fit> {
    let unit = resolution.unit();
    let gate = resolution.noise.max(GATE * resolution.spacing);
    let local: Vec<[f64; 3]> = points.iter().map(|&p| axes.local(p)).collect();
    let mut candidates: Vec<Fit> = Vec::new();
    let mut start = None;
    for half in WINDOWS.map(|w| w * unit) {
        let inside = |&&[u, v, _]: &&[f64; 3]| u >= clear && u <= half && v.abs() <= half;
        let window: Vec<[f64; 3]> = local.iter().filter(inside).copied().collect();
        for count in FORMS {
            let Some(found) = fit(&window, count, start.as_ref(), gate, floor) else { continue };
            candidates.push(found);
            if count == 3 && start.is_none() {
                start = Some(found);
            }
        }
    }
    agreeing(candidates, resolution.noise.max(floor).powi(2))
}

/// The last of the candidates that agree; `variance` is that of a point.
fn agreeing(mut candidates: Vec<Fit>, variance: f64) -> Option<Fit> {
    let spread = |f: &Fit| variance * f.leverage(0.0);
    let least = candidates.iter().map(|f| f.variance).fold(f64::INFINITY, f64::min);
    let most = SCATTER * least.max(variance);
    candidates.retain(|f| f.share >= WHOLE && f.variance <= most);
    candidates.sort_by(|a, b| spread(b).total_cmp(&spread(a)));
    let mut counting: Vec<Fit> = Vec::new();
    for new in candidates {
        let agrees = |old: &Fit| {
            let difference = (spread(old) - spread(&new)).max(0.1 * spread(old));
            let apart = new.coefficients[0] - old.coefficients[0];
            apart * apart <= AGREE * AGREE * difference
        };
        if counting.iter().all(agrees) {
            counting.push(new);
        }
    }
    counting.pop()
}
