//! Arcs and circles of one radius.

use super::cluster::{clusters, deviation};
use super::feature::Feature;

/// Arcs and circles of one radius.
#[derive(Clone, Debug)]
pub(super) struct Radius {
    /// The features, ascending.
    pub members: Vec<usize>,
    /// The mean radius.
    pub radius: f64,
    /// Probability of the least likely member.
    pub likelihood: f64,
    /// Root mean square difference from the mean.
    pub deviation: f64,
}

/// The sets of two arcs and circles or more, where chance gives any radius up to `greatest`.
pub(super) fn radii(features: &[Feature], greatest: f64, least: f64) -> Vec<Radius> {
    let rounds: Vec<(usize, f64, f64)> = features
        .iter()
        .enumerate()
        .filter_map(|(i, f)| Some((i, f.round()?.radius, f.radius_variance())))
        .collect();
    let numbers: Vec<(f64, f64)> = rounds.iter().map(|r| (r.1, r.2)).collect();
    let found = clusters(&numbers, greatest, least);
    let several = found.iter().filter(|c| c.members.len() > 1);
    let set = |c: &super::cluster::Cluster| Radius {
        members: c.members.iter().map(|&k| rounds[k].0).collect(),
        radius: c.mean,
        likelihood: c.likelihood,
        deviation: deviation(c, &numbers),
    };
    several.map(set).collect()
}
