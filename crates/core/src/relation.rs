//! Relations between the lines, arcs and circles of a network, and their imposition.
//!
//! `feature` takes each curve with its covariance, `odds` says how likely a relation is by them. `parallel` makes classes of directions,
//! `perpendicular` finds right angles between these, `coplanar` planes across them, `axes` common axes and centres along them; `radii`
//! finds equal radii, `tangent` smooth joints, `mirror` planes of symmetry. Sets of curves are reported rather than pairs, so that
//! their number stays below that of the curves for each kind. `regularise` imposes them.

mod axes;
mod cluster;
mod coplanar;
mod feature;
mod find;
mod joints;
mod listed;
mod mirror;
mod odds;
mod parallel;
mod perpendicular;
mod radii;
mod regularise;
mod related;
mod relations;
mod tangent;

pub(crate) use find::OPEN;
pub use related::Related;
pub(crate) use related::related;
pub use relations::{Member, Regularised, Relation, RelationKind};

#[cfg(test)]
mod tests;
