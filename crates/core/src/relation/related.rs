//! The relations of a network with what their imposition moved, and how both follow the network into other frames and choices.

use super::find::find;
use super::regularise::regularise;
use super::relations::{Regularised, Relation, RelationKind};
use crate::curve::pieces::Observed;
use crate::frame::Frame;
use crate::network::Network;
use crate::params::RelationParams;

/// The relations between the typed curves of a network.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Related {
    /// The relations, by kind.
    pub relations: Vec<Relation>,
    /// What their imposition moved; `None` where that was not asked for.
    pub regularised: Option<Regularised>,
}

/// The relations of a network whose curves were `observed`, `spacing` the distance of points on each strip. The network is moved if that is
/// asked for.
pub(crate) fn related(
    network: &mut Network,
    observed: &[Vec<Option<Observed>>],
    spacing: &[f64],
    noise: f64,
    params: &RelationParams,
) -> Related {
    let found = find(network, observed, spacing, params);
    if !params.regularise {
        return Related { relations: found.relations(), regularised: None };
    }
    let (relations, moved) = regularise(network, &found, spacing, noise);
    Related { relations, regularised: Some(moved) }
}

impl Related {
    /// The number of relations of one kind.
    pub fn count(&self, kind: RelationKind) -> usize {
        self.relations.iter().filter(|r| r.kind == kind).count()
    }

    /// From the local frame to that of the input.
    pub(crate) fn placed(mut self, frame: &Frame) -> Self {
        let unit = frame.length_to_world(1.0);
        self.relations.iter_mut().for_each(|r| r.place(|p| frame.to_world(p), unit));
        self.regularised.iter_mut().for_each(|r| r.scale(unit));
        self
    }

    /// Those between the strips that stay, by their new numbers; `kept` says whether a node stays.
    pub(crate) fn of_strips(self, stay: &[bool], kept: impl Fn(usize) -> bool) -> Self {
        let mut next = 0..;
        let number: Vec<Option<u32>> = stay.iter().map(|&s| if s { next.next() } else { None }).collect();
        let relations = self.relations.into_iter().filter_map(|r| r.of_strips(&number)).collect();
        Self { relations, regularised: self.regularised.map(|r| r.of_strips(&number, kept)) }
    }
}
