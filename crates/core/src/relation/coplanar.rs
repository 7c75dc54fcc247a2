//! Planes that hold several curves: across each class of directions those curves that lie across it, by their heights.

use super::cluster::{clusters, deviation};
use super::feature::{Feature, between};
use super::parallel::Class;
use super::perpendicular::{COMPARED, Perpendicular};
use crate::math::vec3::{add_scaled, dot, scale, sub};

/// Curves in one plane.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    /// The class of its normal.
    pub class: usize,
    /// The features in it, ascending.
    pub members: Vec<usize>,
    /// A point of it.
    pub point: [f64; 3],
    /// Probability of the least likely member.
    pub likelihood: f64,
    /// Root mean square distance of the members.
    pub deviation: f64,
}

/// The planes across the first classes. `touch` tells whether two features meet: two lines that do are no plane.
pub(super) fn planes(
    features: &[Feature],
    classes: &[Class],
    right: &[Perpendicular],
    touch: impl Fn(usize, usize) -> bool,
    least: f64,
) -> Vec<Plane> {
    let mut across: Vec<Vec<usize>> = vec![Vec::new(); classes.len().min(COMPARED)];
    for p in right {
        for [a, b] in [p.classes, [p.classes[1], p.classes[0]]] {
            if let Some(list) = across.get_mut(a) {
                list.push(b);
            }
        }
    }
    let mut found = Vec::new();
    for (class, others) in across.iter().enumerate() {
        let lines =
            others.iter().flat_map(|&c| &classes[c].members).filter(|&&i| features[i].round().is_none());
        let rounds = classes[class].members.iter().filter(|&&i| features[i].round().is_some());
        let mut inside: Vec<usize> = lines.chain(rounds).copied().collect();
        inside.sort_unstable();
        found.extend(along(features, &classes[class], &inside, least).into_iter().filter_map(|plane| {
            let trivial = match plane.members[..] {
                [_] => true,
                [a, b] => touch(a, b),
                _ => false,
            };
            (!trivial).then_some(Plane { class, ..plane })
        }));
    }
    found
}

/// Features that lie across a class, parted by their heights along it.
fn along(features: &[Feature], class: &Class, inside: &[usize], least: f64) -> Vec<Plane> {
    let sum = inside.iter().fold([0.0; 3], |s, &i| add_scaled(s, features[i].at, 1.0));
    let middle = scale(sum, 1.0 / inside.len().max(1) as f64);
    let height = |&i: &usize| {
        let away = sub(features[i].at, middle);
        let height = dot(away, class.direction);
        let flat = add_scaled(away, class.direction, -height);
        let own = between(class.direction, &features[i].place, class.direction);
        (height, own + between(flat, &class.turn, flat))
    };
    let heights: Vec<(f64, f64)> = inside.iter().map(height).collect();
    let all = || heights.iter().map(|h| h.0);
    let extent = all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min);
    let found = clusters(&heights, extent, least);
    let plane = |c: &super::cluster::Cluster| Plane {
        class: 0,
        members: c.members.iter().map(|&k| inside[k]).collect(),
        point: add_scaled(middle, class.direction, c.mean),
        likelihood: c.likelihood.min(class.likelihood),
        deviation: deviation(c, &heights),
    };
    found.iter().map(plane).collect()
}
