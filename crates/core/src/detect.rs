//! Detectors: what every point says of the lines it may lie on.
//!
//! As printed: `penalty` (Gumhold 2001), `projection` (Tran 2013), `segments` (Demarsin 2007), and the measures that Tran sets
//! beside his own, `baselines`. Ours: `evidence`.

pub mod baselines;
pub(crate) mod evidence;
pub(crate) mod penalty;
pub mod points;
pub mod projection;
pub(crate) mod segments;
