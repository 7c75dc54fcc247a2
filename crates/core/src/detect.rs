//! Detectors: penalties, classes and scores of every point.
//!
//! As printed: `penalty` (Gumhold 2001), `projection` (Tran 2013), `segments` (Demarsin 2007), and the measures to which Tran
//! compares his own, `baselines`. Ours: `evidence`, `edgelets`.

pub mod baselines;
pub(crate) mod edgelets;
pub(crate) mod evidence;
pub(crate) mod penalty;
pub mod points;
pub mod projection;
pub(crate) mod segments;
