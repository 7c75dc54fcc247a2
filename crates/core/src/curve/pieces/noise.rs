//! The error of a row's points, and what that makes a description cost.

/// What is known of the points before any curve is fitted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Noise {
    /// Standard deviation of a point across the curve.
    pub sigma: f64,
    /// Independent observations that a point stands for: neighbours err alike.
    pub share: f64,
    /// Natural logarithm of the number of independent observations.
    pub log_count: f64,
    /// Whether the points lie in a plane that is known.
    pub flat: bool,
}

impl Noise {
    /// Of a row of `count` points that is `length` long, where points err alike over a length of `reach`.
    pub(crate) fn new(sigma: f64, reach: f64, count: usize, length: f64) -> Self {
        let share = (length / (count.max(2) - 1) as f64 / reach).clamp(1e-3, 1.0);
        Self { sigma, share, log_count: (share * count as f64).max(2.0).ln(), flat: false }
    }

    /// Of `count` points of a plane that err independently. A parameter costs `ln n` instead of half of that: a break is the best of
    /// many places (the risk inflation criterion of Foster and George 1994, section 3, with a place a point).
    pub(crate) fn of_plane(sigma: f64, count: usize) -> Self {
        Self { sigma, share: 1.0, log_count: 2.0 * (count.max(2) as f64).ln(), flat: true }
    }

    /// The description length of a piece, nats.
    pub(crate) fn cost(&self, parameters: usize, squares: f64) -> f64 {
        0.5 * squares / (self.sigma * self.sigma) + 0.5 * parameters as f64 * self.log_count
    }

    /// The number of parameters of a piece: its curve and where on it the piece ends.
    pub(crate) fn parameters(&self, kind: Kind) -> usize {
        let curve = match (kind, self.flat) {
            (Kind::Line, false) => 4,
            (Kind::Line, true) => 2,
            (Kind::Arc, false) => 7,
            (Kind::Arc, true) => 3,
            (Kind::Ellipse, false) => 8,
            (Kind::Ellipse, true) => 5,
            (Kind::Spline(controls), false) => 3 * controls,
            (Kind::Spline(controls), true) => 2 * controls,
        };
        curve + 1
    }
}

/// Kinds of pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Line,
    Arc,
    Ellipse,
    /// With this number of control points.
    Spline(usize),
}

impl Kind {
    /// Least number of steps from point to point that speak for the kind: three points lie on a circle, five on an ellipse.
    pub(crate) fn fewest_steps(self) -> usize {
        match self {
            Kind::Line => 1,
            Kind::Ellipse => 5,
            Kind::Arc | Kind::Spline(_) => 3,
        }
    }
}

/// Points `first..=last` under one description.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    /// Its first point.
    pub first: usize,
    /// Its last point, the first of the next span.
    pub last: usize,
    /// Its description.
    pub kind: Kind,
}
