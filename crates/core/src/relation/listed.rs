//! The relations found, as they are reported.

use super::find::Found;
use super::relations::{Member, Relation, RelationKind};

/// Where a relation stands among those found: the number in its list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Class(usize),
    Right(usize),
    Plane(usize),
    Axis(usize),
    Radius(usize),
    Tangent(usize),
    Mirror,
}

impl Found {
    /// The relations for reports, by kind.
    pub(crate) fn relations(&self) -> Vec<Relation> {
        self.listed().into_iter().map(|r| r.1).collect()
    }

    /// The relations for reports, by kind, with the place of each.
    pub(super) fn listed(&self) -> Vec<(Place, Relation)> {
        let mut list = self.of_directions();
        list.extend(self.of_circles());
        for (k, t) in self.tangents.iter().enumerate() {
            let set = self.set(RelationKind::Tangent, &t.features, t.likelihood, t.deviation.abs());
            list.push((Place::Tangent(k), set));
        }
        for m in &self.mirrors {
            let [members, others] = [0, 1].map(|k| m.pairs.iter().map(|p| p[k]).collect::<Vec<usize>>());
            let set = self.set(RelationKind::Symmetric, &members, m.share, m.deviation);
            let direction = self.direction(m.class);
            let relation = Relation { others: self.named(&others), direction, point: Some(m.point), ..set };
            list.push((Place::Mirror, relation));
        }
        list
    }

    fn of_directions(&self) -> Vec<(Place, Relation)> {
        let mut list = Vec::new();
        for (k, class) in self.classes.iter().enumerate().filter(|(_, c)| c.members.len() > 1) {
            let set = self.set(RelationKind::Parallel, &class.members, class.likelihood, class.deviation);
            list.push((Place::Class(k), Relation { direction: Some(class.direction), ..set }));
        }
        for (k, p) in self.right.iter().enumerate() {
            let [a, b] = p.classes.map(|c| &self.classes[c]);
            let likelihood = p.likelihood.min(a.likelihood).min(b.likelihood);
            let set = self.set(RelationKind::Perpendicular, &a.members, likelihood, p.deviation);
            list.push((Place::Right(k), Relation { others: self.named(&b.members), ..set }));
        }
        for (k, p) in self.planes.iter().enumerate() {
            let set = self.set(RelationKind::Coplanar, &p.members, p.likelihood, p.deviation);
            let (direction, point) = (self.direction(p.class), Some(p.point));
            list.push((Place::Plane(k), Relation { direction, point, ..set }));
        }
        list
    }

    fn of_circles(&self) -> Vec<(Place, Relation)> {
        let mut list = Vec::new();
        for concentric in [false, true] {
            let kind = if concentric { RelationKind::Concentric } else { RelationKind::Coaxial };
            for (k, a) in self.axes.iter().enumerate().filter(|(_, a)| a.concentric == concentric) {
                let set = self.set(kind, &a.members, a.likelihood, a.deviation);
                let (direction, point) = (self.direction(a.class), Some(a.point));
                list.push((Place::Axis(k), Relation { direction, point, ..set }));
            }
        }
        for (k, r) in self.radii.iter().enumerate() {
            let set = self.set(RelationKind::EqualRadius, &r.members, r.likelihood, r.deviation);
            list.push((Place::Radius(k), Relation { radius: Some(r.radius), ..set }));
        }
        list
    }

    fn set(&self, kind: RelationKind, members: &[usize], likelihood: f64, deviation: f64) -> Relation {
        Relation {
            kind,
            members: self.named(members),
            others: Vec::new(),
            likelihood,
            deviation,
            direction: None,
            point: None,
            radius: None,
            imposed: false,
        }
    }

    pub(super) fn named(&self, of: &[usize]) -> Vec<Member> {
        of.iter().map(|&i| self.features[i].member).collect()
    }

    fn direction(&self, class: usize) -> Option<[f64; 3]> {
        Some(self.classes[class].direction)
    }
}
