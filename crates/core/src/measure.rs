//! What a detector says of every point.

use crate::error::Error;

/// The output of a detector: one row a point, canonical order, local frame.
///
/// Any detector can feed any linker. A linker for lines reads the two [`Penalties`]; a viewer reads `score` and `class`.
#[derive(Clone, Debug, Default)]
pub struct Measure {
    /// `(N)` the sampling density: average distance to the direct neighbours in the neighbour graph (Gumhold 2001,
    /// equation 1), spacings.
    pub density: Vec<f32>,
    /// `(N)` evidence of a feature, 0 smooth to 1 certain.
    pub score: Vec<f32>,
    /// `(N)` what the point is, by a detector that has a classification of its own.
    pub class: Option<Vec<Class>>,
    /// `(N, 3)` unit normals without orientation; patches need them.
    pub normal: Vec<[f32; 3]>,
    /// Against being on a crease.
    pub crease: Penalties,
    /// Against being on a border.
    pub border: Penalties,
}

/// The penalties of the points that may lie on one kind of line; all others are left out, as nothing else can enter a
/// pattern.
#[derive(Clone, Debug, Default)]
pub struct Penalties {
    /// `(M)` candidates as point indices, ascending.
    pub points: Vec<u32>,
    /// `(M)` penalty in `[0, 1]` whatever the direction: Gumhold's curvature penalty of a crease, open angle of a border.
    pub scalar: Vec<f32>,
    /// `(M, 3)` vector penalty, in the sense of `direction`.
    pub vector: Vec<[f32; 3]>,
    /// `(M)` bound of the vector penalty: at a corner no direction is preferred.
    pub corner: Vec<f32>,
    /// `(M, 3)` where on the line the point says that it is; its own position if it cannot tell.
    pub foot: Vec<[f64; 3]>,
    /// `(M)` what a cross-section shows; `None` where none was taken: by a detector that has no such test, at borders and at
    /// corners.
    pub evidence: Vec<Option<Evidence>>,
    /// How `vector` acts on an edge.
    pub direction: Direction,
    /// Share of `scalar` in the weight of an edge, the rest is the vector penalty's.
    pub share: f64,
}

/// How a vector penalty weighs an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// As printed in Gumhold 2001: the penalty is the part of the vector along the unit edge.
    #[default]
    Along,
    /// The vector is the line's direction times its certainty; the penalty is how far the edge leaves it, in spacings.
    Across,
}

/// What a point is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Class {
    /// On no line.
    #[default]
    Smooth = 0,
    /// On a crease.
    Crease = 1,
    /// On a border.
    Border = 2,
    /// Where lines meet, end or turn.
    Corner = 3,
    /// On no surface: leaves, stray returns, veils between surfaces.
    Clutter = 4,
}

impl Measure {
    /// Checks that the rows are those of `count` points. Normals may be absent unless `with_normals`.
    ///
    /// # Errors
    /// [`Error::Measure`] with the first column, or candidate, at fault.
    pub(crate) fn check(&self, count: usize, with_normals: bool) -> Result<(), Error> {
        let class = self.class.as_ref().map_or(count, Vec::len);
        let normal = if self.normal.is_empty() && !with_normals { count } else { self.normal.len() };
        let columns = [
            ("density", self.density.len()),
            ("score", self.score.len()),
            ("normal", normal),
            ("class", class),
        ];
        if let Some((name, rows)) = columns.into_iter().find(|(_, rows)| *rows != count) {
            return Err(Error::Measure { fault: format!("`{name}` has {rows} rows for {count} points") });
        }
        self.crease.check("crease", count)?;
        self.border.check("border", count)
    }
}

impl Penalties {
    fn check(&self, kind: &str, count: usize) -> Result<(), Error> {
        let fault = |what: String| Err(Error::Measure { fault: format!("`{kind}`: {what}") });
        let rows = self.points.len();
        let columns =
            [self.scalar.len(), self.vector.len(), self.corner.len(), self.foot.len(), self.evidence.len()];
        if let Some(length) = columns.into_iter().find(|length| *length != rows) {
            return fault(format!("a column of {length} rows for {rows} candidates"));
        }
        if let Some(pair) = self.points.windows(2).find(|pair| pair[0] >= pair[1]) {
            return fault(format!("candidate {} follows candidate {}", pair[1], pair[0]));
        }
        if let Some(last) = self.points.last().filter(|&&last| last as usize >= count) {
            return fault(format!("candidate {last} of {count} points"));
        }
        let odd = |i: &usize| !self.scalar[*i].is_finite() || !self.foot[*i].iter().all(|x| x.is_finite());
        match (0..rows).find(odd) {
            Some(i) => fault(format!("candidate {} has a value that is not finite", self.points[i])),
            None => Ok(()),
        }
    }

    /// Without candidates yet.
    pub(crate) fn new(share: f64, direction: Direction) -> Self {
        Self { share, direction, ..Self::default() }
    }

    /// Appends a candidate.
    pub fn push(&mut self, point: u32, row: Row) {
        self.points.push(point);
        self.scalar.push(row.scalar);
        self.vector.push(row.vector);
        self.corner.push(row.corner);
        self.foot.push(row.foot);
        self.evidence.push(row.evidence);
    }

    /// The number of candidates.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no candidate.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }
}

/// The penalties of one candidate, as in [`Penalties`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Penalty in `[0, 1]` whatever the direction.
    pub scalar: f32,
    /// Vector penalty.
    pub vector: [f32; 3],
    /// Bound of the vector penalty.
    pub corner: f32,
    /// Where on the line the point says that it is.
    pub foot: [f64; 3],
    /// What a cross-section shows.
    pub evidence: Option<Evidence>,
}

/// What the cross-section of a crease candidate shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// Evidence that the line is sharp, in variances of the noise; negative speaks for a smooth surface.
    pub sharp: f32,
    /// The evidence that a sharp fold of the measured angle would give without noise.
    pub expected: f32,
    /// Angle between the faces, radians, never negative.
    pub fold: f32,
}
