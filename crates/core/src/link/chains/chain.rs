//! A chain of edgelets.

use crate::math::vec3::distance;
use crate::measure::Edgelet;

/// Least length of a stretch of a chain, in spacings.
const LENGTH: f64 = 4.0;

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

    /// The stretches of the edgelets to `keep`, short ones left out.
    pub(super) fn stretches(&self, keep: impl Fn(&Edgelet) -> bool) -> Vec<Chain> {
        let kept: Vec<bool> = self.members.iter().map(keep).collect();
        if kept.iter().all(|&k| k) {
            return vec![self.clone()];
        }
        let mut from = 0;
        let runs = kept.chunk_by(|a, b| a == b).map(|run| {
            from += run.len();
            (run[0], &self.members[from - run.len()..from])
        });
        let long = runs.filter(|(kept, run)| *kept && extent(run) >= LENGTH * run[0].spacing);
        long.map(|(_, run)| Chain { members: run.to_vec(), closed: false, longest: self.longest }).collect()
    }

    /// Its evidence: that of an edgelet, as many times as edgelets along it rest on points of their own.
    pub(super) fn evidence(&self) -> f64 {
        let seen = || self.members.iter().filter(|e| e.evidence != 0.0);
        let count = seen().count() as f64;
        let mean = |of: fn(&Edgelet) -> f64| seen().map(of).sum::<f64>() / count;
        mean(|e| e.evidence) * (self.extent() / mean(|e| e.reach)).max(1.0)
    }
}

/// The length of a row of edgelets, without gaps that were closed.
pub(super) fn extent(members: &[Edgelet]) -> f64 {
    let seen = members.windows(2).filter(|w| w[0].evidence != 0.0 && w[1].evidence != 0.0);
    seen.map(|w| distance(w[0].place, w[1].place)).sum()
}
