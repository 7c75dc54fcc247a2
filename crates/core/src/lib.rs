//! Feature lines from point clouds.

pub mod cloud;
pub mod curve;
pub mod error;
pub mod math;
pub mod network;

pub use cloud::{Attribute, Cloud, Column};
pub use error::Error;
pub use network::{Network, Node, NodeKind, Strip, StripKind};
