//! Feature lines from point clouds.

pub mod apply;
pub mod check;
pub mod classify;
pub mod cloud;
pub mod curve;
pub mod detect;
pub mod error;
pub mod extract;
pub mod frame;
pub mod link;
pub mod math;
pub mod measure;
pub mod neighbors;
pub mod network;
pub mod params;
pub mod pattern;
pub mod recover;
pub mod resolution;
pub mod section;
pub mod shapes;

pub use cloud::{Attribute, Cloud, Column};
pub use error::Error;
pub use extract::{Extraction, Progress, Report, Stage, extract, extract_observed};
pub use frame::{Frame, Localised};
pub use measure::{Class, Measure};
pub use neighbors::Neighbors;
pub use network::{Network, Node, NodeKind, Strip, StripKind};
pub use params::{Entry, Method, Params};
pub use pattern::Pattern;
pub use resolution::Resolution;
