//! How points come to lie on a shape: on a lattice, at random, or as a scanner sees them.

mod lattice;
mod ray;
mod scan;
mod scanner;
mod uniform;

pub use scan::{Gradient, Noise, Sampled, Sampling, Scan};
