//! Trial: edges from cross-sections pooled along the direction in which the surface does not change.

mod apply;
mod chain;
mod field;
mod pieces;
mod section;

pub(crate) use apply::edgelets;

pub(super) fn env(name: &str, default: f64) -> f64 {
    std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default)
}
