//! Where slanted planes beside an outline meet it.

use super::ground::Spot;
use super::search::Search;
use crate::math::vec2::{dot, sub, unit};
use crate::math::vec3;

/// Least angle of a slanted wall to the axis, degrees: without noise, and for each spacing of noise.
const SLANTED_DEG: (f64, f64) = (10.0, 40.0);
/// Fewest points that show a fold or a rim.
pub(crate) const FEWEST_MEETS: usize = 8;
/// Cosine of the angle between axis and normal above which a plane is level: 4 degrees.
const LEVEL_COSINE: f64 = 0.9976;
/// Cosine of the angle by which a slanted plane may fall aside.
const ACROSS_COSINE: f64 = 0.7;
/// Distance beside an outline up to which planes show where they meet it, spacings.
const BESIDE_OUTLINE: f64 = 6.0;

/// A slanted plane beside an outline.
#[derive(Clone, Copy)]
pub(super) struct Meet {
    /// Distance ahead at which the plane meets the outline.
    pub ahead: f64,
    /// Distance of its point ahead and beside the outline.
    pub own: f64,
    pub off: f64,
    /// Rise of the wall for each unit that it falls aside.
    pub rise: f64,
    pub foot: [f64; 2],
}

/// A line through heights, or the level place of a curve.
pub(super) struct Fitted {
    pub ahead: f64,
    pub error: f64,
}

/// Where the plane at a spot meets the outline, if it is slanted and falls across it.
pub(super) fn meet(search: &Search, s: &Spot, h: f64, noise: f64) -> Option<Meet> {
    let least = (SLANTED_DEG.0 + SLANTED_DEG.1 * noise).to_radians().sin();
    let lean = s.normal[2].abs();
    if !(least..LEVEL_COSINE).contains(&lean) || s.off > BESIDE_OUTLINE * h || !faces_outline(s) {
        return None;
    }
    let [dx, dy] = to_foot(s);
    let height = s.centre[2] - vec3::dot([dx, dy, 0.0], s.normal) / s.normal[2];
    Some(Meet {
        ahead: search.ahead(height),
        own: search.ahead(s.height),
        off: s.off,
        rise: (1.0 - lean * lean).sqrt() / lean,
        foot: s.foot,
    })
}

/// Whether a plane falls towards the outline or away from it, and not along it as the flanks of a bore that opens there.
fn faces_outline(s: &Spot) -> bool {
    let (normal, away) = (unit([s.normal[0], s.normal[1]]), unit(sub(s.at, s.foot)));
    dot(normal, away).abs() >= ACROSS_COSINE
}
/// Horizontal part of the way from a spot's plane to the foot.
pub(super) fn to_foot(spot: &Spot) -> [f64; 2] {
    sub(spot.foot, [spot.centre[0], spot.centre[1]])
}
