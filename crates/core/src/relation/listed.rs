//! The relations found, as they are reported.

use super::find::Found;
use super::relations::{Member, Relation, RelationKind};

impl Found {
    /// The relations for reports, by kind.
    pub(crate) fn relations(&self) -> Vec<Relation> {
        let mut list = self.of_directions();
        list.extend(self.of_circles());
        let tangent = |t: &super::tangent::Tangent| {
            self.set(RelationKind::Tangent, &t.features, t.likelihood, t.deviation.abs())
        };
        list.extend(self.tangents.iter().map(tangent));
        for m in &self.mirrors {
            let [members, others] = [0, 1].map(|k| m.pairs.iter().map(|p| p[k]).collect::<Vec<usize>>());
            let set = self.set(RelationKind::Symmetric, &members, m.share, m.deviation);
            let direction = self.direction(m.class);
            list.push(Relation { others: self.named(&others), direction, point: Some(m.point), ..set });
        }
        list
    }

    fn of_directions(&self) -> Vec<Relation> {
        let mut list = Vec::new();
        for class in self.classes.iter().filter(|c| c.members.len() > 1) {
            let set = self.set(RelationKind::Parallel, &class.members, class.likelihood, class.deviation);
            list.push(Relation { direction: Some(class.direction), ..set });
        }
        for p in &self.right {
            let [a, b] = p.classes.map(|c| &self.classes[c]);
            let likelihood = p.likelihood.min(a.likelihood).min(b.likelihood);
            let set = self.set(RelationKind::Perpendicular, &a.members, likelihood, p.deviation);
            list.push(Relation { others: self.named(&b.members), ..set });
        }
        for p in &self.planes {
            let set = self.set(RelationKind::Coplanar, &p.members, p.likelihood, p.deviation);
            list.push(Relation { direction: self.direction(p.class), point: Some(p.point), ..set });
        }
        list
    }

    fn of_circles(&self) -> Vec<Relation> {
        let mut list = Vec::new();
        for concentric in [false, true] {
            let kind = if concentric { RelationKind::Concentric } else { RelationKind::Coaxial };
            for a in self.axes.iter().filter(|a| a.concentric == concentric) {
                let set = self.set(kind, &a.members, a.likelihood, a.deviation);
                list.push(Relation { direction: self.direction(a.class), point: Some(a.point), ..set });
            }
        }
        for r in &self.radii {
            let set = self.set(RelationKind::EqualRadius, &r.members, r.likelihood, r.deviation);
            list.push(Relation { radius: Some(r.radius), ..set });
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

    fn named(&self, of: &[usize]) -> Vec<Member> {
        of.iter().map(|&i| self.features[i].member).collect()
    }

    fn direction(&self, class: usize) -> Option<[f64; 3]> {
        Some(self.classes[class].direction)
    }
}
