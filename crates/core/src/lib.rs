//! Feature lines from point clouds.

pub mod cloud;
pub mod curve;
pub mod error;
pub mod frame;
pub mod math;
pub mod neighbors;
pub mod network;

pub use cloud::{Attribute, Cloud, Column};
pub use error::Error;
pub use frame::{Frame, Localised};
pub use neighbors::Neighbors;
pub use network::{Network, Node, NodeKind, Strip, StripKind};
