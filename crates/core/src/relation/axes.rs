//! Arcs and circles about one axis, and about one point: those of one class of directions by the places of their centres across it, then
//! along it.

use super::cluster::{Cluster, clusters};
use super::feature::{Feature, between};
use super::parallel::Class;
use crate::math::vec3::{add_scaled, cross, distance, dot, perpendicular, scale, sub};

/// Arcs and circles about one axis or point.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// The class of its direction.
    pub class: usize,
    /// The features, ascending.
    pub members: Vec<usize>,
    /// A point of the axis; the centre.
    pub point: [f64; 3],
    /// Whether the centres are one point.
    pub concentric: bool,
    /// Probability of the least likely member.
    pub likelihood: f64,
    /// Root mean square distance of the centres from the axis, or from the point.
    pub deviation: f64,
}

/// The common axes of all classes. A set with one centre is reported as such alone.
pub(super) fn axes(features: &[Feature], classes: &[Class], least: f64) -> Vec<Axis> {
    let mut found = Vec::new();
    for (k, class) in classes.iter().enumerate() {
        let rounds: Vec<usize> =
            class.members.iter().copied().filter(|&i| features[i].round().is_some()).collect();
        if rounds.len() > 1 {
            of_class(features, class, &rounds, least)
                .into_iter()
                .for_each(|a| found.push(Axis { class: k, ..a }));
        }
    }
    found
}

/// The features of a class seen along its direction.
struct View<'a> {
    features: &'a [Feature],
    class: &'a Class,
    middle: [f64; 3],
    extent: f64,
}

impl View<'_> {
    /// Those that lie at one place along `axis`, with the probability of each set.
    fn alike(&self, of: &[usize], axis: [f64; 3], least: f64) -> Vec<(Vec<usize>, f64)> {
        let direction = self.class.direction;
        let along_class = dot(axis, direction).abs() > 0.5;
        let number = |&i: &usize| {
            let away = sub(self.features[i].at, self.middle);
            let far = dot(away, direction);
            // A tilt of the direction moves what is far along it.
            let lever = if along_class { add_scaled(away, direction, -far) } else { scale(axis, far) };
            let own = between(axis, &self.features[i].place, axis);
            (dot(away, axis), own + between(lever, &self.class.turn, lever))
        };
        let numbers: Vec<(f64, f64)> = of.iter().map(number).collect();
        let set = |c: Cluster| (c.members.iter().map(|&k| of[k]).collect(), c.likelihood);
        clusters(&numbers, self.extent, least).into_iter().map(set).collect()
    }

    fn axis(&self, members: Vec<usize>, concentric: bool, likelihood: f64) -> Axis {
        let sum = members.iter().fold([0.0; 3], |s, &i| add_scaled(s, self.features[i].at, 1.0));
        let point = scale(sum, 1.0 / members.len() as f64);
        let off = |&i: &usize| {
            let away = sub(self.features[i].at, point);
            let d = if concentric { away } else { cross(away, self.class.direction) };
            dot(d, d)
        };
        let deviation = (members.iter().map(off).sum::<f64>() / members.len() as f64).sqrt();
        let likelihood = likelihood.min(self.class.likelihood);
        Axis { class: 0, members, point, concentric, likelihood, deviation }
    }
}

fn of_class(features: &[Feature], class: &Class, rounds: &[usize], least: f64) -> Vec<Axis> {
    let sum = rounds.iter().fold([0.0; 3], |s, &i| add_scaled(s, features[i].at, 1.0));
    let middle = scale(sum, 1.0 / rounds.len() as f64);
    let far = rounds.iter().map(|&i| distance(features[i].at, middle)).fold(0.0, f64::max);
    let widest = rounds.iter().map(|&i| features[i].observed.half).fold(0.0, f64::max);
    let view = View { features, class, middle, extent: 2.0 * far.max(widest) };
    let u = perpendicular(class.direction);
    let mut found = Vec::new();
    for (same, first) in view.alike(rounds, u, least) {
        for (members, second) in view.alike(&same, cross(class.direction, u), least) {
            if members.len() < 2 {
                continue;
            }
            let likelihood = first.min(second);
            let centres: Vec<Axis> = view
                .alike(&members, class.direction, least)
                .into_iter()
                .filter(|(set, _)| set.len() > 1)
                .map(|(set, third)| view.axis(set, true, likelihood.min(third)))
                .collect();
            if centres.iter().all(|c| c.members.len() < members.len()) {
                found.push(view.axis(members, false, likelihood));
            }
            found.extend(centres);
        }
    }
    found
}
