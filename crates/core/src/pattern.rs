//! The pattern: a linker's output, one graph for each kind of line.

mod line_graph;
mod paths;

pub use line_graph::LineGraph;
pub use paths::{Path, paths};

use crate::network::StripKind;

/// The crease pattern and the border pattern (Gumhold 2001, figure 1), and that of rounded edges (ours), local frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pattern {
    /// The graph of creases.
    pub crease: LineGraph,
    /// The graph of borders.
    pub border: LineGraph,
    /// The graph of the design edges of blends.
    pub rounded: LineGraph,
}

impl Pattern {
    /// The graph of one kind of line.
    pub fn of(&self, kind: StripKind) -> &LineGraph {
        match kind {
            StripKind::Crease => &self.crease,
            StripKind::Border => &self.border,
            StripKind::Rounded => &self.rounded,
        }
    }
}
