//! The truth: the feature network of a shape by construction.

use crate::math::vec3::{add_scaled, cross, distance, dot, norm};
use crate::network::{NodeKind, StripKind};

/// Vertices on a full circle of the truth: its polyline leaves the circle by at most 1e-5 of the radius.
pub(crate) const CIRCLE: u32 = 720;

/// A network known by construction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Truth {
    /// The points where curves meet or end, and apexes.
    pub nodes: Vec<TruthNode>,
    /// The creases and borders.
    pub curves: Vec<TruthCurve>,
    /// Fold, in degrees, below which a crease may be found or missed. 0 except for shapes with fading creases.
    pub weak_below_deg: f64,
}

/// A point where curves of a [`Truth`] meet or end.
#[derive(Clone, Debug, PartialEq)]
pub struct TruthNode {
    /// World frame.
    pub position: [f64; 3],
    /// The kind, by the number of curve ends, as in a `Network`.
    pub kind: NodeKind,
    /// The number of curve ends here.
    pub degree: u32,
}

/// One crease or border of a [`Truth`].
#[derive(Clone, Debug, PartialEq)]
pub struct TruthCurve {
    /// Crease or border.
    pub kind: StripKind,
    /// A loop without nodes; its first point is not repeated.
    pub closed: bool,
    /// Node at the first point; `None` exactly when closed.
    pub start: Option<u32>,
    /// Node at the last point; `None` exactly when closed.
    pub end: Option<u32>,
    /// `(M, 3)` points of the curve, so dense that a chord leaves it by at most 1e-5 of its radius.
    pub points: Vec<[f64; 3]>,
    /// `(M)` angles between the normals of the two faces, in degrees; empty for a border. From the platform's
    /// arc tangent: the last bit may differ between machines.
    pub fold_deg: Vec<f64>,
    /// The sense in which the surface folds.
    pub fold: Fold,
}

/// The sense in which the surface folds along a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    /// The solid fills less than half of the space around the crease.
    Convex,
    /// The solid fills more than half.
    Concave,
    /// No second face: a border.
    Open,
}

impl TruthCurve {
    /// Length of the polyline, the closing segment included.
    pub fn length(&self) -> f64 {
        self.segments().map(|[a, b]| distance(a, b)).sum()
    }

    /// The segments in order, the closing one last.
    pub fn segments(&self) -> impl Iterator<Item = [[f64; 3]; 2]> + '_ {
        let closing = if self.closed { self.points.last().zip(self.points.first()) } else { None };
        self.points.windows(2).map(|w| [w[0], w[1]]).chain(closing.map(|(&a, &b)| [a, b]))
    }

    /// The least fold in degrees; infinite for a border.
    pub fn least_fold_deg(&self) -> f64 {
        self.fold_deg.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// A crease with the same fold everywhere.
    pub(crate) fn crease(points: Vec<[f64; 3]>, fold_deg: f64, fold: Fold, ends: Option<[u32; 2]>) -> Self {
        let fold_deg = vec![fold_deg; points.len()];
        Self::new(StripKind::Crease, points, fold_deg, fold, ends)
    }

    /// The end of an open surface.
    pub(crate) fn border(points: Vec<[f64; 3]>, ends: Option<[u32; 2]>) -> Self {
        Self::new(StripKind::Border, points, Vec::new(), Fold::Open, ends)
    }

    /// A curve, closed exactly when it has no ends.
    pub(crate) fn new(
        kind: StripKind,
        points: Vec<[f64; 3]>,
        fold_deg: Vec<f64>,
        fold: Fold,
        ends: Option<[u32; 2]>,
    ) -> Self {
        let [start, end] = [ends.map(|e| e[0]), ends.map(|e| e[1])];
        Self { kind, closed: ends.is_none(), start, end, points, fold_deg, fold }
    }
}

impl Truth {
    /// The number of closed curves.
    pub fn loops(&self) -> usize {
        self.curves.iter().filter(|c| c.closed).count()
    }

    /// The number of nodes of one kind.
    pub fn count(&self, kind: NodeKind) -> usize {
        self.nodes.iter().filter(|n| n.kind == kind).count()
    }

    /// The network of `curves`, with nodes at these positions and the degrees that follow.
    pub(crate) fn with_nodes(positions: &[[f64; 3]], curves: Vec<TruthCurve>) -> Self {
        let mut degrees = vec![0; positions.len()];
        for node in curves.iter().flat_map(|c| [c.start, c.end]).flatten() {
            degrees[node as usize] += 1;
        }
        let kind = |degree| match degree {
            0 => NodeKind::Apex,
            1 => NodeKind::End,
            2 => NodeKind::Corner,
            _ => NodeKind::Junction,
        };
        let node = |(&position, &degree)| TruthNode { position, kind: kind(degree), degree };
        let nodes = positions.iter().zip(&degrees).map(node).collect();
        Self { nodes, curves, weak_below_deg: 0.0 }
    }
}

/// Angle between two unit normals in degrees, well conditioned near 0 and 180.
pub(crate) fn fold_between(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(cross(a, b)).atan2(dot(a, b)).to_degrees()
}

/// A closed circle of [`CIRCLE`] points around `centre` in the plane of the unit vectors `x` and `y`.
pub(crate) fn circle(centre: [f64; 3], x: [f64; 3], y: [f64; 3], radius: f64) -> Vec<[f64; 3]> {
    (0..CIRCLE)
        .map(|i| {
            let [c, s] = super::turns::sin_cos(f64::from(i) / f64::from(CIRCLE));
            add_scaled(add_scaled(centre, x, radius * c), y, radius * s)
        })
        .collect()
}
