//! The patches that can be faces.

use crate::network::Network;
use crate::patch::fit::Surface;
use crate::patch::patches::{Patch, Patches};

/// Why a patch is no face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Omission {
    /// No surface of a known kind suits its points.
    FreeForm,
    /// The lines around it have a gap.
    Open,
    /// No line bounds it, and its surface does not close on itself.
    Unbounded,
    /// A line runs into it and ends there.
    Slit,
    /// A torus that meets itself.
    SelfMeeting,
    /// Its edges lie farther from its surface than its points do.
    Astray,
    /// Its edges cross each other, or leave a side open: they bound nothing.
    Tangled,
}

impl Omission {
    /// The reason in words.
    pub fn reason(self) -> &'static str {
        match self {
            Omission::FreeForm => "free-form",
            Omission::Open => "not closed",
            Omission::Unbounded => "without bounds",
            Omission::Slit => "with a line that ends inside",
            Omission::SelfMeeting => "on a torus that meets itself",
            Omission::Astray => "off their edges",
            Omission::Tangled => "not bounded by their edges",
        }
    }
}

/// The numbers of the patches that can be faces, ascending; and of the others, with the reason.
pub(super) fn choice(network: &Network, patches: &Patches) -> (Vec<u32>, Vec<(u32, Omission)>) {
    let (mut chosen, mut omitted) = (Vec::new(), Vec::new());
    for (p, patch) in (0..).zip(&patches.patches) {
        match obstacle(network, patch) {
            None => chosen.push(p),
            Some(why) => omitted.push((p, why)),
        }
    }
    (chosen, omitted)
}

fn obstacle(network: &Network, patch: &Patch) -> Option<Omission> {
    let coedges = || patch.loops.iter().flat_map(|l| &l.coedges);
    let mut strips: Vec<u32> = coedges().map(|c| c.strip).collect();
    let untyped = strips.iter().any(|&s| network.strips[s as usize].curves.is_empty());
    strips.sort_unstable();
    if patch.fit.free {
        Some(Omission::FreeForm)
    } else if patch.loops.iter().any(|l| !l.closed) || untyped {
        Some(Omission::Open)
    } else if strips.windows(2).any(|w| w[0] == w[1]) {
        Some(Omission::Slit)
    } else {
        match patch.fit.surface {
            Surface::Torus { major, minor, .. } if major <= minor => Some(Omission::SelfMeeting),
            Surface::Sphere { .. } | Surface::Torus { .. } => None,
            _ => patch.loops.is_empty().then_some(Omission::Unbounded),
        }
    }
}
