//! A chain of edgelets.

use crate::math::vec3::distance;
use crate::measure::Edgelet;

/// Edgelets that follow each other along a crease; the last is joined to the first if `closed`.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) members: Vec<Edgelet>,
    pub(super) closed: bool,
    /// Length in spacings of the longest of the chains that it was made of.
    pub(super) longest: f64,
}

impl Chain {
    /// Its length, without gaps that were closed.
    pub(super) fn extent(&self) -> f64 {
        extent(&self.members)
    }

    /// Its segments, each by its ends and the spacing of the cloud there.
    pub(super) fn segments(&self) -> impl Iterator<Item = ([f64; 3], [f64; 3], f64)> + '_ {
        let members = &self.members;
        let closing = self.closed.then(|| [members[members.len() - 1], members[0]]);
        let pairs = members.windows(2).map(|w| [w[0], w[1]]).chain(closing);
        pairs.map(|[a, b]| (a.place, b.place, a.spacing))
    }

    /// Its evidence: that of an edgelet, as many times as edgelets along it rest on points of their own.
    pub(super) fn evidence(&self) -> f64 {
        let seen = || self.members.iter().filter(|e| e.evidence > 0.0);
        let count = seen().count() as f64;
        let mean = |of: fn(&Edgelet) -> f64| seen().map(of).sum::<f64>() / count;
        mean(|e| e.evidence) * (self.extent() / mean(|e| e.reach)).max(1.0)
    }
}

/// The length of a row of edgelets, without gaps that were closed.
pub(super) fn extent(members: &[Edgelet]) -> f64 {
    let seen = members.windows(2).filter(|w| w[0].evidence > 0.0 && w[1].evidence > 0.0);
    seen.map(|w| distance(w[0].place, w[1].place)).sum()
}
