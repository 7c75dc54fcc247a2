//! Sampling of shapes: on a lattice, at random, or by a scanner.

mod lattice;
mod ray;
mod scan;
mod scanner;
mod uniform;

pub use scan::{Gradient, Noise, Sampled, Sampling, Scan};
