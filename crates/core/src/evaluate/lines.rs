//! The two sides of a comparison: lines that were found, and lines that are known.

use crate::curve::pieces::{Piece, Shape};
use crate::network::{Network, NodeKind, Strip, StripKind};
use crate::shapes::{LineIndex, Part, Truth};

/// Lines that are compared, with all that is known of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lines {
    /// The lines, world frame.
    pub lines: Vec<Line>,
    /// The curves that the lines consist of, where their types are known.
    pub curves: Vec<TypedCurve>,
    /// Places where three lines or more meet; `None` where they follow from the ends of the lines.
    pub junctions: Option<Vec<[f64; 3]>>,
    /// Edges that are rounded, as their design has them: where the two faces would meet.
    pub rounded: Vec<RoundedEdge>,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Crease, border, or neither for nor against.
    pub kind: LineKind,
    /// Whether the last point is joined to the first, which is then not repeated.
    pub closed: bool,
    /// `(M, 3)` points in order.
    pub points: Vec<[f64; 3]>,
}

/// The kind of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// Two faces meet.
    Crease,
    /// The surface ends.
    Border,
    /// So slight that it may be found or missed: it counts neither for nor against.
    Weak,
}

/// A curve whose type is known.
#[derive(Clone, Debug, PartialEq)]
pub struct TypedCurve {
    /// Its type.
    pub kind: CurveKind,
    /// Its radius, of circles and arcs.
    pub radius: Option<f64>,
    /// `(M, 3)` points in order; a whole circle ends where it begins.
    pub points: Vec<[f64; 3]>,
}

/// The type of a curve; an arc is a circle, and part of an ellipse an ellipse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// Straight.
    Line,
    /// A circle, or part of one.
    Circle,
    /// An ellipse, or part of one.
    Ellipse,
    /// Any other curve.
    Spline,
}

impl CurveKind {
    /// All of them, in the order of `Types::lengths`.
    pub const ALL: [CurveKind; 4] =
        [CurveKind::Line, CurveKind::Circle, CurveKind::Ellipse, CurveKind::Spline];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            CurveKind::Line => "line",
            CurveKind::Circle => "circle",
            CurveKind::Ellipse => "ellipse",
            CurveKind::Spline => "spline",
        }
    }
}

/// The design edge of a blend.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundedEdge {
    /// The radius of the blend.
    pub radius: f64,
    /// The angle between the two faces, degrees.
    pub turn_deg: f64,
    /// Whether the last point is joined to the first.
    pub closed: bool,
    /// `(M, 3)` points in order.
    pub points: Vec<[f64; 3]>,
}

impl From<StripKind> for LineKind {
    fn from(kind: StripKind) -> Self {
        match kind {
            StripKind::Crease => LineKind::Crease,
            StripKind::Border => LineKind::Border,
            StripKind::Rounded => LineKind::Weak,
        }
    }
}

impl From<&Network> for Lines {
    fn from(network: &Network) -> Self {
        let rounded = network.strips.iter().filter_map(rounded).collect();
        let network = &network.on_surface();
        let strips = network.strips.iter().filter(|s| s.points.len() > 1);
        let line = |s: &Strip| Line { kind: s.kind.into(), closed: s.closed, points: s.points.clone() };
        let junctions = network.nodes.iter().filter(|n| n.kind == NodeKind::Junction);
        Self {
            lines: strips.clone().map(line).collect(),
            curves: strips.flat_map(curves).collect(),
            junctions: Some(junctions.map(|n| n.position).collect()),
            rounded,
        }
    }
}

/// A strip as a rounded edge; `None` of another kind.
fn rounded(strip: &Strip) -> Option<RoundedEdge> {
    let radius = strip.blend?.radius;
    let turn_deg = strip.fold_deg.unwrap_or(0.0);
    Some(RoundedEdge { radius, turn_deg, closed: strip.closed, points: strip.points.clone() })
}

/// The typed curves of a strip; without any it is a spline.
fn curves(strip: &Strip) -> Vec<TypedCurve> {
    let typed = |piece: &Piece| {
        let (kind, radius) = match &piece.shape {
            Shape::Line => (CurveKind::Line, None),
            Shape::Arc { round, .. } | Shape::Circle(round) => (CurveKind::Circle, Some(round.radius)),
            Shape::Ellipse { .. } => (CurveKind::Ellipse, None),
            Shape::Spline(_) => (CurveKind::Spline, None),
        };
        TypedCurve { kind, radius, points: stretch(&strip.points, piece.first, piece.last) }
    };
    if strip.curves.is_empty() {
        let last = strip.points.len() - usize::from(!strip.closed);
        let points = stretch(&strip.points, 0, last);
        return vec![TypedCurve { kind: CurveKind::Spline, radius: None, points }];
    }
    strip.curves.iter().map(typed).filter(|c| c.points.len() > 1).collect()
}

/// The points of a row from one index to another, both included, the row beginning anew behind its end. `last` may be up to one row
/// farther on, and below `first` where the stretch runs over the end.
pub fn stretch(points: &[[f64; 3]], first: usize, last: usize) -> Vec<[f64; 3]> {
    let n = points.len();
    let last = if last < first { last.saturating_add(n) } else { last };
    (first..=last.min((2 * n).saturating_sub(1))).map(|i| points[i % n]).collect()
}

impl From<&Truth> for Lines {
    fn from(truth: &Truth) -> Self {
        let mut lines = Vec::new();
        for curve in &truth.curves {
            for weak in [false, true] {
                let kind = if weak { LineKind::Weak } else { curve.kind.into() };
                let parts = truth.parts(curve, weak).into_iter();
                lines.extend(parts.map(|p| Line { kind, closed: p.closed, points: p.points }));
            }
        }
        let junctions = truth.nodes.iter().filter(|n| n.kind == NodeKind::Junction);
        let junctions = Some(junctions.map(|n| n.position).collect());
        Self { lines, curves: Vec::new(), junctions, rounded: Vec::new() }
    }
}

impl Lines {
    /// The lines that count.
    pub(super) fn sharp(&self) -> impl Iterator<Item = &Line> + Clone {
        self.lines.iter().filter(|l| l.kind != LineKind::Weak && l.points.len() > 1)
    }

    /// An index of the lines that count, for the distances of points from them.
    pub fn index(&self, step: f64) -> LineIndex {
        let part = |line: &Line| Part { points: line.points.clone(), closed: line.closed };
        LineIndex::of(self.sharp().map(part), step)
    }

    /// Least and greatest corner of the lines that count; `None` without any.
    pub fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        let mut points = self.sharp().flat_map(|l| &l.points);
        let first = *points.next()?;
        Some(points.fold([first; 2], |[low, high], p| {
            [std::array::from_fn(|a| low[a].min(p[a])), std::array::from_fn(|a| high[a].max(p[a]))]
        }))
    }
}
