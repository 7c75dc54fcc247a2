//! The result: crease strips and border loops that meet in nodes.

use crate::curve::BSpline;

/// A feature network: strips that run from node to node, and closed strips without any.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// Where strips meet or end.
    pub nodes: Vec<Node>,
    /// The lines, each ordered.
    pub strips: Vec<Strip>,
}

/// A point where strips meet or end.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// World frame once in an `Extraction`.
    pub position: [f64; 3],
    /// What meets here.
    pub kind: NodeKind,
    /// The number of strip ends here; a strip that starts and ends at one node counts twice.
    pub degree: u32,
    /// The point of the cloud nearest to the node's origin in the pattern, as an index into the input.
    pub source: u32,
}

/// What a [`Node`] is, by the strips that meet in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NodeKind {
    /// Three strips or more.
    Junction,
    /// Two strips that meet at an angle.
    Corner,
    /// One strip stops here (Gumhold: singleton end).
    End,
    /// No strip: a peak.
    Apex,
}

/// One feature line.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// Crease or border.
    pub kind: StripKind,
    /// Whether the line is a loop without nodes. The first point is then not repeated at the end.
    pub closed: bool,
    /// Node at the first point; `None` exactly when closed.
    pub start: Option<u32>,
    /// Node at the last point; `None` exactly when closed.
    pub end: Option<u32>,
    /// `(M, 3)` f64 points on the curve, in order; the first and the last lie on the nodes.
    pub points: Vec<[f64; 3]>,
    /// The fitted curve that `points` were taken from.
    pub curve: BSpline,
    /// Points of the cloud that the pattern ran through, in order, as indices into the input.
    pub sources: Vec<u32>,
    /// Root mean square distance of the source points from the curve, in the unit of the input.
    pub deviation: f64,
    /// Mean angle between the faces along a crease, degrees; `None` for borders and where the detector does not measure it.
    pub fold_deg: Option<f64>,
    /// Mean evidence that the line is sharp rather than round, in variances of the noise; zero where not measured.
    pub evidence: f64,
    /// How certain the line is, from 0 (chance) to 1: one minus the mean penalty share along it.
    pub confidence: f64,
}

/// Whether faces meet at a strip or the surface ends there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StripKind {
    /// Two faces meet.
    Crease,
    /// The surface ends.
    Border,
}

impl NodeKind {
    /// The name in files: `junction`, `corner`, `end` or `apex`.
    pub fn name(self) -> &'static str {
        match self {
            NodeKind::Junction => "junction",
            NodeKind::Corner => "corner",
            NodeKind::End => "end",
            NodeKind::Apex => "apex",
        }
    }
}

impl StripKind {
    /// The name in files: `crease` or `border`.
    pub fn name(self) -> &'static str {
        match self {
            StripKind::Crease => "crease",
            StripKind::Border => "border",
        }
    }
}

impl Strip {
    /// Length of the polyline, the closing segment of a loop included.
    pub fn length(&self) -> f64 {
        let open: f64 = self.points.windows(2).map(|w| crate::math::vec3::distance(w[0], w[1])).sum();
        match (self.closed, self.points.first(), self.points.last()) {
            (true, Some(&first), Some(&last)) => open + crate::math::vec3::distance(last, first),
            _ => open,
        }
    }
}

impl Network {
    /// The number of closed strips.
    pub fn loops(&self) -> usize {
        self.strips.iter().filter(|s| s.closed).count()
    }

    /// The number of nodes of one kind.
    pub fn count(&self, kind: NodeKind) -> usize {
        self.nodes.iter().filter(|n| n.kind == kind).count()
    }
}
