//! The graph distance of a point's neighbourhood.

use crate::params::Auto;
use crate::resolution::Resolution;

/// The graph distance of the neighbourhoods at a place: as given, or by the noise there (Gumhold 2001, section 3.1: direct
/// neighbours without noise, graph distance up to five with much noise).
pub(crate) fn hops(given: Auto<usize>, resolution: Resolution) -> usize {
    given.or(|| match resolution.noise / resolution.spacing {
        r if r < 0.15 => 1,
        r if r < 0.6 => 2,
        _ => 3,
    })
}
