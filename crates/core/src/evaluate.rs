//! Evaluation against a known truth: lines by their distances (`score`), types and graph, marks of points (`marks`), and whether
//! a network and a truth are the same graph (`isomorphism`).

mod assignment;
mod chamfer;
mod figures;
mod isomorphism;
mod lines;
mod marks;
mod rounded;
mod samples;
mod score;
mod sides;
mod stretches;
mod topology;
mod types;
mod wireframe;

pub use chamfer::Chamfer;
pub use figures::{Distances, Hits};
pub use isomorphism::isomorphic;
pub use lines::{CurveKind, Line, LineKind, Lines, RoundedEdge, TypedCurve, stretch};
pub use marks::{MarkScore, marks};
pub use rounded::Rounded;
pub use score::{Score, against, score};
pub use sides::Scoring;
pub use stretches::{Stretch, Verdict, stretches};
pub use topology::Topology;
pub use types::Types;
pub use wireframe::Wireframe;

#[cfg(test)]
mod tests;
