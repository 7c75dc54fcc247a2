//! Points of a slab carried along the local surface to the slicing plane: our own step before any outline.
//!
//! A point at height d over the plane, on a surface whose normal n makes sin(theta) = |n_xy| with the slicing
//! direction, lies d / sin(theta) away from the curve along the surface. It is moved down the steepest direction of
//! its tangent plane, so that a slanted wall gives a thin band and not one as wide as the slab is thick.

use super::surface::Patch;

/// Where the surface crosses the slicing plane, as one point of the slab tells it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// Carried from the point itself.
    pub raw: [f64; 2],
    /// Carried from the point's foot on its tangent plane.
    pub foot: [f64; 2],
    /// Unit direction of the curve, of either sign.
    pub tangent: [f64; 2],
    /// How the curve moves with growing height, as the tangent plane has it.
    pub drift: [f64; 2],
    /// Signed distance along the surface, in local spacings; positive over the plane.
    pub lift: f64,
    /// Local spacing.
    pub spacing: f64,
    /// How far the foot may lie beside the curve, in local spacings: the noise of the tangent plane, stretched by
    /// the slant of the surface.
    pub blur: f64,
    /// Whether the tangent plane fits worse than noise explains (beside a crease, on a strong bend), or the surface
    /// is so slanted that noise hides where it crosses.
    pub weak: bool,
}

/// How far and on which faces points are carried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Greatest distance along the surface in local spacings: half of the slab's thickness on a steep wall.
    pub half: f64,
    /// Standard deviation of the points from the surface in local spacings.
    pub noise: f64,
    /// Whether to carry along the surface, or to project straight as in the paper.
    pub carry: bool,
}

/// Least sine of the angle between surface and plane: flatter faces do not say where they cross it.
const LEAST_SINE: f64 = 0.1;

/// Blur in local spacings from which on a crossing is uncertain.
const WEAK_BLUR: f64 = 0.5;

/// The sample of a point `p` (third coordinate: height over the plane), or `None` where the surface runs along the
/// plane or crosses it too far off.
pub(crate) fn carry(p: [f64; 3], patch: &Patch, reach: Reach) -> Option<Sample> {
    let n = patch.normal;
    let sine2 = n[0] * n[0] + n[1] * n[1];
    let sine = sine2.sqrt();
    if sine < LEAST_SINE || patch.spacing <= 0.0 {
        return None;
    }
    let lift = p[2] / (sine * patch.spacing);
    if lift.abs() > reach.half {
        return None;
    }
    let c = patch.centre;
    let off = (p[0] - c[0]) * n[0] + (p[1] - c[1]) * n[1] + (p[2] - c[2]) * n[2];
    let down = |x: f64, y: f64, height: f64| {
        let shift = if reach.carry { height * n[2] / sine2 } else { 0.0 };
        [x + shift * n[0], y + shift * n[1]]
    };
    let drift = [-n[0] * n[2] / sine2, -n[1] * n[2] / sine2];
    let blur = (0.3 * reach.noise + 0.02) / sine;
    Some(Sample {
        raw: down(p[0], p[1], p[2]),
        foot: down(p[0] - off * n[0], p[1] - off * n[1], p[2] - off * n[2]),
        tangent: [-n[1] / sine, n[0] / sine],
        drift,
        lift,
        spacing: patch.spacing,
        blur,
        weak: blur > WEAK_BLUR || patch.residual > (2.0 * reach.noise + 0.15) * patch.spacing,
    })
}
