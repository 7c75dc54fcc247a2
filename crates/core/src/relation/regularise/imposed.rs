//! The relations that are imposed: those found, without the curves that were released.

use super::super::find::Found;
use std::collections::BTreeSet;

/// Relations between features, by their indices; classes have the numbers that they were found under.
#[derive(Clone, Debug)]
pub(super) struct Imposed {
    /// The members of each class.
    pub classes: Vec<Vec<usize>>,
    /// Classes at right angles.
    pub right: Vec<[usize; 2]>,
    /// Planes: the class of the normal, and the features.
    pub planes: Vec<(usize, Vec<usize>)>,
    /// Axes, and whether the centres are one.
    pub axes: Vec<(Vec<usize>, bool)>,
    /// Features of one radius.
    pub radii: Vec<Vec<usize>>,
    /// Tangent features and their joint.
    pub tangents: Vec<([usize; 2], usize)>,
    /// Whether each feature is in a relation.
    related: Vec<bool>,
}

impl Imposed {
    pub(super) fn of(found: &Found, released: &BTreeSet<usize>) -> Self {
        let stay =
            |of: &[usize]| -> Vec<usize> { of.iter().copied().filter(|i| !released.contains(i)).collect() };
        let several = |of: Vec<usize>| (of.len() > 1).then_some(of);
        let classes: Vec<Vec<usize>> = found.classes.iter().map(|c| stay(&c.members)).collect();
        let both = |p: &[usize; 2]| p.iter().all(|&c| !classes[c].is_empty());
        let right: Vec<[usize; 2]> = found.right.iter().map(|p| p.classes).filter(both).collect();
        let planes = found.planes.iter().filter(|p| !classes[p.class].is_empty());
        let planes: Vec<(usize, Vec<usize>)> =
            planes.filter_map(|p| Some((p.class, several(stay(&p.members))?))).collect();
        let axes =
            found.axes.iter().filter_map(|a| Some((several(stay(&a.members))?, a.concentric))).collect();
        let radii: Vec<Vec<usize>> = found.radii.iter().filter_map(|r| several(stay(&r.members))).collect();
        let kept = found.tangents.iter().filter(|t| t.features.iter().all(|i| !released.contains(i)));
        let tangents: Vec<([usize; 2], usize)> = kept.map(|t| (t.features, t.joint)).collect();
        let mut imposed = Self {
            classes,
            right,
            planes,
            axes,
            radii,
            tangents,
            related: vec![false; found.features.len()],
        };
        imposed.mark();
        imposed
    }

    fn mark(&mut self) {
        let Self { classes, right, planes, axes, radii, tangents, related } = self;
        let turned = right.iter().flatten().flat_map(|&c| &classes[c]);
        let sets = classes.iter().filter(|c| c.len() > 1).flatten();
        let placed = planes.iter().flat_map(|p| &p.1).chain(axes.iter().flat_map(|a| &a.0));
        let rounds = radii.iter().flatten().chain(tangents.iter().flat_map(|t| &t.0));
        for &i in turned.chain(sets).chain(placed).chain(rounds) {
            related[i] = true;
        }
    }

    /// Whether a feature is in a relation.
    pub(super) fn has(&self, feature: usize) -> bool {
        self.related[feature]
    }
}
