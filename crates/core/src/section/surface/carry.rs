//! Points of a slab carried along the local surface to the slicing plane: our own step before any outline.
//!
//! A point at height d over the plane, on a surface whose normal n makes sin(theta) = |n_xy| with the slicing
//! direction, lies d / sin(theta) away from the curve along the surface. It is moved down the steepest direction of
//! its tangent plane, so that a slanted wall gives a thin band and not one as wide as the slab is thick. The points of a
//! flat tile share one plane, and come out on one line: those beside each other there are taken together.

use super::plane::TangentPlane;
use crate::math::vec2::{along, dot, sub};

/// Least sine of the angle between surface and plane: flatter faces do not say where they cross it.
const LEAST_SINE: f64 = 0.1;
/// Blur in local spacings from which on a crossing is uncertain.
const WEAK_BLUR: f64 = 0.5;
/// Length along the curve, in spacings, over which the points of a tile are taken together.
const MERGED: f64 = 1.2;
/// Places for them: a tile is about four spacings long, four that share a plane about eight.
const BINS: usize = 12;

/// A place where the surface crosses the slicing plane, from one point of the slab or a few beside each other.
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
    /// Least and greatest of the lifts of its points.
    pub lifts: (f64, f64),
    /// Its weight: the less, the farther its points were carried.
    pub weight: f64,
    /// Local spacing.
    pub spacing: f64,
    /// Error of the foot across the curve, local spacings: the noise of the tangent plane, stretched by the slant of the surface.
    pub blur: f64,
    /// Number of points.
    pub count: u32,
    /// Whether the tangent plane fits worse than noise explains (beside a crease, on a strong bend), or the surface
    /// is so slanted that noise hides where it crosses.
    pub weak: bool,
}

/// The limits within which points are carried, by distance and by face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CarryLimits {
    /// Greatest distance along the surface in local spacings, of points with a plane each.
    pub half: f64,
    /// The same for the points of a flat tile.
    pub far: f64,
    /// Standard deviation of the points from the surface in local spacings.
    pub noise: f64,
    /// Whether to carry along the surface, or to project straight as in the paper.
    pub carry: bool,
}

/// Carries points to the slicing plane along one tangent plane.
pub(crate) struct Carrier {
    plane: TangentPlane,
    limits: CarryLimits,
    sine: f64,
    /// Shift of a point for each unit of height.
    down: [f64; 2],
    tangent: [f64; 2],
    blur: f64,
    /// Where the middle of the tangent plane comes to lie.
    origin: [f64; 2],
    per_lift: f64,
    per_bin: f64,
}

impl Carrier {
    /// For points on a tangent plane in the slice frame, heights counted from the slicing plane; `None` where the
    /// surface runs along that plane.
    pub(crate) fn new(plane: TangentPlane, limits: CarryLimits) -> Option<Self> {
        let n = plane.normal;
        let sine2 = n[0] * n[0] + n[1] * n[1];
        let sine = sine2.sqrt();
        if sine < LEAST_SINE || plane.spacing <= 0.0 {
            return None;
        }
        let down = n[2] / sine2;
        let mut carrier = Self {
            plane,
            limits,
            sine,
            down: [down * n[0], down * n[1]],
            tangent: [-n[1] / sine, n[0] / sine],
            blur: (0.3 * limits.noise + 0.02) / sine,
            origin: [0.0; 2],
            per_lift: 1.0 / (sine * plane.spacing),
            per_bin: 1.0 / (MERGED * plane.spacing),
        };
        carrier.origin = carrier.shifted(plane.centre);
        Some(carrier)
    }

    fn shifted(&self, p: [f64; 3]) -> [f64; 2] {
        if self.limits.carry {
            [p[0] + p[2] * self.down[0], p[1] + p[2] * self.down[1]]
        } else {
            [p[0], p[1]]
        }
    }

    /// The sample of a point (third coordinate: height over the plane), or `None` where it lies too far off.
    pub(crate) fn sample(&self, p: [f64; 3]) -> Option<Sample> {
        let TangentPlane { centre: c, normal: n, spacing, .. } = self.plane;
        let lift = p[2] / (self.sine * spacing);
        if lift.abs() > self.limits.half {
            return None;
        }
        let off = (p[0] - c[0]) * n[0] + (p[1] - c[1]) * n[1] + (p[2] - c[2]) * n[2];
        Some(Sample {
            raw: self.shifted(p),
            foot: self.shifted([p[0] - off * n[0], p[1] - off * n[1], p[2] - off * n[2]]),
            tangent: self.tangent,
            drift: self.down.map(|x| -x),
            lift,
            lifts: (lift, lift),
            weight: weight(lift),
            spacing,
            blur: self.blur,
            count: 1,
            weak: self.weak(),
        })
    }

    /// Adds a point (third coordinate: height over the plane) to those beside it along the curve, unless it lies too far
    /// off.
    pub(crate) fn merge(&self, p: [f64; 3], bins: &mut Bins) {
        let lift = p[2] * self.per_lift;
        if lift.abs() > self.limits.far {
            return;
        }
        let raw = sub(self.shifted(p), self.origin);
        let u = dot(raw, self.tangent);
        let k = (u * self.per_bin + 0.5 * BINS as f64).clamp(0.0, BINS as f64 - 0.5) as usize;
        bins.0[k].add(raw, u, lift);
    }

    /// The samples of points of one plane, those beside each other along the curve taken together.
    pub(crate) fn merged(&self, bins: &Bins, samples: &mut Vec<Sample>) {
        let TangentPlane { spacing, .. } = self.plane;
        for bin in bins.0.iter().filter(|b| b.count > 0) {
            let share = 1.0 / bin.weight;
            let lift = share * bin.lift;
            samples.push(Sample {
                raw: along(self.origin, bin.raw, share),
                foot: along(self.origin, self.tangent, share * bin.u),
                tangent: self.tangent,
                drift: self.down.map(|x| -x),
                lift,
                lifts: bin.lifts,
                weight: bin.weight,
                spacing,
                blur: self.blur,
                count: bin.count,
                weak: self.weak(),
            });
        }
    }

    fn weak(&self) -> bool {
        let TangentPlane { residual, spacing, .. } = self.plane;
        self.blur > WEAK_BLUR || residual > (2.0 * self.limits.noise + 0.15) * spacing
    }
}

/// The points of one plane, by their places along the curve.
pub(crate) struct Bins([Bin; BINS]);

impl Bins {
    /// Without points.
    pub(crate) const EMPTY: Bins = Bins([Bin::EMPTY; BINS]);
}

/// Sums over the points of a tile that lie beside each other along the curve.
#[derive(Clone, Copy)]
struct Bin {
    weight: f64,
    raw: [f64; 2],
    u: f64,
    lift: f64,
    lifts: (f64, f64),
    count: u32,
}

impl Bin {
    const EMPTY: Bin = Bin {
        weight: 0.0,
        raw: [0.0; 2],
        u: 0.0,
        lift: 0.0,
        lifts: (f64::INFINITY, f64::NEG_INFINITY),
        count: 0,
    };

    fn add(&mut self, raw: [f64; 2], u: f64, lift: f64) {
        let weight = weight(lift);
        self.weight += weight;
        self.raw = along(self.raw, raw, weight);
        self.u += weight * u;
        self.lift += weight * lift;
        self.lifts = (self.lifts.0.min(lift), self.lifts.1.max(lift));
        self.count += 1;
    }
}

/// Points count the less, the farther they were carried.
fn weight(lift: f64) -> f64 {
    1.0 / (1.0 + lift * lift)
}
