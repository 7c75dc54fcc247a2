//! The end of a run.

/// The end of a run, with its error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    /// World height.
    pub height: f64,
    /// The error of the height.
    pub error: f64,
    pub by: By,
}

/// The evidence for an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum By {
    Face,
    Fold,
    /// A fold along a curve that is level there.
    Rim,
    Meeting,
    Apex,
    Border,
}

impl By {
    /// Whether the surface shows an edge there.
    pub(crate) fn is_edge(self) -> bool {
        matches!(self, By::Face | By::Fold | By::Rim | By::Meeting)
    }
}
