//! Junction recovery (Gumhold 2001, section 4.2): the points around a junction of k creases are told apart into its k faces, and the
//! corner is laid where these meet.
//!
//! `view` (the projection from the centroid, sorting, the initial grouping by the incident splines) -> `group` (votes along the incident
//! strips into k weights, until no point changes) -> `junctions` -> `quadric_error` (the corner of k planes); in the form of our own
//! `faces` in place of the groups.

mod faces;
mod group;
mod junctions;
mod quadric_error;
mod view;

pub(super) use faces::corners;
pub(super) use group::Grouping;
pub(super) use junctions::{junctions, strange};
pub(super) use quadric_error::Corner;
