//! The slicing planes: at given positions, or through the middles of adjacent slabs (section 2: "we set each slice to start
//! exactly where the previous slice ends").

use crate::error::Error;
use crate::params::ParamValue;
use crate::params::section::{MOST_PLANES, Planes};

/// A slicing plane: its position along the axis and the slab it stands for, adjacent slabs sharing their bounds.
pub(crate) type Cut = (f64, Option<[f64; 2]>);

/// The planes that equal steps give over an extent, or a refusal where they are too many.
pub(crate) fn cuts(planes: &Planes, low: f64, high: f64) -> Result<Vec<Cut>, Error> {
    let slab = |from: f64, to: f64| (0.5 * (from + to), Some([from, to]));
    let parts = |n: usize| {
        let edge = |k: usize| low + (high - low) * k as f64 / n as f64;
        (0..n).map(|k| slab(edge(k), edge(k + 1))).collect()
    };
    match planes {
        Planes::At(at) => Ok(at.iter().map(|&z| (z, None)).collect()),
        Planes::Count(n) | Planes::Adaptive { start: n, .. } => Ok(parts(*n)),
        Planes::Every(step) => {
            let many = ((high - low) / step).floor();
            if many >= MOST_PLANES as f64 {
                return Err(Error::Parameter {
                    key: "section.planes".into(),
                    value: planes.show(),
                    expected: "expected a step that gives at most 100000 slices".into(),
                });
            }
            let first = 0.5 * (low + high) - 0.5 * (many + 1.0) * step;
            let edge = |k: usize| first + k as f64 * step;
            Ok((0..=many as usize).map(|k| slab(edge(k), edge(k + 1))).collect())
        }
    }
}
