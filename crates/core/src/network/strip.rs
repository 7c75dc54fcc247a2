//! Strips: the lines of a network.

use crate::curve::BSpline;
use crate::curve::pieces::Piece;
use crate::math::vec3::distance;

/// One feature line.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Strip {
    /// Crease, border or rounded edge.
    pub kind: StripKind,
    /// Whether the line is a loop without nodes. The first point is then not repeated at the end.
    pub closed: bool,
    /// Node at the first point; `None` exactly when closed.
    pub start: Option<u32>,
    /// Node at the last point; `None` exactly when closed.
    pub end: Option<u32>,
    /// `(M, 3)` f64 points on the curve, in order; the first and the last lie on the nodes.
    pub points: Vec<[f64; 3]>,
    /// The fitted curve, from which `points` were taken.
    pub curve: BSpline,
    /// The line as lines, arcs, circles, ellipses and splines end to end, their ranges as indices of `points`; empty where none were sought.
    pub curves: Vec<Piece>,
    /// Points of the cloud along the strip, in order, as indices into the input.
    pub sources: Vec<u32>,
    /// Root mean square distance of the source points from the curve, in the unit of the input.
    pub deviation: f64,
    /// Mean angle between the faces along a crease, degrees; `None` for borders and if the detector does not measure it.
    pub fold_deg: Option<f64>,
    /// Mean evidence that the line is sharp rather than round, in variances of the noise; `None` if it is not measured.
    pub evidence: Option<f64>,
    /// Confidence in the line, from 0 (chance) to 1: one minus the mean penalty along a crease, twice the mean open share of a turn
    /// along a border.
    pub confidence: f64,
    /// `(M, 3)` standard deviation of each of `points` on each axis, in the unit of the input, from the fits of the faces that meet there;
    /// empty where the crease was not recovered from these.
    pub sigma: Vec<[f64; 3]>,
    /// The round of a rounded edge; `None` for other kinds.
    pub blend: Option<Blend>,
}

/// The round between the faces of a rounded edge.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Blend {
    /// Radius across the edge, in the unit of the input.
    pub radius: f64,
    /// Its standard deviation.
    pub sigma: f64,
}

/// The kind of a strip: crease, border or rounded edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum StripKind {
    /// Two faces meet.
    Crease,
    /// The surface ends.
    Border,
    /// A blend leads from one face to the other; the line lies on the design edge, where the faces would meet.
    Rounded,
}

impl StripKind {
    /// The name in files: `crease`, `border` or `rounded`.
    pub fn name(self) -> &'static str {
        match self {
            StripKind::Crease => "crease",
            StripKind::Border => "border",
            StripKind::Rounded => "rounded",
        }
    }
}

impl Strip {
    /// Length of the polyline, the closing segment of a loop included.
    pub fn length(&self) -> f64 {
        let open: f64 = self.points.windows(2).map(|w| distance(w[0], w[1])).sum();
        match (self.closed, self.points.first(), self.points.last()) {
            (true, Some(&first), Some(&last)) => open + distance(last, first),
            _ => open,
        }
    }
}
