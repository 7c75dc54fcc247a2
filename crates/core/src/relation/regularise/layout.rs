//! Where the unknowns stand in their vector.

use super::super::find::Found;
use super::imposed::Imposed;
use crate::curve::pieces::Shape;
use crate::math::vec3::{dot, scale};
use crate::network::Network;
use std::collections::BTreeSet;

/// The first of the unknowns of each kind, and where they begin.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Three for each joint.
    pub joint: Vec<usize>,
    /// Three for the centre of each feature that is an arc or a circle.
    pub centre: Vec<Option<usize>>,
    /// One for its radius.
    pub radius: Vec<Option<usize>>,
    /// Three for its direction, and whether that is turned about.
    pub direction: Vec<Option<(usize, f64)>>,
    /// Three for the direction of each class that needs one.
    pub class: Vec<Option<usize>>,
    /// One for the height of each plane.
    pub plane: Vec<usize>,
    /// First unknown and number of each block.
    pub blocks: Vec<(usize, usize)>,
    /// The unknowns before the fit.
    pub start: Vec<f64>,
    /// All directions.
    pub directions: Vec<usize>,
}

impl Layout {
    fn push(&mut self, values: &[f64]) -> usize {
        let at = self.start.len();
        self.blocks.push((at, values.len()));
        self.start.extend_from_slice(values);
        at
    }

    fn push_direction(&mut self, direction: [f64; 3]) -> usize {
        let at = self.push(&direction);
        self.directions.push(at);
        at
    }

    pub(super) fn new(found: &Found, imposed: &Imposed, unseen: &BTreeSet<usize>, network: &Network) -> Self {
        let n = found.features.len();
        let mut layout = Self {
            joint: Vec::new(),
            centre: vec![None; n],
            radius: vec![None; n],
            direction: vec![None; n],
            class: vec![None; found.classes.len()],
            plane: Vec::new(),
            blocks: Vec::new(),
            start: Vec::new(),
            directions: Vec::new(),
        };
        for &place in &found.joints.places {
            let at = layout.push(&place);
            layout.joint.push(at);
        }
        layout.directions(found, imposed);
        layout.rounds(found, imposed, unseen);
        for plane in &imposed.planes {
            let direction = found.classes[plane.class].direction;
            let heights = plane.members.iter().map(|&i| dot(found.features[i].at, direction));
            let mean = heights.sum::<f64>() / plane.members.len() as f64;
            let at = layout.push(&[mean]);
            layout.plane.push(at);
        }
        debug_assert!(
            network
                .strips
                .iter()
                .flat_map(|s| &s.curves)
                .all(|p| !matches!(p.shape, Shape::Circle(r) if r.radius <= 0.0))
        );
        layout
    }

    fn directions(&mut self, found: &Found, imposed: &Imposed) {
        let mut needed = vec![false; found.classes.len()];
        imposed.right.iter().flat_map(|r| r.classes).for_each(|c| needed[c] = true);
        imposed.planes.iter().for_each(|p| needed[p.class] = true);
        for (c, members) in imposed.classes.iter().enumerate() {
            if needed[c] || members.len() > 1 {
                let direction = found.classes[c].direction;
                let at = self.push_direction(direction);
                self.class[c] = Some(at);
                for &i in members {
                    let sign = dot(found.features[i].direction, direction).signum();
                    self.direction[i] = Some((at, sign));
                }
            }
        }
    }

    /// Arcs that are in no relation and not observed go along with their ends: nothing would say how far they bend.
    fn rounds(&mut self, found: &Found, imposed: &Imposed, unseen: &BTreeSet<usize>) {
        for members in imposed.axes.iter().filter(|a| a.concentric).map(|a| &a.members) {
            let sum = members.iter().fold([0.0; 3], |s, &i| crate::math::vec3::add(s, found.features[i].at));
            let at = self.push(&scale(sum, 1.0 / members.len() as f64));
            members.iter().for_each(|&i| self.centre[i] = Some(at));
        }
        for members in imposed.radii.iter().map(|r| &r.members) {
            let mean =
                members.iter().map(|&i| found.features[i].observed.half).sum::<f64>() / members.len() as f64;
            let at = self.push(&[mean]);
            members.iter().for_each(|&i| self.radius[i] = Some(at));
        }
        for (i, feature) in found.features.iter().enumerate() {
            let Some(round) = feature.round().filter(|_| imposed.has(i) || !unseen.contains(&i)) else {
                continue;
            };
            if self.direction[i].is_none() {
                self.direction[i] = Some((self.push_direction(feature.direction), 1.0));
            }
            if self.centre[i].is_none() {
                self.centre[i] = Some(self.push(&round.centre));
            }
            if self.radius[i].is_none() {
                self.radius[i] = Some(self.push(&[round.radius]));
            }
        }
    }
}

/// Three unknowns in a row.
pub(super) fn triple(x: &[f64], at: usize) -> [f64; 3] {
    [x[at], x[at + 1], x[at + 2]]
}
