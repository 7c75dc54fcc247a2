//! Local regression of position on arc along a band: a line, or a parabola where bends are sharp.

use crate::section::contour::band::Band;

/// Ratio of the kernel widths of a parabola and a line with about the same scatter.
const PARABOLA: f64 = 1.5;

/// A line fitted to the samples of a stretch of a band: position and direction as functions of the arc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Local {
    /// Position.
    pub at: [f64; 2],
    /// Change of the position with the arc.
    pub slope: [f64; 2],
}

/// Weighted regression of position on arc, evaluated at `centre`, over samples from `from` to `to` with a kernel of
/// half-width `width`; `None` with fewer than three samples.
pub(crate) fn regress(band: &Band, centre: f64, width: f64, from: f64, to: f64) -> Option<Local> {
    let mut sums = [0.0f64; 7];
    let mut count = 0;
    band.visit(from.max(centre - width), to.min(centre + width), |arc, sample| {
        let u = (arc - centre) / width;
        let kernel = (1.0 - u * u).max(0.0).powi(2) * sample.weight;
        count += 1;
        let values = [1.0, u, u * u, sample.raw[0], sample.raw[1], u * sample.raw[0], u * sample.raw[1]];
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += kernel * value;
        }
    });
    let [w, su, suu, sx, sy, sux, suy] = sums;
    if count < 3 || w <= 0.0 {
        return None;
    }
    let determinant = w * suu - su * su;
    if determinant <= 1e-4 * w * w {
        return None;
    }
    let fit = |s: f64, t: f64| ((suu * s - su * t) / determinant, (w * t - su * s) / determinant / width);
    let ((x, dx), (y, dy)) = (fit(sx, sux), fit(sy, suy));
    Some(Local { at: [x, y], slope: [dx, dy] })
}

/// Like [`regress`] with a parabola, so that a bend of few spacings is not cut short; where samples lie to one side
/// or are few, a parabola runs wild and the line is taken.
pub(crate) fn parabola(band: &Band, centre: f64, width: f64, from: f64, to: f64) -> Option<Local> {
    let wide = PARABOLA * width;
    if from > centre - 0.7 * wide || to < centre + 0.7 * wide {
        return regress(band, centre, width, from, to);
    }
    let mut moments = [0.0f64; 5];
    let mut right = [[0.0f64; 2]; 3];
    let mut count = 0;
    band.visit(from.max(centre - wide), to.min(centre + wide), |arc, sample| {
        let u = (arc - centre) / wide;
        let kernel = (1.0 - u * u).max(0.0).powi(2) * sample.weight;
        let powers = [1.0, u, u * u, u * u * u, u * u * u * u];
        count += 1;
        for (moment, power) in moments.iter_mut().zip(powers) {
            *moment += kernel * power;
        }
        for (row, power) in right.iter_mut().zip(powers) {
            row[0] += kernel * power * sample.raw[0];
            row[1] += kernel * power * sample.raw[1];
        }
    });
    let [a, b, c, d, e] = moments;
    let determinant = a * (c * e - d * d) - b * (b * e - c * d) + c * (b * d - c * c);
    if count < 8 || determinant <= 1e-3 * a * c * e {
        return regress(band, centre, width, from, to);
    }
    let at = |k: usize| {
        let [r, s, t] = [right[0][k], right[1][k], right[2][k]];
        (r * (c * e - d * d) - b * (s * e - d * t) + c * (s * d - c * t)) / determinant
    };
    let slope = |k: usize| {
        let [r, s, t] = [right[0][k], right[1][k], right[2][k]];
        (a * (s * e - d * t) - r * (b * e - c * d) + c * (b * t - c * s)) / determinant / wide
    };
    Some(Local { at: [at(0), at(1)], slope: [slope(0), slope(1)] })
}

/// Half-width of the kernel in local spacings: wider with noise and on slanted surfaces.
pub(crate) fn width(band: &Band, arc: f64, spacing: f64, noise: f64) -> f64 {
    let blur = band.blur(arc - 1.5 * spacing, arc + 1.5 * spacing);
    1.8 + 3.0 * noise + 3.0 * (blur - 0.3 * noise).clamp(0.0, 1.0)
}

/// Spacing of the chain at an arc.
pub(crate) fn spacing_at(band: &Band, arc: f64) -> f64 {
    band.chain.vertices[band.vertex(arc).min(band.chain.vertices.len() - 1)].spacing
}
