//! Ordered vertices: contours while they are put together.

use crate::math::vec2::distance;

/// No node.
pub(crate) const NO_NODE: u32 = u32::MAX;

/// One vertex of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vertex {
    /// Position in the slicing plane.
    pub at: [f64; 2],
    /// Local spacing.
    pub spacing: f64,
    /// Whether two straight continuations were found to meet here.
    pub corner: bool,
    /// Whether the surface here is known from badly fitting tangent planes alone.
    pub weak: bool,
    /// The index of its node; [`NO_NODE`] for none.
    pub node: u32,
}

impl Vertex {
    /// A vertex of a smooth line.
    pub(crate) fn new(at: [f64; 2], spacing: f64) -> Self {
        Self { at, spacing, corner: false, weak: false, node: NO_NODE }
    }

    /// A corner.
    pub(crate) fn corner(at: [f64; 2], spacing: f64) -> Self {
        Self { corner: true, ..Self::new(at, spacing) }
    }
}

/// An ordered run of vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Chain {
    /// In order along the curve; the first is not repeated at the end of a closed chain.
    pub vertices: Vec<Vertex>,
    /// Whether the last vertex leads back to the first.
    pub closed: bool,
}

impl Chain {
    /// Length of the polyline, the closing segment included.
    pub(crate) fn length(&self) -> f64 {
        let v = &self.vertices;
        let open: f64 = v.windows(2).map(|w| distance(w[0].at, w[1].at)).sum();
        let closing = match (self.closed, v.first(), v.last()) {
            (true, Some(first), Some(last)) => distance(last.at, first.at),
            _ => 0.0,
        };
        open + closing
    }

    /// Positions of the vertices.
    pub(crate) fn points(&self) -> Vec<[f64; 2]> {
        self.vertices.iter().map(|v| v.at).collect()
    }

    /// Mean spacing of the vertices; 0 for none.
    pub(crate) fn spacing(&self) -> f64 {
        self.vertices.iter().map(|v| v.spacing).sum::<f64>() / self.vertices.len().max(1) as f64
    }
}
