//! The Convex Hull Method: feature points by repeated convex hulls (Kyriazis et al., section 3).
//!
//! The first feature points are the convex hull of the contour's points (step 3); a region whose points lie far from its
//! chord adds the vertices of its own convex hull (step 4). On a thick band these alternate between outside and inside: the
//! paper's internal-external point switching effect (figure 6), which `voronoi` eliminates.

use super::regions::{FeatureMark, refine};
use crate::math::convex_hull::convex_hull;
use crate::section::contour::band::Band;

/// Feature points, refined until every region's points lie within
/// `threshold` of their chord on average. Takes O(n log n) for each of the usually few rounds.
pub(crate) fn features(band: &Band, threshold: f64) -> Vec<FeatureMark> {
    refine(band, threshold, |region, _| convex_hull(region, |m| band.marks[m].raw))
}
