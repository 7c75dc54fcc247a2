//! Contours told apart and ordered before any outline is drawn, and the samples assigned to them (Kyriazis et al., figure 5).

pub(crate) mod assign;
pub(crate) mod band;
pub(crate) mod bridge;
pub(crate) mod chain;
pub(crate) mod end;
pub(crate) mod join;
pub(crate) mod link;
pub(crate) mod node;
pub(crate) mod splice;
pub(crate) mod stray;
pub(crate) mod tidy;
