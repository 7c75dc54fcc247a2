//! The minimum spanning graph and its pruning (Gumhold 2001, sections 3.2 and 3.3).
//!
//! `weight` makes the queue of edges, `graph` builds the minimum spanning graph from it with the cycle test, `prune` removes
//! short branches. `web` knows the shortest path that an edge would close to a cycle, by `two_sided` searches; `walk` has the
//! bounded searches of pruning and repair, `rule` the length `rho`.

mod graph;
mod prune;
mod rule;
mod two_sided;
mod walk;
mod web;
mod weight;

pub(super) use graph::{enters, minimum_spanning_graph};
pub(super) use prune::{prune, remove_branch};
pub(crate) use rule::{CycleRule, Metric};
pub(super) use walk::Walker;
pub(super) use web::Web;
pub use weight::Candidate;
pub(super) use weight::{candidate_edges, length_term, sort};
