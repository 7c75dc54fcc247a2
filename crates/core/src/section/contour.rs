//! Contours of a section, linked and ordered before any outline is drawn (ours), and the assignment of samples to them
//! (Kyriazis et al., section 3, figure 5: `assign`).

pub(crate) mod assign;
pub(crate) mod band;
pub(crate) mod bridge;
pub(crate) mod chain;
pub(crate) mod cut;
pub(crate) mod end;
pub(crate) mod join;
pub(crate) mod link;
pub(crate) mod node;
pub(crate) mod splice;
pub(crate) mod stray;
pub(crate) mod tidy;
