//! Both sides of a comparison cut into short pieces, with the distances between them.

use super::lines::{Line, LineKind, Lines};
use super::samples::samples;
use crate::math::vec3::distance;
use crate::shapes::Tree;

/// Spacings around a weak line within which what is found counts neither way.
const BESIDE_WEAK: f64 = 2.0;
/// Spacings around a point that is left out within which what is found counts neither way.
const BESIDE_IGNORED: f64 = 1.5;

/// What is compared, and how.
#[derive(Clone, Copy, Debug)]
pub struct Scoring<'a> {
    /// Mean spacing of the points, the unit of all distances; above 0.
    pub spacing: f64,
    /// Tolerances beside one and two spacings, in spacings.
    pub tolerances: &'a [f64],
    /// `(I, 3)` points beside which what is found counts neither way, such as those on faces of strong curvature.
    pub ignored: &'a [[f64; 3]],
}

impl Scoring<'_> {
    /// At one and two spacings, with nothing left out.
    pub fn new(spacing: f64) -> Self {
        Self { spacing, tolerances: &[], ignored: &[] }
    }

    /// The length of the pieces that lines are cut into.
    pub(super) fn step(&self) -> f64 {
        self.spacing / 5.0
    }
}

/// A line in pieces of at most a fifth of a spacing; a closed one ends where it begins.
pub(super) struct Row<'a> {
    pub line: &'a Line,
    pub points: Vec<[f64; 3]>,
}

impl Row<'_> {
    /// The length of the line as it is written.
    pub fn length(&self) -> f64 {
        let ends = self.line.points.first().zip(self.line.points.last()).filter(|_| self.line.closed);
        length(&self.line.points) + ends.map_or(0.0, |(a, b)| distance(*a, *b))
    }
}

/// Length of a polyline.
pub(super) fn length(points: &[[f64; 3]]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// Found and known lines in pieces.
pub(super) struct Sides<'a> {
    pub scoring: &'a Scoring<'a>,
    pub found: Vec<Row<'a>>,
    pub known: Vec<Row<'a>>,
    found_tree: Tree,
    known_tree: Tree,
    weak: Tree,
    ignored: Tree,
}

impl<'a> Sides<'a> {
    pub fn new(found: &'a Lines, known: &'a Lines, scoring: &'a Scoring<'a>) -> Self {
        let row = |line: &'a Line| Row { line, points: samples(&line.points, line.closed, scoring.step()) };
        let rows = |lines: &'a Lines| lines.sharp().map(row).collect::<Vec<Row>>();
        let tree =
            |rows: &[Row]| Tree::new(&rows.iter().flat_map(|r| &r.points).copied().collect::<Vec<_>>());
        let (found, sharp) = (rows(found), rows(known));
        let weak = known.lines.iter().filter(|l| l.kind == LineKind::Weak);
        let weak = tree(&weak.map(row).collect::<Vec<Row>>());
        let (found_tree, known_tree) = (tree(&found), tree(&sharp));
        let ignored = Tree::new(scoring.ignored);
        Self { scoring, found, known: sharp, found_tree, known_tree, weak, ignored }
    }

    fn away(&self, tree: &Tree, p: [f64; 3]) -> f64 {
        tree.nearest(p).map_or(f64::INFINITY, |(_, d2)| d2.sqrt() / self.scoring.spacing)
    }

    /// Spacings from a found point to the known lines; `None` where it counts neither way.
    pub fn to_truth(&self, p: [f64; 3]) -> Option<f64> {
        let d = self.away(&self.known_tree, p);
        let left_out =
            || self.away(&self.weak, p) <= BESIDE_WEAK || self.away(&self.ignored, p) <= BESIDE_IGNORED;
        (d <= 1.0 || !left_out()).then_some(d)
    }

    /// Spacings from a known point to the found lines.
    pub fn away_from_found(&self, p: [f64; 3]) -> f64 {
        self.away(&self.found_tree, p)
    }
}
