//! Networks without a fault, for tests.

use crate::curve::BSpline;
use crate::math::vec3::distance;
use crate::network::{Network, Node, Strip};
use crate::shapes::{self, Truth, TruthCurve};

/// The network of a perfect extraction: the polylines of the truth as curves of degree 1, those of loops as the control points
/// of a cubic.
pub(crate) fn perfect(truth: &Truth) -> Network {
    let node = |n: &shapes::TruthNode| {
        let shapes::TruthNode { position, kind, degree } = *n;
        Node { position, kind, degree, source: 0, sigma: None }
    };
    Network {
        nodes: truth.nodes.iter().map(node).collect(),
        strips: truth.curves.iter().map(strip).collect(),
    }
}

pub(crate) fn strip(curve: &TruthCurve) -> Strip {
    let degree = if curve.closed { 3 } else { 1 };
    let mut knots = vec![0.0];
    for [a, b] in curve.segments() {
        knots.push(knots[knots.len() - 1] + distance(a, b));
    }
    if !curve.closed {
        knots.insert(0, 0.0);
        knots.push(knots[knots.len() - 1]);
    }
    Strip {
        kind: curve.kind,
        closed: curve.closed,
        start: curve.start,
        end: curve.end,
        points: curve.points.clone(),
        curve: BSpline { degree, knots, controls: curve.points.clone(), periodic: curve.closed },
        sources: vec![0, 1],
        fold_deg: None,
        evidence: None,
        curves: Vec::new(),
        deviation: 0.0,
        confidence: 1.0,
        sigma: Vec::new(),
        blend: None,
    }
}
