//! What a condition stems from, and so what is released where it cannot hold.

use std::collections::BTreeSet;

/// The origin of a condition; numbers are those of what was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Cause {
    /// A direction has length one: never released.
    Unit,
    /// An arc ends on its joints; released, the feature is in no relation at all.
    Feature(usize),
    /// A feature runs in the direction of its class.
    Parallel(usize),
    /// Two classes are at a right angle.
    Perpendicular(usize),
    /// A feature lies in a plane.
    Coplanar(usize, usize),
    /// A feature is about an axis or a point.
    Coaxial(usize, usize),
    /// A feature has a common radius.
    EqualRadius(usize, usize),
    /// Two features are tangent.
    Tangent(usize),
}

impl Cause {
    /// The feature that is left out of a relation with it; none where the whole relation goes.
    pub(super) fn feature(self) -> Option<usize> {
        match self {
            Cause::Unit | Cause::Perpendicular(_) | Cause::Tangent(_) => None,
            Cause::Feature(i)
            | Cause::Parallel(i)
            | Cause::Coplanar(_, i)
            | Cause::Coaxial(_, i)
            | Cause::EqualRadius(_, i) => Some(i),
        }
    }
}

/// What is not imposed.
pub(super) type Released = BTreeSet<Cause>;
