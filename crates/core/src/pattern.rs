//! What the linker leaves: a graph of points for each kind of line.

mod line_graph;
mod paths;

pub use line_graph::LineGraph;
pub use paths::{Path, paths};

use crate::network::StripKind;

/// The crease pattern and the border pattern (Gumhold 2001, figure 1), local frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    /// Points that creases run through.
    pub crease: LineGraph,
    /// Points that borders run through.
    pub border: LineGraph,
}

impl Pattern {
    /// The graph of one kind of line.
    pub fn of(&self, kind: StripKind) -> &LineGraph {
        match kind {
            StripKind::Crease => &self.crease,
            StripKind::Border => &self.border,
        }
    }
}
