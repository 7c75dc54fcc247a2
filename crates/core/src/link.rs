//! Linkers: from the penalties of the points to graphs of lines.
//!
//! As printed: `spanning` (Gumhold 2001, sections 3.2 and 3.3) and `clusters` (Demarsin et al. 2007). Ours: `repair`, which
//! both call in their robust forms, `beside`, `flat`, `chains`, `handles`, `triples` and `passing`.

mod beside;
mod blends;
mod chains;
pub(crate) mod clusters;
mod flat;
mod handles;
mod lines;
mod passing;
mod repair;
mod spanning;
mod steps;
mod triples;

pub(crate) use beside::unborder;
pub(crate) use chains::Known;
pub(crate) use lines::link;
pub(crate) use spanning::{CycleRule, Metric};
pub(crate) use steps::steps;
pub use steps::{LineSteps, WeighedEdge};
