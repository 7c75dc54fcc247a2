//! The relations that are imposed: those found, without what was released of them.

use super::super::find::Found;
use super::cause::{Cause, Released};

/// Two classes at a right angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Right {
    /// Its number among those found.
    pub found: usize,
    pub classes: [usize; 2],
}

/// Features in a plane.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    /// Its number among those found.
    pub found: usize,
    /// The class of the normal.
    pub class: usize,
    pub members: Vec<usize>,
}

/// Features about an axis or a point.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Its number among those found.
    pub found: usize,
    /// Whether the centres are one.
    pub concentric: bool,
    pub members: Vec<usize>,
}

/// Features of one radius.
#[derive(Clone, Debug)]
pub(super) struct Radius {
    /// Its number among those found.
    pub found: usize,
    pub members: Vec<usize>,
}

/// Relations between features, by their indices; classes have the numbers that they were found under.
#[derive(Clone, Debug)]
pub(super) struct Imposed {
    /// The members of each class.
    pub classes: Vec<Vec<usize>>,
    pub right: Vec<Right>,
    pub planes: Vec<Plane>,
    pub axes: Vec<Axis>,
    pub radii: Vec<Radius>,
    /// Tangents, by their numbers among those found.
    pub tangents: Vec<usize>,
    /// Whether each feature is in a relation.
    related: Vec<bool>,
}

impl Imposed {
    pub(super) fn of(found: &Found, released: &Released) -> Self {
        let free = |i: usize| released.contains(&Cause::Feature(i));
        let stay = |of: &[usize], cause: &dyn Fn(usize) -> Cause| -> Vec<usize> {
            of.iter().copied().filter(|&i| !free(i) && !released.contains(&cause(i))).collect()
        };
        let several = |of: Vec<usize>| (of.len() > 1).then_some(of);
        let classes: Vec<Vec<usize>> =
            found.classes.iter().map(|c| stay(&c.members, &Cause::Parallel)).collect();
        // An arc has the direction of a plane or an axis from its class.
        let turned =
            |i: usize| found.features[i].round().is_none() || !released.contains(&Cause::Parallel(i));
        let right = found.right.iter().enumerate().map(|(found, p)| Right { found, classes: p.classes });
        let right = right.filter(|r| {
            !released.contains(&Cause::Perpendicular(r.found))
                && r.classes.iter().all(|&c| !classes[c].is_empty())
        });
        let right: Vec<Right> = right.collect();
        let planes = found.planes.iter().enumerate().filter(|(_, p)| !classes[p.class].is_empty());
        let planes = planes.filter_map(|(k, p)| {
            let mut members = stay(&p.members, &|i| Cause::Coplanar(k, i));
            members.retain(|&i| turned(i));
            Some(Plane { found: k, class: p.class, members: several(members)? })
        });
        let planes: Vec<Plane> = planes.collect();
        let axes = found.axes.iter().enumerate().filter_map(|(k, a)| {
            let mut members = stay(&a.members, &|i| Cause::Coaxial(k, i));
            members.retain(|&i| turned(i));
            Some(Axis { found: k, concentric: a.concentric, members: several(members)? })
        });
        let axes: Vec<Axis> = axes.collect();
        let radii = found.radii.iter().enumerate().filter_map(|(k, r)| {
            Some(Radius { found: k, members: several(stay(&r.members, &|i| Cause::EqualRadius(k, i)))? })
        });
        let radii: Vec<Radius> = radii.collect();
        let whole = |t: &usize| {
            !released.contains(&Cause::Tangent(*t)) && !found.tangents[*t].features.iter().any(|&i| free(i))
        };
        let tangents: Vec<usize> = (0..found.tangents.len()).filter(whole).collect();
        let related = vec![false; found.features.len()];
        let mut imposed = Self { classes, right, planes, axes, radii, tangents, related };
        imposed.mark(found);
        imposed
    }

    fn mark(&mut self, found: &Found) {
        let Self { classes, right, planes, axes, radii, tangents, related } = self;
        let turned = right.iter().flat_map(|r| r.classes).flat_map(|c| &classes[c]);
        let sets = classes.iter().filter(|c| c.len() > 1).flatten();
        let placed = planes.iter().flat_map(|p| &p.members).chain(axes.iter().flat_map(|a| &a.members));
        let touching = tangents.iter().flat_map(|&t| &found.tangents[t].features);
        let rounds = radii.iter().flat_map(|r| &r.members).chain(touching);
        for &i in turned.chain(sets).chain(placed).chain(rounds) {
            related[i] = true;
        }
    }

    /// Whether a feature is in a relation.
    pub(super) fn has(&self, feature: usize) -> bool {
        self.related[feature]
    }
}
