//! Sampling of shapes: on a lattice, at random, or by a scanner.

mod lattice;
mod ray;
mod scan;
mod scanner;
mod survey;
mod uniform;

pub use scan::{Gradient, Noise, Sampled, Sampling, Scan};
pub use survey::{Survey, Surveyed};
