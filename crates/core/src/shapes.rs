//! Solids and sheets with known feature networks, sampled as a scanner would: for tests, docs and examples.
//!
//! A [`Shape`] is a list of trimmed faces and the [`Truth`]: the creases and borders that it has by construction.
//! A [`Scan`] has the settings of a sampling: positions of the points (grid, by area, blue noise, scanner), noise and seed;
//! the same seed gives the same bits on every machine.
//!
//! ```
//! use lineament::shapes::{Sampling, Scan, bracket};
//!
//! let part = bracket().sample(&Scan::new(Sampling::Area { count: 2000 }).noise(0.1).seed(1));
//! assert_eq!(part.cloud.len(), 2000);
//! assert_eq!(part.truth.loops(), 4); // both rims of the bore, foot and rim of the boss
//! ```

mod face;
mod line_index;
mod nearest;
mod outline;
mod parts;
mod random;
mod samples;
mod sampling;
mod shape;
mod surface;
mod truth;
mod turns;

pub use face::{Face, Trim};
pub use line_index::LineIndex;
pub use outline::{Edge, Outline, gear, polygon, ring, rounded_rectangle, slot};
pub use parts::*;
pub use random::Rng;
pub use samples::{DEFAULT_SAMPLE, Sample, sample, samples};
pub use sampling::{Gradient, Noise, Sampled, Sampling, Scan, Survey, Surveyed};
pub use shape::Shape;
pub use surface::{Axes, FaceSurface};
pub use truth::{Fold, Truth, TruthCurve, TruthNode};

pub(crate) use line_index::{Part, densify};
pub(crate) use nearest::Tree;

#[cfg(test)]
mod tests;
