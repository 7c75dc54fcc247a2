//! Feature lines from point clouds: creases, borders and corners as ordered, closed curves.
//!
//! ```
//! use lineament::{NodeKind, Params, extract, shapes};
//!
//! // A scan with a known answer: the surface points of a 9 x 9 x 9 grid.
//! let scan = shapes::cube_386();
//! let found = extract(&scan.cloud, &Params::default())?;
//! assert_eq!(found.network.strips.len(), 12);
//! assert_eq!(found.network.count(NodeKind::Junction), 8);
//! for strip in &found.network.strips {
//!     println!("{} of length {:.2}, fold {:?} degrees", strip.kind.name(), strip.length(), strip.fold_deg);
//! }
//! # Ok::<(), lineament::Error>(())
//! ```
//!
//! [`extract()`] is the whole pipeline; [`Extraction`] keeps every stage of it. No parameter needs a guess: [`Params`] lists
//! what can be set. [`shapes`] makes scans with known networks, [`check`] says whether a network is sound and scores it.

pub mod apply;
pub mod check;
mod classify;
mod cloud;
pub mod curve;
pub mod detect;
mod error;
pub mod evaluate;
mod extract;
pub mod frame;
mod link;
pub mod math;
pub mod measure;
mod method;
pub mod neighbors;
pub mod network;
pub mod papers;
pub mod params;
pub mod patch;
pub mod pattern;
mod prepare;
mod recover;
mod report;
pub mod resolution;
pub mod section;
pub mod shapes;

pub use cloud::{Attribute, Cloud, Column};
pub use error::Error;
pub use extract::{Extraction, extract, extract_observed};
pub use frame::{Frame, Localised};
pub use measure::{Class, Measure};
pub use method::ClusterStages;
pub use neighbors::Neighbors;
pub use network::{Network, Node, NodeKind, Strip, StripKind};
pub use params::{Entry, Method, Params};
pub use patch::{Patch, Patches};
pub use pattern::Pattern;
pub use report::{Progress, Report, Stage};
pub use resolution::Resolution;
